#pragma once

#include "core/base/job_control.h"
#include "core/base/result.h"
#include "core/recording/bytes/file_bytes.h"
#include "core/recording/samples/open_options.h"
#include "core/recording/samples/recording.h"
#include "core/recording/samples/sample_source.h"
#include "core/recording/variables/variable_choice.h"

#include <cstdint>
#include <memory>
#include <span>

namespace vybeg {

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

inline constexpr std::int64_t frames_per_request = std::int64_t{1} << 16;

// A file of several variables (MAT, HDF5, NPZ), whatever reads them.
struct VariableFile {
    std::shared_ptr<const FileBytes> file;
    Catalogue catalogue;
    std::shared_ptr<const VariableReader> reader;
};

// The recording that choose_variables() finds in the file. Where the rate comes from times that are
// not even, it is read whole and brought onto a uniform grid, as a text is. A file that is still
// being written, or was never closed, gets the diagnostic file_not_closed. Errors: those of
// choose_variables() and the reader; channel_out_of_range, too_few_frames, rate_unknown,
// interrupted.
Result<Recording> open_variables(const VariableFile& from, const OpenOptions& options,
                                 const JobControl& job);

}  // namespace vybeg
