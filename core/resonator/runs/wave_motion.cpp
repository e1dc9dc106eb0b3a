#include "core/resonator/runs/wave_motion.h"

#include "core/estimators/wave/wave_state.h"
#include "core/numerics/dense_solvers.h"
#include "core/numerics/phase.h"
#include "core/numerics/statistics.h"
#include "core/resonator/runs/decay.h"
#include "core/resonator/runs/mean_rate.h"
#include "core/resonator/runs/merge_windows.h"

#include <Eigen/Core>

#include <algorithm>
#include <array>
#include <cmath>
#include <complex>
#include <cstddef>
#include <limits>
#include <numbers>
#include <numeric>
#include <span>
#include <vector>

namespace vybeg {
namespace {

using Complex = std::complex<double>;
using Eigen::Index;
using std::numbers::pi;

constexpr std::size_t least_windows = 8;
// Least size of a wave and of its smaller travelling wave, deviations; below it a window is
// excluded.
constexpr double seen = 5;
// Distance of an outlier in robust deviations of the scatter, at least those of the noise.
constexpr double outlier = 6;
// Step of 2theta_A, of period pi, that may as well be one the other way. A wave that passes near
// the circular state turns by almost pi/2.
constexpr double ambiguous_step = std::numbers::pi / 4;

// Series of the listed windows, and the windows of the angle.
struct Motion {
    RateSeries phase;      // rad
    RateSeries amplitude;  // logarithm
    RateSeries theta;      // rad
    RateSeries quadrature;
    std::vector<std::size_t> angles;
    bool branch_lost = false;  // which way the angle turned between two of them
};

void add(RateSeries& series, double time_s, double value, double sd, std::size_t part) {
    series.part.push_back(part);
    series.time_s.push_back(time_s);
    series.value.push_back(value);
    series.sd.push_back(sd);
}

std::size_t breaks_before(const PhasorRun& run, double time_s) {
    const auto behind = std::ranges::upper_bound(run.breaks, time_s, {}, &RunBreak::time_s);
    return static_cast<std::size_t>(behind - run.breaks.begin());
}

// Number of the breaks before a time that change amplitude, angle and quadrature, too.
std::size_t knocks_before(const PhasorRun& run, double time_s) {
    return static_cast<std::size_t>(std::ranges::count_if(run.breaks, [&](const RunBreak& each) {
        return each.kind != BreakKind::phase && each.time_s <= time_s;
    }));
}

// Whether three windows are adjacent, without a break of the phase.
bool in_a_row(const PhasorRun& run, std::size_t before, std::size_t at, std::size_t behind) {
    constexpr double even = 0.01;
    const auto touch = [&](std::size_t j, std::size_t k) {
        return std::abs(run.time_s[k] - run.time_s[j] - run.window_s) < even * run.window_s;
    };
    return touch(before, at) && touch(at, behind) &&
           breaks_before(run, run.time_s[before]) == breaks_before(run, run.time_s[behind]);
}

// Phasors at the centres of windows. A mean over w is z + (w^2/24) z'', which weights the mode
// farther from the reference less; z'' from the neighbours is subtracted. A slope keeps its
// variance, because slow changes pass with a gain of one.
struct Middles : PhasorRun {
    std::vector<double> noise_gain{};  // in units of the variance of one window
};

Middles middles_of(const PhasorRun& run, const std::vector<std::size_t>& windows) {
    constexpr double share = 1.0 / 24;
    Middles out{run, std::vector<double>(run.c.size(), 1)};
    for (std::size_t i = 0; i < windows.size() && windows.size() > 2; ++i) {
        const std::size_t centre = std::clamp<std::size_t>(i, 1, windows.size() - 2);
        const std::size_t before = windows[centre - 1];
        const std::size_t at = windows[centre];
        const std::size_t behind = windows[centre + 1];
        if (!in_a_row(run, before, at, behind)) {
            continue;
        }
        const auto bend = [&](const std::vector<Complex>& z) {
            return share * (z[before] - 2.0 * z[at] + z[behind]);
        };
        out.c[windows[i]] -= bend(run.c);
        out.d[windows[i]] -= bend(run.d);
        out.noise_gain[windows[i]] = i == centre ? std::pow(1 + 2 * share, 2) + 2 * share * share
                                                 : std::pow(1 - share, 2) + 5 * share * share;
    }
    return out;
}

// Variance of the phase noise that a window adds to all later windows: the wave moves from z by a
// transverse part v, which does not count as phase, but noise rotates z towards it, by |v| sd /
// |z|^2. Without the mean contribution of noise to |v|^2; with the product of the noises of two
// windows.
double step_variance(const PhasorRun& run, std::size_t before, std::size_t k, std::size_t behind) {
    const double power = run.power(k);
    const auto across = [&](std::size_t j) {
        return (run.c[k] * run.d[j] - run.d[k] * run.c[j]) *
               std::polar(1.0, -std::arg(run.product(k, j)));
    };
    const double variance = run.sd[k] * run.sd[k];
    const double noise = 2 * (run.sd[before] * run.sd[before] + run.sd[behind] * run.sd[behind]);
    const double v = std::norm(across(behind) - across(before)) / power;
    return ((v - noise) * variance + 4 * variance * variance) / (power * power);
}

// Phase per second between consecutive windows at the usual distance.
double usual_rate(const PhasorRun& run, const std::vector<std::size_t>& windows) {
    Complex sum = 0;
    for (std::size_t i = 1; i < windows.size(); ++i) {
        if (run.time_s[windows[i]] - run.time_s[windows[i - 1]] < 1.5 * run.window_s) {
            sum += run.product(windows[i - 1], windows[i]);
        }
    }
    return std::arg(sum) / run.window_s;
}

// Whether modes beat so fast that differences of three windows do not follow them.
bool beats_fast(const PhasorRun& run, const std::vector<std::size_t>& windows, double rate) {
    constexpr double fast = 0.15;  // rad, root mean square
    const Complex back = std::polar(1.0, -rate * run.window_s);
    double change = 0;
    double power = 0;
    for (std::size_t i = 1; i < windows.size(); ++i) {
        const std::size_t k = windows[i];
        const std::size_t before = windows[i - 1];
        if (run.time_s[k] - run.time_s[before] < 1.5 * run.window_s) {
            change += std::norm(run.c[k] * back - run.c[before]) +
                      std::norm(run.d[k] * back - run.d[before]) -
                      4 * (run.sd[k] * run.sd[k] + run.sd[before] * run.sd[before]);
            power += run.power(k);
        }
    }
    return change > fast * fast * power;
}

constexpr double band = 0.25;  // cycles per window
constexpr Index frequencies = 64;
// Weight of the noise gain, so small that it costs 1e-6 of the signal.
constexpr double regularisation = 1e-6;

// Phasors between the centres of windows, from the means of 2 reach consecutive windows: the
// weights of least squares for which every frequency up to a quarter of a cycle per window (a beat
// of four windows and more) passes unchanged within 1e-6.
class BetweenWindows {
public:
    static constexpr std::size_t reach = 8;  // windows on each side

    BetweenWindows() {
        constexpr auto taps = static_cast<Index>(2 * reach);
        Eigen::MatrixXd passed = Eigen::MatrixXd::Zero(2 * frequencies + taps, taps);
        Eigen::MatrixXd wanted = Eigen::MatrixXd::Zero(passed.rows(), parts + 1);
        for (Index k = 0; k < frequencies; ++k) {
            const double turn = 2 * pi * band * (static_cast<double>(k) + 0.5) /
                                static_cast<double>(frequencies);  // per window
            const double mean = std::sin(turn / 2) / (turn / 2);
            for (Index tap = 0; tap < taps; ++tap) {
                const double off = static_cast<double>(tap) - (static_cast<double>(reach) - 1);
                passed(2 * k, tap) = mean * std::cos(turn * off);
                passed(2 * k + 1, tap) = mean * std::sin(turn * off);
            }
            for (Index part = 0; part <= static_cast<Index>(parts); ++part) {
                const double off = static_cast<double>(part) / static_cast<double>(parts);
                wanted(2 * k, part) = std::cos(turn * off);
                wanted(2 * k + 1, part) = std::sin(turn * off);
            }
        }
        passed.bottomRows(taps).diagonal().setConstant(regularisation *
                                                       std::sqrt(static_cast<double>(frequencies)));
        weights_ = passed.colPivHouseholderQr().solve(wanted).transpose();
    }

    // The phasor `part` parts after the centre of the window before the last `reach` means.
    Complex at(std::size_t part, std::span<const Complex> means) const {
        Complex sum = 0;
        for (std::size_t tap = 0; tap < 2 * reach; ++tap) {
            sum += weights_(static_cast<Index>(part), static_cast<Index>(tap)) * means[tap];
        }
        return sum;
    }

    // Phase from that centre to the next one, weighted by the power of both channels; summed over
    // steps so short that unequal modes are weighted by their power.
    double phase(std::span<const Complex> c, std::span<const Complex> d) const {
        std::array<Complex, parts + 1> by_c;
        std::array<Complex, parts + 1> by_d;
        for (std::size_t part = 0; part <= parts; ++part) {
            by_c[part] = at(part, c);
            by_d[part] = at(part, d);
        }
        const auto sum = [&](std::size_t step) {
            double phase = 0;
            for (std::size_t part = 0; part < parts; part += step) {
                phase += std::arg(std::conj(by_c[part]) * by_c[part + step] +
                                  std::conj(by_d[part]) * by_d[part + step]);
            }
            return phase;
        };
        // A step weights unequal modes by their power, with an error of third order.
        return (4 * sum(1) - sum(2)) / 3;
    }

    // Noise gain at a centre, in units of a window's noise variance.
    double noise_gain() const { return weights_.row(0).squaredNorm(); }

private:
    static constexpr std::size_t parts = 16;  // of the way from a window to the next

    Eigen::MatrixXd weights_;  // a row for each part
};

// Of a fast beat: phasors, with enough consecutive windows on both sides, by interpolation. Returns
// the phase from the window before to each of the list likewise; NaN near ends and gaps.
std::vector<double> interpolate_beat(const PhasorRun& run, const std::vector<std::size_t>& windows,
                                     Middles& z) {
    constexpr std::size_t reach = BetweenWindows::reach;
    const BetweenWindows between;
    std::vector<double> phases(windows.size(), std::numeric_limits<double>::quiet_NaN());
    std::size_t in_row = 0;  // consecutive windows up to this one
    for (std::size_t last = 0; last < windows.size(); ++last) {
        const bool follows =
            last > 1 && in_a_row(run, windows[last - 2], windows[last - 1], windows[last]);
        in_row = follows ? in_row + 1 : 2;
        if (in_row < 2 * reach) {
            continue;
        }
        const std::size_t first = windows[last + 1 - 2 * reach];
        const std::size_t k = last + 1 - reach;  // in the list, after the centre
        const auto c = std::span(run.c).subspan(first, 2 * reach);
        const auto d = std::span(run.d).subspan(first, 2 * reach);
        phases[k] = between.phase(c, d);
        z.c[windows[k - 1]] = between.at(0, c);
        z.d[windows[k - 1]] = between.at(0, d);
        z.noise_gain[windows[k - 1]] = between.noise_gain();
    }
    return phases;
}

Motion motion_of(const PhasorRun& run, const std::vector<std::size_t>& windows) {
    const double rate = usual_rate(run, windows);
    Middles z = middles_of(run, windows);
    const std::vector<double> of_beat =
        beats_fast(run, windows, rate) ? interpolate_beat(run, windows, z) : std::vector<double>{};
    Motion motion;
    double phase = 0;
    double two_theta = 0;
    std::size_t part = 0;
    for (std::size_t i = 0; i < windows.size(); ++i) {
        const std::size_t k = windows[i];
        const double t = run.time_s[k];
        const std::size_t own = breaks_before(run, t);
        if (i > 0) {
            // Relative to the usual rate, so that gaps are bridged with the right number of turns.
            const double usual = rate * (t - run.time_s[windows[i - 1]]);
            const double beyond = std::arg(z.product(windows[i - 1], k) * std::polar(1.0, -usual));
            phase += usual + (part == own ? beyond : 0);
        }
        if (!of_beat.empty() && i > 0 && !std::isnan(of_beat[i])) {
            phase = motion.phase.value.back() + of_beat[i];
        } else if (i > 1 && in_a_row(run, windows[i - 2], windows[i - 1], k)) {
            // A step underestimates the mean rate of unequal modes by a term of third order; a
            // double step shows that term eightfold.
            phase +=
                std::arg(z.product(windows[i - 2], windows[i - 1]) * z.product(windows[i - 1], k) *
                         std::conj(z.product(windows[i - 2], k))) /
                6;
        }
        const double power = z.power(k);
        const double sd = run.sd[k];
        add(motion.phase, t, phase, sd / std::sqrt(power), own);
        part = own;
        const std::size_t knocks = knocks_before(run, t);
        const bool inside = i > 0 && i + 1 < windows.size();
        motion.phase.step_variance.push_back(
            inside ? step_variance(run, windows[i - 1], k, windows[i + 1]) : 0);
        add(motion.amplitude, t, std::log(power - 4 * z.noise_gain[k] * sd * sd) / 2,
            sd / std::sqrt(power), knocks);
        const WaveState state = to_wave_state({z.c[k], z.d[k]});
        if (state.a_A - std::abs(state.a_B) < seen * std::numbers::sqrt2 * sd) {
            continue;
        }
        const double before = two_theta;
        two_theta = motion.angles.empty()
                        ? state.two_theta_A
                        : nearest_branch(state.two_theta_A, before, std::numbers::pi);
        motion.branch_lost |= !motion.angles.empty() && knocks == motion.theta.part.back() &&
                              std::abs(two_theta - before) > ambiguous_step;
        const double across = (state.a_A + state.a_B) * (state.a_A - state.a_B);
        add(motion.theta, t, two_theta / 2, sd * std::sqrt(power) / (2 * across), knocks);
        add(motion.quadrature, t, state.a_B / state.a_A,
            sd * std::sqrt(power) / (state.a_A * state.a_A), knocks);
        motion.angles.push_back(k);
    }
    return motion;
}

// Marks the windows of a series outside its scatter.
void mark_outliers(const RateSeries& series, const std::vector<std::size_t>& windows,
                   std::vector<bool>& out) {
    if (series.value.size() < least_windows) {
        return;
    }
    const std::vector<double> trend = trend_of(series);
    std::vector<double> off;
    for (std::size_t i = 0; i < trend.size(); ++i) {
        off.push_back(std::abs(series.value[i] - trend[i]) / series.sd[i]);
    }
    const double limit = outlier * std::max(1.0, 1.4826 * median(off));
    for (std::size_t i = 0; i < off.size(); ++i) {
        if (off[i] > limit) {
            out[windows[i]] = true;
        }
    }
}

Motion motion_without_outliers(const PhasorRun& run, const JobControl& job) {
    std::vector<std::size_t> windows;
    for (std::size_t k = 0; k < run.time_s.size(); ++k) {
        if (run.power(k) > seen * seen * run.sd[k] * run.sd[k]) {
            windows.push_back(k);
        }
    }
    constexpr int passes = 4;
    for (int pass = 0; pass < passes && !job.cancelled(); ++pass) {
        Motion motion = motion_of(run, windows);
        std::vector<bool> out(run.time_s.size(), false);
        mark_outliers(motion.phase, windows, out);
        mark_outliers(motion.amplitude, windows, out);
        mark_outliers(motion.theta, motion.angles, out);
        mark_outliers(motion.quadrature, motion.angles, out);
        if (std::erase_if(windows, [&](std::size_t k) { return out[k]; }) == 0) {
            return motion;
        }
    }
    return motion_of(run, windows);
}

// Factor of the variance of a mean over many windows due to their correlation.
double inflation_of(const PhasorRun& run) {
    if (run.noise_correlation.empty()) {
        return 1;
    }
    constexpr double least =
        0.05;  // where the band is so narrow that the lags' sum is all rounding
    return std::max(
        least,
        2 * std::accumulate(run.noise_correlation.begin(), run.noise_correlation.end(), 0.0) - 1);
}

// Merges windows until the summed products of neighbouring noise are far below that noise: for N
// steps 4 N (sd/|z|)^4 against (sd/|z|)^2.
PhasorRun clear_windows(const PhasorRun& run) {
    constexpr double least = 0.008;
    double noise = 0;
    double power = 0;
    for (std::size_t k = 0; k < run.time_s.size(); ++k) {
        noise += run.sd[k] * run.sd[k];
        power += run.power(k);
    }
    const auto count = static_cast<double>(run.time_s.size());
    const double together = std::ceil(std::sqrt(4 * count * noise / (least * power)));
    if (!(together > 1) || count < 2 * together * static_cast<double>(least_windows)) {
        return run;
    }
    return merge_windows(run, static_cast<std::size_t>(count / together));
}

// Without deviations, which are then NaN, at a fraction of the cost.
WaveMotion motion_with(const PhasorRun& windows, bool deviations, const JobControl& job) {
    const PhasorRun run = clear_windows(windows);
    const Motion motion = motion_without_outliers(run, job);
    WaveMotion found;
    if (motion.phase.value.size() < least_windows) {
        found.f_hz = found.tau_s = found.theta_rate_rad_s = found.quadrature_rate_per_s =
            found.decay_per_s = Estimate{.reason = {ReasonCode::too_few_windows, {}}};
        return found;
    }
    constexpr double two_pi = 2 * std::numbers::pi;
    const bool circular =
        motion.angles.size() < std::max(least_windows, motion.phase.value.size() / 2);
    std::vector<RateSeries> series{motion.phase, motion.amplitude};
    if (!circular) {
        series.insert(series.end(), {motion.theta, motion.quadrature});
    }
    const std::vector<Estimate> rates =
        deviations ? mean_rates(series, inflation_of(run), job) : mean_slopes(series);
    found.f_hz = {run.f_ref_hz + rates[0].value / two_pi, rates[0].sd / two_pi, {}};
    found.decay_per_s = {-rates[1].value, rates[1].sd, {}};
    found.tau_s = decay_time(found.decay_per_s);
    const Estimate none{.reason = {ReasonCode::circular_wave, {}}};
    found.theta_rate_rad_s = circular || motion.branch_lost ? none : rates[2];
    found.quadrature_rate_per_s = circular ? none : rates[3];
    return found;
}

// Members affected by channel errors; tau follows from the decay rate.
constexpr std::array numbers{&WaveMotion::f_hz, &WaveMotion::theta_rate_rad_s,
                             &WaveMotion::quadrature_rate_per_s, &WaveMotion::decay_per_s};

// The run with one more error of its D, by the channels of phasor_model.h.
// `of_c`: C drifts in place of D.
PhasorRun with_error(const PhasorRun& run, ErrorSource error, double size, bool of_c) {
    ChannelTolerance one{};
    one[error] = size;
    PhasorRun with = run;
    for (std::size_t k = 0; k < run.d.size(); ++k) {
        const double x = run.time_s[k] / (run.time_s.back() + run.window_s / 2);
        const Complex gain = (1 + one[gain_drift_error] * x) / (1 + one[kappa_error]) *
                             std::polar(1.0, one[delay_error] + one[phase_drift_error] * x);
        Complex c = run.c[k];
        Complex& d = with.d[k];
        turn_channels(-run.two_theta_zero, c, d);
        d = (of_c ? Complex(1) : gain) * d +
            Complex(std::sin(one[skew_error]), one[crosstalk_error]) * c;
        c *= of_c ? gain : Complex(1);
        turn_channels(run.two_theta_zero, c, d);
        with.c[k] = c;
    }
    return with;
}

}  // namespace

WaveMotion wave_motion(const PhasorRun& run, const ChannelTolerance& tolerance,
                       const JobControl& job) {
    WaveMotion found = motion_with(run, true, job);
    std::array<double, numbers.size()> variance{};
    for (const ToleratedError& error : channel_errors) {
        const double size = tolerance[error.source];
        if (size == 0 || job.cancelled()) {
            continue;
        }
        const bool drifts = std::ranges::find(drift_errors, error.source) != drift_errors.end();
        for (const bool of_c : {false, true}) {
            if (of_c && !drifts) {
                continue;
            }
            const WaveMotion moved =
                motion_with(with_error(run, error.source, size, of_c), false, job);
            for (std::size_t k = 0; k < numbers.size(); ++k) {
                const double change = (moved.*numbers[k]).value - (found.*numbers[k]).value;
                variance[k] += std::isfinite(change) ? change * change : 0;
            }
        }
    }
    for (std::size_t k = 0; k < numbers.size(); ++k) {
        Estimate& number = found.*numbers[k];
        number.u = std::sqrt(number.sd * number.sd + variance[k]);
    }
    if (found.decay_per_s.given()) {
        found.tau_s = decay_time(found.decay_per_s);
    }
    return found;
}

}  // namespace vybeg
