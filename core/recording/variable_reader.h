#pragma once

#include "core/base/job_control.h"
#include "core/recording/reader_process.h"
#include "core/recording/variable_choice.h"

#include <cstdint>
#include <memory>
#include <mutex>
#include <span>
#include <string>

namespace vybeg {

// What vybeg-reader is to be told about a file.
struct LibraryFormat {
    std::string kind;  // "mat", "mat73", "hdf5"
    std::string name;  // "MAT 5", ...
};

// Samples of a file's variables through vybeg-reader. A helper that died or was given up is
// replaced at the next read: a damaged stretch does not cost the rest of the recording. For several
// threads at once.
class VariableReader {
public:
    VariableReader(std::shared_ptr<const FileBytes> file, LibraryFormat format,
                   std::unique_ptr<ReaderProcess> process);

    // Fills `out` with the samples of a channel from the frame `first` on; infinite ones are NaN.
    // Errors: those of ReaderProcess.
    Status read(const ChannelPlace& place, std::int64_t first, std::span<double> out) const;

private:
    std::shared_ptr<const FileBytes> file_;
    LibraryFormat format_;
    mutable std::mutex mutex_;
    mutable std::unique_ptr<ReaderProcess> process_;
};

inline constexpr std::int64_t frames_per_request = std::int64_t{1} << 16;

// Two channels of `frames` frames, read on demand.
std::shared_ptr<const SampleSource> variable_source(std::shared_ptr<const VariableReader> reader,
                                                    ChannelPlace c, ChannelPlace d,
                                                    std::int64_t frames);

}  // namespace vybeg
