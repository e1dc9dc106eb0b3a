#include "core/resonator/results/channel_findings.h"

#include "core/numerics/dense_solvers.h"
#include "core/numerics/statistics.h"
#include "core/resonator/fit/score_test.h"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <numbers>
#include <utility>

namespace vybeg {
namespace {

using std::numbers::pi;

constexpr double most_tolerances = 3;
constexpr double by_chance = 2e-3;       // probability of a quadrature that follows the angle
constexpr std::size_t least_angles = 4;  // for the line through the quadratures and its scatter
constexpr double one_angle = 0.1;        // rad of 2theta: recordings nearer are a point of the line
constexpr double least_spread = 0.1;     // of the angles: sum of squares of an error's shape
constexpr double earth_rate_rad_s = 7.2921e-5;
constexpr double bryan = 0.277;        // d theta_A/dt = -bryan * omega, METHOD.md 8
constexpr double most_phase = 1;       // rad, of a channel that comes late
constexpr double passive_share = 0.9;  // of the greatest anisotropy
constexpr double passive_within = 2;   // combined uncertainties

// Upper bound, close where it is small, of the probability that the correlation of n uncorrelated
// pairs has 1 - r^2 below `rest`.
double chance_of(double rest, std::size_t n) {
    const double half = static_cast<double>(n - 2) / 2;
    const double beta = std::tgamma(half) * std::tgamma(0.5) / std::tgamma(half + 0.5);
    return std::pow(rest, half) / (half * beta * std::sqrt(std::max(1 - rest, 1e-6)));
}

const ToleratedError& error_of(SharedParameter parameter) {
    return *std::ranges::find(channel_errors, parameter, &ToleratedError::parameter);
}

// A ratio a_B/a_A at the start of a recording.
struct Quadrature {
    double two_theta = 0;  // from the electrode of C
    double ratio = 0;
    double variance = 0;
};

// The mean of recordings at one angle.
Quadrature mean_of(const std::vector<Quadrature>& all) {
    const auto count = static_cast<double>(all.size());
    Quadrature mean{all.front().two_theta, 0, 0};
    double variance = 0;
    for (const Quadrature& each : all) {
        mean.ratio += each.ratio / count;
        variance += each.variance / (count * count);
    }
    double square = 0;
    for (const Quadrature& each : all) {
        square += (each.ratio - mean.ratio) * (each.ratio - mean.ratio);
    }
    mean.variance = std::max(variance, square / (count * std::max(count - 1, 1.0)));
    return mean;
}

struct Followed {
    double size = 0;
    double chance = 1;
};

// The quadratures as a constant and a part that an error of unit size adds by `shape`.
template <class Shape>
Followed followed_by(const std::vector<Quadrature>& all, const Shape& shape) {
    const auto count = static_cast<double>(all.size());
    const LineFit line = fit_line(all.size(), [&](std::size_t k) {
        return LinePoint{shape(all[k].two_theta), all[k].ratio, 1};
    });
    double floor = 0;
    double square = 0;
    for (const Quadrature& each : all) {
        floor += each.variance * (count - 2) / count;
        square += (each.ratio - line.mean_y) * (each.ratio - line.mean_y);
    }
    if (!(line.spread > least_spread) || !(square > 0)) {
        return {};
    }
    const double explained = line.slope * line.slope * line.spread;
    const double rest = std::max(square - explained, floor);
    return {line.slope, chance_of(rest / (explained + rest), all.size())};
}

class Findings {
public:
    Findings(const FittedSet& set, const ResonatorFit& fit) : set_(set), fit_(fit) {}

    std::vector<Diagnostic> found(bool white) {
        add_left_priors();
        if (white) {
            add_held();
        }
        if (!add_quadrature()) {
            add_rotation();
        }
        add_anisotropy();
        return std::move(found_);
    }

private:
    double tolerance_of(const ToleratedError& error) const { return set_.tolerance[error.source]; }

    // An error of the channels with its size.
    void add(DiagnosticKind kind, const ToleratedError& error, double size) {
        found_.push_back({kind, named_error(error, size, f_ref_hz_)});
    }

    void add_left_priors() {
        for (const ToleratedError& error : channel_errors) {
            const Eigen::Index place = posterior_.place_of(error.parameter);
            if (place < 0) {
                continue;
            }
            const double told = problem_.priors.sd[error.parameter];
            const double off =
                posterior_.p[error.parameter] - problem_.priors.mean[error.parameter];
            // Other errors within their tolerances move it, too.
            if (std::abs(off) > most_tolerances * std::hypot(told, set_.moved.row(place).norm())) {
                add(DiagnosticKind::prior_left, error, off);
                found_.back().args.push_back(number_arg(std::abs(off) / told, 2));
            }
        }
    }

    // The error held at zero that leaves its assumed tolerance by most if all of them are opened,
    // each with its tolerance: alone each imitates the others.
    void add_held() {
        std::vector<ToleratedError> held;
        for (const ToleratedError& error : channel_errors) {
            if (problem_.priors.sd[error.parameter] == 0 && tolerance_of(error) > 0) {
                held.push_back(error);
            }
        }
        if (held.empty()) {
            return;
        }
        const auto count = static_cast<Eigen::Index>(held.size());
        Effect effect;
        for (const Linearised& run : posterior_.runs) {
            Eigen::MatrixXd by(run.by_parameter.rows(), count);
            for (Eigen::Index k = 0; k < count; ++k) {
                const ToleratedError& error = held[static_cast<std::size_t>(k)];
                by.col(k) = tolerance_of(error) * run.by_parameter.col(error.parameter);
            }
            effect.push_back(std::move(by));
        }
        // In tolerances; their prior has the precision of one.
        const Score free = score(problem_, posterior_, effect);
        const Eigen::VectorXd size =
            (Eigen::MatrixXd::Identity(count, count) + free.inverse).ldlt().solve(free.size);
        Eigen::Index most = 0;
        if (size.cwiseAbs().maxCoeff(&most) > most_tolerances) {
            const ToleratedError& error = held[static_cast<std::size_t>(most)];
            add(DiagnosticKind::misfit_channel, error, size[most] * tolerance_of(error));
        }
    }

    // A point for each angle, modulo a right angle: two recordings at one angle are one point of
    // what follows the angle.
    std::vector<Quadrature> quadratures() const {
        std::vector<std::vector<Quadrature>> angles;
        for (std::size_t k = 0; k < fit_.runs.size(); ++k) {
            const RunEstimate& run = fit_.runs[k];
            if (run.two_theta_A_rad.given() && run.a_A.given() && run.a_B.given()) {
                const double sd = run.a_B.sd / run.a_A.value;
                const Quadrature found{run.two_theta_A_rad.value + problem_.runs[k].two_theta_zero,
                                       run.a_B.value / run.a_A.value, sd * sd};
                const auto known = std::ranges::find_if(angles, [&](const auto& angle) {
                    return std::abs(std::remainder(found.two_theta - angle.front().two_theta, pi)) <
                           one_angle;
                });
                (known == angles.end() ? angles.emplace_back() : *known).push_back(found);
            }
        }
        std::vector<Quadrature> all;
        std::ranges::transform(angles, std::back_inserter(all), mean_of);
        return all;
    }

    // Rotation (rad/s) that an error of one tolerance looks like.
    double rotation_by(const ToleratedError& error) const {
        return set_.variances.gradient.row(angle_rate_of)
            .dot(set_.moved.col(&error - channel_errors.data()));
    }

    // Share of the rotation that an error does not explain, at most 1: that its size by the
    // quadratures fits the rotation is chance as often as this.
    double left_of_rotation(const ToleratedError& error, double tolerances) const {
        const double by_error = tolerances * rotation_by(error);
        return rotation_.given() && by_error != 0
                   ? std::min(1.0, std::abs(rotation_.value / by_error - 1))
                   : 1;
    }

    bool add_quadrature() {
        const std::vector<Quadrature> all = quadratures();
        if (all.size() < least_angles) {
            return false;
        }
        // a_A a_B = Im(c conj d) of a linear wave, to first order in the error.
        const Followed phase =
            followed_by(all, [](double two_theta) { return -std::sin(2 * two_theta) / 2; });
        const Followed crosstalk = followed_by(
            all, [](double two_theta) { return -std::cos(two_theta) * std::cos(two_theta); });
        const bool is_phase = phase.chance <= crosstalk.chance;
        const Followed& found = is_phase ? phase : crosstalk;
        const ToleratedError& error = error_of(is_phase ? phase_at : crosstalk_at);
        const double tolerances = found.size / tolerance_of(error);
        // The better one of two shapes, and with the rotation the product of two probabilities,
        // which is below q with the probability q (1 - ln q).
        const double alone = std::min(1.0, 2 * found.chance);
        const double left = left_of_rotation(error, tolerances);
        const double both = alone * left;
        const double chance = left < 1 ? both * (1 - std::log(both)) : alone;
        if (!(std::abs(tolerances) > most_tolerances) || chance > by_chance) {
            return false;
        }
        add(DiagnosticKind::quadrature_by_channel, error, found.size);
        return true;
    }

    // A rotation that neither the Earth nor the delay's tolerance makes is one of the base, or a
    // larger delay of a channel, which the motion does not show.
    void add_rotation() {
        const ToleratedError& error = error_of(phase_at);
        const double assumed = tolerance_of(error);
        if (!(assumed > 0) || !rotation_.given() ||
            !(std::abs(rotation_.value) - most_tolerances * rotation_.uncertainty() >
              bryan * earth_rate_rad_s)) {
            return;
        }
        const double phase = rotation_.value / rotation_by(error) * assumed;
        if (std::abs(phase) < most_phase) {
            add(DiagnosticKind::rotation_or_channel, error, phase);
            std::vector<MessageArg>& args = found_.back().args;
            args.insert(args.begin(), number_arg(rotation_.value * 180 / pi * 3600, 3, "deg/h"));
        }
    }

    void add_anisotropy() {
        const Estimate& g = fit_.resonator.damping_anisotropy_per_s;
        const double passive = 2 * posterior_.p[decay_at];
        if (g.given() && g.value - passive_within * g.uncertainty() > passive_share * passive) {
            found_.push_back({DiagnosticKind::anisotropy_not_passive,
                              {number_arg(g.value, 3), number_arg(passive, 3)}});
        }
    }

    const FittedSet& set_;
    const ResonatorFit& fit_;
    const FitProblem& problem_ = *set_.problem;
    const Posterior& posterior_ = set_.posterior;
    const Estimate& rotation_ = fit_.resonator.angle_rate_rad_s;
    const double f_ref_hz_ = set_.mean_f_ref_hz();
    std::vector<Diagnostic> found_;
};

}  // namespace

std::vector<MessageArg> named_error(const ToleratedError& error, double size, double f_ref_hz) {
    // Of a log without a phase the frequency is unknown.
    if (error.source == delay_error && !(f_ref_hz > 0)) {
        return {error.name, number_arg(-size, 2, "rad")};
    }
    return {error.name,
            number_arg(size / error.per_unit(f_ref_hz) / error.shown, 2, error.shown_unit)};
}

std::vector<Diagnostic> channel_findings(const FittedSet& set, const ResonatorFit& fit,
                                         bool white) {
    return Findings(set, fit).found(white);
}

}  // namespace vybeg
