#pragma once

#include "core/base/result.h"
#include "core/simulation/free_decay.h"

namespace vybeg {

// Whether the decay can be simulated at all: simulation_impossible with the reason.
Status check(const FreeDecay& decay);

}  // namespace vybeg
