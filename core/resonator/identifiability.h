#pragma once

#include "core/resonator/phasor_model.h"

#include <Eigen/Core>

#include <span>

namespace vybeg {

// How sharply a set of runs sees the rates, all in 1/s (a split counts as the turn pi * split, an
// anisotropy as half of itself). One run whose wave hardly moves shows M z0 alone, four numbers for
// seven rates: there the worst direction is seen less sharply than the best by the inverse of the
// angle through which the wave moves, however good the data.
struct Sight {
    double best = 0;     // least sd of any combination of rates
    double split = 0;    // greatest sd within the pair of split rates
    double damping = 0;  // within the pair of damping rates
    double rotation = 0;
};

// From the covariance in the coordinates of phasor_model.h, all structured rates free.
Sight sight(const Eigen::MatrixXd& covariance);

// The ratio to the best above which a rate counts as not seen: the angle through which the wave
// must move, or by which the starts of two runs must differ in 4theta, is about 1/10 rad.
inline constexpr double blur_limit = 10;

// Sizes of the pairs, in the same unit.
double split_size(const Shared& shared);
double damping_size(const Shared& shared);

// Whether a fall of chi^2, in units of its expected size, is beyond four standard deviations of
// chance for so many parameters (Wilson and Hilferty's approximation).
bool significant(double fall, int parameters);

// The direction in (split cos 4theta_w, split sin 4theta_w) that still waves see: the quadrature
// grows with sin 4(theta_A - theta_w). The mean of the runs' directions where there are several.
Eigen::Vector2d seen_direction(const FitState& state);

// The greatest angle theta_A through which the wave of one of the runs turns, degrees.
double turned_deg(std::span<const ScaledRun> runs);

}  // namespace vybeg
