#pragma once

#include "core/base/diagnostic.h"
#include "core/base/result.h"
#include "core/recording/bytes/file_bytes.h"
#include "core/recording/samples/open_options.h"
#include "core/recording/samples/recording.h"
#include "core/recording/samples/sample_source.h"

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace vybeg {

// Rules common to all readers, and the conversion of their results to a recording.

// Whether one channel is to be read, as C and D: the other one has a file, or times, of its own.
bool wants_one_channel(const OpenOptions& options);

// The error of a file with so many channels where two are needed: too_few_channels, with the file
// that lies beside it and may hold the other one, or no_channels.
Error too_few_channels(const FileBytes& file, int found);

// The error of a file that holds phasors of a phasemeter or a lock-in: holds_log.
Error holds_phasors(const FileBytes& file);
// That of a file of the wave over time, as a track is: a, b and theta.
Error holds_waves(const FileBytes& file);

// Checks that both chosen channels exist among the `found` channels of the file. Errors:
// no_channels, too_few_channels, channel_out_of_range.
Status check_channels(const FileBytes& file, int found, const OpenOptions& options);

// Checks for at least 5 frames, the least for five parameters. Errors: too_few_frames.
Status check_frames(const FileBytes& file, std::int64_t frames);

// Channels without names in the file, named "1", "2", ...
std::vector<Channel> numbered_channels(int count);

// Adds channels_unequal for C's and D's samples. Precondition: source and channels are set.
void note_unequal(std::int64_t samples_c, std::int64_t samples_d, Recording& recording);

// Factor from the unit of D to that of C, with its diagnostic; 1 if one channel has no unit or the
// ratio is unknown.
double note_units(const Channel& c, const Channel& d, std::vector<Diagnostic>& diagnostics);

// The rate of the file if it has one (> 0) known within 20 %, otherwise that of the option. Times
// above 1 GHz are not in seconds. Errors: rate_unknown.
Result<SampleRate> choose_rate(const FileBytes& file, std::optional<SampleRate> own,
                               const OpenOptions& options);

// Result of a reader: format, channels, start, diagnostics and samples of a recording, and the
// data that complete it.
struct FoundSamples : Recording {
    std::optional<SampleRate> own_rate{};  // of the file
    std::int64_t present_frames = 0;       // in the file; a resampled grid may have another number
    std::int64_t promised_frames = 0;      // stated by the file, which may be shorter
    bool never_closed = false;             // the file states no number of frames
    bool one_unit = false;                 // the reader has converted D to the unit of C
};

// Makes the recording after the checks above. Adds file_ends_early if it has fewer frames than
// stated, and file_not_closed; converts D to the unit of C (note_units()). Errors: those of
// check_channels(), choose_rate() and check_frames(), in this order; channel_is_time.
Result<Recording> complete_recording(const FileBytes& file, FoundSamples found,
                                     const OpenOptions& options);

// Whether two rates are one, within their digits.
bool same_rates(const Recording& one, const Recording& other);

// The error of two files, or columns, that are no parts of one recording: parts_differ.
Error no_parts(const Recording& one, const std::string& other, const char* what,
               const MessageArg& of_one, const MessageArg& of_other);

// D's samples at C's times, where their first times differ, or, by the factor `rate_ratio` of D's
// rate to C's, all: by band-limited interpolation, with the diagnostics channel_delayed and
// channel_clocks_apart.
void align_channels(double delay_s, Recording& recording, double rate_ratio = 1);

// One recording of two that were opened with one channel each (channel_c == channel_d), whose
// channels are then C and D, in C's unit. D's samples are brought to C's times; the end of the
// longer channel is left out (channels_unequal). `name_d` names D in a sentence. Errors:
// parts_differ for unlike sample rates, but for those of two time columns up to 200 ppm, unlike
// starts, and times that have nothing in common.
Result<Recording> pair_channels(Recording c, Recording d, const std::string& name_d);

// The file beside a channel's file that holds the other channel by its name: the next number
// ("sig0001.ana", "sig0002.ana"; of a demodulator of LabOne) or the next letter in place of a
// single one ("run_C", "run_D"; "x", "y"; "sin" of "cos"). Nothing where there is no such file.
std::optional<std::filesystem::path> partner_of(const std::filesystem::path& path);

}  // namespace vybeg
