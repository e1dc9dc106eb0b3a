#include "core/analysis/analyse_logs.h"

#include "core/analysis/setting_table.h"
#include "core/base/read_value.h"
#include "core/estimators/wave/estimator.h"
#include "core/estimators/wave/wave_state.h"
#include "core/numerics/statistics.h"
#include "core/resonator/results/power_fit.h"
#include "core/resonator/runs/wave_motion.h"
#include "core/track/track.h"

#include <algorithm>
#include <cmath>
#include <complex>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <numbers>
#include <optional>
#include <utility>
#include <vector>

namespace vybeg {
namespace {

constexpr double two_pi = 2 * std::numbers::pi;

// Across the neighbours, whose noise remains.
void put_frequency(const PhasorRun& run, std::size_t k, Track& track) {
    const std::size_t first = k > 0 ? k - 1 : 0;
    const std::size_t last = std::min(k + 1, run.time_s.size() - 1);
    if (first == last) {
        return;
    }
    double turns = 0;
    for (std::size_t at = first; at < last; ++at) {
        turns += std::arg(run.product(at, at + 1)) / two_pi;  // relative to f_ref
    }
    const double seconds = run.time_s[last] - run.time_s[first];
    const double before = run.sd[first] / std::sqrt(run.power(first));
    const double behind = run.sd[last] / std::sqrt(run.power(last));
    const std::size_t lag = last - first;
    const double shared =
        lag < run.noise_correlation.size() ? run.noise_correlation[lag] * before * behind : 0;
    const double sd = std::sqrt(before * before + behind * behind - 2 * shared);
    track.put(k, SlowVariable::f, run.f_ref_hz + turns / seconds, sd / (two_pi * seconds));
}

void put_wave(const PhasorRun& run, std::size_t k, Track& track) {
    const Phasors phasors{run.c[k], run.d[k]};
    const WaveState state = to_wave_state(phasors);
    const double sd = run.sd[k];
    track.put(k, SlowVariable::a_A, state.a_A, sd);
    track.put(k, SlowVariable::a_B, state.a_B, sd);
    track.values(SlowVariable::delta_phi_CD)[k] = phase_difference(phasors);
    // The smaller travelling wave has a deviation of sd sqrt(2) in modulus.
    const double smaller = state.a_A - std::abs(state.a_B);
    if (!(smaller * smaller > 18 * sd * sd && smaller > 1e-12 * state.a_A)) {
        set(track.flags()[k], Flag::circular);
        return;
    }
    const double difference = state.a_A * state.a_A - state.a_B * state.a_B;
    const double sd_angle = sd * std::sqrt(run.power(k)) / difference;
    track.put(k, SlowVariable::two_theta_A, state.two_theta_A, sd_angle);
    if (!run.phase_lost) {
        // alpha is that of the carrier at the window's centre.
        const double turned = state.alpha - two_pi * std::fmod(run.f_ref_hz * run.time_s[k], 1.0);
        track.put(k, SlowVariable::alpha, std::remainder(turned, two_pi), sd_angle);
    }
}

Track track_of(const PhasorRun& run, double noise_sd) {
    Track track(run.time_s.size());
    for (std::size_t k = 0; k < run.time_s.size(); ++k) {
        track.time_s()[k] = run.time_s[k];
        track.values(SlowVariable::noise)[k] = noise_sd;
        put_wave(run, k, track);
        if (!run.phase_lost) {
            put_frequency(run, k, track);
        }
    }
    AngleUnwrapper(0).unwrap(track);
    return track;
}

Result<PhasorLog> read_as_phasors(const LogFile& file) {
    if (!file.choice.without_phase()) {
        return read_phasor_log(file);
    }
    constexpr std::size_t all_rows = std::numeric_limits<std::size_t>::max() / 2;
    const auto powers = TRY(read_power_log(file));
    PhasorLog log{phasors_without_phase(powers, all_rows), 0,
                  static_cast<std::int64_t>(powers.time_s.size()), 1, 0};
    if (log.run.time_s.empty()) {
        return Error{ErrorCode::no_valid_samples, file.path.string(), {}};
    }
    for (double& time : log.run.time_s) {
        time += powers.time_s.front();
    }
    log.run.f_ref_hz = std::numeric_limits<double>::quiet_NaN();
    log.noise_sd = median(log.run.sd);
    return log;
}

// Of a log without a stated carrier: the largest effect of an assumed delay.
constexpr double high_carrier_hz = 1e4;

IdentifiedRun run_of_powers(const PowerRun& log, const PhasorRun& run,
                            const ChannelTolerance& tolerance, const JobControl& job) {
    IdentifiedRun identified;
    identified.f0_hz = std::numeric_limits<double>::quiet_NaN();
    identified.window = 1;
    identified.windows = static_cast<std::int64_t>(log.time_s.size());
    identified.windows_used = static_cast<std::int64_t>(run.time_s.size());
    identified.noise_sd = median(run.sd);
    identified.track = run_track(run, run_track_points);
    identified.wave = wave_motion(run, tolerance, job);
    identified.wave.f_hz = Estimate{.reason = {ReasonCode::phase_lost, {}}};
    return identified;
}

// Phasors of a rate below four times the split fold: the motion is not the one that they show.
Status check_rate(const Identification& found, std::span<const PhasorLog> logs,
                  std::span<const std::string> names) {
    constexpr double least_per_split = 4;
    const auto& modes = found.fit.modes;
    const Estimate& split = found.fit.resonator.split_hz;
    const double split_hz = split.given() ? split.value
                            : modes.size() == 2
                                ? std::abs(modes[0].f_hz.value - modes[1].f_hz.value)
                                : 0;
    for (std::size_t k = 0; k < logs.size(); ++k) {
        const double rate_hz = logs[k].rate_hz;
        if (rate_hz < least_per_split * split_hz) {
            return Error{ErrorCode::phasors_fold,
                         names[k],
                         {number_arg(rate_hz, 6, "Hz"), number_arg(split_hz, 6, "Hz")}};
        }
    }
    return {};
}

}  // namespace

Result<Analysis> analyse_log(const std::filesystem::path& path, const OpenOptions& options,
                             const LogChoice& choice, const Settings& settings,
                             const JobControl& job) {
    TRY(validate(settings));
    const double begun = job.now();
    const auto log = TRY(read_as_phasors({path, options, choice, settings, job}));
    Analysis analysis;
    analysis.timing.read_s = job.now() - begun;
    analysis.timing.threads = 1;
    analysis.settings = settings;
    analysis.settings.f0_hz = log.run.f_ref_hz;
    analysis.settings.window = analysis.settings.hop = log.rows_per_window;
    analysis.settings.periods.reset();
    analysis.plan = {0, log.rows_per_window, log.rows_per_window,
                     static_cast<std::int64_t>(log.run.time_s.size())};
    analysis.residual = std::numeric_limits<double>::quiet_NaN();
    analysis.track = track_of(log.run, log.noise_sd);
    // Neighbours of a window but one share the phase between them.
    analysis.f_correlation = {1, 0, -0.5};
    analysis.means = summarise(analysis.track, 1, analysis.f_correlation);
    return analysis;
}

Result<Identification> identify_phasors(std::span<const PhasorLog> logs,
                                        std::span<const std::string> names,
                                        const IdentifySettings& settings, const JobControl& job) {
    TRY(validate(settings));
    std::vector<RecordedRun> runs;
    for (std::size_t k = 0; k < logs.size(); ++k) {
        const PhasorLog& log = logs[k];
        RecordedRun run{names[k], 0, log.run, {}};
        run.told.f0_hz = log.run.f_ref_hz;
        run.told.window = log.rows_per_window;
        run.told.windows = log.rows / log.rows_per_window;
        run.told.windows_used = static_cast<std::int64_t>(log.run.time_s.size());
        run.told.noise_sd = log.noise_sd;
        runs.push_back(std::move(run));
    }
    Identification begun;
    begun.settings = settings;
    auto found = TRY(identify_runs(std::move(runs), std::move(begun), job));
    TRY(check_rate(found, logs, names));
    // With one sign of Y alone the wave of both channels leaves noise.
    constexpr double at_noise = 1.5;
    const bool is_wave =
        found.fit.model == ResonatorModel::structured && found.fit.chi2_per_dof < at_noise;
    for (std::size_t k = logs.size(); k-- > 0;) {
        for (Diagnostic warning : logs[k].warnings) {
            if (is_wave && warning.kind == DiagnosticKind::phasors_mirrored) {
                continue;
            }
            warning.args.insert(warning.args.begin(), names[k]);
            found.fit.warnings.insert(found.fit.warnings.begin(), std::move(warning));
        }
    }
    return found;
}

Result<Identification> identify_powers(std::span<const PowerRun> runs,
                                       std::span<const std::string> names,
                                       const IdentifySettings& settings, const JobControl& job) {
    TRY(validate(settings));
    if (settings.model == FitOptions::Model::free) {
        return refused_value("--model", "free", "logs without a phase show no free model");
    }
    const std::optional<double>& carrier_hz = settings.signal.f0_hz;
    const double delay_s = settings.tolerance[delay_error].value_or(0);
    if (delay_s > 0 && !carrier_hz) {
        return refused_delay("--tolerance delay", delay_s);
    }
    std::vector<Diagnostic> apart;
    for (std::size_t k = 0; k < runs.size(); ++k) {
        constexpr double another_unit = 0.1;
        constexpr double harmless = 1e-3;
        const PowerMismatch mismatch = power_mismatch(runs[k]);
        if (std::abs(mismatch.of_all) > another_unit) {
            return Error{
                ErrorCode::powers_disagree, names[k], {number_arg(100 * (1 + mismatch.of_all), 3)}};
        }
        if (std::abs(mismatch.worst) > harmless) {
            apart.push_back({DiagnosticKind::powers_apart,
                             {recording_arg(k), number_arg(100 * mismatch.worst, 2),
                              number_arg(mismatch.at_s, 4)}});
        }
    }
    Identification found;
    found.settings = settings;
    const double begun = job.now();
    const FitOptions options = fit_options(settings, carrier_hz.value_or(high_carrier_hz));
    const std::vector<MessageArg> called(names.begin(), names.end());
    auto fitted = fit_powers(runs, options, job);
    if (!fitted) {
        return named(fitted.error(), called);
    }
    PowerFit& fit = *fitted;
    found.fit = std::move(fit.fit);
    refer_to_recorded(settings.signal.calibration.kappa, found.fit);
    found.fit.warnings.insert(found.fit.warnings.begin(), apart.begin(), apart.end());
    for (Diagnostic& warning : found.fit.warnings) {
        name_recordings(called, warning.args);
    }
    for (std::size_t k = 0; k < runs.size(); ++k) {
        found.runs.push_back(run_of_powers(runs[k], fit.runs[k], options.assumed, job));
        found.timing.windows += found.runs.back().windows;
    }
    found.drift = drift_function(fit.runs, found.fit, job);
    found.timing.fit_s = job.now() - begun;
    TRY(job.go_on());
    return found;
}

}  // namespace vybeg
