#pragma once

#include "core/estimators/batch/lanes.h"

namespace vybeg {

// The waves in windows that stand side by side, by maximum likelihood: what estimate() puts into
// WaveEstimate, lane by lane. Standard deviations are those for noise of one recording unit.
struct SeriesEstimates {
    Lanes w;  // rad per sample
    Lanes c_re;
    Lanes c_im;
    Lanes d_re;
    Lanes d_im;
    Lanes a_A;
    Lanes a_B;
    Lanes two_theta_A;
    Lanes alpha;
    Lanes delta_phi_CD;
    Lanes orthogonality;
    Lanes sd_a_A;
    Lanes sd_a_B;
    Lanes sd_two_theta_A;
    Lanes sd_alpha;
    Lanes sd_w;
    Lanes sd_delta_phi_CD;
};

}  // namespace vybeg
