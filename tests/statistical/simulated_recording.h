#pragma once

#include "core/recording/samples/recording.h"
#include "core/recording/samples/sample_source.h"
#include "core/simulation/free_decay.h"
#include "core/simulation/simulate.h"
#include "tests/needed.h"

#include <cmath>

namespace vybeg::test {

// Samples as a recording that was never in a file.
inline Recording recording_of(std::vector<double> c, std::vector<double> d, double rate_hz) {
    Recording recording;
    recording.path = "simulated";
    recording.rate_hz = rate_hz;
    recording.channels = {{"C", ""}, {"D", ""}};
    recording.source = memory_source(std::move(c), std::move(d));
    return recording;
}

inline SimulatedDecay simulated(const FreeDecay& decay) {
    return needed(simulate(decay, {}));
}

inline Recording simulated_recording(const FreeDecay& decay) {
    SimulatedDecay samples = simulated(decay);
    return recording_of(std::move(samples.c), std::move(samples.d), decay.rate_hz);
}

inline double rms_of(const std::vector<double>& values) {
    double sum = 0;
    for (const double value : values) {
        sum += value * value;
    }
    return std::sqrt(sum / static_cast<double>(values.size()));
}

}  // namespace vybeg::test
