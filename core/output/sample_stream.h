#pragma once

#include "core/base/result.h"

#include <cstdint>
#include <functional>
#include <span>

namespace vybeg {

// Receives frames of both channels in order.
using SampleSink = std::function<Status(std::span<const double> c, std::span<const double> d)>;

// Two signals computed while they are written.
struct SampleStream {
    std::int64_t frames = 0;
    double rate_hz = 0;
    int bits = 0;           // 0: double precision; otherwise those of the quantiser
    double full_scale = 0;  // of that quantiser
    // Passes all frames to a sink, from the first on, the same in each call. Errors: its own and
    // those of the sink.
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
