#pragma once

#include "core/resonator/noise/residual_noise.h"

#include <Eigen/Core>

namespace vybeg {

// Test of the claim that the residual is a stationary noise (principle 9 of the fit): such a noise
// is equally likely in both halves of every recording and in each of its four series, and the
// parameters of the first halves and of the second halves agree within the deviations that it
// leaves them (in sets of at most 150 parameters).
struct NoiseClaim {
    bool holds = true;
    Eigen::VectorXd difference;  // of the parameters, in the basis of the posterior's root
};
NoiseClaim noise_claim(const NoiseEstimate& noise, const Posterior& posterior,
                       const JobControl& job);

}  // namespace vybeg
