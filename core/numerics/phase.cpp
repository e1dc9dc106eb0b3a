#include "core/numerics/phase.h"

#include <cmath>
#include <numbers>

namespace vybeg {

double wrap(double angle) {
    const double wrapped = std::remainder(angle, 2 * std::numbers::pi);
    return wrapped <= -std::numbers::pi ? std::numbers::pi : wrapped;
}

double nearest_branch(double value, double reference, double period) {
    return value + period * std::round((reference - value) / period);
}

}  // namespace vybeg
