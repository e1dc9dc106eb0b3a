#pragma once

#include "core/base/result.h"
#include "core/recording/bytes/file_bytes.h"
#include "core/recording/samples/open_options.h"
#include "core/recording/samples/recording.h"

#include <cstdint>
#include <optional>
#include <vector>

namespace vybeg {

// What every reader asks of a file before it hands out a recording.

// Both chosen channels exist among the file's `found`. Errors: too_few_channels,
// channel_out_of_range.
Status check_channels(const FileBytes& file, int found, const OpenOptions& options);

// At least 5 frames: the least that five parameters can be identified from. Errors: too_few_frames.
Status check_frames(const FileBytes& file, std::int64_t frames);

// Channels of which the file tells no more than that they are there: named "1", "2", ...
std::vector<Channel> numbered_channels(int count);

// Adds file_ends_early where the recording has fewer frames than its file promises.
void note_early_end(std::int64_t promised_frames, Recording& recording);

// Adds file_not_closed: nothing in the file says how many frames there were to be.
void note_not_closed(Recording& recording);

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

}  // namespace vybeg
