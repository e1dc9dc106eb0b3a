#include "core/resonator/results/fitted_set.h"

#include <algorithm>
#include <cmath>

namespace vybeg {
namespace {

// Step of central differences, as a share of a parameter's deviation with all others known. Within
// its full deviation a parameter that depends on others would leave the linear range.
constexpr double difference_share = 0.03;

// Share of a variance that a profile must add for the direction to count as undetermined.
constexpr double unseen_share = 0.25;

double by_shorter_way(double difference, double period) {
    return period > 0 ? std::remainder(difference, period) : difference;
}

// Parameters to both sides of the maximum along one of them.
struct Neighbours {
    Eigen::VectorXd up;
    Eigen::VectorXd down;
    double step = 0;  // between them, after rounding
};

Neighbours neighbours(const Posterior& posterior, Eigen::Index k) {
    const Eigen::Index at = posterior.active[static_cast<std::size_t>(k)];
    const double h = difference_share * posterior.alone_sd[k];
    Neighbours near{posterior.p, posterior.p, 0};
    near.up[at] += h;
    near.down[at] -= h;
    near.step = near.up[at] - near.down[at];
    return near;
}

}  // namespace

Eigen::VectorXcd square_gradient(const Posterior& posterior) {
    Eigen::VectorXcd by(static_cast<Eigen::Index>(posterior.active.size()));
    for (Eigen::Index k = 0; k < by.size(); ++k) {
        const Neighbours near = neighbours(posterior, k);
        by[k] = (square_half_difference(near.up) - square_half_difference(near.down)) / near.step;
    }
    return by;
}

double ReportedVariances::sd(Eigen::Index quantity) const {
    return std::sqrt(std::max(data[quantity] + nothing[quantity], 0.0));
}

double ReportedVariances::width(Eigen::Index quantity) const {
    return std::sqrt(std::max(total(quantity), 0.0));
}

double ReportedVariances::u(Eigen::Index quantity) const {
    return std::hypot(sd(quantity), shares.row(quantity).norm(), spread[quantity]);
}

ReportedVariances reported_variances(const Posterior& posterior, const QuantityContext& context,
                                     const std::vector<ProfilePoint>& beside,
                                     const Eigen::MatrixXd& moved,
                                     const Eigen::MatrixXd& scattered) {
    ReportedVariances out;
    out.value = quantities(posterior.p, context);
    const Eigen::VectorXd period = quantity_periods(context.layout->runs());
    const Eigen::Index count = out.value.size();
    out.gradient.resize(count, static_cast<Eigen::Index>(posterior.active.size()));
    for (Eigen::Index k = 0; k < out.gradient.cols(); ++k) {
        const Neighbours near = neighbours(posterior, k);
        const Eigen::VectorXd difference =
            quantities(near.up, context) - quantities(near.down, context);
        for (Eigen::Index q = 0; q < count; ++q) {
            out.gradient(q, k) = by_shorter_way(difference[q], period[q]) / near.step;
        }
    }
    const Eigen::MatrixXd in_root = out.gradient * posterior.root;
    const auto variances = [&](const Eigen::MatrixXd& part) {
        return Eigen::VectorXd((in_root * part).cwiseProduct(in_root).rowwise().sum());
    };
    out.data = variances(posterior.data);
    out.known = variances(posterior.known);
    out.nothing = variances(posterior.nothing);
    for (const ProfilePoint& point : beside) {
        const Eigen::VectorXd there = quantities(point.p, context);
        for (Eigen::Index q = 0; q < count; ++q) {
            const double off = by_shorter_way(there[q] - out.value[q], period[q]);
            const double missing = off * off / point.rise - out.total(q);
            if (missing > 0) {
                // A small part is the curvature of the quantity along a determined direction.
                (missing > unseen_share * out.total(q) ? out.nothing : out.data)[q] += missing;
            }
        }
    }
    out.shares = Eigen::MatrixXd::Zero(count, moved.cols());
    for (Eigen::Index k = 0; k < moved.cols(); ++k) {
        if (moved.col(k).isZero(0)) {
            continue;
        }
        for (const double sign : {1.0, -1.0}) {
            Eigen::VectorXd p = posterior.p;
            p(posterior.active) += sign * moved.col(k);
            const Eigen::VectorXd there = quantities(p, context);
            for (Eigen::Index q = 0; q < count; ++q) {
                double off = by_shorter_way(there[q] - out.value[q], period[q]);
                if (!std::isfinite(off)) {
                    off = out.gradient.row(q).dot(moved.col(k));
                }
                out.shares(q, k) += off * off / 2;
            }
        }
    }
    out.shares = out.shares.cwiseSqrt();
    out.spread = (out.gradient * scattered).rowwise().norm();
    return out;
}

}  // namespace vybeg
