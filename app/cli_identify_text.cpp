#include "app/cli_identify_text.h"

#include "core/base/number_text.h"
#include "core/base/plain_text.h"
#include "core/report/quantity_text.h"
#include "core/resonator/resonator_parameters.h"

#include <array>
#include <cmath>
#include <numbers>
#include <string_view>

namespace vybeg::cli {
namespace {

// "1.00034 ± 0.00005 Hz", "(1.03 ± 0.03)e-6 Hz", or the reason.
std::string text_of(const Estimate& estimate, const std::string& unit) {
    if (!estimate.given()) {
        return "- " + english(estimate.reason);
    }
    const QuantityText text = quantity_text(estimate.value, estimate.sd);
    std::string numbers = text.value;
    if (!text.sd.empty()) {
        numbers += " ± " + text.sd;
    }
    if (text.exponent != 0) {
        numbers = "(" + numbers + ")e" + std::to_string(text.exponent);
    }
    return unit.empty() ? numbers : numbers + " " + unit;
}

// Angles for people are in degrees.
std::string text_in_degrees(const Estimate& estimate) {
    constexpr double degrees = 180 / std::numbers::pi;
    return text_of({estimate.value * degrees, estimate.sd * degrees, estimate.reason}, "deg");
}

std::string line(const std::string& name, const std::string& text) {
    constexpr std::size_t column = 28;
    const std::string indented = "  " + name;
    return indented + std::string(column - std::min(column - 1, indented.size()), ' ') + text +
           "\n";
}

// Parameters for people have the names of the JSON without their units.
std::string label_of(std::string name) {
    for (const std::string_view unit : {"_hz_per_s", "_rad_s", "_per_s", "_rad", "_hz", "_s"}) {
        if (name.ends_with(unit)) {
            name.resize(name.size() - unit.size());
            break;
        }
    }
    return name;
}

std::string parameter_text(const ResonatorParameter& parameter, const Estimate& estimate) {
    return parameter.period > 0 ? text_in_degrees(estimate) : text_of(estimate, parameter.unit);
}

std::string modes_text(const ResonatorFit& fit) {
    if (fit.modes.empty()) {
        return "modes: - " + english(fit.no_modes) + "\n";
    }
    std::string text;
    for (std::size_t k = 0; k < fit.modes.size(); ++k) {
        text += "mode " + std::to_string(k + 1) + "\n";
        for (const ModeParameter& parameter : mode_parameters) {
            text += line(label_of(parameter.name),
                         text_of(fit.modes[k].*parameter.member, parameter.unit));
        }
    }
    return text;
}

std::string run_text(const IdentifiedInput& input, const IdentifiedRun& run,
                     const RunEstimate& estimate) {
    return "run " + plain_text(input.name) + "\n" +
           line("windows", integer_text(run.windows_used) + " of " + integer_text(run.windows) +
                               ", " + integer_text(run.window) + " samples") +
           line("f_offset", text_of(estimate.f_offset_hz, "Hz")) +
           line("a_A", text_of(estimate.a_A, "")) + line("a_B", text_of(estimate.a_B, "")) +
           line("two_theta_A", text_in_degrees(estimate.two_theta_A_rad)) +
           line("split_sin", text_of(estimate.split_sin_hz, "Hz")) +
           line("q_envelope", text_of(estimate.q_envelope, "")) +
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
        text +=
            line(names[static_cast<std::size_t>(k)],
                 text_of({drift.coefficients[k], std::sqrt(drift.covariance(k, k)), {}}, "rad/s"));
    }
    return text;
}

std::string difference_text(const Difference& difference) {
    if (difference.verdict == Verdict::not_comparable) {
        const bool then = difference.then.given();
        return line(label_of(difference.name),
                    std::string(verdict_name(difference.verdict)) + ": " +
                        (then ? "now: " : "in the passport: ") +
                        english(then ? difference.now.reason : difference.then.reason));
    }
    const Estimate change{difference.change, difference.sd, {}};
    const bool angle = std::string_view(difference.unit) == "rad";
    return line(label_of(difference.name),
                std::string(verdict_name(difference.verdict)) + ": by " +
                    (angle ? text_in_degrees(change) : text_of(change, difference.unit)) + ", " +
                    short_text(difference.deviations(), 3) + " standard deviations");
}

}  // namespace

std::string identify_text(std::span<const IdentifiedInput> inputs,
                          const Identification& identification,
                          const PassportComparison* comparison) {
    const ResonatorFit& fit = identification.fit;
    std::string text;
    if (fit.model == ResonatorModel::structured) {
        text += "resonator, structured model\n";
        for (const ResonatorParameter& parameter : resonator_parameters) {
            text += line(label_of(parameter.name),
                         parameter_text(parameter, fit.resonator.*parameter.member));
        }
    } else {
        text += "resonator, free model: " + english(Reason{ReasonCode::free_model, {}}) + "\n";
    }
    text += modes_text(fit);
    for (std::size_t k = 0; k < inputs.size(); ++k) {
        text += run_text(inputs[k], identification.runs[k], fit.runs[k]);
    }
    text += drift_text(identification);
    text += "residual rms " + short_text(fit.residual_rms, 4) + ", chi^2 per degree of freedom " +
            short_text(fit.chi2_per_dof, 4) + "\n";
    if (comparison != nullptr) {
        text += "compared with " + plain_text(comparison->file) + "\n";
        for (const Difference& difference : comparison->differences) {
            text += difference_text(difference);
        }
    }
    return text;
}

}  // namespace vybeg::cli
