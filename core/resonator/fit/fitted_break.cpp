#include "core/resonator/fit/fitted_break.h"

#include "core/numerics/dense_solvers.h"
#include "core/resonator/fit/score_test.h"
#include "core/resonator/model/phasor_run.h"

#include <algorithm>
#include <cmath>
#include <complex>
#include <numbers>

namespace vybeg {
namespace {

using Complex = std::complex<double>;
using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;

// Each kind of break with its first column among the effects of all kinds on the windows after it,
// and the least fall of chi^2: white noise exceeds it in less than one of a thousand sets of four
// runs with 150 windows each.
struct KindOfBreak {
    BreakKind kind;
    Index column;
    double least_fall;
};
constexpr std::array<KindOfBreak, 4> kinds{{{BreakKind::phase, 0, 28},
                                            {BreakKind::gain, 1, 33},
                                            {BreakKind::start, 3, 42},
                                            {BreakKind::event, 7, 50}}};
constexpr Index effect_columns = kinds.back().column;
using Columns = Eigen::Matrix<double, Eigen::Dynamic, effect_columns>;
using Square = Eigen::Matrix<double, effect_columns, effect_columns>;
using Column = Eigen::Matrix<double, effect_columns, 1>;

// Best break of each of them.
using Best = std::array<FittedBreak, kinds.size()>;

// Fall of chi^2 by the columns [first, first + count).
double fall_by(const MatrixXd& square, const VectorXd& whole, const VectorXd& with_residual) {
    MatrixXd left = square;
    VectorXd along = with_residual;
    for (Index k = 0; k < along.size(); ++k) {
        if (!(left(k, k) > own_share * whole[k])) {
            left.row(k).setZero();
            left.col(k).setZero();
            left(k, k) = 1;
            along[k] = 0;
        }
    }
    const VectorXd unit = left.diagonal().cwiseSqrt().cwiseInverse();
    const Eigen::SelfAdjointEigenSolver<MatrixXd> eigen(
        MatrixXd(unit.asDiagonal() * left * unit.asDiagonal()));
    const VectorXd turned = eigen.eigenvectors().transpose() * (unit.asDiagonal() * along);
    double fall = 0;
    for (Index k = 0; k < turned.size(); ++k) {
        // Columns that differ by rounding only count once.
        constexpr double least = 1e-9;
        fall += eigen.eigenvalues()[k] > least ? turned[k] * turned[k] / eigen.eigenvalues()[k] : 0;
    }
    return fall;
}

// A run's part of the posterior: what its windows see of the parameters.
struct SeenByRun {
    MatrixXd root;    // lower triangle L: L L^T is the covariance of its parameters
    VectorXd toward;  // change of those parameters toward which the residual points
};

SeenByRun seen_by(const FitProblem& problem, const Posterior& at, std::size_t k) {
    const auto [places, columns] = columns_of(problem.layout, k, at.active);
    MatrixXd rows = MatrixXd::Zero(shared_count + problem.layout.own_size(k), at.root.cols());
    rows(columns, Eigen::all) = at.root(places, Eigen::all);
    SeenByRun seen;
    seen.toward = rows * at.toward;
    const Eigen::HouseholderQR<MatrixXd> qr(MatrixXd(rows.transpose()));
    const Index rank = std::min(rows.rows(), rows.cols());
    seen.root = MatrixXd(qr.matrixQR().topRows(rank).triangularView<Eigen::Upper>()).transpose();
    return seen;
}

void consider(FittedBreak candidate, Best& best) {
    FittedBreak& now = best[static_cast<std::size_t>(candidate.kind)];
    if (candidate.fall > now.fall) {
        now = candidate;
    }
}

// Effects on one window: weighted changes of its four numbers.
Eigen::Matrix<double, 4, effect_columns> effects_on(const ScaledRun& run, const Linearised& here,
                                                    std::size_t window) {
    Eigen::Matrix<double, 4, effect_columns> by;
    const Eigen::Vector2cd expected = expected_phasor(run, here, window);
    const auto put = [&](Index column, const Eigen::Vector2cd& change) {
        by.col(column) = real_parts(run.weighted(window, change));
    };
    put(0, Complex(0, 1) * expected);
    put(1, {expected[0], 0});
    put(2, {0, expected[1]});
    by.rightCols<4>() = here.by_parameter.block<4, 4>(4 * static_cast<Index>(window),
                                                      shared_count + static_cast<Index>(start_at));
    return by;
}

// Tries all instants of a run; the effect on the windows after an instant is a sum from the end.
void scan(const FitProblem& problem, const Posterior& at, std::size_t k, Best& best) {
    const ScaledRun& run = problem.runs[k];
    const Linearised& here = at.runs[k];
    const SeenByRun seen = seen_by(problem, at, k);
    Columns with_parameters = Columns::Zero(here.by_parameter.cols(), effect_columns);
    Square square = Square::Zero();
    Column with_residual = Column::Zero();
    for (std::size_t window = run.size(); window-- > 0;) {
        const auto row = 4 * static_cast<Index>(window);
        const auto derivatives = here.by_parameter.middleRows<4>(row);
        const auto residual = here.residual.segment<4>(row);
        const MatrixXd absorbed = derivatives * seen.root;
        const MatrixXd own = Eigen::Matrix4d::Identity() - absorbed * absorbed.transpose();
        consider(
            {.run = k,
             .time_s = run.time_s[window],
             .reach_s = run.window_s / 2,
             .kind = BreakKind::event,
             .fall = fall_by(own, Eigen::Vector4d::Ones(), residual - derivatives * seen.toward)},
            best);
        if (window == 0) {
            break;
        }
        const Eigen::Matrix<double, 4, effect_columns> by = effects_on(run, here, window);
        with_parameters += derivatives.transpose() * by;
        square += by.transpose() * by;
        with_residual += by.transpose() * residual;
        const MatrixXd in_root = seen.root.transpose() * with_parameters;
        const MatrixXd left = square - in_root.transpose() * in_root;
        const VectorXd along = with_residual - with_parameters.transpose() * seen.toward;
        for (const auto& [kind, first, least] : kinds) {
            const Index count = break_size(kind);
            if (count == 0) {
                continue;
            }
            consider({.run = k,
                      .time_s = (run.time_s[window - 1] + run.time_s[window]) / 2,
                      .reach_s = (run.time_s[window] - run.time_s[window - 1] + run.window_s) / 2,
                      .kind = kind,
                      .fall = fall_by(left.block(first, first, count, count),
                                      square.diagonal().segment(first, count),
                                      along.segment(first, count)),
                      .size = {kind == BreakKind::phase ? along[0] / left(0, 0) : 0, 0}},
                     best);
        }
    }
}

}  // namespace

std::vector<FittedBreak> likely_breaks(const FitProblem& problem, const Posterior& at) {
    Best best;
    for (std::size_t k = 0; k < problem.runs.size(); ++k) {
        scan(problem, at, k, best);
    }
    std::vector<FittedBreak> likely;
    for (std::size_t k = 0; k < kinds.size(); ++k) {
        if (best[k].fall > kinds[k].least_fall) {
            likely.push_back(best[k]);
        }
    }
    return likely;
}

std::vector<int> possible_samples(double step_rad, double f_hz, double rate_hz) {
    constexpr int most_samples = 64;
    constexpr double close_rad = 0.05;  // of a step fitted without its shift in time
    std::vector<int> possible;
    for (int k = -most_samples; rate_hz > 0 && k <= most_samples; ++k) {
        const double phase = 2 * std::numbers::pi * f_hz * k / rate_hz;
        if (k != 0 &&
            std::abs(std::remainder(phase - step_rad, 2 * std::numbers::pi)) < close_rad) {
            possible.push_back(k);
        }
    }
    return possible;
}

PhasorRun with_break(const PhasorRun& run, const FittedBreak& found) {
    PhasorRun broken = kept_windows(
        run, [&](std::size_t k) { return std::abs(run.time_s[k] - found.time_s) > found.reach_s; });
    for (double& time_s : broken.time_s) {
        time_s += time_s > found.time_s ? found.shift_s : 0;
    }
    std::vector<RunBreak>& breaks = broken.breaks;
    breaks.insert(std::ranges::upper_bound(breaks, found.time_s, {}, &RunBreak::time_s),
                  {found.time_s, found.kind});
    return broken;
}

std::array<double, 2> fitted_size(const FitProblem& problem, const Eigen::VectorXd& p,
                                  const FittedBreak& found) {
    ScaledRun run = problem.runs[found.run];
    VectorXd own = own_of(problem.layout, p, found.run);
    Index at = own_count;
    std::size_t place = 0;
    for (; place < run.breaks.size() && run.breaks[place].time_s != found.time_s; ++place) {
        at += break_size(run.breaks[place].kind);
    }
    if (place == run.breaks.size()) {
        return {};
    }
    if (found.kind == BreakKind::phase) {
        return {std::remainder(own[at], 2 * std::numbers::pi), 0};
    }
    if (found.kind == BreakKind::gain) {
        return {std::expm1(own[at]), std::expm1(own[at + 1])};
    }
    if (found.kind == BreakKind::event) {
        return {};
    }
    // The wave at the instant as it goes on, and as it would have gone on.
    run.time_s = {std::nextafter(found.time_s, run.time_s.back())};
    const VectorXd shared = p.head(shared_count);
    const Eigen::Vector2cd after = expected_phasors(run, shared, own, 1)[0];
    own.segment<4>(at).setZero();
    const Eigen::Vector2cd before = expected_phasors(run, shared, own, 1)[0];
    return {(after - before).norm() / before.norm(), 0};
}

}  // namespace vybeg
