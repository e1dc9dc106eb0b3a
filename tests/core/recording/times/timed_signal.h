#pragma once

#include "core/base/number_text.h"
#include "core/recording/times/time_grid.h"
#include "tests/core/recording/recording_files.h"
#include "tests/needed.h"

#include <cmath>
#include <cstdio>
#include <numbers>
#include <string>
#include <vector>

namespace vybeg::test {

inline constexpr double rate = 33333;
inline constexpr double cycles_per_sample = 0.05;  // of the signals: 20 samples a period

inline double signal_c(double time_s) {
    return std::cos(2 * std::numbers::pi * cycles_per_sample * rate * time_s);
}
inline double signal_d(double time_s) {
    return 0.5 * std::cos(2 * std::numbers::pi * cycles_per_sample * rate * time_s - 1);
}

inline std::vector<double> sampled(double (*signal)(double), const std::vector<double>& times) {
    std::vector<double> values;
    for (const double time : times) {
        values.push_back(std::isnan(time) ? no_value : signal(time));
    }
    return values;
}

inline TimedSamples samples_at(const std::vector<double>& times) {
    return {times, sampled(signal_c, times), sampled(signal_d, times), {}};
}

inline std::vector<double> even_times(std::size_t count, double start = 0) {
    std::vector<double> times;
    for (std::size_t i = 0; i < count; ++i) {
        times.push_back(start + static_cast<double>(i) / rate);
    }
    return times;
}

// Samples at the times, whose text has the given printf format for the time.
inline std::string text_of(const std::vector<double>& times, const char* format) {
    std::string text = "t,C,D\n";
    for (const double time : times) {
        char number[64];
        std::snprintf(number, sizeof number, format, time);
        text += number + ("," + round_trip_text(signal_c(time))) + "," +
                round_trip_text(signal_d(time)) + "\n";
    }
    return text;
}

inline UniformSamples gridded(const TimedSamples& samples) {
    return needed(to_uniform_grid(samples, "run.csv"));
}

}  // namespace vybeg::test
