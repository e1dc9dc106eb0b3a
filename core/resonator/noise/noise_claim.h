#pragma once

#include "core/resonator/noise/residual_noise.h"

#include <Eigen/Core>

namespace vybeg {

// Test of the claim that the residual is a stationary noise (principle 9 of the fit): such a noise
// is equally likely in both halves of every recording and in each of its four series, and the
// parameters of the first halves and of the second halves agree within the deviations that it
// leaves them (in sets of at most 150 parameters).
struct NoiseClaim {
    // Normal deviates of the rise of the likelihood if each half of each series has its own amount
    // of colour, and of the difference of the parameters.
    double by_likelihood = 0;
    double by_parameters = 0;
    Eigen::VectorXd difference;  // of the parameters, in the basis of the posterior's root

    bool holds() const { return by_likelihood < 8 && by_parameters < 5; }
};
NoiseClaim noise_claim(const NoiseEstimate& noise, const Posterior& posterior,
                       const JobControl& job);

}  // namespace vybeg
