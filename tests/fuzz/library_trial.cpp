#include "core/recording/audio/audio_reader.h"
#include "core/recording/mat_hdf5/hdf5_file.h"
#include "core/recording/sndfile/audio_file.h"
#include "tests/fuzz/memory_file.h"
#include "tests/fuzz/trial.h"

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

namespace vybeg::fuzz {
namespace {

constexpr std::int64_t most_frames = std::int64_t{1} << 16;

// As the program does it: the catalogue and each answer in the form in which they are sent.
Verdict read_through(HelperFile& file) {
    const auto catalogue = decode_catalogue(encode(file.catalogue()));
    if (!catalogue) {
        return {Outcome::read, "a catalogue that cannot be sent"};
    }
    for (std::size_t i = 0; i < catalogue->variables.size(); ++i) {
        const FileVariable& variable = catalogue->variables[i];
        const std::int64_t count = std::min(variable.frames, most_frames);
        for (const std::int64_t channel : {std::int64_t{0}, variable.channels - 1}) {
            for (const std::int64_t first : {std::int64_t{0}, variable.frames - count}) {
                const SampleRequest request{static_cast<std::int64_t>(i), channel, first, count};
                if (!fits(request, *catalogue)) {
                    continue;
                }
                std::vector<double> samples(static_cast<std::size_t>(count));
                if (const Status status = file.read(request, samples); !status) {
                    return {Outcome::unreadable, decode_error(encode(status.error()))
                                                     ? ""
                                                     : "an error that cannot be sent"};
                }
            }
        }
    }
    return {Outcome::read, ""};
}

Verdict judge(Result<std::unique_ptr<HelperFile>> opened) {
    if (!opened) {
        return {Outcome::refused,
                decode_error(encode(opened.error())) ? "" : "an error that cannot be sent"};
    }
    return read_through(**opened);
}

// What is wrong with the plain samples of an audio file beside those of the library; empty where
// nothing is.
std::string difference(std::string_view bytes, const std::shared_ptr<const FileBytes>& file,
                       HelperFile& decoded) {
    const auto header = audio_extent(*file);
    if (!header || !header->plain || header->plain->frames < 5 || header->plain->channels < 2) {
        return {};
    }
    // Of a second chunk of samples libsndfile takes these.
    if (bytes.find("data", static_cast<std::size_t>(header->samples_at)) != bytes.npos) {
        return {};
    }
    const PlainSamples& plain = *header->plain;
    const Catalogue& catalogue = decoded.catalogue();
    const FileVariable& samples = catalogue.variables.front();
    // libsndfile takes what stands behind the samples of a W64 file for samples, and of an RF64
    // file one of several sizes.
    const bool same_frames = plain.container == "W64"
                                 ? plain.frames <= samples.frames
                                 : plain.container == "RF64" || plain.frames == samples.frames;
    if (!same_frames || plain.channels != samples.channels || plain.type_name != samples.type ||
        plain.container != catalogue.format ||
        (!header->rate_is_zero && static_cast<double>(plain.rate_hz) != samples.rate_hz)) {
        return "another header in place: " + std::to_string(plain.frames) + " and " +
               std::to_string(samples.frames) + " frames, " + plain.container + ", " +
               catalogue.format;
    }
    OpenOptions options;
    options.rate_hz = 33333;
    const auto recording = open_audio(file, options, {});
    const std::int64_t frames = std::min(plain.frames, samples.frames);
    const std::int64_t count = std::min(frames, most_frames);
    std::vector<double> c(static_cast<std::size_t>(count)), d(c), x(c);
    for (const std::int64_t first : {std::int64_t{0}, frames - count}) {
        if (!recording || !recording->source->read(first, c, d)) {
            return "samples that are not there in place";
        }
        for (const std::int64_t channel : {0, 1}) {
            const std::vector<double>& own = channel == 0 ? c : d;
            const bool same = decoded.read({0, channel, first, count}, x) &&
                              std::equal(own.begin(), own.end(), x.begin(), [](double a, double b) {
                                  return a == b || (std::isnan(a) && !std::isfinite(b));
                              });
            if (!same) {
                return "other samples in place";
            }
        }
    }
    return {};
}

Verdict try_audio(std::string_view bytes) {
    const MemoryFile memory(bytes);
    const auto file = FileBytes::open(memory.path());
    if (!file) {
        return {};
    }
    auto opened = open_audio_file(*file);
    HelperFile* const decoded = opened ? opened->get() : nullptr;
    std::string fault = decoded ? difference(bytes, *file, *decoded) : "";
    return fault.empty() ? judge(std::move(opened)) : Verdict{Outcome::read, std::move(fault)};
}

Verdict try_mat73(std::string_view bytes) {
    const MemoryFile file(bytes);
    return judge(open_hdf5_file(file.descriptor(), Naming::matlab));
}

Verdict try_hdf5(std::string_view bytes) {
    const MemoryFile file(bytes);
    return judge(open_hdf5_file(file.descriptor(), Naming::hdf5));
}

}  // namespace

TryFile library_of(std::string_view format) {
    return format == "audio"   ? TryFile(try_audio)
           : format == "mat73" ? TryFile(try_mat73)
           : format == "hdf5"  ? TryFile(try_hdf5)
                               : nullptr;
}

}  // namespace vybeg::fuzz
