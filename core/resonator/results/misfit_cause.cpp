#include "core/resonator/results/misfit_cause.h"

#include "core/numerics/spectral_density.h"
#include "core/resonator/fit/score_test.h"
#include "core/resonator/results/channel_findings.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <complex>
#include <limits>
#include <numbers>
#include <span>
#include <utility>
#include <vector>

namespace vybeg {
namespace {

using Complex = std::complex<double>;
using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::Vector2cd;
using std::numbers::pi;

constexpr Complex i{0, 1};

// Share of the excess chi^2 that a cause must explain. The decay and the neighbours of a line
// remain in the residual.
constexpr double most_of_it = 0.8;
constexpr double most_by_line = 0.5;
constexpr double least_fall = 25;
constexpr double least_cycles = 3;  // least distance of a line from the wave, cycles over a run
constexpr double lines_per_cycle = 3;
constexpr double most_lines = 1e5;

double wave_hz_of(const FittedSet& set, const Posterior& at) {
    return set.fine[0].f_ref_hz + at.p[set.problem->layout.at(0, frequency_at)];
}

// A line at `f_hz` that decays: both parts of its phasor in each channel and run.
Effect line_effect(const FittedSet& set, double f_hz, double decay_per_s) {
    return effect_by_window(
        *set.problem, 4 * static_cast<Index>(set.fine.size()),
        [&](std::size_t k, const ScaledRun& run, std::size_t window, MatrixXd& by) {
            const double t = run.time_s[window];
            const Complex turn =
                std::polar(std::exp(-decay_per_s * t), 2 * pi * (f_hz - set.fine[k].f_ref_hz) * t);
            const auto first = 4 * static_cast<Index>(k);
            put_effect(by, run, window, first, {turn, 0});
            put_effect(by, run, window, first + 1, {i * turn, 0});
            put_effect(by, run, window, first + 2, {0, turn});
            put_effect(by, run, window, first + 3, {0, i * turn});
        });
}

// Residual of a run, weighted for a mode that decays like the wave.
struct DampedResidual {
    double f_ref_hz = 0;
    double step_s = 0;
    std::vector<double> time_s;
    std::vector<Vector2cd> left;
    double norm = 0;
};

std::vector<DampedResidual> damped_residuals(const FittedSet& set, const Posterior& at) {
    std::vector<DampedResidual> all;
    for (std::size_t k = 0; k < set.fine.size(); ++k) {
        const ScaledRun& run = set.problem->runs[k];
        DampedResidual damped{set.fine[k].f_ref_hz, run.step_s, run.time_s, {}, 0};
        for (std::size_t window = 0; window < run.size(); ++window) {
            const double size =
                run.weight[window] * std::exp(-std::abs(at.p[decay_at]) * run.time_s[window]);
            const auto left = at.runs[k].residual.segment<4>(4 * static_cast<Index>(window));
            damped.left.push_back(size * of_real_parts(left));
            damped.norm += size * size;
        }
        all.push_back(std::move(damped));
    }
    return all;
}

// Power of a line at `f_hz` in the squared residual of a run, without the part absorbed by the
// parameters.
double line_power(const DampedResidual& run, double f_hz) {
    const double rate = -2 * pi * (f_hz - run.f_ref_hz);
    const Complex step = std::polar(1.0, rate * run.step_s);
    Vector2cd along = Vector2cd::Zero();
    Complex turn;
    double last_s = -std::numeric_limits<double>::infinity();
    for (std::size_t window = 0; window < run.time_s.size(); ++window) {
        const double t = run.time_s[window];
        const bool follows = std::abs(t - last_s - run.step_s) < 1e-6 * run.step_s;
        turn = follows ? turn * step : std::polar(1.0, rate * t);
        along += turn * run.left[window];
        last_s = t;
    }
    return along.squaredNorm() / run.norm;
}

double line_power(const std::vector<DampedResidual>& runs, double f_hz) {
    double sum = 0;
    for (const DampedResidual& run : runs) {
        sum += line_power(run, f_hz);
    }
    return sum;
}

// line_power() of a run at the nearest frequency of a fine transform: within a tenth about a peak.
class LineSpectrum {
public:
    explicit LineSpectrum(const DampedResidual& run) : run_(run) {
        constexpr std::size_t finer = 8;  // than a cycle over the run
        constexpr double on_grid = 1e-3;
        constexpr std::size_t most_gaps = 16;  // the transform is as long as the run
        std::vector<std::size_t> places;
        for (const double t : run.time_s) {
            const double steps = (t - run.time_s.front()) / run.step_s;
            if (std::abs(steps - std::round(steps)) > on_grid) {
                return;  // no grid: where samples were lost
            }
            places.push_back(static_cast<std::size_t>(std::lround(steps)));
        }
        if (places.empty() || places.back() > most_gaps * places.size()) {
            return;
        }
        std::vector<Complex> c(std::bit_ceil(finer * (places.back() + 1)));
        std::vector<Complex> d(c.size());
        for (std::size_t window = 0; window < places.size(); ++window) {
            c[places[window]] = run.left[window][0];
            d[places[window]] = run.left[window][1];
        }
        power_ = bin_powers(std::move(c), std::move(d));
    }

    double at(double f_hz) const {
        if (power_.empty()) {
            return line_power(run_, f_hz);
        }
        const auto size = std::ssize(power_);
        const auto bin =
            std::lround((f_hz - run_.f_ref_hz) * run_.step_s * static_cast<double>(size)) % size;
        return power_[static_cast<std::size_t>(bin < 0 ? bin + size : bin)] / run_.norm;
    }

private:
    const DampedResidual& run_;
    std::vector<double> power_;
};

// Frequency of a line in the fine windows, among those `spacing_hz` apart that merged windows do
// not distinguish.
double unaliased(const FittedSet& set, const Posterior& at, double f_hz, double spacing_hz,
                 const JobControl& job) {
    const FitProblem& problem = *set.problem;
    const std::span<const PhasorRun> fine = set.fine;
    std::vector<DampedResidual> residuals;
    double band_hz = 0;
    for (std::size_t k = 0; k < fine.size(); ++k) {
        ScaledRun frame = scaled_run(fine[k], set.scale);  // of the fit, with the fine windows
        band_hz = std::max(band_hz, 0.5 / frame.step_s);
        frame.duration_s = problem.runs[k].duration_s;
        frame.reference_s = problem.runs[k].reference_s;
        frame.power = problem.runs[k].power;
        const std::vector<Vector2cd> model = expected_phasors(
            frame, at.p.head(shared_count), own_of(problem.layout, at.p, k), frame.size());
        DampedResidual damped{fine[k].f_ref_hz, frame.step_s, frame.time_s, {}, 1};
        for (std::size_t window = 0; window < frame.size(); ++window) {
            const double size = std::exp(-std::abs(at.p[decay_at]) * frame.time_s[window]);
            damped.left.push_back(size * (frame.z[window] - model[window]));
        }
        residuals.push_back(std::move(damped));
    }
    const double wave_hz = wave_hz_of(set, at);
    const auto reach = static_cast<int>(band_hz / spacing_hz) + 1;
    double best_hz = f_hz;
    double most = 0;
    for (int alias = -reach; alias <= reach && !job.cancelled(); ++alias) {
        const double there_hz = f_hz + alias * spacing_hz;
        if (std::abs(there_hz - wave_hz) > band_hz) {
            continue;
        }
        const double power = line_power(residuals, there_hz);
        if (power > most) {
            most = power;
            best_hz = there_hz;
        }
    }
    return best_hz;
}

struct Line {
    double f_hz = 0;
    double fall = 0;
    double per_cent = 0;
};

// The strongest line within the windows' band, away from the wave.
Line strongest_line(const FittedSet& set, const Posterior& at, const JobControl& job) {
    const FitProblem& problem = *set.problem;
    const double longest = longest_s(problem);
    const double step_s = std::ranges::min(problem.runs, {}, &ScaledRun::step_s).step_s;
    const double wave_hz = wave_hz_of(set, at);
    const double step_hz = 1 / (lines_per_cycle * longest);
    const double band_hz = 0.5 / step_s;
    const std::vector<DampedResidual> residuals = damped_residuals(set, at);
    const std::vector<LineSpectrum> spectra(residuals.begin(), residuals.end());
    const auto steps =
        static_cast<int>(std::min((band_hz - least_cycles / longest) / step_hz, most_lines));
    std::vector<std::pair<double, double>> lines;  // frequency, power nearby
    for (int step = 0; step < steps && !job.cancelled(); ++step) {
        const double off = least_cycles / longest + step * step_hz;
        for (const double f_hz : {wave_hz - off, wave_hz + off}) {
            double power = 0;
            for (const LineSpectrum& spectrum : spectra) {
                power += spectrum.at(f_hz);
            }
            lines.emplace_back(f_hz, power);
        }
    }
    constexpr double nearly = 0.7;  // of the strongest
    double least = 0;
    for (const auto& [f_hz, power] : lines) {
        least = std::max(least, nearly * power);
    }
    Line best;
    double most = 0;
    for (const auto& [f_hz, nearby] : lines) {
        if (nearby < least || job.cancelled()) {
            continue;
        }
        const double power = line_power(residuals, f_hz);
        if (power > most) {
            most = power;
            best.f_hz = f_hz;
        }
    }
    if (most == 0) {
        return best;
    }
    const Score line = score(problem, at, line_effect(set, best.f_hz, std::abs(at.p[decay_at])));
    best.fall = line.fall;
    best.f_hz = unaliased(set, at, best.f_hz, 1 / step_s, job);
    const double turn = pi * (best.f_hz - wave_hz) * problem.runs[0].window_s;
    const double kept = turn == 0 ? 1 : std::abs(std::sin(turn) / turn);
    best.per_cent = 100 * line.size.head(4).norm() / kept / problem.runs[0].z[0].norm();
    return best;
}

// The line nearer to the wave that leaves only noise, decaying like the wave or steady: noise of a
// finite width leaves more.
Line nearest_line(const FittedSet& set, const Posterior& at, const JobControl& job) {
    constexpr double nearest = 0.4;  // cycles over a run
    constexpr double step = 1.0 / 6;
    const FitProblem& problem = *set.problem;
    const double longest = longest_s(problem);
    const double wave_hz = wave_hz_of(set, at);
    double needed = at.chi2() - noise_limit(degrees_of_freedom(problem));
    Line best;
    for (double cycles = nearest; cycles < least_cycles + 1 && !job.cancelled(); cycles += step) {
        for (const double off_hz : {cycles / longest, -cycles / longest}) {
            for (const double decay_per_s : {std::abs(at.p[decay_at]), 0.0}) {
                const Score line =
                    score(problem, at, line_effect(set, wave_hz + off_hz, decay_per_s));
                if (line.fall > needed) {
                    needed = line.fall;
                    best = {wave_hz + off_hz, line.fall,
                            100 * line.size.head(4).norm() / problem.runs[0].z[0].norm()};
                }
            }
        }
    }
    return best;
}

// `near`: closer to the wave than a filter separates.
std::vector<MessageArg> line_args(const Line& line, int digits, bool near) {
    return {number_arg(line.f_hz, digits), number_arg(line.per_cent, 2),
            near ? Phrase::tr("so close to the carrier the gain or the phase of a channel that "
                              "settles or follows the amplitude, or another mode")
                 : Phrase::tr("another mode, or a disturbance that folds there"),
            near ? Phrase::tr("does not remove it: record after the channels have settled, or with "
                              "a smaller amplitude")
                 : Phrase::tr("removes it")};
}

}  // namespace

MessageArg friction_words(double exponent) {
    if (exponent < 0) {
        return Phrase::tr("dry friction");
    }
    return exponent < 1.5 ? Phrase::tr("the friction of air") : Phrase::tr("the squared amplitude");
}

std::optional<MisfitCause> misfit_cause(const FittedSet& set, const Posterior& posterior,
                                        Causes causes, const JobControl& job) {
    const FitProblem& problem = *set.problem;
    const double beyond = posterior.chi2() - degrees_of_freedom(problem);
    double best = std::max(most_of_it * beyond, least_fall);
    std::optional<MisfitCause> cause;
    const auto consider = [&](double fall, DiagnosticKind kind, std::vector<MessageArg> args) {
        if (fall > best) {
            best = fall;
            cause = MisfitCause{{kind, std::move(args)}, fall};
        }
    };
    // In the free model the channels are any two projections.
    const bool structured = problem.priors.sd[free_rotation_at] == 0;
    for (const ToleratedError& error : channel_errors) {
        const bool held = problem.priors.sd[error.parameter] == 0 && error.source != kappa_error;
        if (structured && held) {
            const Score found = parameter_score(problem, posterior, error.parameter);
            consider(found.fall, DiagnosticKind::misfit_channel,
                     named_error(error, found.size[0], set.fine[0].f_ref_hz));
        }
    }
    if (structured) {
        const Score springs = score(problem, posterior, springs_effect(problem, posterior));
        consider(springs.fall, DiagnosticKind::misfit_springs,
                 {number_arg(springs.size.norm(), 2)});
    }
    double largest = 0;  // of all |z|, scaled units
    for (const ScaledRun& run : problem.runs) {
        for (const Vector2cd& z : run.z) {
            largest = std::max(largest, z.norm());
        }
    }
    for (const int exponent : {-1, 1, 2}) {
        const Score damping =
            score(problem, posterior, damping_effect(problem, posterior, exponent));
        const double share = damping.size[0] * std::pow(largest, exponent) /
                             std::max(std::abs(posterior.p[decay_at]), 1e-300);
        // A friction takes energy; only the squared amplitude can be a term of either sign.
        if (exponent == 2 || share > 0) {
            consider(damping.fall, DiagnosticKind::misfit_damping,
                     {friction_words(exponent), number_arg(100 * share, 2)});
        }
    }
    // The gain depends on |c|^2; the largest scaled amplitude is 1.
    const Score pickoff = score(problem, posterior, pickoff_effect(problem, posterior));
    // A gain that changes by more than itself is that of a channel without a wave.
    if (pickoff.size.cwiseAbs().maxCoeff() < 1) {
        consider(pickoff.fall, DiagnosticKind::misfit_pickoff,
                 {number_arg(100 * pickoff.size[0], 2), number_arg(100 * pickoff.size[1], 2)});
    }
    const SettlingScore settling = settling_score(problem, posterior);
    if (settling.fall > 0) {
        consider(settling.fall, DiagnosticKind::misfit_settling,
                 {number_arg(settling.most_hz, 2), number_arg(settling.time_s, 2)});
    }
    // Logs without a phase have no frequencies.
    const bool no_lines = causes == Causes::without_lines || problem.runs.front().phase_lost;
    if (cause || no_lines || job.cancelled()) {
        return cause;
    }
    const Line line = strongest_line(set, posterior, job);
    best = std::max(most_by_line * beyond, least_fall);
    consider(line.fall, DiagnosticKind::misfit_neighbour, line_args(line, 6, false));
    if (!cause) {
        const Line near = nearest_line(set, posterior, job);
        consider(near.fall, DiagnosticKind::misfit_neighbour, line_args(near, 8, true));
    }
    return cause;
}

}  // namespace vybeg
