#include "core/resonator/noise/residual_noise.h"

#include "core/numerics/dense_solvers.h"
#include "core/numerics/statistics.h"

#include <tbb/parallel_for.h>

#include <algorithm>
#include <cmath>
#include <complex>
#include <limits>
#include <numbers>
#include <optional>
#include <utility>

namespace vybeg {
namespace {

using Complex = std::complex<double>;
using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::Vector2cd;
using Eigen::VectorXd;

constexpr Complex i{0, 1};

// Amplitude in deviations below which the linear part replaces the logarithm of the phasor.
constexpr double clear_amplitude = 10;

// The mean of -ln|lag| over two windows whose centres are x windows apart, up to a constant.
double one_over_f(double x) {
    const auto g = [](double at) {
        const double square = at * at;
        return square > 0 ? 0.25 * square * std::log(square) - 0.75 * square : 0;
    };
    return 2 * g(x) - g(x + 1) - g(x - 1);
}

// Covariances of the means over windows of `window_s` at the given instants. A line: variance 1,
// exp(-b |lag|), b = 2 pi half_width. 1/f: -ln |lag|, up to a constant, which is that of the phase.
Eigen::MatrixXd shape_covariance(const NoiseShape& shape, const std::vector<double>& time_s,
                                 double window_s) {
    const auto n = static_cast<Eigen::Index>(time_s.size());
    if (std::isinf(shape.half_width_hz)) {
        return Eigen::MatrixXd::Identity(n, n);
    }
    Eigen::MatrixXd covariance(n, n);
    const double rate = 2 * std::numbers::pi * shape.half_width_hz;
    const double turn = rate * window_s;
    const double apart = std::pow(std::sinh(turn / 2) / (turn / 2), 2);
    const double same = 2 * (turn + std::expm1(-turn)) / (turn * turn);
    const double constant = std::log(1 + static_cast<double>(n));
    for (Eigen::Index k = 0; k < n; ++k) {
        for (Eigen::Index l = 0; l <= k; ++l) {
            const double lag =
                time_s[static_cast<std::size_t>(k)] - time_s[static_cast<std::size_t>(l)];
            double value = 0;
            if (shape.half_width_hz == 0) {
                value = constant + one_over_f(lag / window_s);
            } else {
                value = lag < window_s / 2 ? same : apart * std::exp(-rate * lag);
            }
            covariance(k, l) = covariance(l, k) = value;
        }
    }
    return covariance;
}

// The covariance of a part of the noise in a run's series, in units of their white noise.
Eigen::MatrixXd part_covariance(const NoiseShape& shape, const ResidualSeries& run) {
    const Eigen::VectorXd scale =
        shape.of_phase ? Eigen::VectorXd(run.size / std::sqrt(run.size.squaredNorm() /
                                                              static_cast<double>(run.size.size())))
                       : run.noise;
    return scale.asDiagonal() * shape_covariance(shape, run.time_s, run.window_s) *
           scale.asDiagonal();
}

// Correlation of points that are sums of `merge` windows over their root.
Eigen::MatrixXd merged_correlation(const std::vector<double>& correlation, std::size_t merge,
                                   Eigen::Index points) {
    if (correlation.empty()) {
        return {};
    }
    const auto n = static_cast<Eigen::Index>(merge);
    Eigen::MatrixXd merged = Eigen::MatrixXd::Zero(points, points);
    for (Eigen::Index lag = 0; lag < points; ++lag) {
        const double mean = covariance_of_sums(correlation, n, lag) / static_cast<double>(n);
        merged.diagonal(lag).setConstant(mean);
        merged.diagonal(-lag).setConstant(mean);
    }
    return merged;
}

// Points of a series: the cost grows with their cube, and the widest line has the width of half a
// point.
constexpr std::size_t most_points = 110;
constexpr int widths = 8;
constexpr double narrowest_width = 0.28;  // half width times duration
// Share of the variance above which the fit absorbs a direction of the residual.
constexpr double absorbed_share = 0.02;
constexpr double least_rise = 4;
constexpr double negligible_weight = 1e-4;
// Decades of the variance of a part over that of the white noise of a point.
constexpr double first_decade = -3;
constexpr double last_decade = 8;
constexpr double decade_step = 0.2;
constexpr std::size_t coarse_step = 3;  // of decade_step, for the coarse grid
// Distance below the best from which on a point has no weight.
constexpr double hopeless = 13;
constexpr double impossible = std::numeric_limits<double>::lowest() / 1e6;  // sums stay finite

// One series of one run, ready for the likelihood.
struct Block {
    const ResidualSeries* run = nullptr;
    std::size_t series = 0;
    MatrixXd residual_and_absorbed;  // x, then an orthonormal basis of the part absorbed by the fit
};

// A symmetric matrix as Q T Q', T tridiagonal: a solution with 1 + a T takes a time that grows with
// the number of points, where the eigenvectors would take nine times that of Q.
using Decomposition = Eigen::Tridiagonalization<MatrixXd>;

// V0 + a K with V0 = L L': Q' L^-1 [x, U] for L^-1 K L^-T = Q T Q'.
struct Spectrum {
    VectorXd diagonal;     // of T
    VectorXd subdiagonal;  // one less
    MatrixXd rotated;
    double log_determinant = 0;  // of V0
};

// log likelihood of V = V0 + a K, up to a constant: with U orthonormal, ln|Q'VQ| = ln|V| +
// ln|U'V^-1 U|, and x'Q(Q'VQ)^-1 Q'x = x'V^-1 x less the part explained by U.
double log_likelihood(const Spectrum& at, double a) {
    // 1 + a T = B D B', B with a diagonal of ones.
    RowMajor left = at.rotated;
    VectorXd pivot(left.rows());
    pivot[0] = 1 + a * at.diagonal[0];
    for (Index k = 1; k < left.rows(); ++k) {
        const double beside = a * at.subdiagonal[k - 1];
        const double factor = beside / pivot[k - 1];
        pivot[k] = 1 + a * at.diagonal[k] - factor * beside;
        left.row(k) -= factor * left.row(k - 1);
    }
    const MatrixXd square = left.transpose() * pivot.cwiseInverse().asDiagonal() * left;
    double log_determinant = at.log_determinant + pivot.array().log().sum();
    double quadratic = square(0, 0);
    const Index absorbed = square.rows() - 1;
    if (absorbed > 0) {
        const Eigen::LLT<MatrixXd> inner(MatrixXd(square.bottomRightCorner(absorbed, absorbed)));
        const VectorXd cross = square.col(0).tail(absorbed);
        quadratic -= cross.dot(inner.solve(cross));
        log_determinant += 2 * inner.matrixLLT().diagonal().array().log().sum();
    }
    const double likelihood = -(log_determinant + quadratic) / 2;
    // A covariance that is singular by rounding is no candidate.
    return std::isfinite(likelihood) ? likelihood : impossible;
}

// `root`: of the covariance of the run's parameters.
Block block_of(const ResidualSeries& run, std::size_t series, const MatrixXd& root) {
    const MatrixXd seen = run.by_parameter[series] * root;
    const Eigen::SelfAdjointEigenSolver<MatrixXd> principal(MatrixXd(seen.transpose() * seen));
    const VectorXd& share = principal.eigenvalues();
    Index absorbed = 0;
    while (absorbed < share.size() && share[share.size() - 1 - absorbed] > absorbed_share) {
        ++absorbed;
    }
    absorbed = std::min(absorbed, seen.rows() - 1);
    Block block{&run, series, MatrixXd(seen.rows(), absorbed + 1)};
    block.residual_and_absorbed.col(0) = run.residual[series];
    block.residual_and_absorbed.rightCols(absorbed) =
        seen * principal.eigenvectors().rightCols(absorbed) *
        share.tail(absorbed).cwiseSqrt().cwiseInverse().asDiagonal();
    return block;
}

bool same_grid(const ResidualSeries& a, const ResidualSeries& b) {
    return a.time_s == b.time_s && a.noise == b.noise && a.window_s == b.window_s;
}

// Possible shape of a part of the noise.
struct Candidate {
    NoiseShape shape;
    std::vector<std::pair<const ResidualSeries*, Decomposition>> known{};

    // Beside white noise: series on the same grid share it, except for the phase, whose noise
    // depends on the wave's size.
    const Decomposition& beside_white(const ResidualSeries& run) {
        const auto found = std::ranges::find_if(known, [&](const auto& each) {
            return each.first == &run || (!shape.of_phase && same_grid(*each.first, run));
        });
        return found != known.end() ? found->second
                                    : known.emplace_back(&run, part_covariance(shape, run)).second;
    }
};

bool concerns(const NoiseShape& shape, std::size_t series) {
    return !shape.of_phase || series == ResidualSeries::phase;
}

class Search {
public:
    Search(const std::vector<ResidualSeries>& series, const Posterior& posterior, double longest_s,
           const JobControl& job)
        : job_(job) {
        for (const ResidualSeries& run : series) {
            const MatrixXd root = posterior.root_of(run.places);
            for (std::size_t k = 0; k < 4 && !job.cancelled(); ++k) {
                constexpr double nothing = 1e-6;
                // The phase is lost.
                if (!run.residual[k].isZero(nothing)) {
                    blocks_.push_back(block_of(run, k, root));
                }
            }
        }
        for (int k = 0; k < widths; ++k) {
            const double width = std::ldexp(narrowest_width / longest_s, k);
            common_.push_back({{width, false}});
            phase_.push_back({{width, true}});
        }
        common_.push_back({{std::numeric_limits<double>::infinity(), false}});
        phase_.push_back({{0, true}});
    }

    ResidualNoise find() {
        ResidualNoise noise;
        std::vector<ResidualNoise::Part> given;
        bool left_common = true;
        bool left_phase = true;
        while ((left_common || left_phase) && !job_.cancelled()) {
            std::optional<Trial> best;
            const double now = likelihood_of(given);
            for (const bool phase : {false, true}) {
                if (phase ? left_phase : left_common) {
                    Trial trial = try_shapes(phase ? phase_ : common_, given);
                    if (!best || trial.top > best->top) {
                        best = std::move(trial);
                    }
                }
            }
            // Without any finite likelihood the residual shows no colour.
            if (!(best->top >= now + least_rise) || now <= impossible || job_.cancelled()) {
                break;
            }
            given.push_back(best->part);
            noise.rise += best->top - now;
            noise.narrowest =
                noise.narrowest || best->part.shape.half_width_hz == common_[0].shape.half_width_hz;
            add_mean(*best, noise.parts);
            (best->part.shape.of_phase ? left_phase : left_common) = false;
        }
        return noise;
    }

private:
    struct Trial {
        double top = impossible;
        ResidualNoise::Part part;
        struct Row {
            double likelihood = impossible;
            ResidualNoise::Part part;
            bool evaluated = false;
        };
        std::vector<Row> table;
    };

    // V of the windows' noise and the given parts in a block.
    MatrixXd covariance(const Block& block, const std::vector<ResidualNoise::Part>& given) const {
        const Index n = block.residual_and_absorbed.rows();
        MatrixXd v =
            is_white(block.run->correlation) ? MatrixXd::Identity(n, n) : block.run->correlation;
        for (const ResidualNoise::Part& part : given) {
            if (concerns(part.shape, block.series)) {
                v += part.variance * part_covariance(part.shape, *block.run);
            }
        }
        return v;
    }

    // Spectrum of V0 only: K = 0.
    Spectrum plain(const Block& block, const std::vector<ResidualNoise::Part>& given) const {
        Spectrum at;
        at.rotated = block.residual_and_absorbed;
        at.diagonal = VectorXd::Zero(at.rotated.rows());
        at.subdiagonal = VectorXd::Zero(at.rotated.rows() - 1);
        if (!is_white(block, given)) {
            const Eigen::LLT<MatrixXd> factor(covariance(block, given));
            factor.matrixL().solveInPlace(at.rotated);
            at.log_determinant = 2 * factor.matrixLLT().diagonal().array().log().sum();
        }
        return at;
    }

    double likelihood_of(const std::vector<ResidualNoise::Part>& given) const {
        double sum = 0;
        for (const Block& block : blocks_) {
            sum += log_likelihood(plain(block, given), 0);
        }
        return sum;
    }

    // Spectra of one shape in all blocks.
    std::vector<Spectrum> spectra(Candidate& candidate,
                                  const std::vector<ResidualNoise::Part>& given) const {
        const NoiseShape& shape = candidate.shape;
        std::vector<Spectrum> all;
        for (const Block& block : blocks_) {
            if (!concerns(shape, block.series) || job_.cancelled()) {
                continue;
            }
            Spectrum at;
            at.rotated = block.residual_and_absorbed;
            if (is_white(block, given)) {
                rotate(candidate.beside_white(*block.run), at);
            } else {
                const Eigen::LLT<MatrixXd> factor(covariance(block, given));
                MatrixXd k = part_covariance(shape, *block.run);
                factor.matrixL().solveInPlace(k);
                k.transposeInPlace();
                factor.matrixL().solveInPlace(k);
                factor.matrixL().solveInPlace(at.rotated);
                at.log_determinant = 2 * factor.matrixLLT().diagonal().array().log().sum();
                rotate(Decomposition((k + k.transpose()) / 2), at);
            }
            all.push_back(std::move(at));
        }
        return all;
    }

    static void rotate(const Decomposition& of, Spectrum& at) {
        at.diagonal = of.diagonal();
        at.subdiagonal = of.subDiagonal();
        at.rotated.applyOnTheLeft(of.matrixQ().adjoint());
    }

    static bool is_white(const MatrixXd& correlation) { return correlation.size() == 0; }

    // Whether V0 of a block is the unit matrix.
    static bool is_white(const Block& block, const std::vector<ResidualNoise::Part>& given) {
        return is_white(block.run->correlation) &&
               std::ranges::none_of(given, [&](const ResidualNoise::Part& part) {
                   return concerns(part.shape, block.series);
               });
    }

    Trial try_shapes(std::vector<Candidate>& shapes,
                     const std::vector<ResidualNoise::Part>& given) const {
        const auto steps =
            static_cast<std::size_t>(std::lround((last_decade - first_decade) / decade_step)) + 1;
        Trial trial;
        trial.table.resize(shapes.size() * steps);
        double unconcerned = 0;
        for (const Block& block : blocks_) {
            if (!concerns(shapes.front().shape, block.series)) {
                unconcerned += log_likelihood(plain(block, given), 0);
            }
        }
        trial.part.shape = shapes.front().shape;
        const auto row = [&](std::size_t k, std::size_t step) -> Trial::Row& {
            return trial.table[k * steps + step];
        };
        const auto evaluate = [&](std::size_t k, const std::vector<Spectrum>& all,
                                  std::size_t step) {
            const double a = std::pow(10, first_decade + decade_step * static_cast<double>(step));
            double sum = unconcerned;
            for (const Spectrum& at : all) {
                sum += log_likelihood(at, a);
            }
            row(k, step) = {sum, {shapes[k].shape, a}, true};
            return sum;
        };
        // A coarse grid of variances first, then those around the best with a weight.
        tbb::parallel_for(std::size_t{0}, shapes.size(), [&](std::size_t k) {
            if (job_.cancelled()) {
                return;
            }
            const std::vector<Spectrum> all = spectra(shapes[k], given);
            double best = impossible;
            for (std::size_t step = 0; step < steps; step += coarse_step) {
                best = std::max(best, evaluate(k, all, step));
            }
            for (bool more = true; more && !job_.cancelled();) {
                more = false;
                for (std::size_t step = 0; step < steps; ++step) {
                    const std::size_t from = step - std::min(step, coarse_step - 1);
                    const std::size_t to = std::min(step + coarse_step, steps);
                    bool near = false;
                    for (std::size_t other = from; other < to; ++other) {
                        near = near || (row(k, other).evaluated &&
                                        row(k, other).likelihood >= best - hopeless);
                    }
                    if (near && !row(k, step).evaluated) {
                        best = std::max(best, evaluate(k, all, step));
                        more = true;
                    }
                }
            }
        });
        for (const Trial::Row& each : trial.table) {
            if (each.likelihood > trial.top) {
                trial.top = each.likelihood;
                trial.part = each.part;
            }
        }
        return trial;
    }

    static void add_mean(const Trial& trial, std::vector<ResidualNoise::Part>& parts) {
        double sum = 0;
        for (const Trial::Row& row : trial.table) {
            sum += std::exp(row.likelihood - trial.top);
        }
        for (const Trial::Row& row : trial.table) {
            const double weight = std::exp(row.likelihood - trial.top);
            if (weight > negligible_weight) {
                parts.push_back({row.part.shape, row.part.variance * weight / sum});
            }
        }
    }

    const JobControl& job_;
    std::vector<Block> blocks_;
    std::vector<Candidate> common_;
    std::vector<Candidate> phase_;
};

// The series of a run, `merge` consecutive windows averaged into one; a remainder at the end is
// ignored. Averages keep unit white noise and reduce correlated noise.
ResidualSeries residual_series(const FitProblem& problem, const Posterior& posterior,
                               std::size_t index, std::size_t merge) {
    const ScaledRun& run = problem.runs[index];
    const Linearised& at = posterior.runs[index];
    const auto points = static_cast<Eigen::Index>(run.size() / merge);
    ResidualSeries out;
    const RunColumns own = columns_of(problem.layout, index, posterior.active);
    out.places = own.places;
    const double usual_sd = 1 / median(run.weight);
    const double share = 1 / static_cast<double>(merge);
    const double keeps_noise = std::sqrt(share);
    out.window_s = run.window_s * static_cast<double>(merge);
    out.correlation = merged_correlation(run.correlation, merge, points);
    out.time_s.assign(static_cast<std::size_t>(points), 0);
    out.size = out.noise = Eigen::VectorXd::Zero(points);
    out.residual.fill(Eigen::VectorXd::Zero(points));
    out.by_parameter.fill(
        Eigen::MatrixXd::Zero(points, static_cast<Eigen::Index>(own.columns.size())));
    for (Eigen::Index k = 0; k < points * static_cast<Eigen::Index>(merge); ++k) {
        const auto window = static_cast<std::size_t>(k);
        const Eigen::Index point = k / static_cast<Eigen::Index>(merge);
        const double weight = run.weight[window];
        const auto left = at.residual.segment<4>(4 * k);
        // Noise of both channels is alike in the frame of the whitened channels.
        const Vector2cd y = run.whitening * run.z[window];
        const Vector2cd z = y - of_real_parts(left) / weight;
        const double size = z.norm();
        const Vector2cd u = z / size;
        const Vector2cd v(-std::conj(u[1]), std::conj(u[0]));
        const Complex along_y = u.dot(y) / size;
        const bool clear = size * weight > clear_amplitude;
        const Complex along = weight * size * (clear ? std::log(along_y) : along_y - 1.0);
        const Complex turn = clear ? std::polar(1.0, -std::arg(along_y)) : 1.0;
        const Complex across = weight * v.dot(y) * turn;
        const std::array<double, 4> residual{along.real(), along.imag(), across.real(),
                                             across.imag()};
        const std::array<Vector2cd, 4> axis{u, i * u, v, i * v};
        out.time_s[static_cast<std::size_t>(point)] += share * run.time_s[window];
        out.size[point] += share * weight * size;
        out.noise[point] += share * usual_sd * weight;
        for (std::size_t s = 0; s < 4; ++s) {
            out.residual[s][point] += keeps_noise * residual[s];
            const Eigen::RowVector4d row = real_parts(axis[s]).transpose();
            const Eigen::RowVectorXd by = row * at.by_parameter.middleRows<4>(4 * k);
            out.by_parameter[s].row(point) += keeps_noise * by(own.columns);
        }
    }
    return out;
}

}  // namespace

NoiseEstimate::NoiseEstimate(const FitProblem& problem, const Posterior& posterior,
                             const JobControl& job) {
    for (std::size_t k = 0; k < problem.runs.size() && !job.cancelled(); ++k) {
        const std::size_t merge = (problem.runs[k].size() + most_points - 1) / most_points;
        series.push_back(residual_series(problem, posterior, k, merge));
    }
    if (!job.cancelled()) {
        static_cast<ResidualNoise&>(*this) =
            Search(series, posterior, longest_s(problem), job).find();
    }
}

std::array<MatrixXd, 2> NoiseEstimate::part_sums(const ResidualSeries& run) const {
    const MatrixXd none = MatrixXd::Zero(run.size.size(), run.size.size());
    std::array<MatrixXd, 2> sums{none, none};
    for (const Part& part : parts) {
        sums[part.shape.of_phase ? 1 : 0] += part.variance * part_covariance(part.shape, run);
    }
    return sums;
}

MatrixXd NoiseEstimate::covariance(const Posterior& posterior) const {
    if (as_expected()) {
        return posterior.data;
    }
    const Index size = posterior.covariance.rows();
    MatrixXd sum = MatrixXd::Zero(size, size);
    for (const ResidualSeries& run : series) {
        const auto [common, of_phase] = part_sums(run);
        for (std::size_t k = 0; k < 4; ++k) {
            const MatrixXd& x = run.by_parameter[k];
            sum(run.places, run.places) += x.transpose() * common * x;
            if (k == ResidualSeries::phase) {
                sum(run.places, run.places) += x.transpose() * of_phase * x;
            }
        }
    }
    return posterior.data + posterior.root.transpose() * sum * posterior.root;
}

double widening(const FitProblem& problem, const Posterior& white, const JobControl& job) {
    const Eigen::MatrixXd coloured = NoiseEstimate(problem, white, job).covariance(white);
    double most = 1;
    for (std::size_t k = 0; k < white.active.size() && white.active[k] < rate_count; ++k) {
        const auto at = static_cast<Eigen::Index>(k);
        const Eigen::RowVectorXd row = white.root.row(at);
        most = std::max(most, (row * coloured).dot(row) / (row * white.data).dot(row));
    }
    return most;
}

}  // namespace vybeg
