#pragma once

#include "core/recording/samples/recording.h"

#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace vybeg {

// The rate of each column of the table by the fields and lines above it that name a rate or a step
// ("Sample Interval,2E-06", "# Samplerate: 10 kHz", "Delta_X", "Start,Increment" over their
// values, "dt=0.001"). Empty where there is none, or where two of them disagree by more than their
// digits.
std::vector<SampleRate> header_rates(std::span<const std::string> lines, char delimiter,
                                     int columns, bool decimal_comma);

// The unit of the times by a line that says so ("HUnit,ms", "Time markers scale: ms"); empty where
// no line names one of time.
std::string axis_unit(std::span<const std::string> lines, char delimiter);

// Whether a line says a rate or a step and nothing else: "Sample rate 33333 Hz".
bool is_rate_line(std::string_view line);

// Whether a text is the name of a rate or of a step: "Sample Rate (kHz)", "XInc:", "dt".
bool is_rate_key(std::string_view text);

}  // namespace vybeg
