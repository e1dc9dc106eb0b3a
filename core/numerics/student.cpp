#include "core/numerics/student.h"

#include <cmath>
#include <numbers>

namespace vybeg {

double student_beyond(double t, std::size_t freedom) {
    const double angle = std::atan(t / std::sqrt(static_cast<double>(freedom)));
    const double sine = std::sin(angle);
    const double cosine = std::cos(angle);
    const bool odd = freedom % 2 == 1;
    double sum = 0;
    double term = odd ? cosine : 1;
    // Of an odd number cos + 2/3 cos^3 + ..., of an even one 1 + 1/2 cos^2 + ...
    for (std::size_t k = odd ? 1 : 0; k + 2 <= freedom; k += 2) {
        sum += term;
        const auto step = static_cast<double>(k);
        term *= cosine * cosine * (step + 1) / (step + 2);
    }
    return 1 - (odd ? 2 / std::numbers::pi * (angle + sine * sum) : sine * sum);
}

double student_limit(double beyond, std::size_t freedom) {
    double low = 0;
    double high = 1;
    while (student_beyond(high, freedom) > beyond) {
        high *= 2;
    }
    while (high - low > 1e-9 * high) {
        const double middle = (low + high) / 2;
        (student_beyond(middle, freedom) > beyond ? low : high) = middle;
    }
    return high;
}

}  // namespace vybeg
