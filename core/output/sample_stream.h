#pragma once

#include "core/base/result.h"

#include <cstdint>
#include <functional>
#include <span>

namespace vybeg {

// Takes frames of both channels, in their order.
using SampleSink = std::function<Status(std::span<const double> c, std::span<const double> d)>;

// Two signals that are made while they are written.
struct SampleStream {
    std::int64_t frames = 0;
    double rate_hz = 0;
    int bits = 0;           // 0: double precision; else the quantiser that made the samples
    double full_scale = 0;  // of that quantiser
    // Gives all frames to a sink, from the first on, the same each time; ends with its own errors
    // and those of the sink.
    std::function<Status(const SampleSink&)> run;
};

// Two signals of equal length in memory, the rest as in SampleStream.
struct Samples {
    std::span<const double> c;
    std::span<const double> d;
    double rate_hz = 0;
    int bits = 0;
    double full_scale = 0;
};

}  // namespace vybeg
