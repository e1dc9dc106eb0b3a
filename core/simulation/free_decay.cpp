#include "core/simulation/free_decay.h"

#include <cmath>

namespace vybeg {

FreeDecay demo_decay() {
    FreeDecay decay;
    decay.split_hz = 0.012;
    decay.theta_w = -0.2;
    decay.tau_s = 30;
    decay.damping_anisotropy_per_s = 0.002;
    decay.theta_tau = 0.3;
    decay.omega_rad_s = 0.08;
    decay.noise = 1e-3;
    return decay;
}

std::int64_t motion_frame_count(const FreeDecay& decay) {
    return static_cast<std::int64_t>(std::floor(decay.seconds * decay.rate_hz + 1e-6));
}

std::int64_t frame_count(const FreeDecay& decay) {
    std::int64_t frames = motion_frame_count(decay);
    for (const LostSamples& fault : decay.lost) {
        frames -= fault.count;
    }
    return frames;
}

}  // namespace vybeg
