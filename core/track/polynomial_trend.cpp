#include "core/track/polynomial_trend.h"

#include <Eigen/Dense>

#include <cmath>

namespace vybeg {

double PolynomialTrend::at(double time_s) const {
    double value = 0;
    for (std::size_t k = coefficient.size(); k-- > 0;) {
        value = value * (time_s - centre_s) + coefficient[k];
    }
    return value;
}

std::optional<PolynomialTrend> polynomial_trend(const Track& track, SlowVariable variable,
                                                double from_s, double to_s, std::size_t apart,
                                                int degree) {
    constexpr int most = most_trend_degree + 1;
    using Vector = Eigen::Matrix<double, Eigen::Dynamic, 1, 0, most, 1>;
    using Matrix = Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, 0, most, most>;
    const std::vector<TrendPoint> points = trend_points(track, variable, from_s, to_s, apart);
    const int count = degree + 1;
    if (points.size() < static_cast<std::size_t>(count) + 1) {
        return std::nullopt;
    }
    PolynomialTrend trend;
    trend.windows = points.size();
    trend.centre_s = (points.front().time_s + points.back().time_s) / 2;
    // Times from -1 to 1, where the powers up to the third are far from parallel, and values from
    // the first one on: they are large against what they change by.
    const double half_s = (points.back().time_s - points.front().time_s) / 2;
    const double first = points.front().value;
    Matrix normal = Matrix::Zero(count, count);
    Vector right = Vector::Zero(count);
    Vector powers(count);
    for (const TrendPoint& point : points) {
        const double u = (point.time_s - trend.centre_s) / half_s;
        powers[0] = 1;
        for (int k = 1; k < count; ++k) {
            powers[k] = powers[k - 1] * u;
        }
        normal.noalias() += point.weight * powers * powers.transpose();
        right += point.weight * (point.value - first) * powers;
    }
    const Eigen::LDLT<Matrix> factors(normal);
    const Vector solution = factors.solve(right);
    const Matrix covariance = factors.solve(Matrix::Identity(count, count));
    for (int k = 0; k < count; ++k) {
        const double scale = std::pow(half_s, -k);
        trend.coefficient.push_back(solution[k] * scale + (k == 0 ? first : 0));
        trend.sd.push_back(std::sqrt(covariance(k, k)) * scale);
    }
    const Scatter scatter =
        scatter_about(points, count, [&trend](double time_s) { return trend.at(time_s); });
    trend.chi2_per_dof = scatter.chi2_per_dof;
    trend.enlargement = scatter.enlargement;
    for (double& sd : trend.sd) {
        sd *= trend.enlargement;
    }
    return trend;
}

}  // namespace vybeg
