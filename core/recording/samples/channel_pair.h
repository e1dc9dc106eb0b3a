#pragma once

#include "core/base/diagnostic.h"
#include "core/base/result.h"
#include "core/recording/samples/recording.h"

#include <cstddef>
#include <string>
#include <vector>

namespace vybeg {

// Whether two rates are one, within their digits.
bool same_rates(const Recording& one, const Recording& other);

// The error of two files, or columns, that are no parts of one recording: parts_differ.
Error no_parts(const Recording& one, const std::string& other, const char* what,
               const MessageArg& of_one, const MessageArg& of_other);

// D's samples at C's times, where their first times differ: by band-limited interpolation, with the
// diagnostic channel_delayed.
void align_channels(double delay_s, Recording& recording);

// One recording of two that were opened with one channel each (channel_c == channel_d), whose
// channels are then C and D, in C's unit. D's samples are brought to C's times; the end of the
// longer channel is left out (channels_unequal). `name_d` stands for D in a sentence. Errors:
// parts_differ for unlike sample rates or starts, and for times that have nothing in common.
Result<Recording> pair_channels(Recording c, Recording d, const std::string& name_d);

}  // namespace vybeg
