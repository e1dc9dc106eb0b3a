#include "core/recording/checks/sample_prediction.h"

#include "core/numerics/dense_solvers.h"

#include <Eigen/Core>

#include <algorithm>
#include <limits>

namespace vybeg {
namespace {

constexpr Eigen::Index order = 16;
// The prediction is fitted to blocks of about so many frames together.
constexpr std::size_t fitted_frames = 2048;

using Samples = Eigen::Map<const Eigen::VectorXd>;

// Adds the normal equations of x[j] = sum over i of a_i x[j - i] for j in [from, from + count).
void add_equations(const Samples& x, Eigen::Index from, Eigen::Index count, Eigen::MatrixXd& normal,
                   Eigen::VectorXd& right) {
    for (Eigen::Index i = 1; i <= order; ++i) {
        const auto past = x.segment(from - i, count);
        right[i - 1] += past.dot(x.segment(from, count));
        for (Eigen::Index k = 1; k <= i; ++k) {
            normal(i - 1, k - 1) += past.dot(x.segment(from - k, count));
        }
    }
}

}  // namespace

std::vector<double> prediction_errors(std::span<const double> c, std::span<const double> d,
                                      std::size_t block) {
    const std::size_t blocks = c.size() / block;
    std::vector<double> errors(blocks, std::numeric_limits<double>::quiet_NaN());
    const Samples x(c.data(), static_cast<Eigen::Index>(c.size()));
    const Samples y(d.data(), static_cast<Eigen::Index>(d.size()));
    const auto length = static_cast<Eigen::Index>(block);
    std::vector<Eigen::Index> whole;  // starts of blocks that can be predicted
    for (std::size_t b = 1; b < blocks; ++b) {
        const auto from = static_cast<Eigen::Index>(b * block);
        if (length >= order && x.segment(from - order, length + order).allFinite() &&
            y.segment(from - order, length + order).allFinite()) {
            whole.push_back(from);
        }
    }
    if (whole.size() < 8) {
        return errors;
    }
    Eigen::MatrixXd normal = Eigen::MatrixXd::Zero(order, order);
    Eigen::VectorXd right = Eigen::VectorXd::Zero(order);
    const std::size_t stride = std::max<std::size_t>(1, whole.size() * block / fitted_frames);
    for (std::size_t k = 0; k < whole.size(); k += stride) {
        add_equations(x, whole[k], length, normal, right);
        add_equations(y, whole[k], length, normal, right);
    }
    // Noise far below the last digits keeps the equations solvable where there is none.
    normal.diagonal().array() += 1e-12 * normal.trace() / static_cast<double>(order);
    const Eigen::VectorXd a = normal.selfadjointView<Eigen::Lower>().ldlt().solve(right);
    Eigen::VectorXd left(length);
    for (const Eigen::Index from : whole) {
        double squares = 0;
        for (const Samples* channel : {&x, &y}) {
            left = channel->segment(from, length);
            for (Eigen::Index i = 1; i <= order; ++i) {
                left -= a[i - 1] * channel->segment(from - i, length);
            }
            squares += left.squaredNorm();
        }
        errors[static_cast<std::size_t>(from) / block] = squares / static_cast<double>(block);
    }
    return errors;
}

}  // namespace vybeg
