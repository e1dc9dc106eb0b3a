#include "tests/benchmarks/recording_files.h"

#include "core/output/sample_files.h"
#include "core/simulation/free_decay.h"
#include "core/simulation/simulate.h"
#include "tests/needed.h"

#include <sndfile.h>

#include <array>
#include <cstdio>
#include <cstdlib>

namespace vybeg::benchmarks {
namespace {

using test::needed;

FreeDecay decay(int frames) {
    FreeDecay decay = demo_decay();
    decay.seconds = static_cast<double>(frames) / decay.rate_hz;
    return decay;
}

void write(const std::filesystem::path& path, const SimulatedDecay& samples, double rate_hz) {
    OutputFile file = needed(OutputFile::create(path, {}));
    needed(write_samples(file, needed(sample_format(path)),
                         in_memory(samples.c, samples.d, rate_hz, {})));
    needed(file.commit());
}

// As another program writes it.
RecordingFile write_wav(const std::filesystem::path& path, const SimulatedDecay& samples,
                        int sample_format) {
    SF_INFO info{};
    info.samplerate = 33333;
    info.channels = 2;
    info.format = SF_FORMAT_WAV | sample_format;
    SNDFILE* const file = sf_open(path.c_str(), SFM_WRITE, &info);
    for (std::size_t i = 0; file && i < samples.c.size(); ++i) {
        const std::array<double, 2> frame{0.5 * samples.c[i], 0.5 * samples.d[i]};
        if (sf_writef_double(file, frame.data(), 1) != 1) {
            break;
        }
    }
    if (!file || sf_error(file) != SF_ERR_NO_ERROR) {
        std::fprintf(stderr, "%s\n", sf_strerror(file));
        std::exit(1);
    }
    sf_close(file);
    return {path, {}};
}

}  // namespace

RecordingFiles::RecordingFiles() {
    std::string name = (std::filesystem::temp_directory_path() / "vybeg-XXXXXX").string();
    if (!mkdtemp(name.data())) {
        std::perror(name.c_str());
        std::exit(1);
    }
    folder_ = name;
    const FreeDecay motion = decay(1 << 23);
    const SimulatedDecay samples = needed(simulate(motion, {}));
    OpenOptions rate;
    rate.rate_hz = motion.rate_hz;
    npy = {folder_ / "decay.npy", rate};
    write(npy.path, samples, motion.rate_hz);
    wav_f64 = write_wav(folder_ / "f64.wav", samples, SF_FORMAT_DOUBLE);
    wav_f32 = write_wav(folder_ / "f32.wav", samples, SF_FORMAT_FLOAT);
    wav_i32 = write_wav(folder_ / "i32.wav", samples, SF_FORMAT_PCM_32);
    wav_i24 = write_wav(folder_ / "i24.wav", samples, SF_FORMAT_PCM_24);
    wav_i16 = write_wav(folder_ / "i16.wav", samples, SF_FORMAT_PCM_16);
    csv = {folder_ / "decay.csv", {}};
    write(csv.path, needed(simulate(decay(1 << 21), {})), motion.rate_hz);
    // The same bytes behind the NPY header.
    const auto bytes = frame_count(motion) * static_cast<std::int64_t>(2 * sizeof(double));
    raw = {npy.path, rate};
    raw.open.raw = RawLayout{.type = RawType::f64};
    raw.open.raw->skip_bytes =
        static_cast<std::int64_t>(std::filesystem::file_size(npy.path)) - bytes;
}

RecordingFiles::~RecordingFiles() {
    std::error_code ignored;
    std::filesystem::remove_all(folder_, ignored);
}

}  // namespace vybeg::benchmarks
