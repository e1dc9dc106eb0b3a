#include "core/analysis/identify_logs.h"

#include "core/analysis/power_log.h"
#include "core/analysis/setting_table.h"
#include "core/base/read_value.h"
#include "core/numerics/statistics.h"
#include "core/resonator/results/power_fit.h"
#include "core/resonator/runs/wave_uncertainty.h"

#include <cmath>
#include <limits>
#include <optional>
#include <utility>
#include <vector>

namespace vybeg {
namespace {

constexpr std::size_t power_track_points = 200;
// Of a log whose carrier nobody tells: an assumed delay counts as it does at most.
constexpr double high_carrier_hz = 1e4;

IdentifiedRun run_of_powers(const PowerRun& log, const PhasorRun& run,
                            const ChannelTolerance& tolerance, const JobControl& job) {
    IdentifiedRun identified;
    identified.f0_hz = std::numeric_limits<double>::quiet_NaN();
    identified.window = 1;
    identified.windows = static_cast<std::int64_t>(log.time_s.size());
    identified.windows_used = static_cast<std::int64_t>(run.time_s.size());
    identified.noise_sd = median(run.sd);
    identified.track = run_track(run, power_track_points);
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
    for (std::size_t k = logs.size(); k-- > 0;) {
        for (Diagnostic warning : logs[k].warnings) {
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
    const double delay_s = settings.tolerance.delay_s.value_or(0);
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
    }
    found.drift = drift_function(fit.runs, found.fit, job);
    found.timing.fit_s = job.now() - begun;
    TRY(job.go_on());
    return found;
}

}  // namespace vybeg
