#include "core/analysis/identify.h"

#include "core/analysis/prepare.h"
#include "core/analysis/setting_table.h"
#include "core/base/guarded.h"
#include "core/resonator/results/free_decay.h"
#include "core/resonator/results/resonator_parameters.h"
#include "core/resonator/runs/merge_windows.h"
#include "core/resonator/runs/sum_of_modes.h"
#include "core/resonator/runs/wave_motion.h"

#include <tbb/parallel_for.h>
#include <tbb/task_arena.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <iterator>
#include <numeric>
#include <string_view>
#include <utility>

namespace vybeg {
namespace {

// From one recording to its phasors.
Result<RecordedRun> run_of(const Recording& recording, const SignalSettings& signal,
                           const PhasorWindowSettings& wished, int threads, const JobControl& job) {
    const auto choice = TRY(choose_windows(recording, signal, wished, job.silent()));
    auto run = TRY(phasor_windows(choice, recording.rate_hz, threads, job));
    run.name = recording_name(recording);
    return run;
}

// Tolerances of the channels: all, or those that the fit takes for its priors, which are the stated
// ones and that of the gain ratio. A delay of D is a phase at the carrier.
enum class Taken { all, by_fit };
ChannelTolerance tolerance_of(const IdentifySettings& settings, double f_hz, Taken taken) {
    ChannelTolerance tolerance{};
    for (const ToleranceInUse& each :
         tolerances_in_use(settings.tolerance, settings.signal.calibration.kappa)) {
        const ErrorSource source = each.error.source;
        const bool held = each.assumed && source != kappa_error;
        if (source >= channel_error_count || (held && taken == Taken::by_fit)) {
            continue;
        }
        tolerance[source] = std::abs(each.error.per_unit(f_hz)) * each.value;
    }
    return tolerance;
}

WaveMotion motion_of(const PhasorRun& run, const IdentifySettings& settings,
                     const JobControl& job) {
    return wave_motion(run, tolerance_of(settings, run.f_ref_hz, Taken::all), job);
}

// The recordings' phasors, several recordings at a time.
std::vector<Result<RecordedRun>> all_runs(std::span<const Recording> recordings,
                                          const IdentifySettings& settings, int threads,
                                          const JobControl& job) {
    const Error not_yet{ErrorCode::interrupted, "", {}};
    std::vector<Result<RecordedRun>> found(recordings.size(), Result<RecordedRun>(not_yet));
    Guarded<std::vector<double>> fractions(recordings.size());
    tbb::task_arena(threads).execute([&] {
        tbb::parallel_for(std::size_t{0}, recordings.size(), [&](std::size_t k) {
            const auto report = [&, k](double fraction) {
                const auto each = fractions.hold();
                (*each)[k] = fraction;
                job.report(std::accumulate(each->begin(), each->end(), 0.0) /
                           static_cast<double>(each->size()));
            };
            found[k] = run_of(recordings[k], settings.signal_of(k), settings.windows, threads,
                              job.with_progress(report));
        });
    });
    return found;
}

// The resonator of the phasors, with the verdicts on its recordings.
Result<ResonatorFit> fit_of(std::span<const PhasorRun> phasors, const FitOptions& options,
                            const JobControl& job) {
    const bool one_projection = std::ranges::any_of(
        phasors, [](const PhasorRun& run) { return shares_projection(usable_windows(run)); });
    if (one_projection) {
        return fit_one_projection(phasors);
    }
    Result<ResonatorFit> fit = fit_resonator(phasors, options, job);
    if (fit) {
        judge_free_decay(phasors, options, job, *fit);
    }
    return fit;
}

// Channels of one projection show no angle and no quadrature of a wave.
void refuse_directions(Identification& found) {
    for (const Diagnostic& warning : found.fit.warnings) {
        if (warning.kind == DiagnosticKind::same_projection) {
            for (IdentifiedRun& run : found.runs) {
                run.wave.theta_rate_rad_s = run.wave.quadrature_rate_per_s =
                    Estimate{.reason = {ReasonCode::same_projection, {}}};
            }
        }
    }
}

// The breaks that the fit has found count in each recording's own numbers, too.
void take_breaks(std::span<const FittedBreak> breaks, const IdentifySettings& settings,
                 std::vector<PhasorRun>& phasors, const JobControl& job, Identification& found) {
    for (const FittedBreak& each : breaks) {
        PhasorRun& run = phasors[each.run];
        run = with_break(run, each);
        IdentifiedRun& identified = found.runs[each.run];
        identified.track = run_track(run, run_track_points);
        identified.wave = motion_of(run, settings, job);
    }
}

// An error of the clock falsifies every frequency, rate and time by as much; Q, a number of
// periods, is free of it.
void add_clock(std::span<const RecordedRun> recordings, Identification& found) {
    const double told =
        found.settings.tolerance[rate_error].value_or(0) * tolerated_errors[rate_error].factor;
    // Uncertainty of a rate from the digits in its file. A stated tolerance is that of one
    // recorder, so that it leaves the differences between the recordings.
    double digits = 0;
    const auto widen = [](Estimate& number, double relative, double size) {
        if (number.given() && relative > 0) {
            number.u = std::hypot(number.uncertainty(), relative * size);
        }
    };
    const auto scale = [&widen](Estimate& number, double relative) {
        widen(number, relative, number.value);
    };
    for (std::size_t k = 0; k < recordings.size(); ++k) {
        const double own = recordings[k].rate_relative_sd;
        digits = std::max(digits, own);
        WaveMotion& wave = found.runs[k].wave;
        for (Estimate* const number : {&wave.f_hz, &wave.tau_s, &wave.theta_rate_rad_s,
                                       &wave.quadrature_rate_per_s, &wave.decay_per_s}) {
            scale(*number, std::hypot(own, told));
        }
    }
    const double relative = std::hypot(digits, told);
    ResonatorFit& fit = found.fit;
    for (std::size_t k = 0; k < fit.shares.size(); ++k) {
        const std::string_view unit = resonator_parameters[k].unit;
        Estimate& number = fit.resonator.*resonator_parameters[k].member;
        const bool clocked = !unit.empty() && unit != "rad";
        if (clocked && number.given()) {
            scale(number, relative);
            fit.shares[k][rate_error] = relative * std::abs(number.value);
        }
    }
    for (ModeEstimate& mode : fit.modes) {
        scale(mode.f_hz, relative);
        scale(mode.tau_s, relative);
    }
    for (std::size_t k = 0; k < fit.runs.size(); ++k) {
        RunEstimate& run = fit.runs[k];
        for (Estimate* const number :
             {&run.direction_f_hz, &run.direction_tau_s, &run.split_sin_hz, &run.drift_hz_per_s}) {
            scale(*number, relative);
        }
        if (fit.runs.size() > 1) {
            widen(run.f_offset_hz, digits, found.runs[k].f0_hz);
        }
    }
}

// Q of the envelope rests on the same decay as the wave's, and errors of the channels move both
// alike.
void add_envelopes(Identification& found) {
    for (std::size_t k = 0; k < found.runs.size(); ++k) {
        const Estimate& decay = found.runs[k].wave.decay_per_s;
        Estimate& q = found.fit.runs[k].q_envelope;
        if (q.given() && decay.given() && decay.u > decay.sd) {
            const double tolerances = std::sqrt(decay.u * decay.u - decay.sd * decay.sd);
            q.u = std::hypot(q.sd, q.value * tolerances / decay.value);
        }
    }
}

std::vector<MessageArg> names_of(std::span<const RecordedRun> recordings) {
    std::vector<MessageArg> names;
    names.reserve(recordings.size());
    for (const RecordedRun& recording : recordings) {
        names.emplace_back(recording.name);
    }
    return names;
}

// What the motion shows of the recording: no free decay, channels of one projection. None where an
// identification is impossible. Errors: interrupted.
Result<std::vector<Diagnostic>> verdicts_on(const Recording& recording,
                                            const SignalSettings& signal, const JobControl& job) {
    constexpr std::array verdicts{DiagnosticKind::no_free_decay, DiagnosticKind::no_free_decay_part,
                                  DiagnosticKind::same_projection, DiagnosticKind::mode_grows};
    IdentifySettings settings;
    settings.signal = signal;
    const Result<Identification> found = identify({&recording, 1}, settings, job.silent());
    if (!found) {
        const bool interrupted = found.error().code == ErrorCode::interrupted;
        return interrupted ? Result<std::vector<Diagnostic>>(found.error())
                           : std::vector<Diagnostic>{};
    }
    std::vector<Diagnostic> said;
    std::ranges::copy_if(found->fit.warnings, std::back_inserter(said), [&](const auto& warning) {
        return std::ranges::find(verdicts, warning.kind) != verdicts.end();
    });
    return said;
}

}  // namespace

Result<Identification> identify(std::span<const Recording> recordings,
                                const IdentifySettings& settings, const JobControl& job) {
    TRY(validate(settings));
    const int threads = threads_of(settings.threads);
    Identification found;
    found.settings = settings;
    found.timing.threads = threads;
    const double begun = job.now();
    std::vector<Result<RecordedRun>> each = all_runs(recordings, settings, threads, job);
    std::vector<RecordedRun> runs;
    for (std::size_t k = 0; k < each.size(); ++k) {
        if (!each[k]) {
            return about(recordings[k], each[k].error());
        }
        found.timing.read_s += each[k]->timing.read_s;
        found.timing.carrier_s += each[k]->timing.carrier_s;
        found.timing.estimate_s += each[k]->timing.estimate_s;
        runs.push_back(std::move(*each[k]));
    }
    found.timing.windows_s = job.now() - begun;
    return identify_runs(std::move(runs), std::move(found), job);
}

void refer_to_recorded(double calibrated, ResonatorFit& fit) {
    fit.resonator.kappa = calibrated * fit.resonator.kappa;
    for (std::size_t k = 0; k < fit.sensitivities.size(); ++k) {
        if (resonator_parameters[k].member == &ResonatorEstimate::kappa) {
            for (double& each : fit.sensitivities[k]) {
                each *= calibrated;
            }
            for (double& each : fit.shares[k]) {
                each *= std::abs(calibrated);
            }
        }
    }
    RawParameters& raw = fit.raw;
    const std::size_t count = raw.names.size();
    for (std::size_t kappa = 0; kappa < count; ++kappa) {
        if (raw.names[kappa] == "kappa") {
            raw.values[kappa] *= calibrated;
            for (std::size_t k = 0; k < count; ++k) {
                raw.covariance[kappa * count + k] *= calibrated;
                raw.covariance[k * count + kappa] *= calibrated;
            }
        }
    }
}

Result<Identification> identify_runs(std::vector<RecordedRun> runs, Identification found,
                                     const JobControl& job) {
    const double fitted_from = job.now();
    const IdentifySettings& settings = found.settings;
    std::vector<PhasorRun> phasors;
    for (RecordedRun& run : runs) {
        found.timing.windows += run.told.windows;
        found.runs.push_back(std::move(run.told));
        found.runs.back().track = run_track(run.phasors, run_track_points);
        found.runs.back().wave = motion_of(run.phasors, settings, job);
        phasors.push_back(std::move(run.phasors));
    }
    const FitOptions options = fit_options(settings, phasors.front().f_ref_hz);
    Result<ResonatorFit> fit = fit_of(phasors, options, job.silent());
    if (!fit) {
        return named(fit.error(), names_of(runs));
    }
    found.fit = std::move(*fit);
    refuse_directions(found);
    take_breaks(found.fit.breaks, settings, phasors, job, found);
    refer_to_recorded(settings.signal.calibration.kappa, found.fit);
    add_envelopes(found);
    add_clock(runs, found);
    for (Diagnostic& warning : found.fit.warnings) {
        name_recordings(names_of(runs), warning.args);
    }
    if (found.fit.model == ResonatorModel::structured) {
        found.drift = drift_function(phasors, found.fit, job);
        for (std::size_t k = 0; k < phasors.size() && !job.cancelled(); ++k) {
            found.balance.push_back(
                channel_balance(phasors[k], found.fit.motion, k, run_track_points));
        }
    }
    found.timing.fit_s = job.now() - fitted_from;
    TRY(job.go_on());
    return found;
}

Result<SampleFaults> inspect(const Recording& recording, const SignalSettings& settings,
                             const JobControl& job) {
    const Result<double> f0 = find_recording_carrier(recording, settings, job.silent());
    Result<SampleFaults> faults = check_recording(*recording.source, recording.rate_hz,
                                                  f0 ? std::optional(*f0) : std::nullopt, job);
    if (faults && f0) {
        const auto verdicts = TRY(verdicts_on(recording, settings, job));
        std::ranges::copy(verdicts, std::back_inserter(faults->findings));
    }
    if (faults) {
        std::vector<Diagnostic> all = recording.diagnostics;
        add_findings(faults->findings, all);
        faults->findings = std::move(all);
    }
    return faults;
}

Error named(Error error, std::span<const MessageArg> names) {
    if (error.code == ErrorCode::fit_too_few_windows) {
        name_recordings(names, error.args);
        error.where = error.args.back().text;
    }
    return error;
}

FitOptions fit_options(const IdentifySettings& settings, double f_hz) {
    FitOptions options;
    options.model = settings.model;
    options.tolerance = tolerance_of(settings, f_hz, Taken::by_fit);
    options.assumed = tolerance_of(settings, f_hz, Taken::all);
    options.spread = settings.tolerance[spread_error];
    return options;
}

Reason no_drift_function(const Identification& identification) {
    if (identification.drift.order > 0) {
        return {};
    }
    const bool free = identification.fit.model == ResonatorModel::free;
    return {free ? ReasonCode::free_model : ReasonCode::few_angles, {}};
}

}  // namespace vybeg
