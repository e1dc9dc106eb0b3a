#include "core/resonator/fit/phase_break.h"

#include "core/resonator/fit/score_test.h"
#include "core/resonator/model/kept_windows.h"

#include <algorithm>
#include <cmath>
#include <complex>
#include <numbers>

namespace vybeg {
namespace {

using Complex = std::complex<double>;
using Eigen::Index;
using Eigen::VectorXd;

constexpr double least_share = 0.3;
constexpr double least_fall = 100;
constexpr std::size_t least_windows = 1;  // on each side

// Tries steps between all windows of a run; the effect of a step on the windows after it is a sum
// from the end.
void best_step(const FitProblem& problem, const Posterior& at, std::size_t k, PhaseBreak& best) {
    const ScaledRun& run = problem.runs[k];
    const Linearised& here = at.runs[k];
    const Index first = problem.layout.at(k, 0);
    const Index own = problem.layout.own_size(k);
    VectorXd with_parameters = VectorXd::Zero(at.information.rows());
    double square = 0;
    double with_residual = 0;
    for (std::size_t window = run.size(); window-- > least_windows;) {
        const Eigen::Vector2cd turned =
            Complex(0, run.weight[window]) * expected_phasor(run, here, window);
        const Eigen::Vector4d by(turned[0].real(), turned[0].imag(), turned[1].real(),
                                 turned[1].imag());
        const auto row = 4 * static_cast<Index>(window);
        const VectorXd cross = here.by_parameter.middleRows<4>(row).transpose() * by;
        with_parameters.head(shared_count) += cross.head(shared_count);
        with_parameters.segment(first, own) += cross.tail(own);
        square += by.squaredNorm();
        with_residual += by.dot(here.residual.segment<4>(row));
        if (run.size() - window < least_windows) {
            continue;
        }
        const VectorXd seen = at.root.transpose() * with_parameters(at.active);
        const double left = square - seen.squaredNorm();
        if (left <= own_share * square) {
            continue;
        }
        const double along = with_residual - seen.dot(at.toward);
        if (along * along / left > best.fall) {
            best = {k, (run.time_s[window - 1] + run.time_s[window]) / 2,
                    (run.time_s[window] - run.time_s[window - 1] + run.window_s) / 2, along / left,
                    along * along / left};
        }
    }
}

}  // namespace

std::optional<PhaseBreak> phase_break(const FitProblem& problem, const Posterior& at) {
    PhaseBreak best;
    for (std::size_t k = 0; k < problem.runs.size(); ++k) {
        best_step(problem, at, k, best);
    }
    const double beyond = at.chi2() - degrees_of_freedom(problem);
    if (best.fall < std::max(least_share * beyond, least_fall)) {
        return {};
    }
    return best;
}

std::vector<int> possible_samples(const PhaseBreak& step, double f_hz, double rate_hz) {
    constexpr int most_samples = 64;
    constexpr double close_rad = 0.05;  // tolerance of a step whose size is not fitted yet
    std::vector<int> possible;
    for (int k = -most_samples; rate_hz > 0 && k <= most_samples; ++k) {
        const double phase = 2 * std::numbers::pi * f_hz * k / rate_hz;
        if (k != 0 &&
            std::abs(std::remainder(phase - step.step_rad, 2 * std::numbers::pi)) < close_rad) {
            possible.push_back(k);
        }
    }
    return possible;
}

PhasorRun with_break(const PhasorRun& run, const PhaseBreak& step) {
    PhasorRun broken = kept_windows(
        run, [&](std::size_t k) { return std::abs(run.time_s[k] - step.time_s) > step.reach_s; });
    for (double& time_s : broken.time_s) {
        time_s += time_s > step.time_s ? step.shift_s : 0;
    }
    std::vector<double>& breaks = broken.phase_breaks_s;
    breaks.insert(std::ranges::upper_bound(breaks, step.time_s), step.time_s);
    return broken;
}

}  // namespace vybeg
