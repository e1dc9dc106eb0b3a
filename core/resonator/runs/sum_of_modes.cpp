#include "core/resonator/runs/sum_of_modes.h"

#include "core/numerics/dense_solvers.h"
#include "core/numerics/minimise.h"
#include "core/numerics/statistics.h"
#include "core/resonator/runs/merge_windows.h"

#include <Eigen/Dense>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numbers>
#include <numeric>
#include <utility>

namespace vybeg {
namespace {

using Complex = std::complex<double>;
using Eigen::Index;
using Eigen::MatrixXcd;
using Eigen::VectorXcd;
using std::numbers::pi;

constexpr std::size_t fewest_of_sum = 16;
constexpr int sum_steps = 60;

// The channels' phasors in units of the noise, without the mean rotation, from the first window.
struct Data {
    std::vector<double> time_s;
    std::vector<double> weight;
    std::array<VectorXcd, 2> z;  // weighted
    double turn = 0;             // removed rotation, rad/s
    double step_s = 0;
};

Data data_of(const PhasorRun& run) {
    Data data;
    Complex steps = 0;
    for (std::size_t k = 1; k < run.time_s.size(); ++k) {
        if (run.time_s[k] - run.time_s[k - 1] < 1.5 * run.window_s) {
            steps += run.product(k - 1, k);
        }
    }
    data.step_s = run.window_s;
    data.turn = std::arg(steps) / run.window_s;
    const auto count = static_cast<Index>(run.time_s.size());
    data.z = {VectorXcd(count), VectorXcd(count)};
    for (Index k = 0; k < count; ++k) {
        const auto at = static_cast<std::size_t>(k);
        const double t = run.time_s[at] - run.time_s.front();
        const Complex back = std::polar(1 / run.sd[at], -data.turn * t);
        data.time_s.push_back(t);
        data.weight.push_back(1 / run.sd[at]);
        data.z[0][k] = back * run.c[at];
        data.z[1][k] = back * run.d[at];
    }
    return data;
}

// Modes by linear prediction: z(t + n lag) of the n values before.
std::vector<Complex> predicted_rates(const Data& data, std::size_t lag, std::size_t modes) {
    const std::size_t rows = data.time_s.size();
    const double span = static_cast<double>(lag) * data.step_s;
    const auto follows = [&](std::size_t k) {
        const double off = data.time_s[k + lag] - data.time_s[k] - span;
        return std::abs(off) < 0.01 * data.step_s;
    };
    Eigen::Matrix2cd square = Eigen::Matrix2cd::Zero();
    Eigen::Vector2cd side = Eigen::Vector2cd::Zero();
    for (std::size_t k = 0; k + modes * lag < rows; ++k) {
        if (!follows(k) || (modes == 2 && !follows(k + lag))) {
            continue;
        }
        for (const VectorXcd& z : data.z) {
            const auto at = [&](std::size_t place) {
                return z[static_cast<Index>(place)] / data.weight[place];
            };
            const Eigen::Vector2cd before(at(k), modes == 2 ? at(k + lag) : Complex(0));
            square += before.conjugate() * before.transpose();
            side += before.conjugate() * at(k + modes * lag);
        }
    }
    std::vector<Complex> rates;
    const auto add = [&](Complex step) {
        const Complex rate = std::log(step) / span;
        if (std::isfinite(rate.real()) && std::isfinite(rate.imag())) {
            rates.push_back(rate);
        }
    };
    if (modes == 1) {
        add(side[0] / square(0, 0));
        return rates;
    }
    const Eigen::Vector2cd by = square.fullPivLu().solve(side);
    const Complex root = std::sqrt(by[1] * by[1] / 4.0 + by[0]);
    add(by[1] / 2.0 + root);
    add(by[1] / 2.0 - root);
    return rates;
}

// Modes with the amplitudes that fit them best. The model is holomorphic in rates and amplitudes,
// so that its equations are complex ones.
struct Solution {
    // chi2 is infinite where there are no amplitudes.
    Solution(const Data& of, std::vector<Complex> at) : data(&of), rates(std::move(at)) {
        const MatrixXcd all = waves();
        const MatrixXcd square = all.adjoint() * all;
        for (std::size_t channel = 0; channel < 2; ++channel) {
            const VectorXcd& z = data->z[channel];
            amplitudes[channel] = square.fullPivLu().solve(all.adjoint() * z);
            chi2 += (z - all * amplitudes[channel]).squaredNorm();
        }
        chi2 = std::isfinite(chi2) ? chi2 : std::numeric_limits<double>::infinity();
    }

    // After one step of Gauss and Newton.
    Solution next(double damping) const {
        const MatrixXcd jacobian = derivatives();
        MatrixXcd square = jacobian.adjoint() * jacobian;
        const VectorXcd side = jacobian.adjoint() * residual();
        square.diagonal() *= 1 + damping;
        const VectorXcd change = square.fullPivLu().solve(side);
        std::vector<Complex> moved = rates;
        for (std::size_t mode = 0; mode < moved.size(); ++mode) {
            moved[mode] += change[static_cast<Index>(mode)];
        }
        return {*data, std::move(moved)};
    }

    ModeSum found() const {
        const auto modes = static_cast<Index>(rates.size());
        ModeSum sum;
        sum.chi2 = chi2;
        sum.freedom = 4 * static_cast<double>(data->time_s.size()) - 6 * static_cast<double>(modes);
        sum.correlated_windows = correlation_windows();
        const double scale = std::max(1.0, chi2 / sum.freedom) * sum.correlated_windows;
        const MatrixXcd jacobian = derivatives();
        const MatrixXcd covariance =
            (jacobian.adjoint() * jacobian)
                .eval()
                .fullPivLu()
                .solve(MatrixXcd::Identity(jacobian.cols(), jacobian.cols()));
        const auto sd = [&](Index k) {
            return std::sqrt(std::max(covariance(k, k).real(), 0.0) * scale);
        };
        std::vector<Index> order(rates.size());
        std::iota(order.begin(), order.end(), Index{0});
        std::ranges::sort(order, std::ranges::greater{},
                          [&](Index mode) { return rates[static_cast<std::size_t>(mode)].imag(); });
        for (const Index mode : order) {
            sum.rates.push_back(rates[static_cast<std::size_t>(mode)] + Complex(0, data->turn));
            sum.rate_sd.push_back(sd(mode));
            sum.shapes.emplace_back(amplitudes[0][mode], amplitudes[1][mode]);
            sum.shape_sd.push_back(std::max(sd(modes + mode), sd(2 * modes + mode)) /
                                   sum.shapes.back().norm());
        }
        if (modes == 2) {
            const double common = 2 * covariance(0, 1).real() * scale;
            sum.beat_sd = std::sqrt(
                std::max(std::pow(sum.rate_sd[0], 2) + std::pow(sum.rate_sd[1], 2) - common, 0.0));
        }
        return sum;
    }

    MatrixXcd waves() const {
        const auto rows = static_cast<Index>(data->time_s.size());
        MatrixXcd waves(rows, static_cast<Index>(rates.size()));
        for (Index mode = 0; mode < waves.cols(); ++mode) {
            const Complex rate = rates[static_cast<std::size_t>(mode)];
            for (Index k = 0; k < rows; ++k) {
                const auto at = static_cast<std::size_t>(k);
                waves(k, mode) = data->weight[at] * std::exp(rate * data->time_s[at]);
            }
        }
        return waves;
    }

    VectorXcd residual() const {
        const MatrixXcd all = waves();
        VectorXcd left(2 * all.rows());
        left << data->z[0] - all * amplitudes[0], data->z[1] - all * amplitudes[1];
        return left;
    }

    // Windows over which the residual keeps its sign: a motion other than the sum leaves a slow
    // one, and holds less information than its windows by as much.
    double correlation_windows() const {
        const VectorXcd left = residual();
        const Index rows = left.size() / 2;
        const auto product = [&](std::size_t lag) {
            const Index length = rows - static_cast<Index>(lag);
            double sum = 0;
            for (const Index first : {Index{0}, rows}) {
                sum += left.segment(first, length)
                           .dot(left.segment(first + rows - length, length))
                           .real();
            }
            return sum;
        };
        return correlated_values(static_cast<std::size_t>(rows), left.squaredNorm(), product);
    }

    // By the rates, then the amplitudes in C, then those in D.
    MatrixXcd derivatives() const {
        const MatrixXcd all = waves();
        const Index rows = all.rows();
        const Index modes = all.cols();
        MatrixXcd by = MatrixXcd::Zero(2 * rows, 3 * modes);
        for (Index mode = 0; mode < modes; ++mode) {
            for (Index k = 0; k < rows; ++k) {
                const Complex moved = data->time_s[static_cast<std::size_t>(k)] * all(k, mode);
                by(k, mode) = moved * amplitudes[0][mode];
                by(rows + k, mode) = moved * amplitudes[1][mode];
                by(k, modes + mode) = all(k, mode);
                by(rows + k, 2 * modes + mode) = all(k, mode);
            }
        }
        return by;
    }

    const Data* data;
    std::vector<Complex> rates;
    std::array<VectorXcd, 2> amplitudes{};
    double chi2 = 0;
};

// Whether the channels have nearly one shape, and a power that rises again: what a beat in one
// projection needs. Cheap, and false for nearly all recordings of a gyro.
bool may_share(const PhasorRun& run) {
    constexpr double most_second = 0.05;  // of the first principal power
    constexpr double least_rise = 1.05;
    Eigen::Matrix2cd power = Eigen::Matrix2cd::Zero();
    double least = std::numeric_limits<double>::infinity();
    double rise = 1;
    double noise = 0;
    for (std::size_t k = 0; k < run.time_s.size(); ++k) {
        const Eigen::Vector2cd z(run.c[k], run.d[k]);
        power += z * z.adjoint();
        noise += 2 * run.sd[k] * run.sd[k];
        const double now = std::max(z.squaredNorm(), 100 * run.sd[k] * run.sd[k]);
        least = std::min(least, now);
        rise = std::max(rise, now / least);
    }
    const double half = power.trace().real() / 2;
    const double spread = std::sqrt(std::max(half * half - power.determinant().real(), 0.0));
    return half - spread - noise < most_second * (half + spread) && rise > least_rise;
}

// Seconds until a mode falls below ten deviations of a window.
double visible_s(const ModeSum& sum, std::size_t mode, const PhasorRun& run) {
    const double span = run.time_s.back() - run.time_s.front();
    const double over = sum.shapes[mode].norm() / (10 * run.sd.front());
    const double decay = -sum.rates[mode].real();
    if (!(over > 1)) {
        return 0;
    }
    return decay * span > std::log(over) ? std::log(over) / decay : span;
}

// Angle between the channels' shapes of two modes, with its deviation. What both miss alike turns
// no shape: the deviation is that of the amplitudes across the strongest shape, by what they leave.
struct ShapeAngle {
    double sine = 0;
    double sd = 0;
    double across = 0;  // amplitude across the strongest shape, of that along it
};

ShapeAngle shape_angle(const PhasorRun& run, const ModeSum& sum) {
    const double sizes[] = {sum.shapes[0].norm(), sum.shapes[1].norm()};
    const double cosine = std::abs(sum.shapes[0].dot(sum.shapes[1])) / (sizes[0] * sizes[1]);
    const Eigen::Vector2cd& along = sum.shapes[sizes[0] > sizes[1] ? 0 : 1];
    const Eigen::Vector2cd across =
        Eigen::Vector2cd(-std::conj(along[1]), std::conj(along[0])) / along.norm();
    const auto rows = static_cast<Index>(run.time_s.size());
    MatrixXcd waves(rows, 2);
    VectorXcd z(rows);
    double power = 0;
    for (Index k = 0; k < rows; ++k) {
        const auto at = static_cast<std::size_t>(k);
        const double t = run.time_s[at] - run.time_s.front();
        power += run.power(at) / (run.sd[at] * run.sd[at]);
        waves(k, 0) = std::exp(sum.rates[0] * t) / run.sd[at];
        waves(k, 1) = std::exp(sum.rates[1] * t) / run.sd[at];
        z[k] = across.dot(Eigen::Vector2cd(run.c[at], run.d[at])) / run.sd[at];
    }
    const Eigen::Matrix2cd square = waves.adjoint() * waves;
    const Eigen::Matrix2cd covariance = square.fullPivLu().inverse();
    const double left = (z - waves * (covariance * (waves.adjoint() * z))).squaredNorm();
    const double scale = std::max(1.0, left / (2 * static_cast<double>(rows) - 4));
    return {std::sqrt(std::max(1 - cosine * cosine, 0.0)),
            std::sqrt(scale * (covariance(0, 0).real() / (sizes[0] * sizes[0]) +
                               covariance(1, 1).real() / (sizes[1] * sizes[1]))),
            std::sqrt(std::max(z.squaredNorm() - 2 * static_cast<double>(rows), 0.0) / power)};
}

// Whether one of two modes does not decay as the other does: a line, or a drive.
bool one_persists(const ModeSum& sum) {
    constexpr double least_decay = 0.1;  // of the other's
    constexpr double clear = 3;
    const double first = -sum.rates[0].real();
    const double second = -sum.rates[1].real();
    return std::min(first, second) + clear * std::hypot(sum.rate_sd[0], sum.rate_sd[1]) <
           least_decay * std::max(first, second);
}

// Whether one mode alone is the motion in a third of the time in which it is visible: before or
// after a drive, a knock or a hand. A beat shows in every third.
bool one_mode_in_a_third(const PhasorRun& run) {
    constexpr double little = 1e-3;  // of the power
    const PhasorRun seen = seen_windows(run);
    const std::size_t end = seen.time_s.size();
    for (std::size_t sixth = 0; sixth < 5; ++sixth) {
        PhasorRun part = kept_windows(seen, end * sixth / 6, end * (sixth + 2) / 6);
        double power = 0;
        double noise = 0;
        for (std::size_t k = 0; k < part.time_s.size(); ++k) {
            power += part.power(k);
            noise += 4 * part.sd[k] * part.sd[k];
            part.sd[k] = 1;
        }
        const std::optional<ModeSum> one = sum_of_modes(part, 1);
        if (!one || !(one->chi2 - noise > little * power)) {
            return true;
        }
    }
    return false;
}

// Whether both channels show the sum.
bool in_both_channels(const ModeSum& sum) {
    constexpr double least_channel = 0.1;  // of the other channel's amplitude
    const double c = std::hypot(std::abs(sum.shapes[0][0]), std::abs(sum.shapes[1][0]));
    const double d = std::hypot(std::abs(sum.shapes[0][1]), std::abs(sum.shapes[1][1]));
    return std::min(c, d) > least_channel * std::max(c, d);
}

}  // namespace

std::optional<ModeSum> sum_of_modes(const PhasorRun& run, std::size_t count) {
    if (run.time_s.size() < fewest_of_sum) {
        return {};
    }
    const Data data = data_of(run);
    std::optional<Solution> best;
    for (std::size_t lag = 1; 3 * lag < data.time_s.size(); lag += (lag + 1) / 2) {
        std::vector<Complex> rates = predicted_rates(data, lag, count);
        if (rates.size() < count) {
            continue;
        }
        Solution next(data, std::move(rates));
        if (std::isfinite(next.chi2) && (!best || next.chi2 < best->chi2)) {
            best.emplace(std::move(next));
        }
    }
    if (!best) {
        return {};
    }
    descend_damped(*best, {sum_steps, 1e-12, 1e6},
                   [](const Solution& at, double damping) { return at.next(damping); });
    return best->found();
}

bool shares_projection(const PhasorRun& run) {
    constexpr double most_sine = 0.1;
    constexpr double most_sine_sd = 0.03;
    constexpr double most_across = 0.03;
    constexpr double exact = 0.03;        // relative deviation of the shapes
    constexpr double least_share = 0.05;  // of the weaker mode
    constexpr double least_fall = 100;
    constexpr double most_of_it = 0.7;
    if (run.time_s.size() < fewest_of_sum || !may_share(run)) {
        return false;
    }
    const std::optional<ModeSum> one = sum_of_modes(run, 1);
    const std::optional<ModeSum> two = sum_of_modes(run, 2);
    if (!one || !two) {
        return false;
    }
    const double fall = one->chi2 - two->chi2;
    const double needed = least_fall * std::max(1.0, two->chi2 / two->freedom);
    const double sizes[] = {two->shapes[0].norm(), two->shapes[1].norm()};
    const double seen_s = std::min(visible_s(*two, 0, run), visible_s(*two, 1, run));
    const double beat = std::abs(two->rates[0].imag() - two->rates[1].imag()) * seen_s;
    const bool beats = fall > needed && fall > most_of_it * (one->chi2 - one->freedom) &&
                       beat > pi && !one_persists(*two) &&
                       std::min(sizes[0], sizes[1]) > least_share * std::max(sizes[0], sizes[1]);
    if (!beats || !in_both_channels(*two)) {
        return false;
    }
    const ShapeAngle angle = shape_angle(run, *two);
    if (!(angle.sine < most_sine && angle.sd < most_sine_sd)) {
        return false;
    }
    // The two modes of a bell are part of its motion only: a strike and other partials are in it.
    // A drive that ends looks like half a beat, too; then more is required to distinguish them.
    const bool explained = std::hypot(two->shape_sd[0], two->shape_sd[1]) < exact;
    return explained || (beat > 2 * pi && angle.across < most_across && !one_mode_in_a_third(run));
}

}  // namespace vybeg
