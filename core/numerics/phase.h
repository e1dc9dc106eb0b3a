#pragma once

namespace vybeg {

// The angle in (-pi, pi] that differs from `angle` by whole turns. NaN stays NaN.
double wrap(double angle);

// The number of the form value + k period, k whole, nearest to `reference`.
double nearest_branch(double value, double reference, double period);

}  // namespace vybeg
