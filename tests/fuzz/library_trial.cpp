#include "core/recording/mat_hdf5/hdf5_file.h"
#include "tests/fuzz/memory_file.h"
#include "tests/fuzz/trial.h"

#include <algorithm>
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

}  // namespace

Verdict try_mat73(std::string_view bytes) {
    const NamedFile file(bytes);
    return judge(open_hdf5_file(file.path(), Naming::matlab));
}

Verdict try_hdf5(std::string_view bytes) {
    const NamedFile file(bytes);
    return judge(open_hdf5_file(file.path(), Naming::hdf5));
}

}  // namespace vybeg::fuzz
