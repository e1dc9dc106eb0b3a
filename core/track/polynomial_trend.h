#pragma once

#include "core/track/track.h"
#include "core/track/trend_points.h"

#include <cstddef>
#include <optional>
#include <vector>

namespace vybeg {

inline constexpr int most_trend_degree = 3;

// Polynomial through a slow variable between two times, about the middle of its windows:
//     v(t) = sum_k coefficient[k] u^k,   u = t - centre_s.
struct PolynomialTrend {
    std::size_t windows = 0;          // that count
    double centre_s = 0;              // middle of the windows' times
    std::vector<double> coefficient;  // stored units per s^k, k = 0 to the degree
    std::vector<double> sd;           // of each
    double chi2_per_dof = 0;          // of the windows, before the deviations are enlarged
    double enlargement = 1;           // of the deviations, see scatter_about()

    double at(double time_s) const;
};

// Weighted least squares over trend_points(). Nothing for fewer than degree + 2 points.
// Precondition: 1 <= degree <= most_trend_degree.
std::optional<PolynomialTrend> polynomial_trend(const Track& track, SlowVariable variable,
                                                double from_s, double to_s, std::size_t apart,
                                                int degree);

}  // namespace vybeg
