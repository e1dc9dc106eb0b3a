#pragma once

#include <span>

namespace vybeg {

// The straight line y = mean_y + slope (x - mean_x) of least squares.
struct LineFit {
    double mean_x = 0;
    double mean_y = 0;
    double slope = 0;  // units of y per unit of x; 0 where all x are the same
};

// Pairs in which x or y is NaN do not count. Precondition: equal lengths, at least one valid pair.
LineFit fit_line(std::span<const double> x, std::span<const double> y);

}  // namespace vybeg
