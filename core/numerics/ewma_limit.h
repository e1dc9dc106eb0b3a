#pragma once

#include <cstddef>

namespace vybeg {

// Mean number of independent normal numbers z (mean `shift`, standard deviation `sd`) until the
// exponentially weighted mean E = lambda z + (1 - lambda) E, from E = 0, leaves
// +-limit sqrt(lambda / (2 - lambda)). Integral equation of S. V. Crowder, Technometrics 29 (1987)
// 401-407, by Gauss-Legendre quadrature. Preconditions: 0 < lambda <= 1, limit > 0, sd > 0.
double ewma_run_length(double lambda, double limit, double shift, double sd);

// The limit at which a chart whose centre and standard deviation come from `baseline` normal
// numbers gives one false alarm in `points_per_alarm` points: 1/ewma_run_length() averaged over the
// errors of both (L. A. Jones, C. W. Champ, S. E. Rigdon, Technometrics 43 (2001) 156-167). Widens
// as the baseline shortens. NaN below least_baseline.
double ewma_limit(double lambda, std::size_t baseline, double points_per_alarm);

// Shortest baseline of a chart.
inline constexpr std::size_t least_baseline = 10;

}  // namespace vybeg
