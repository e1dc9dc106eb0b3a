#include "core/analysis/identify_powers.h"

#include "core/analysis/setting_table.h"
#include "core/base/read_value.h"
#include "core/numerics/median.h"
#include "core/resonator/results/power_fit.h"
#include "core/resonator/runs/wave_uncertainty.h"

#include <limits>
#include <utility>
#include <vector>

namespace vybeg {
namespace {

constexpr std::size_t power_track_points = 200;

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

}  // namespace

Result<Identification> identify_powers(std::span<const PowerRun> runs,
                                       std::span<const std::string> names,
                                       const IdentifySettings& settings, const JobControl& job) {
    TRY(validate(settings));
    if (settings.model == FitOptions::Model::free) {
        return refused_value("--model", "free", "logs without a phase show no free model");
    }
    Identification found;
    found.settings = settings;
    const double begun = job.now();
    // A delay is a phase at a frequency that is not known.
    const FitOptions options = fit_options(settings, 0);
    auto fit = TRY(fit_powers(runs, options, job));
    found.fit = std::move(fit.fit);
    std::vector<MessageArg> called(names.begin(), names.end());
    for (Diagnostic& warning : found.fit.warnings) {
        name_recordings(called, warning.args);
    }
    for (std::size_t k = 0; k < runs.size(); ++k) {
        found.runs.push_back(run_of_powers(runs[k], fit.runs[k], options.assumed, job));
    }
    found.drift = drift_function(fit.runs, found.fit, job);
    found.timing.fit_s = job.now() - begun;
    if (job.cancelled()) {
        return Error{ErrorCode::interrupted, {}, {}};
    }
    return found;
}

}  // namespace vybeg
