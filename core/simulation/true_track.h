#pragma once

#include "core/base/result.h"
#include "core/simulation/free_decay.h"
#include "core/track/track.h"

#include <cstdint>

namespace vybeg {

// Exact slow variables at the centres of consecutive windows of `window` samples, from the axes of
// the ellipse of (c, d): the wave itself, without errors of channels, noise about the carrier and
// lost samples. sd columns are zero, rms is the white noise's sqrt(2) sigma. f is f(t) plus the
// mean rate of phase of both signals, weighted with their power: Im(z^H dz/dt) / (2 pi |z|^2).
// Angles are NaN where the wave is circular within 1e-12 (flag circular), delta_phi_CD also where
// one of the signals vanishes. Errors: simulation_impossible.
Result<Track> true_track(const FreeDecay& decay, std::int64_t window);

}  // namespace vybeg
