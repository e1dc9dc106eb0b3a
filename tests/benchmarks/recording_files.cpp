#include "tests/benchmarks/recording_files.h"

#include "core/base/messages.h"
#include "core/report/sample_files.h"
#include "core/simulation/free_decay.h"

#include <cstdio>
#include <cstdlib>

namespace vybeg::benchmarks {
namespace {

template <class Value>
Value needed(Result<Value> result) {
    if (!result) {
        std::fprintf(stderr, "%s\n", english(result.error()).c_str());
        std::exit(1);
    }
    return std::move(*result);
}

void needed(const Status& status) {
    if (!status) {
        std::fprintf(stderr, "%s\n", english(status.error()).c_str());
        std::exit(1);
    }
}

FreeDecay decay(int bits) {
    FreeDecay decay = demo_decay();
    decay.seconds = static_cast<double>(1 << 21) / decay.rate_hz;
    decay.bits = bits;
    return decay;
}

void write(const std::filesystem::path& path, int bits) {
    const FreeDecay motion = decay(bits);
    const SimulatedDecay samples = needed(simulate(motion, {}));
    OutputFile file = needed(OutputFile::create(path, {}));
    needed(write_samples(file, needed(sample_format(path)),
                         {samples.c, samples.d, motion.rate_hz, bits, samples.full_scale}, {}));
    needed(file.commit());
}

}  // namespace

RecordingFiles::RecordingFiles() {
    std::string name = (std::filesystem::temp_directory_path() / "vybeg-XXXXXX").string();
    if (!mkdtemp(name.data())) {
        std::perror(name.c_str());
        std::exit(1);
    }
    folder_ = name;
    OpenOptions rate;
    rate.rate_hz = decay(0).rate_hz;
    npy = {folder_ / "decay.npy", rate};
    wav = {folder_ / "decay.wav", {}};
    wav_pcm = {folder_ / "pcm.wav", {}};
    csv = {folder_ / "decay.csv", {}};
    write(npy.path, 0);
    write(wav.path, 0);
    write(wav_pcm.path, 16);
    write(csv.path, 0);
    // The same bytes behind the NPY header.
    const auto samples = frame_count(decay(0)) * static_cast<std::int64_t>(2 * sizeof(double));
    raw = {npy.path, rate};
    raw.open.raw = RawLayout{.type = RawType::f64};
    raw.open.raw->skip_bytes =
        static_cast<std::int64_t>(std::filesystem::file_size(npy.path)) - samples;
}

RecordingFiles::~RecordingFiles() {
    std::error_code ignored;
    std::filesystem::remove_all(folder_, ignored);
}

}  // namespace vybeg::benchmarks
