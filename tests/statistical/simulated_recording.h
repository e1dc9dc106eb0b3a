#pragma once

#include "core/recording/memory_source.h"
#include "core/recording/recording.h"
#include "core/simulation/free_decay.h"

#include <QtTest>

namespace vybeg::test {

// A simulated decay as a recording that was never in a file.
inline Recording simulated_recording(const FreeDecay& decay) {
    Result<SimulatedDecay> simulated = simulate(decay, {});
    if (!simulated) {
        qFatal("the simulation failed");
    }
    Recording recording;
    recording.path = "simulated";
    recording.rate_hz = decay.rate_hz;
    recording.channels = {{"C", ""}, {"D", ""}};
    recording.source =
        std::make_shared<MemorySource>(std::move(simulated->c), std::move(simulated->d));
    return recording;
}

}  // namespace vybeg::test
