#pragma once

#include "core/base/result.h"
#include "core/simulation/free_decay.h"

#include <string>
#include <utility>

namespace vybeg {

// Whether the decay can be simulated at all: simulation_impossible with the reason.
Status check(const FreeDecay& decay);

inline Error impossible(std::string reason) {
    return {ErrorCode::simulation_impossible, "simulate", {std::move(reason)}};
}

}  // namespace vybeg
