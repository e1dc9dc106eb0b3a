#pragma once

#include <cstddef>

namespace vybeg {

// Probability that a number of Student's distribution with `freedom` degrees of freedom lies beyond
// +-t. Finite series for whole degrees (M. Abramowitz, I. A. Stegun, 26.7.3 and 26.7.4).
// Preconditions: t >= 0, freedom >= 1.
double student_beyond(double t, std::size_t freedom);

// The t beyond which lies the probability `beyond`, on both sides together, to 1e-9 of itself.
// Preconditions: 1e-10 <= beyond < 1, freedom >= 1.
double student_limit(double beyond, std::size_t freedom);

}  // namespace vybeg
