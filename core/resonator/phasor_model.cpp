#include "core/resonator/phasor_model.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace vybeg {
namespace {

using Complex = std::complex<double>;
using Eigen::Vector2cd;
using std::numbers::pi;

constexpr Complex i{0, 1};

// Where a straight line through the phase, weighted with the power, is parallel to a bent one: at
// this instant the frequency does not depend on the drift.
double best_known_instant(const ScaledRun& run) {
    double power = 0;
    double mean = 0;
    for (std::size_t k = 0; k < run.size(); ++k) {
        power += run.z[k].squaredNorm();
        mean += run.z[k].squaredNorm() * run.time_s[k];
    }
    mean /= power;
    double spread = 0;
    double skew = 0;
    for (std::size_t k = 0; k < run.size(); ++k) {
        const double t = run.time_s[k] - mean;
        spread += run.z[k].squaredNorm() * t * t;
        skew += run.z[k].squaredNorm() * t * t * t;
    }
    return spread > 0 ? mean + skew / (2 * spread) : run.time_s.front();
}

}  // namespace

Shared to_shared(const SlowRates& rates) {
    Shared shared;
    for (int k = 0; k < rate_count; ++k) {
        shared[k] = rates.*all_rates[static_cast<std::size_t>(k)];
    }
    shared[kappa_index] = 1;
    shared[power_index] = 0;
    return shared;
}

SlowRates rates_of(const Shared& shared) {
    SlowRates rates;
    for (int k = 0; k < rate_count; ++k) {
        rates.*all_rates[static_cast<std::size_t>(k)] = shared[k];
    }
    return rates;
}

Vector2cd start_of(const Own& own) {
    return {Complex{own[start_index], own[start_index + 1]},
            Complex{own[start_index + 2], own[start_index + 3]}};
}

ScaledRun scaled_run(const PhasorRun& run, double scale) {
    ScaledRun scaled;
    const std::size_t n = run.time_s.size();
    scaled.time_s = run.time_s;
    std::vector<double> steps;
    double integral = 0;
    for (std::size_t k = 0; k < n; ++k) {
        scaled.z.emplace_back(run.c[k] / scale, run.d[k] / scale);
        scaled.weight.push_back(scale / run.sd[k]);
        if (k > 0) {
            const double step = run.time_s[k] - run.time_s[k - 1];
            steps.push_back(step);
            integral += step / 2 * (scaled.z[k].squaredNorm() + scaled.z[k - 1].squaredNorm());
        }
        scaled.power_integral.push_back(integral);
    }
    scaled.middle_s = best_known_instant(scaled);
    std::ranges::nth_element(steps, steps.begin() + static_cast<std::ptrdiff_t>(steps.size() / 2));
    scaled.step_s = steps[steps.size() / 2];
    return scaled;
}

void residuals(const ScaledRun& run, const Shared& shared, const Own& own, double* residual,
               double* by_shared, double* by_own) {
    const SlowDynamics motion(rates_of(shared));
    const Vector2cd start = start_of(own);
    const double kappa = shared[kappa_index];
    for (std::size_t k = 0; k < run.size(); ++k) {
        const double t = run.time_s[k];
        const double bent = t * (t / 2 - run.middle_s);
        const double turns = own[frequency_index] * t + own[drift_index] * bent +
                             shared[power_index] * run.power_integral[k];
        const double weight = run.weight[k];
        // Weight, phase and kappa act on every column alike.
        const Complex to_c = std::polar(weight, 2 * pi * turns);
        const Complex to_d = to_c / kappa;
        double* r = residual + 4 * k;
        const auto finish = [&](const Vector2cd& z) {
            const Complex c = weight * run.z[k][0] - to_c * z[0];
            const Complex d = weight * run.z[k][1] - to_d * z[1];
            r[0] = c.real();
            r[1] = c.imag();
            r[2] = d.real();
            r[3] = d.imag();
        };
        if (by_shared == nullptr && by_own == nullptr) {
            finish(motion.propagator(t) * start);
            continue;
        }
        const SlowDynamics::Propagation at = motion.propagation(t);
        const Vector2cd z = at.value * start;
        finish(z);
        const auto column = [&](double* rows, int width, int index, const Vector2cd& by) {
            const Complex c = -to_c * by[0];
            const Complex d = -to_d * by[1];
            double* first = rows + 4 * k * static_cast<std::size_t>(width) + index;
            first[0] = c.real();
            first[width] = c.imag();
            first[2 * width] = d.real();
            first[3 * width] = d.imag();
        };
        if (by_shared != nullptr) {
            for (int p = 0; p < rate_count; ++p) {
                column(by_shared, shared_count, p, at.by_rate[static_cast<std::size_t>(p)] * start);
            }
            column(by_shared, shared_count, kappa_index, Vector2cd(0, -z[1] / kappa));
            column(by_shared, shared_count, power_index, 2 * pi * run.power_integral[k] * i * z);
        }
        if (by_own != nullptr) {
            column(by_own, own_count, frequency_index, 2 * pi * t * i * z);
            column(by_own, own_count, drift_index, 2 * pi * bent * i * z);
            for (int p = 0; p < 2; ++p) {
                column(by_own, own_count, start_index + 2 * p, at.value.col(p));
                column(by_own, own_count, start_index + 2 * p + 1, i * at.value.col(p));
            }
        }
    }
}

NormalEquations normal_equations(std::span<const ScaledRun> runs, const FitState& state) {
    const Eigen::Index size = shared_count + own_count * static_cast<Eigen::Index>(runs.size());
    NormalEquations sum{Eigen::MatrixXd::Zero(size, size), Eigen::VectorXd::Zero(size), 0};
    for (std::size_t k = 0; k < runs.size(); ++k) {
        const auto rows = static_cast<Eigen::Index>(4 * runs[k].size());
        Eigen::VectorXd r(rows);
        RowMajor by_shared(rows, shared_count);
        RowMajor by_own(rows, own_count);
        residuals(runs[k], state.shared, state.runs[k], r.data(), by_shared.data(), by_own.data());
        const Eigen::Index at = shared_count + own_count * static_cast<Eigen::Index>(k);
        auto& h = sum.information;
        h.topLeftCorner<shared_count, shared_count>() += by_shared.transpose() * by_shared;
        h.block<shared_count, own_count>(0, at) = by_shared.transpose() * by_own;
        h.block<own_count, shared_count>(at, 0) =
            h.block<shared_count, own_count>(0, at).transpose();
        h.block<own_count, own_count>(at, at) = by_own.transpose() * by_own;
        sum.gradient.head<shared_count>() += by_shared.transpose() * r;
        sum.gradient.segment<own_count>(at) = by_own.transpose() * r;
        sum.chi2 += r.squaredNorm();
    }
    return sum;
}

double chi_square(std::span<const ScaledRun> runs, const FitState& state) {
    double sum = 0;
    Eigen::VectorXd r;
    for (std::size_t k = 0; k < runs.size(); ++k) {
        r.resize(static_cast<Eigen::Index>(4 * runs[k].size()));
        residuals(runs[k], state.shared, state.runs[k], r.data(), nullptr, nullptr);
        sum += r.squaredNorm();
    }
    return sum;
}

}  // namespace vybeg
