#include "core/recording/times/local_cubic.h"

#include <algorithm>
#include <cstddef>

namespace vybeg {
namespace {

// Value at x of the polynomial through all of the points.
double lagrange(std::span<const double> nodes, std::span<const double> values, double x) {
    double sum = 0;
    for (std::size_t i = 0; i < nodes.size(); ++i) {
        double product = values[i];
        for (std::size_t j = 0; j < nodes.size(); ++j) {
            product *= i == j ? 1.0 : (x - nodes[j]) / (nodes[i] - nodes[j]);
        }
        sum += product;
    }
    return sum;
}

}  // namespace

void interpolate_cubic(std::span<const double> nodes, std::span<const double> values, double start,
                       double step, std::span<double> out) {
    const std::size_t count = std::min<std::size_t>(4, nodes.size());
    std::size_t right = 0;  // first node that is not before the point
    for (std::size_t i = 0; i < out.size(); ++i) {
        const double at = start + step * static_cast<double>(i);
        while (right < nodes.size() - 1 && nodes[right] < at) {
            ++right;
        }
        const std::size_t first = std::clamp<std::size_t>(right, 2, nodes.size() - count + 2) - 2;
        out[i] = lagrange(nodes.subspan(first, count), values.subspan(first, count), at);
    }
}

}  // namespace vybeg
