#pragma once

#include "core/base/diagnostic.h"
#include "core/base/result.h"
#include "core/recording/bytes/file_bytes.h"
#include "core/recording/samples/open_options.h"
#include "core/recording/samples/recording.h"
#include "core/recording/samples/sample_source.h"

#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace vybeg {

// What every reader asks of a file, and the one way from what it finds to a recording.

// Both chosen channels exist among the file's `found`. Errors: too_few_channels,
// channel_out_of_range.
Status check_channels(const FileBytes& file, int found, const OpenOptions& options);

// At least 5 frames: the least that five parameters can be identified from. Errors: too_few_frames.
Status check_frames(const FileBytes& file, std::int64_t frames);

// Channels that have no names in the file: named "1", "2", ...
std::vector<Channel> numbered_channels(int count);

// Adds channels_unequal for C's and D's samples. Precondition: source and channels are there.
void note_unequal(std::int64_t samples_c, std::int64_t samples_d, Recording& recording);

struct SampleRate {
    double hz = 0;
    RateOrigin from = RateOrigin::file;
    double relative_sd = 0;  // what the digits of the file leave open
};

// The file's own rate where it has one (> 0), else the option's. Errors: rate_unknown.
Result<SampleRate> choose_rate(const FileBytes& file, std::optional<SampleRate> own,
                               const OpenOptions& options);

// What a reader finds in a file.
struct FoundSamples {
    std::string format;                          // as Recording::format
    std::vector<Channel> channels;               // as Recording::channels
    std::optional<SampleRate> own_rate;          // of the file
    std::string start;                           // as Recording::start
    std::int64_t frames = 0;                     // in the file; a grid of times may have others
    std::int64_t promised_frames = 0;            // by the file, which may end before
    bool never_closed = false;                   // nothing promises a number of frames
    bool one_unit = false;                       // the reader has brought D to the unit of C
    std::vector<Diagnostic> diagnostics;         // of the reader
    std::shared_ptr<const SampleSource> source;  // channels C and D; none without frames
};

// The recording with its rate, after the checks above. Adds file_ends_early where it has fewer
// frames than promised, and file_not_closed; brings D to the unit of C (match_units()). Errors:
// those of check_channels(), choose_rate() and check_frames(), in this order; channel_is_time.
Result<Recording> complete_recording(const FileBytes& file, FoundSamples found,
                                     const OpenOptions& options);

}  // namespace vybeg
