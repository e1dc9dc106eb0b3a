#include "core/analysis/ignored_options.h"

#include "core/recording/open/open_recording.h"

#include <algorithm>
#include <utility>

namespace vybeg {
namespace {

// Only some files hold variables with names.
bool has_variables(const Recording& recording) {
    if (!recording.file) {
        return true;
    }
    const auto head = file_head(*recording.file);
    if (!head) {
        return true;
    }
    const FileFormat* const format = find_format(*head, *recording.file);
    return format && format->has_variables;
}

constexpr const char* no_samples = "a log holds no samples of the carrier";

class Findings {
public:
    void add(bool idle, const char* option, const char* why) {
        if (idle) {
            found_.push_back({DiagnosticKind::option_without_effect, {option, why}});
        }
    }
    void add_idle_search(const SignalSettings& settings) {
        add(settings.band && settings.f0_hz, "--band", "--f0 skips the search for the carrier");
    }
    // Options of samples.
    void add_idle_on_log(const SignalSettings& signal, const LogChoice& log) {
        const Calibration& calibration = signal.calibration;
        add(calibration.offset_auto || calibration.offset_c != 0 || calibration.offset_d != 0,
            "--offset", no_samples);
        add(signal.band.has_value(), "--band", no_samples);
        add(signal.filter.has_value(), "--filter", no_samples);
        // Without a phase a delay counts at it.
        add(signal.f0_hz && !log.without_phase(), "--f0", no_samples);
        add(signal.repair_lost, "--repair-lost", no_samples);
    }
    // What belongs to logs of another kind, or to none.
    void add_idle_choice(const LogChoice& log) {
        constexpr const char* only_phasors = "only phasors have it: give --phasors, too";
        const PhasorChoice& how = log.phasors;
        const bool none = how.frame == PhasorFrame::none;
        add(!log.given() && log.rad_per_angle_unit > 0, "--angle-unit",
            "only logs have it: give --columns or --phasors, too");
        add(none && how.f_ref_hz > 0, "--f-ref", only_phasors);
        add(none && how.y_sign != 0, "--y-sign", only_phasors);
        add(none && how.peak_per_unit > 0, "--amplitude", only_phasors);
        add(none && how.filter.order > 0, "--lock-in", only_phasors);
    }
    std::vector<Diagnostic> take() { return std::move(found_); }

private:
    std::vector<Diagnostic> found_;
};

}  // namespace

std::vector<Diagnostic> without_effect(const Settings& settings) {
    constexpr const char* only_descent = "only conjugate-gradient has start values";
    const bool descent = settings.algorithm == Algorithm::conjugate_gradient;
    Findings found;
    found.add(settings.initial && !descent, "--initial", only_descent);
    found.add(settings.start != StartRule::first && !descent, "--start", only_descent);
    found.add_idle_search(settings);
    return found.take();
}

std::vector<Diagnostic> without_effect(const IdentifySettings& settings) {
    Findings found;
    const std::vector<SignalSettings>& each = settings.of_recordings;
    const auto idle = std::ranges::find_if(each, [](const auto& s) { return s.band && s.f0_hz; });
    found.add_idle_search(idle == each.end() ? settings.signal : *idle);
    found.add_idle_choice(settings.logs);
    if (settings.logs.given()) {
        found.add_idle_on_log(settings.signal, settings.logs);
        found.add(settings.windows.window.has_value(), "--window", no_samples);
        found.add(settings.windows.periods.has_value(), "--periods", no_samples);
    }
    return found.take();
}

std::vector<Diagnostic> without_effect(const Settings& settings, const LogChoice& log) {
    const Settings usual;
    Findings found;
    found.add_idle_choice(log);
    if (!log.given()) {
        return found.take();
    }
    found.add_idle_on_log(settings, log);
    found.add(settings.algorithm != usual.algorithm, "--algorithm", no_samples);
    found.add(settings.window != usual.window, "--window", no_samples);
    found.add(settings.periods.has_value(), "--periods", no_samples);
    found.add(settings.hop != usual.hop, "--hop", no_samples);
    return found.take();
}

std::vector<Diagnostic> without_effect(const OpenOptions& options, const Recording& recording) {
    Findings found;
    found.add(options.rate_hz && recording.rate_from != RateOrigin::option, "--rate",
              "the file has its own sample rate");
    found.add(
        options.text && options.text->time_unit_s && recording.rate_from != RateOrigin::time_column,
        "--time-unit", "there is no time column");
    found.add(
        !options.variables.empty() && (options.raw || options.text || !has_variables(recording)),
        "--variables", "the file has none by name");
    return found.take();
}

}  // namespace vybeg
