#include "core/resonator/runs/channels.h"

#include "core/estimators/wave/wave_state.h"

#include <Eigen/Cholesky>

#include <algorithm>
#include <cmath>
#include <cstddef>

namespace vybeg {
namespace {

constexpr double significant = 6;  // standard deviations
constexpr double most_correlation = 0.95;
constexpr std::size_t differences = 3;

Eigen::Matrix2d whitening(const PhasorRun& run, const std::vector<Phasors>& fitted) {
    Eigen::Matrix2d sum = Eigen::Matrix2d::Zero();
    double count = 0;
    for (std::size_t k = 0; k + differences < run.time_s.size(); ++k) {
        const double length = run.time_s[k + differences] - run.time_s[k];
        if (std::abs(length / run.window_s - static_cast<double>(differences)) > 0.01) {
            continue;
        }
        Eigen::Vector2cd difference = Eigen::Vector2cd::Zero();
        double factor = 1;
        for (std::size_t j = 0; j <= differences; ++j) {
            const std::size_t at = k + j;
            difference += factor / run.sd[at] *
                          Eigen::Vector2cd(run.c[at] - fitted[at].c, run.d[at] - fitted[at].d);
            factor *= -static_cast<double>(differences - j) / static_cast<double>(j + 1);
        }
        sum += (difference * difference.adjoint()).real();
        count += 1;
    }
    const double trace = sum.trace();
    if (!(trace > 0) || !std::isfinite(trace)) {
        return Eigen::Matrix2d::Identity();
    }
    const Eigen::Matrix2d covariance = 2 / trace * sum;
    // Neighbouring differences are not independent: a third of them counts.
    const double sd = std::sqrt(3 / count);
    const double correlation = covariance(0, 1) / std::sqrt(covariance(0, 0) * covariance(1, 1));
    const double unlike = std::log(covariance(1, 1) / covariance(0, 0)) / 2;
    // NaN of a silent channel is no noise to weight by.
    // The inverse of noise that is nearly the same in both rests on their small difference.
    if (std::abs(correlation) > most_correlation) {
        return Eigen::Matrix2d::Identity();
    }
    if (!(std::abs(correlation) > significant * sd || std::abs(unlike) > significant * sd) ||
        !std::isfinite(correlation + unlike)) {
        return Eigen::Matrix2d::Identity();
    }
    const Eigen::LLT<Eigen::Matrix2d> factor(covariance);
    if (factor.info() != Eigen::Success) {
        return Eigen::Matrix2d::Identity();
    }
    return factor.matrixL().solve(Eigen::Matrix2d::Identity());
}

}  // namespace

ChannelBalance channel_balance(const PhasorRun& run, const FittedMotion& motion, std::size_t index,
                               std::size_t most_points) {
    ChannelBalance balance;
    const std::size_t windows = run.time_s.size();
    const std::size_t points = std::min(most_points, windows);
    const std::vector<Phasors> fitted = predicted_phasors(motion, index, run.time_s);
    for (std::size_t point = 0; point < points; ++point) {
        double count = 0;
        double time = 0;
        double sum = 0;
        double variance = 0;
        std::complex<double> direction;  // its period is 90 degrees of theta
        for (std::size_t k = point * windows / points; k < (point + 1) * windows / points; ++k) {
            const WaveState wave = to_wave_state(fitted[k]);
            if (wave.a_A - std::abs(wave.a_B) < 6 * run.sd[k]) {
                continue;
            }
            const double cosine = std::cos(wave.two_theta_A);
            const double sine = std::sin(wave.two_theta_A);
            const std::complex<double> s_A = run.c[k] * cosine + run.d[k] * sine;
            const std::complex<double> s_B = run.d[k] * cosine - run.c[k] * sine;
            const double power = std::norm(s_A) + std::norm(s_B);
            count += 1;
            time += run.time_s[k];
            sum += (s_A * std::conj(s_B)).real() / power;
            direction += std::polar(1.0, 2 * wave.two_theta_A);
            variance += run.sd[k] * run.sd[k] / power;
        }
        if (count > 0) {
            balance.time_s.push_back(time / count);
            balance.theta_rad.push_back(std::arg(direction) / 4);
            balance.orthogonality.push_back(sum / count);
            balance.sd.push_back(std::sqrt(variance) / count);
        }
    }
    return balance;
}

std::vector<Eigen::Matrix2d> whitenings(const FittedMotion& motion,
                                        std::span<const PhasorRun> runs) {
    std::vector<Eigen::Matrix2d> all;
    for (std::size_t k = 0; k < runs.size(); ++k) {
        all.push_back(whitening(runs[k], predicted_phasors(motion, k, runs[k].time_s)));
    }
    return all;
}

}  // namespace vybeg
