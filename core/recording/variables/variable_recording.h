#pragma once

#include "core/base/job_control.h"
#include "core/base/result.h"
#include "core/recording/bytes/file_bytes.h"
#include "core/recording/samples/open_options.h"
#include "core/recording/samples/recording.h"
#include "core/recording/samples/sample_source.h"
#include "core/recording/variables/reader_protocol.h"

#include <cstdint>
#include <memory>
#include <span>

namespace vybeg {

struct ChannelPlace {
    std::int64_t variable = 0;  // place in the catalogue
    std::int64_t channel = 0;   // of that variable, from 0
};

// The variables of a file, with their samples on demand. For several threads at once.
class VariableReader {
public:
    VariableReader() = default;
    VariableReader(const VariableReader&) = delete;
    VariableReader& operator=(const VariableReader&) = delete;
    virtual ~VariableReader() = default;

    virtual const Catalogue& catalogue() const = 0;

    // Fills `out` with the samples of a channel from the frame `first` on; infinite ones are NaN.
    virtual Status read(const ChannelPlace& place, std::int64_t first,
                        std::span<double> out) const = 0;

    // Two channels of so many frames, on demand.
    virtual Result<std::shared_ptr<const SampleSource>> source(const ChannelPlace& c,
                                                               const ChannelPlace& d,
                                                               std::int64_t frames) const = 0;
};

inline constexpr std::int64_t frames_per_request = std::int64_t{1} << 16;

// The recording in a file of several variables (MAT, HDF5, NPZ), whatever reads them.
//
// The variables that options.variables name: two vectors (or more general: C's and D's channels
// must each be one), or one array, whose channels all count. Without names: the longest array of
// two channels or more, or all vectors of the greatest length that two or more share, whichever is
// longer, with those named as C and D first; vectors named as times or, as pandas has them, index
// do not count. An array whose first column holds even times has C and D after it.
//
// The rate: of the named variable; else of the attributes of C's; else of a single number with the
// name of a rate or a sample period, from C's own struct or group first; without one, from the
// times of a vector t or time of the same length, which otherwise must agree with it. Where these
// are not even, the file is read whole and brought onto a uniform grid, as a text is.
//
// A file that is still being written, or was never closed, gets the diagnostic file_not_closed.
// Errors: variables_ambiguous where arrays have one size; variable_missing, setting_invalid,
// format_unsupported, too_few_channels, channel_out_of_range, too_few_frames, rate_unknown,
// interrupted; those of the reader.
Result<Recording> open_variables(const FileBytes& file, const VariableReader& reader,
                                 const OpenOptions& options, const JobControl& job);

}  // namespace vybeg
