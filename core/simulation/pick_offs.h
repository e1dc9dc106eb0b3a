#pragma once

#include "core/simulation/free_decay.h"

#include <Eigen/Core>

#include <complex>
#include <cstdint>
#include <utility>

namespace vybeg {

// Pick-off signals of the wave: errors of the channels, modes beside, cubic, offsets, hum, as
// defined in FreeDecay. The phasor of D already contains its delay.
class PickOffs {
public:
    explicit PickOffs(const FreeDecay& decay);

    // Signals of both channels at a frame, from the phasors with their carrier.
    std::pair<double, double> signals(const Eigen::Vector2cd& z, std::int64_t frame) const;

private:
    FreeDecay decay_;
    std::complex<double> from_c_;  // sin skew + i crosstalk
    bool drifts_;
};

}  // namespace vybeg
