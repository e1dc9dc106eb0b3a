#include "core/resonator/resonator_fit.h"

#include "core/base/number_text.h"
#include "core/resonator/merge_windows.h"
#include "core/resonator/model_choice.h"
#include "core/resonator/resonator_estimates.h"

#include <algorithm>
#include <cmath>

namespace vybeg {
namespace {

// Each run has four to six parameters of its own; eight windows are 32 numbers.
constexpr std::size_t least_windows = 8;

// Of one run: 28 s by 1000 are 28 ms, in which a bell's beat of 5 Hz turns by less than a radian.
constexpr std::size_t enough_windows = 1000;

// The windows that are numbers with a deviation.
PhasorRun usable(const PhasorRun& run) {
    PhasorRun good{run.f_ref_hz, run.window_s, {}, {}, {}, {}};
    for (std::size_t k = 0; k < run.time_s.size(); ++k) {
        const double sum = run.time_s[k] + std::abs(run.c[k]) + std::abs(run.d[k]) + run.sd[k];
        if (std::isfinite(sum) && run.sd[k] > 0) {
            good.time_s.push_back(run.time_s[k]);
            good.c.push_back(run.c[k]);
            good.d.push_back(run.d[k]);
            good.sd.push_back(run.sd[k]);
        }
    }
    return good;
}

double largest_amplitude(std::span<const PhasorRun> runs) {
    double most = 0;
    for (const PhasorRun& run : runs) {
        for (std::size_t k = 0; k < run.c.size(); ++k) {
            most = std::max({most, std::abs(run.c[k]), std::abs(run.d[k])});
        }
    }
    return most;
}

void tell_of_drifts(const ModelChoice& choice, ResonatorFit& fit) {
    for (std::size_t k = 0; k < fit.runs.size(); ++k) {
        const Estimate& drift = fit.runs[k].drift_hz_per_s;
        if (choice.space.drift && std::abs(drift.value) > 4 * drift.sd) {
            fit.warnings.push_back({DiagnosticKind::frequency_drifts,
                                    {integer_text(static_cast<std::int64_t>(k) + 1),
                                     short_text(drift.value, 3), short_text(drift.sd, 2)}});
        }
    }
    const Estimate& power = fit.resonator.frequency_per_power;
    if (power.given() && std::abs(power.value) > 4 * power.sd) {
        fit.warnings.push_back({DiagnosticKind::frequency_follows_amplitude,
                                {short_text(power.value, 3), short_text(power.sd, 2)}});
    }
}

}  // namespace

Result<ResonatorFit> fit_resonator(std::span<const PhasorRun> runs, const FitOptions& options,
                                   const JobControl& job) {
    std::vector<PhasorRun> good;
    for (const PhasorRun& run : runs) {
        good.push_back(usable(run));
        if (good.back().time_s.size() < least_windows) {
            return Error{ErrorCode::fit_too_few_windows,
                         "recording " + std::to_string(good.size()),
                         {integer_text(static_cast<std::int64_t>(good.back().time_s.size())),
                          integer_text(least_windows)}};
        }
    }
    for (PhasorRun& run : good) {
        run = merge_windows(run, enough_windows);
    }
    const double scale = largest_amplitude(good);
    if (good.empty() || scale <= 0) {
        return Error{ErrorCode::fit_failed, "the recordings", {"there is no wave"}};
    }
    std::vector<ScaledRun> scaled;
    for (const PhasorRun& run : good) {
        scaled.push_back(scaled_run(run, scale));
    }
    Result<ModelChoice> choice = choose_model(scaled, options, job);
    if (!choice) {
        Error error = choice.error();
        error.where = "the recordings";
        return error;
    }
    ResonatorFit fit = estimates(*choice, good, scaled, scale);
    tell_of_drifts(*choice, fit);
    return fit;
}

}  // namespace vybeg
