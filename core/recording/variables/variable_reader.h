#pragma once

#include "core/base/guarded.h"
#include "core/base/job_control.h"
#include "core/recording/variables/reader_process.h"
#include "core/recording/variables/variable_choice.h"

#include <cstdint>
#include <memory>
#include <span>
#include <string>

namespace vybeg {

// A file of MATLAB's or HDF5's, or audio; vybeg-reader knows the kinds "mat73", "hdf5" and "audio".
struct LibraryFormat {
    std::string kind;  // "mat73", "hdf5", "audio"
    std::string name;  // "MAT 7.3", ...
};

// Samples of the variables that a file's catalogue lists, on demand. For several threads at once.
class VariableReader {
public:
    VariableReader() = default;
    VariableReader(const VariableReader&) = delete;
    VariableReader& operator=(const VariableReader&) = delete;
    virtual ~VariableReader() = default;

    // Fills `out` with the samples of a channel from the frame `first` on; infinite ones are NaN.
    virtual Status read(const ChannelPlace& place, std::int64_t first,
                        std::span<double> out) const = 0;

    // Two channels of so many frames, on demand.
    virtual Result<std::shared_ptr<const SampleSource>> source(const ChannelPlace& c,
                                                               const ChannelPlace& d,
                                                               std::int64_t frames) const = 0;
};

// The same through vybeg-reader. A helper that died or was given up is replaced at the next read: a
// damaged segment does not cost the rest of the recording. Errors: those of ReaderProcess.
class LibraryVariables final : public VariableReader,
                               public std::enable_shared_from_this<LibraryVariables> {
public:
    LibraryVariables(std::shared_ptr<const FileBytes> file, LibraryFormat format,
                     std::unique_ptr<ReaderProcess> process);

    Status read(const ChannelPlace& place, std::int64_t first,
                std::span<double> out) const override;
    Result<std::shared_ptr<const SampleSource>> source(const ChannelPlace& c, const ChannelPlace& d,
                                                       std::int64_t frames) const override;

private:
    std::shared_ptr<const FileBytes> file_;
    LibraryFormat format_;
    Guarded<std::unique_ptr<ReaderProcess>> process_;
};

inline constexpr std::int64_t frames_per_request = std::int64_t{1} << 16;

// Two channels of `frames` frames, read on demand. `seeks`: as SampleSource::seeks(); a packed
// variable is unpacked from its start.
std::shared_ptr<const SampleSource> variable_source(std::shared_ptr<const VariableReader> reader,
                                                    ChannelPlace c, ChannelPlace d,
                                                    std::int64_t frames, bool seeks = false);

}  // namespace vybeg
