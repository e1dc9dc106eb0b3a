#pragma once

#include "core/base/result.h"
#include "core/recording/bytes/file_bytes.h"
#include "core/recording/samples/open_options.h"
#include "core/recording/samples/reader_rules.h"
#include "core/recording/samples/recording.h"
#include "core/recording/variables/reader_protocol.h"

#include <cstdint>
#include <optional>
#include <vector>

namespace vybeg {

struct ChannelPlace {
    std::int64_t variable = 0;  // place in the catalogue
    std::int64_t channel = 0;   // of that variable, from 0
};

// Which of a file's variables are the recording.
struct VariableChoice {
    std::vector<ChannelPlace> channels;  // all that options.channel_c and channel_d choose from
    std::int64_t frames = 0;
    std::vector<Channel> names;  // of each channel
    std::optional<SampleRate> rate;
    std::optional<std::int64_t> time;       // the variable that holds the times
    double time_unit_s = 1;                 // in which those count
    std::optional<std::int64_t> time_of_d;  // where D's struct or group has times of its own
};

// The variables that options.variables name: two vectors (or more general: C's and D's channels
// must each be one), or one array, whose channels all count. Without names: the longest array of
// two channels or more, or all vectors of the greatest length that two or more share, whichever is
// longer, with those named as C and D first; vectors named as times or, as pandas has them, index
// do not count.
//
// The rate: of the named variable; else of the attributes of C's; else of a single number with the
// name of a rate or a sample period, from C's own struct or group first; without one, from the
// times of a vector t or time of the same length, which otherwise must agree with it. Whether both
// chosen channels exist is left to check_channels(). Errors: variable_missing, setting_invalid,
// format_unsupported, too_few_channels.
Result<VariableChoice> choose_variables(const FileBytes& file, const Catalogue& catalogue,
                                        const OpenOptions& options);

// Whether two rates are one, as files round them.
bool same_rate(double one_hz, double other_hz);

// The error of a file that states two rates: format_unsupported.
Error two_rates(const FileBytes& file, const Catalogue& catalogue, double first_hz,
                double second_hz);

}  // namespace vybeg
