#include "core/analysis/analyse.h"
#include "core/analysis/estimate_track.h"
#include "core/analysis/setting_table.h"
#include "core/analysis/window_noise.h"
#include "core/estimators/wave/wave_formulas.h"
#include "core/estimators/wave/wave_state.h"
#include "core/numerics/statistics.h"
#include "core/sweep/window_sweep.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <memory>
#include <numbers>
#include <set>
#include <utility>

namespace vybeg {
namespace {

constexpr std::size_t most_groups = std::size_t{1} << 16;
constexpr std::size_t least_groups = 8;
constexpr std::size_t middle = 3;
constexpr std::array<double, 7> sixth_difference{1, -6, 15, -20, 15, -6, 1};
constexpr double sixth_norm = 924;                    // sum of the squares of these
constexpr double second_norm = 6;                     // of 1, -2, 1
constexpr double normal_median = 0.6744897501960817;  // of |x|, x normal with sd 1
constexpr double far_out = 4;                         // sd of a value that does not count
// A beat moves a_B and the angles to first order, a_A and f to second: so much of the slope reaches
// them in simulated beats (0.1 to 0.4).
constexpr double second_order = 0.25;
constexpr double nan = SweepValue::none;

// Above this the absolute value of a number does not count.
double limit_of(const std::vector<double>& x) {
    std::vector<double> sizes(x.size());
    std::ranges::transform(x, sizes.begin(), [](double value) { return std::abs(value); });
    return far_out * median(std::move(sizes)) / normal_median;
}

// Root of the mean square of the values of x at which |by| lies within the limit of `by`.
double root_mean_square(const std::vector<double>& x, const std::vector<double>& by) {
    const double limit = limit_of(by);
    double sum = 0;
    std::size_t count = 0;
    for (std::size_t k = 0; k < x.size(); ++k) {
        if (std::abs(by[k]) <= limit) {
            sum += x[k] * x[k];
            ++count;
        }
    }
    return count > 0 ? std::sqrt(sum / static_cast<double>(count)) : nan;
}

// Relative standard deviation of the root mean square of sixth differences of white noise, `count`
// of them, `stride` windows apart: their squares have the correlation rho^2.
double relative_sd(std::size_t count, std::size_t stride) {
    double correlated = 1;
    for (std::size_t lag = stride; lag < sixth_difference.size(); lag += stride) {
        double product = 0;
        for (std::size_t k = 0; k + lag < sixth_difference.size(); ++k) {
            product += sixth_difference[k] * sixth_difference[k + lag];
        }
        correlated += 2 * (product / sixth_norm) * (product / sixth_norm);
    }
    return std::sqrt(correlated / (2 * static_cast<double>(count)));
}

// Scatter of adjacent windows (hop = length) of one track, whose rows arrive in pieces.
//
// Scatter: sixth differences of seven neighbouring windows over sqrt(924), in units of the
// Cramer-Rao bound of the window in the middle (README.md has the reasons). A motion of the angular
// frequency v enters with (2 sin(vT/2))^6: of a beat of 1 Hz in windows of 18 ms 7e-8 of its
// amplitude remains, of first differences 8e-2. Values beyond four times the median's deviation do
// not count, so that some disturbed windows do not matter.
//
// Motion: second differences D of the same windows, x'' T^2, less the part of the scatter:
// sqrt(<D^2> - 6 scatter^2) / 24.
//
// Of more than 2^16 windows every k-th is the middle of such a group: memory does not grow.
class NeighbourScatter {
public:
    // `angle_zero`: twice the angle of the first electrode, which the track has subtracted.
    // `faults`: windows over faults of the samples. `noise`: the white noise of the recording, for
    // phasors and frequency.
    NeighbourScatter(const WindowPlan& plan, double rate_hz, double angle_zero,
                     std::vector<FlaggedRows> faults, const EquivalentNoise& noise);

    void take(const Track& next_rows);
    SweepLength finish() const;

private:
    struct Row {
        std::array<double, sweep_variable_count> values{};
        std::array<double, sweep_variable_count> sds{};
        double alpha = 0;
        bool counts = false;
    };
    struct Sums {
        std::vector<double> sixth;   // differences in units of the bound
        std::vector<double> second;  // of the same windows
        std::vector<double> stated;  // in units of the bound
        std::vector<double> bound;   // for noise of one recording unit
    };
    static constexpr std::size_t held_rows = 7;

    void judge_middle();

    WindowPlan plan_;
    double rate_hz_;
    double angle_zero_;
    std::vector<FlaggedRows> faults_;
    EquivalentNoise noise_;
    std::size_t stride_;
    std::size_t rows_ = 0;
    std::int64_t used_ = 0;
    double rms_squares_ = 0;
    double noise_squares_ = 0;
    std::array<Row, held_rows> held_;
    std::array<Sums, sweep_variable_count> sums_;
};

NeighbourScatter::NeighbourScatter(const WindowPlan& plan, double rate_hz, double angle_zero,
                                   std::vector<FlaggedRows> faults, const EquivalentNoise& noise)
    : plan_(plan),
      rate_hz_(rate_hz),
      angle_zero_(angle_zero),
      faults_(std::move(faults)),
      noise_(noise),
      stride_((static_cast<std::size_t>(plan.count) + most_groups - 1) / most_groups) {}

void NeighbourScatter::take(const Track& next_rows) {
    std::vector<Flags> flags(next_rows.flags().begin(), next_rows.flags().end());
    set_flags(flags, rows_, faults_);
    for (std::size_t k = 0; k < next_rows.rows(); ++k) {
        std::shift_left(held_.begin(), held_.end(), 1);
        Row& row = held_.back();
        for (std::size_t v = 0; v < sweep_variable_count; ++v) {
            row.values[v] = next_rows.values(main_slow_variables[v])[k];
            row.sds[v] = next_rows.sds(main_slow_variables[v])[k];
        }
        row.alpha = next_rows.values(SlowVariable::alpha)[k];
        row.counts = is_sound_window(flags[k]);
        const double rms = next_rows.values(SlowVariable::rms)[k];
        const double noise = next_rows.values(SlowVariable::noise)[k];
        if (row.counts && std::isfinite(rms)) {
            rms_squares_ += rms * rms;
            noise_squares_ += noise * noise;
            ++used_;
        }
        ++rows_;
        if (rows_ >= held_rows && rows_ % stride_ == 0) {
            judge_middle();
        }
    }
}

void NeighbourScatter::judge_middle() {
    if (!std::ranges::all_of(held_, &Row::counts)) {
        return;
    }
    const Row& at = held_[middle];
    const double a_B = std::isnan(at.values[1]) ? 0 : at.values[1];  // algorithm 1 has none
    const WaveState state{at.values[0], a_B, at.values[2] + angle_zero_, at.alpha};
    const WaveErrors unit =
        precision_bound(to_phasors(state), at.values[3], rate_hz_, plan_.length, 1);
    const std::array bounds{unit.a_A, unit.a_B, unit.two_theta_A, unit.f_hz, unit.delta_phi_CD};
    for (std::size_t v = 0; v < sweep_variable_count; ++v) {
        const double period =
            main_slow_variables[v] == SlowVariable::delta_phi_CD ? 2 * std::numbers::pi : 0;
        double sixth = 0;
        std::array<double, held_rows> x{};
        for (std::size_t k = 0; k < held_rows; ++k) {
            x[k] = held_[k].values[v];
            if (period > 0 && k > 0) {
                x[k] = x[k - 1] + std::remainder(x[k] - x[k - 1], period);
            }
            sixth += sixth_difference[k] * x[k];
        }
        const double bound = bounds[v];
        if (std::isfinite(sixth) && std::isfinite(bound) && bound > 0) {
            Sums& sums = sums_[v];
            sums.sixth.push_back(sixth / (std::sqrt(sixth_norm) * bound));
            sums.second.push_back((x[middle - 1] - 2 * x[middle] + x[middle + 1]) / bound);
            sums.stated.push_back(at.sds[v] / bound);
            sums.bound.push_back(bound);
        }
    }
}

SweepLength NeighbourScatter::finish() const {
    SweepLength found;
    found.length = plan_.length;
    found.windows = plan_.count;
    found.used = used_;
    if (used_ > 0) {
        found.rms = std::sqrt(rms_squares_ / static_cast<double>(used_));
        found.noise = std::sqrt(noise_squares_ / static_cast<double>(used_));
    }
    const double white = noise_.phasors;
    const double beyond = std::sqrt(std::max(found.noise * found.noise - white * white, 0.0));
    for (std::size_t v = 0; v < sweep_variable_count; ++v) {
        const Sums& sums = sums_[v];
        if (sums.sixth.size() < least_groups) {
            continue;
        }
        SweepValue& value = found.values[v];
        const double typical = median(sums.bound);
        const bool of_frequency = main_slow_variables[v] == SlowVariable::f;
        const bool of_amplitude = main_slow_variables[v] == SlowVariable::a_A;
        value.bound = typical * (of_frequency ? noise_.frequency : noise_.phasors);
        const double scatter = root_mean_square(sums.sixth, sums.sixth);
        const double second = root_mean_square(sums.second, sums.sixth);
        value.scatter = typical * scatter;
        value.sd_scatter = value.scatter * relative_sd(sums.sixth.size(), stride_);
        value.stated = typical * root_mean_square(sums.stated, sums.stated);
        const double bend = second * second - second_norm * scatter * scatter;
        value.motion = typical * std::sqrt(std::max(bend, 0.0)) / 24;
        // A slope d in the window enters the projections through their residual, about d/2n.
        const double share = of_amplitude || of_frequency ? second_order : 1;
        value.unmodelled =
            share * typical * beyond * std::sqrt(3 / static_cast<double>(plan_.length));
    }
    return found;
}

constexpr double pi = std::numbers::pi;
constexpr int phases = 8;  // of alpha in half a turn: leakage has the period pi

using Errors = std::array<double, sweep_variable_count>;

// The samples of a wave about the middle of a window of n, with context on both sides.
void sample(const WaveState& wave, double w, std::int64_t n, std::int64_t context,
            std::vector<double>& c, std::vector<double>& d) {
    const Phasors z = to_phasors(wave);
    c.resize(static_cast<std::size_t>(n + 2 * context));
    d.resize(c.size());
    const double centre = static_cast<double>(context) + 0.5 * static_cast<double>(n - 1);
    for (std::size_t k = 0; k < c.size(); ++k) {
        const std::complex<double> turn = std::polar(1.0, w * (static_cast<double>(k) - centre));
        c[k] = (z.c * turn).real();
        d[k] = (z.d * turn).real();
    }
}

Errors errors_of(const WaveEstimate& found, const WaveState& wave, double f0_hz) {
    return {found.state.a_A - wave.a_A, found.state.a_B - wave.a_B,
            std::remainder(found.state.two_theta_A - wave.two_theta_A, pi), found.f_hz - f0_hz,
            std::remainder(found.delta_phi_CD - phase_difference(to_phasors(wave)), 2 * pi)};
}

// Errors of one closed form (algorithms 1 to 4) in windows of n samples without noise: its estimate
// of a wave at f0 less that wave, root of the mean square over the phases of the carrier at the
// window, median over the waves. Next to the leakage of windows that do not hold whole half-periods
// they contain the quadrature that algorithm 1 leaves out. In the order of main_slow_variables; NaN
// where the algorithm has no value.
Errors form_leakage(Algorithm algorithm, std::span<const WaveState> waves, std::int64_t n,
                    double f0_hz, double rate_hz) {
    const auto estimator =
        make_estimator(algorithm, {.length = n, .rate_hz = rate_hz, .f0_hz = f0_hz});
    const std::int64_t context = estimator->context();
    const double w = 2 * pi * f0_hz / rate_hz;
    std::array<std::vector<double>, sweep_variable_count> of_waves;
    std::vector<double> c;
    std::vector<double> d;
    for (const WaveState& wave : waves) {
        Errors squares{};
        for (int phase = 0; phase < phases; ++phase) {
            WaveState turned = wave;
            turned.alpha = wave.alpha + pi * phase / phases;
            sample(turned, w, n, context, c, d);
            WaveEstimate found;
            estimator->estimate({c, d, context, n, n}, 0, {&found, 1});
            const Errors errors = errors_of(found, turned, f0_hz);
            for (std::size_t v = 0; v < errors.size(); ++v) {
                squares[v] += errors[v] * errors[v] / phases;
            }
        }
        for (std::size_t v = 0; v < squares.size(); ++v) {
            if (std::isfinite(squares[v])) {
                of_waves[v].push_back(std::sqrt(squares[v]));
            }
        }
    }
    Errors typical;
    std::ranges::transform(of_waves, typical.begin(), median);
    return typical;
}

constexpr std::int64_t most_held = std::int64_t{1} << 24;
constexpr std::int64_t block = std::int64_t{1} << 16;
constexpr std::int64_t wave_count = 8;    // of which the leakage is computed
constexpr std::int64_t wave_window = 60;  // samples
constexpr double work_of_window = 30;     // in samples of reading

// Reads the range once, past the check of the samples, and holds it where it is not too long.
Status read_range(ConditionedRecording& prepared, const JobControl& job) {
    const bool held = prepared.end - prepared.first <= most_held;
    const auto count = static_cast<std::size_t>(held ? prepared.end - prepared.first : block);
    std::vector<double> c(count);
    std::vector<double> d(count);
    for (std::int64_t at = prepared.first; at < prepared.end; at += block) {
        TRY(job.go_on());
        const auto frames = static_cast<std::size_t>(std::min(block, prepared.end - at));
        const auto offset = static_cast<std::size_t>(held ? at - prepared.first : 0);
        TRY(prepared.source->read(at, std::span(c).subspan(offset, frames),
                                  std::span(d).subspan(offset, frames)));
    }
    prepared.source = prepared.ahead;
    if (held) {
        prepared.source = source_of(
            prepared.ahead->frames(), true,
            [ahead = prepared.ahead, begin = prepared.first, c = std::move(c), d = std::move(d)](
                std::int64_t first, std::span<double> to_c, std::span<double> to_d) -> Status {
                if (first < begin || first + std::ssize(to_c) > begin + std::ssize(c)) {
                    return ahead->read(first, to_c, to_d);
                }
                std::copy_n(c.begin() + (first - begin), to_c.size(), to_c.begin());
                std::copy_n(d.begin() + (first - begin), to_d.size(), to_d.begin());
                return {};
            });
    }
    return {};
}

// White noise about the carrier: the median of the density, which lines do not move.
Result<double> white_noise(const ConditionedRecording& prepared, double rate_hz,
                           const JobControl& job) {
    if (prepared.filter) {
        return prepared.noise_in_band.value_or(SweepValue::none);
    }
    const double f0 = prepared.f0_hz;
    const Band around{f0 / 2, std::min(1.5 * f0, (rate_hz / 2 + f0) / 2)};
    return noise_in_band(*prepared.source, prepared.first, prepared.end, around, rate_hz, job);
}

// Waves evenly spread over the range.
Result<std::vector<WaveState>> waves_of(const ConditionedRecording& prepared,
                                        const Settings& settings, double rate_hz,
                                        const JobControl& job) {
    const std::int64_t length = std::max(wave_window, least_window(prepared.f0_hz, rate_hz));
    const std::int64_t span = prepared.end - prepared.first;
    std::vector<WaveState> waves;
    if (span < length) {
        return waves;
    }
    const std::int64_t hop = std::max((span - length) / wave_count, std::int64_t{1});
    WindowPlan plan = plan_windows(prepared.first, prepared.end, length, hop);
    plan.count = std::min(plan.count, wave_count);
    Settings likely = settings;
    likely.algorithm = Algorithm::maximum_likelihood;
    const double zero = prepared.calibration.two_theta_zero();
    Track track;
    TRY(estimate_track(prepared, plan, likely, rate_hz, 1, appended_to(track), job.silent()));
    for (std::size_t k = 0; k < track.rows(); ++k) {
        const auto value = [&](SlowVariable v) { return track.values(v)[k]; };
        if (std::isfinite(value(SlowVariable::two_theta_A))) {
            waves.push_back({value(SlowVariable::a_A), value(SlowVariable::a_B),
                             value(SlowVariable::two_theta_A) + zero, value(SlowVariable::alpha)});
        }
    }
    return waves;
}

// The sweep's algorithm in windows of one length. `waves`: for the leakage of the closed forms.
Result<SweepLength> in_windows(const WindowPlan& plan, const WindowSweep& sweep,
                               const ConditionedRecording& prepared, const SampleFaults& faults,
                               std::span<const WaveState> waves, const JobControl& job) {
    const double rate = sweep.rate_hz;
    EquivalentNoise noise{sweep.white_noise, sweep.white_noise};
    if (prepared.filter) {
        noise = equivalent_noise(sweep.white_noise, *prepared.filter, prepared.f0_hz, plan.length,
                                 rate);
    }
    const auto over_faults = windows_over(faults, plan, prepared.filter_reach);
    NeighbourScatter scatter(plan, rate, prepared.calibration.two_theta_zero(), over_faults, noise);
    const TrackSink sink = [&](const Track& rows) -> Status {
        scatter.take(rows);
        return {};
    };
    const EstimationSummary summary = TRY(estimate_track(
        prepared, plan, sweep.settings, rate, threads_of(sweep.settings.threads), sink, job));
    SweepLength found = scatter.finish();
    for (const FlaggedRows& rows : moving_apart(summary.moving, over_faults, plan)) {
        found.moving += static_cast<std::int64_t>(rows.count);
    }
    for (std::size_t k = 0; k < closed_form_algorithms.size() && !waves.empty(); ++k) {
        const auto leakage =
            form_leakage(closed_form_algorithms[k], waves, plan.length, prepared.f0_hz, rate);
        for (std::size_t v = 0; v < leakage.size(); ++v) {
            found.values[v].leakage[k] = leakage[v];
            if (closed_form_algorithms[k] == sweep.settings.algorithm) {
                found.values[v].leaking = leakage[v];
            }
        }
    }
    return found;
}

}  // namespace

std::vector<std::int64_t> spaced_lengths(std::int64_t first, std::int64_t last) {
    constexpr int steps = 15;
    std::vector<std::int64_t> lengths;
    const double ratio = static_cast<double>(last) / static_cast<double>(first);
    for (int k = 0; k < steps; ++k) {
        const double share = static_cast<double>(k) / (steps - 1);
        const auto length = static_cast<std::int64_t>(
            std::llround(static_cast<double>(first) * std::pow(ratio, share)));
        if (lengths.empty() || length > lengths.back()) {
            lengths.push_back(length);
        }
    }
    return lengths;
}

Result<WindowSweep> sweep_windows(const Recording& recording, const Settings& settings,
                                  std::span<const std::int64_t> lengths, const JobControl& job) {
    WindowSweep sweep;
    sweep.settings = settings;
    sweep.settings.periods.reset();
    sweep.settings.hop = 0;
    TRY(validate(sweep.settings));
    const double rate = recording.rate_hz;
    auto prepared = TRY(prepare(recording, settings, job.silent()));
    TRY(read_range(prepared, job));
    sweep.rate_hz = rate;
    sweep.f0_hz = prepared.f0_hz;
    sweep.white_noise = TRY(white_noise(prepared, rate, job.silent()));
    const auto waves = TRY(waves_of(prepared, sweep.settings, rate, job));

    std::map<std::int64_t, WindowPlan> plans;
    double all_work = 0;
    const auto work = [](const WindowPlan& plan) {
        return static_cast<double>(plan.count) *
               (static_cast<double>(plan.length) + work_of_window);
    };
    for (const std::int64_t length : std::set(lengths.begin(), lengths.end())) {
        sweep.settings.window = length;
        const Result<WindowPlan> plan = plan_of(sweep.settings, prepared, recording);
        if (!plan) {
            sweep.refused.push_back({length, plan.error()});
        } else if (plans.try_emplace(plan->length, *plan).second) {
            all_work += work(*plan);
        }
    }
    if (plans.empty() && !sweep.refused.empty()) {
        return sweep.refused.front().error;
    }
    const SampleFaults faults = prepared.check->finish();
    double done = 0;
    for (const auto& [length, plan] : plans) {
        const double share = work(plan) / all_work;
        const JobControl part =
            job.with_progress([&](double fraction) { job.report(done + share * fraction); });
        auto found = TRY(in_windows(plan, sweep, prepared, faults, waves, part));
        sweep.lengths.push_back(found);
        done += share;
    }
    sweep.advice = advise_window(sweep.lengths);
    return sweep;
}

}  // namespace vybeg
