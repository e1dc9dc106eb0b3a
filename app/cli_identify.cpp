#include "app/cli_commands.h"
#include "app/cli_support.h"
#include "core/analysis/setting_table.h"
#include "core/base/number_text.h"
#include "core/base/plain_text.h"
#include "core/batch/batch_sets.h"
#include "core/batch/identify_set.h"
#include "core/database/results_database.h"
#include "core/output/identify_json.h"
#include "core/output/output_file.h"
#include "core/output/passport_json.h"
#include "core/recording/samples/open_table.h"
#include "core/resonator/results/resonator_parameters.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <optional>
#include <string_view>
#include <utility>

namespace vybeg::cli {
namespace {

constexpr double degrees = 180 / std::numbers::pi;
constexpr double negligible = 0.01;  // of a standard deviation

// What the wave of a recording did, whatever the resonator is.
std::string wave_text(const RecordingRef& recording, const WaveMotion& wave) {
    return "wave of " + recording.name() + ", means over the recording\n" +
           lines_of(wave, wave_parameters);
}

std::string padded(const std::string& text, std::size_t width) {
    return std::string(width - std::min(width, text.size()), ' ') + text;
}

// "kappa 0.01 (assumed), skew 0.1 deg (assumed)": what u holds besides sd.
std::string tolerances_text(const IdentifySettings& settings) {
    const std::string list =
        joined(tolerances_in_use(settings.tolerance, settings.signal.calibration.kappa), ", ",
               [](const ToleranceInUse& each) {
                   const std::string unit = each.error.unit;
                   return std::string(each.error.name) + " " + short_text(each.value, 3) +
                          (unit.empty() ? "" : " " + unit) + (each.assumed ? " (assumed)" : "");
               });
    std::string text = "± is statistical";
    if (!list.empty()) {
        text += "; u holds the tolerances " + list;
    }
    return text + "\n" +
           (settings.tolerance[rate_error] ? "" : "frequencies by the clock of the recorder\n");
}

// By how much each parameter is wrong by an error of a usual size.
std::string sensitivities_text(const ResonatorFit& fit) {
    std::string rows;
    const auto add = [&rows](std::string row, const auto& parameter, const Estimate& estimate,
                             const BySource& sensitivity) {
        if (!estimate.given()) {
            return;
        }
        const bool angle = std::string_view(parameter.unit) == "rad";
        const std::string unit = angle ? "deg" : parameter.unit;
        row += label_of(parameter.name) + (unit.empty() ? "" : ", " + unit);
        row.resize(std::max<std::size_t>(row.size() + 1, 38), ' ');
        for (const UsualError& error : usual_errors) {
            const double change = error.size * sensitivity[error.source];
            const bool felt = std::abs(change) > negligible * estimate.sd;
            row += padded(felt ? short_text(angle ? change * degrees : change, 3) : "~0", 12);
        }
        rows += row + "\n";
    };
    for (std::size_t k = 0; k < fit.sensitivities.size(); ++k) {
        const ResonatorParameter& parameter = resonator_parameters[k];
        add("  ", parameter, fit.resonator.*parameter.member, fit.sensitivities[k]);
    }
    for (std::size_t k = 0; k < fit.modes.size(); ++k) {
        const ModeEstimate& mode = fit.modes[k];
        for (std::size_t of = 0; of < mode.sensitivities.size(); ++of) {
            add("  mode " + std::to_string(k + 1) + " ", mode_parameters[of],
                mode.*mode_parameters[of].member, mode.sensitivities[of]);
        }
    }
    if (rows.empty()) {
        return "";
    }
    std::string head = "  error of a parameter by";
    head.resize(38, ' ');
    std::string names(38, ' ');
    for (const UsualError& error : usual_errors) {
        head += padded(error.amount, 12);
        names += padded(error.name, 12);
    }
    return "sensitivity: by how much a value would be wrong by errors of the channels (u holds "
           "those with a tolerance),\n"
           "by a cubic spring, a damping or pick-offs that follow the amplitude, by springs unlike "
           "along the axes\n"
           "(at the largest amplitude), and by an eighth harmonic of the drift\n" +
           head + "\n" + names + "\n" + rows;
}

std::string modes_text(const ResonatorFit& fit) {
    if (fit.modes.empty()) {
        return "modes: - " + english(fit.no_modes) + "\n";
    }
    std::string text = "modes by falling ";
    text += fit.mode_order == ModeOrder::decay ? "decay rate" : "frequency";
    text += "\n";
    for (std::size_t k = 0; k < fit.modes.size(); ++k) {
        text += "mode " + std::to_string(k + 1) + "\n" + lines_of(fit.modes[k], mode_parameters);
    }
    return text;
}

// "1234 ± 5 at the amplitude 0.41 (900 at 0.95, 3000 at 0.1)" where Q depends on the amplitude.
std::string q_envelope_text(const RunEstimate& run) {
    const std::string text = text_of(run.q_envelope, "");
    if (!run.law || !run.q_envelope.given()) {
        return text;
    }
    const QBand band = q_band(*run.law, run.q_envelope.value);
    return text + " at the amplitude " + short_text(band.amplitude, 3) + " (" +
           short_text(band.q_at_largest, 3) + " at " + short_text(band.largest, 3) + ", " +
           short_text(band.q_at_smallest, 3) + " at " + short_text(band.smallest, 3) + ")";
}

std::string run_text(const RecordingRef& recording, const IdentifiedRun& run,
                     const RunEstimate& estimate) {
    return "run " + plain_text(recording.name()) + "\n" +
           line("windows", integer_text(run.windows_used) + " of " + integer_text(run.windows) +
                               ", " + integer_text(run.window) + " samples") +
           line("f_offset", text_of(estimate.f_offset_hz, "Hz")) +
           line("a_A", text_of(estimate.a_A, "")) + line("a_B", text_of(estimate.a_B, "")) +
           line("two_theta_A", text_of(estimate.two_theta_A_rad, "rad")) +
           line("split_sin", text_of(estimate.split_sin_hz, "Hz")) +
           line("f of this direction", text_of(estimate.direction_f_hz, "Hz")) +
           line("tau of this direction", text_of(estimate.direction_tau_s, "s")) +
           line("q of this wave", q_envelope_text(estimate)) +
           line("drift", text_of(estimate.drift_hz_per_s, "Hz/s"));
}

std::string drift_text(const Identification& identification) {
    const DriftFunction& drift = identification.drift;
    if (drift.order == 0) {
        return "drift function: - " + english(no_drift_function(identification)) + "\n";
    }
    constexpr std::array<const char*, 5> names{"mean", "cos 4 theta", "sin 4 theta", "cos 8 theta",
                                               "sin 8 theta"};
    std::string text = "drift function, d theta_A/dt\n";
    for (Eigen::Index k = 0; k < drift.coefficients.size(); ++k) {
        text += line(names[static_cast<std::size_t>(k)], text_of(drift.coefficient(k), "rad/s"));
    }
    return text;
}

// "+2.1 %", or ppm where there is less; with a comma before it, empty where it says nothing.
std::string relative_text(double relative) {
    constexpr double rounding = 1e-12;
    if (std::isnan(relative) || std::abs(relative) < rounding) {
        return "";
    }
    const bool small = std::abs(relative) < 1e-4;
    const std::string text = short_text(relative * (small ? 1e6 : 1e2), 3);
    return std::string(" (") + (relative > 0 ? "+" : "") + text + (small ? " ppm)" : " %)");
}

std::string difference_text(const Difference& difference) {
    const std::string verdict = std::string(verdict_name(difference.verdict)) + ": ";
    if (!difference.known()) {
        return line(label_of(difference.name), verdict + incomparable_text(difference));
    }
    const Estimate change{difference.change, difference.u, {}};
    std::string text = verdict + "by " + text_of(change, difference.unit) +
                       relative_text(difference.relative) + ", " +
                       short_text(difference.deviations(), 3) + " u";
    if (difference.limit > 0 && std::abs(difference.change) <= difference.limit) {
        text += ", within the limit of " + short_text(difference.limit, 3) + " " + difference.unit;
    }
    return line(label_of(difference.name), text);
}

// The summary of an identification for people: what each wave did, resonator, modes, runs, drift
// function and, where there is one, the comparison; every number with its standard deviation, and u
// where it differs, or its reason.
std::string identify_text(const SetResult& result) {
    const std::vector<RecordingRef>& recordings = result.set.recordings;
    const Identification& identification = result.identification;
    const ResonatorFit& fit = identification.fit;
    std::string text;
    for (std::size_t k = 0; k < recordings.size(); ++k) {
        text += wave_text(recordings[k], identification.runs[k].wave);
    }
    text += tolerances_text(identification.settings);
    if (fit.model == ResonatorModel::structured) {
        text += "resonator, structured model\n" + lines_of(fit.resonator, resonator_parameters) +
                sensitivities_text(fit);
    } else {
        text += "resonator, free model: " + english(Reason{ReasonCode::free_model, {}}) + "\n";
    }
    text += modes_text(fit);
    for (std::size_t k = 0; k < recordings.size(); ++k) {
        text += run_text(recordings[k], identification.runs[k], fit.runs[k]);
    }
    text += drift_text(identification);
    text += "residual rms " + short_text(fit.residual_rms, 4) + ", " +
            (fit.noise.white() ? "white" : "coloured") + ", chi^2 per degree of freedom " +
            short_text(fit.chi2_per_dof, 4) + "\n";
    if (const auto& comparison = result.comparison) {
        text += "compared with " + plain_text(comparison->file) + ", changed from " +
                short_text(changed_from(count_compared(comparison->differences)), 3) +
                " u of the difference on\n";
        for (const Difference& difference : comparison->differences) {
            text += difference_text(difference);
        }
    }
    return text;
}

Status check_paths(const IdentifyRequest& request, const MeasurementSet& set) {
    std::vector<InputPath> inputs{{request.old_passport, "it is the passport to compare with"},
                                  {request.list, "it is the list of the recordings"}};
    for (const RecordingRef& recording : set.recordings) {
        add_recording_files(inputs, recording.path, recording.open);
    }
    if (request.database == "-") {
        return refused_value("--database", request.database, "it must be a file");
    }
    const bool summary = request.output.empty();
    TRY(check_outputs(
        {{"-o", summary ? "-" : request.output,
          summary ? "the summary goes there already" : "the result goes there already"},
         {"--passport", request.new_passport, "the passport goes there already"},
         {"--database", request.database, ""}},
        inputs));
    for (const std::string& output : {request.output, request.new_passport}) {
        if (output != "-") {
            TRY(check_ending(output, {"", ".json"}));
        }
    }
    return {};
}

Result<std::optional<ResultsDatabase>> open_database(const std::string& name, const JobControl& job,
                                                     Log& log) {
    if (name.empty()) {
        return std::optional<ResultsDatabase>();
    }
    auto database = TRY(ResultsDatabase::open(
        name, ResultsDatabase::Access::write, job,
        [&log](const Diagnostic& waiting) { log.warnings(std::vector{waiting}); }));
    return std::optional(std::move(database));
}

void tell_timing(const IdentifyTiming& timing, double open_s, double write_s, const Log& log) {
    log.timing({{"open_s", open_s},
                {"read_s", timing.read_s},
                {"carrier_s", timing.carrier_s},
                {"estimate_s", timing.estimate_s},
                {"windows_s", timing.windows_s},
                {"fit_s", timing.fit_s},
                {"write_s", write_s},
                {"windows", timing.windows},
                {"threads", timing.threads}});
}

}  // namespace

Status run_identify(const IdentifyRequest& request, Log& log, std::stop_token stop) {
    TRY(validate(request.settings));
    TRY(check_options(request.open));
    auto list = TRY(sets_of(request, request.settings, log));
    if (list.sets.size() > 1) {
        TRY(keep_set(list, "--set", ""));
    }
    const MeasurementSet& set = list.sets.front();
    const double begun = seconds_now();
    const auto open = TRY(open_set(set, request.old_passport, stop));
    TRY(check_paths(request, set));
    // Before the work is done: a missing folder shows at once.
    const bool summary = request.output.empty();
    auto output = TRY(open_output(summary ? "-" : request.output, silent_job(stop)));
    auto passport = TRY(open_named(request.new_passport, silent_job(stop)));
    auto database = TRY(open_database(request.database, silent_job(stop), log));
    const double opened = seconds_now();
    const Result<SetResult> result =
        identify_set(open, program, request.compare, job_of(stop, log));
    if (!result) {
        log.warnings(warnings_of(open));
        return result.error();
    }
    log.warnings(warnings_of(open, *result));
    const double identified = seconds_now();
    if (database) {
        // Before the files, as batch does: the same again replaces what a failure of them leaves.
        const auto stored = TRY(stored_result(*result, identify_json(*result)));
        const auto added = TRY(database->add(stored));
        log.warnings(same_recordings(stored, added.replaced.value_or(stored)));
    }
    // All of them appear, or none: a text that has no room in memory is missed before the first.
    const std::string text = summary ? identify_text(*result) : identify_json(*result);
    const std::string kept = passport ? passport_json(passport_of(*result)) : std::string();
    std::vector<OutputFile*> files{&output};
    TRY(output.write(text));
    if (passport) {
        TRY(passport->write(kept));
        files.push_back(&*passport);
    }
    TRY(OutputFile::commit_together(files));
    tell_timing(result->identification.timing, opened - begun, seconds_now() - identified, log);
    return {};
}

}  // namespace vybeg::cli
