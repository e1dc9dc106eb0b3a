#include "core/output/identify_json.h"

#include "core/analysis/measurement_list.h"
#include "core/analysis/setting_table.h"
#include "core/base/number_text.h"
#include "core/output/quantity_json.h"
#include "core/resonator/results/resonator_parameters.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <map>
#include <numbers>
#include <utility>

namespace vybeg {
namespace {

// Each kind once for each input, the worst first.
Json warnings_json(const Identification& identification, std::span<const RecordingRef> inputs) {
    std::vector<std::pair<Finding, Json>> findings;
    const auto add = [&findings](const std::vector<Diagnostic>& diagnostics, const Json& input) {
        for (Finding& finding : findings_of(diagnostics)) {
            findings.emplace_back(std::move(finding), input);
        }
    };
    add(identification.fit.warnings, nullptr);
    for (std::size_t k = 0; k < identification.runs.size(); ++k) {
        add(identification.runs[k].diagnostics, inputs[k].name());
    }
    const auto weight = [](const auto& each) { return severity(each.first.diagnostic.kind); };
    std::ranges::stable_sort(findings, std::ranges::greater(), weight);
    Json list = Json::array();
    for (const auto& [finding, input] : findings) {
        Json warning = finding_json(finding);
        warning["input"] = input;
        for (const Diagnostic& other : finding.more) {
            warning["more"].push_back(english(other));
        }
        list.push_back(std::move(warning));
    }
    return list;
}

// The rms of the residual as a quantity: of N real numbers it has the deviation rms / sqrt(2 N).
Json residual_json(const Identification& identification) {
    double numbers = 0;
    for (const IdentifiedRun& run : identification.runs) {
        numbers += 4 * static_cast<double>(run.windows_used);
    }
    const double freedom = numbers - static_cast<double>(identification.fit.raw.names.size());
    const double rms = identification.fit.residual_rms;
    return quantity_json({rms, rms / std::sqrt(2 * std::max(freedom, 1.0)), {}});
}

// By how much a parameter is wrong per unit of each error.
Json sensitivity_json(const BySource& sensitivity) {
    Json object;
    for (const UsualError& error : usual_errors) {
        object[error.key] = number_json(sensitivity[error.source]);
    }
    return object;
}

Json modes_json(const std::vector<ModeEstimate>& modes) {
    Json list = parameters_json(modes, mode_parameters);
    for (std::size_t k = 0; k < modes.size(); ++k) {
        const ModeEstimate& mode = modes[k];
        for (std::size_t of = 0; of < mode.sensitivities.size(); ++of) {
            const ModeParameter& parameter = mode_parameters[of];
            if ((mode.*parameter.member).given()) {
                list[k][parameter.name]["sensitivity"] = sensitivity_json(mode.sensitivities[of]);
            }
        }
    }
    return list;
}

// The tolerances in u, and whether they are stated or assumed.
Json tolerances_json(const IdentifySettings& settings) {
    Json object = Json::object();
    for (const ToleranceInUse& each :
         tolerances_in_use(settings.tolerance, settings.signal.calibration.kappa)) {
        object[each.error.name] = {
            {"value", each.value}, {"unit", each.error.unit}, {"assumed", each.assumed}};
    }
    return object;
}

Json resonator_json(const Identification& identification) {
    if (identification.fit.model == ResonatorModel::free) {
        return nullptr;
    }
    Json object;
    const ResonatorFit& fit = identification.fit;
    for (std::size_t k = 0; k < resonator_parameters.size(); ++k) {
        const Estimate& estimate = fit.resonator.*resonator_parameters[k].member;
        Json& quantity = object[resonator_parameters[k].name] = quantity_json(estimate);
        if (estimate.given() && k < fit.sensitivities.size()) {
            quantity["sensitivity"] = sensitivity_json(fit.sensitivities[k]);
        }
    }
    object["residual_rms"] = residual_json(identification);
    return object;
}

// Where Q depends on the amplitude, with the one at which it holds, and with Q at both ends.
Json q_envelope_json(const RunEstimate& run) {
    Json quantity = quantity_json(run.q_envelope);
    if (run.law && run.q_envelope.given()) {
        const QBand band = q_band(*run.law, run.q_envelope.value);
        quantity["at_amplitude"] = number_json(band.amplitude);
        quantity["band"] = {
            {{"amplitude", number_json(band.largest)}, {"value", number_json(band.q_at_largest)}},
            {{"amplitude", number_json(band.smallest)},
             {"value", number_json(band.q_at_smallest)}}};
    }
    return quantity;
}

Json runs_json(const Identification& identification, std::span<const RecordingRef> inputs) {
    Json list = Json::array();
    for (std::size_t k = 0; k < identification.runs.size(); ++k) {
        const RunEstimate& run = identification.fit.runs[k];
        const IdentifiedRun& input = identification.runs[k];
        list.push_back({{"name", inputs[k].name()},
                        {"wave", parameters_json(input.wave, wave_parameters)},
                        {"f_offset_hz", quantity_json(run.f_offset_hz)},
                        {"a_A", quantity_json(run.a_A)},
                        {"a_B", quantity_json(run.a_B)},
                        {"two_theta_A_rad", quantity_json(run.two_theta_A_rad)},
                        {"split_sin_hz", quantity_json(run.split_sin_hz)},
                        {"direction",
                         {{"f_hz", quantity_json(run.direction_f_hz)},
                          {"tau_s", quantity_json(run.direction_tau_s)}}},
                        {"q_envelope", q_envelope_json(run)},
                        {"drift_hz_per_s", quantity_json(run.drift_hz_per_s)},
                        {"window_samples", input.window},
                        {"windows", input.windows},
                        {"windows_used", input.windows_used},
                        {"noise_sd", number_json(input.noise_sd)}});
    }
    return list;
}

const char* shape_name(const NoiseShape& shape) {
    if (std::isinf(shape.half_width_hz)) {
        return "white";
    }
    return shape.half_width_hz == 0 ? "1/f" : "line";
}

// Parts of the residual besides the noise of the windows, one entry per shape, in both channels and
// in the phase only: variance in units of that noise, half width weighted with it.
Json noise_json(const ResidualNoise& noise) {
    struct Sum {
        double variance = 0;
        double width = 0;
    };
    std::map<std::pair<std::string, std::string>, Sum> sums;
    for (const ResidualNoise::Part& part : noise.parts) {
        Sum& sum = sums[{part.shape.of_phase ? "phase" : "signal", shape_name(part.shape)}];
        sum.variance += part.variance;
        sum.width += part.variance * part.shape.half_width_hz;
    }
    Json parts = Json::array();
    for (const auto& [kind, sum] : sums) {
        const auto& [of, shape] = kind;
        Json part{{"of", of}, {"shape", shape}, {"variance", number_json(sum.variance)}};
        if (shape == "line") {
            part["half_width_hz"] = number_json(sum.width / sum.variance);
        }
        parts.push_back(part);
    }
    return {{"kind", noise.white() ? "white" : "coloured"},
            {"parts", parts},
            {"narrowest", noise.narrowest}};
}

// Which of its quantities the recordings determine.
Json identifiable_json(const ResonatorEstimate& resonator) {
    return {{"split", resonator.split_hz.given()},
            {"theta_w", resonator.theta_w_rad.given()},
            {"tau", resonator.tau_s.given()},
            {"damping_anisotropy", resonator.damping_anisotropy_per_s.given()},
            {"theta_tau", resonator.theta_tau_rad.given()},
            {"rotation", resonator.angle_rate_rad_s.given()},
            {"kappa", resonator.kappa.given()}};
}

// The curve at every 2.5 degrees of its period, and that of the fitted resonator.
Json curve_json(const DriftFunction& drift, const ResonatorFit& fit) {
    constexpr int steps = 36;
    std::vector<double> theta;
    std::vector<double> rate;
    std::vector<double> sd;
    std::vector<double> u;
    std::vector<double> fitted;
    const Eigen::Matrix2cd m = SlowDynamics(fit.motion.shared).matrix();
    for (int k = 0; k <= steps; ++k) {
        theta.push_back((static_cast<double>(k) / steps - 0.5) * std::numbers::pi / 2);
        rate.push_back(drift.rate(theta.back()));
        sd.push_back(drift.sd_rate(theta.back()));
        u.push_back(drift.u_rate(theta.back()));
        fitted.push_back(drift_of_dynamics(m, theta.back()));
    }
    Json curve{{"theta_rad", numbers_json(theta)},
               {"rate_rad_s", numbers_json(rate)},
               {"sd_rad_s", numbers_json(sd)},
               {"u_rad_s", numbers_json(u)}};
    if (fit.model == ResonatorModel::structured) {
        curve["of_resonator_rad_s"] = numbers_json(fitted);
    }
    return curve;
}

Json drift_json(const Identification& identification) {
    const DriftFunction& drift = identification.drift;
    constexpr std::array<const char*, 5> names{"mean_rad_s", "cos4_rad_s", "sin4_rad_s",
                                               "cos8_rad_s", "sin8_rad_s"};
    const auto point = [](const DriftPoint& each) -> Json {
        return {{"run", each.run},
                {"theta_rad", number_json(each.theta)},
                {"rate_rad_s", quantity_json({each.rate, each.sd_rate, {}})}};
    };
    Reason none = no_drift_function(identification);
    if (none.code == ReasonCode::none) {
        none.code = ReasonCode::few_angles;  // for harmonics above the order of the curve
    }
    Json harmonics = Json::object();
    for (std::size_t k = 0; k < names.size(); ++k) {
        const auto at = static_cast<Eigen::Index>(k);
        harmonics[names[k]] = quantity_json(
            at < drift.coefficients.size() ? drift.coefficient(at) : Estimate{.reason = none});
    }
    return {{"order", drift.order},
            {"harmonics", harmonics},
            {"chi2_per_dof", number_json(drift.chi2_per_freedom)},
            {"points", list_json(drift.points, point)},
            {"curve", drift.order > 0 ? curve_json(drift, identification.fit) : Json(nullptr)}};
}

// Six digits of the deviation, and the value to their last place: each recording has 200 points,
// and the digits below are of the noise.
Json rounded_json(std::span<const double> values, std::span<const double> sds) {
    constexpr int digits = 6;
    constexpr int all_digits = 17;
    std::vector<double> rounded;
    for (std::size_t k = 0; k < values.size(); ++k) {
        const double above = std::ceil(std::log10(std::abs(values[k] / sds[k])));
        const int kept = std::isfinite(above)
                             ? digits + static_cast<int>(std::clamp(above, 0.0, 11.0))
                             : all_digits;
        rounded.push_back(*parse_number(short_text(values[k], std::min(kept, all_digits))));
    }
    return numbers_json(rounded);
}

Json balance_json(const Identification& identification, std::span<const RecordingRef> inputs) {
    if (identification.balance.empty()) {
        return nullptr;
    }
    Json list = Json::array();
    for (std::size_t k = 0; k < identification.balance.size(); ++k) {
        const ChannelBalance& balance = identification.balance[k];
        list.push_back({{"name", inputs[k].name()},
                        {"time_s", numbers_json(balance.time_s)},
                        {"orthogonality", rounded_json(balance.orthogonality, balance.sd)},
                        {"sd", rounded_json(balance.sd, balance.sd)}});
    }
    return list;
}

Json differences_json(std::span<const Difference> differences) {
    Json list = Json::array();
    for (const Difference& difference : differences) {
        Json object{{"name", difference.name},
                    {"passport", quantity_json(difference.then)},
                    {"now", quantity_json(difference.now)},
                    {"verdict", verdict_name(difference.verdict)}};
        if (!difference.known()) {
            object["change"] = {{"value", nullptr}, {"reason", incomparable_text(difference)}};
            object["relative"] = nullptr;
            object["deviations"] = nullptr;
        } else {
            object["change"] = quantity_json({difference.change, difference.sd, {}, difference.u});
            object["relative"] = number_json(difference.relative);
            object["deviations"] = number_json(difference.deviations());
        }
        if (difference.known() && difference.limit > 0) {
            object["limit"] = difference.limit;
        }
        list.push_back(object);
    }
    return list;
}

}  // namespace

std::vector<Finding> findings_of(const Identification& identification) {
    std::vector<NamedWarnings> all{{"", identification.fit.warnings}};
    for (const IdentifiedRun& run : identification.runs) {
        all.emplace_back("", run.diagnostics);
    }
    return findings_of(all);
}

std::string identify_json(const SetResult& result) {
    const Identification& identification = result.identification;
    const std::vector<RecordingRef>& inputs = result.set.recordings;
    const ResonatorFit& fit = identification.fit;
    Json json{
        {"program", result.program},
        {"inputs", inputs_json(inputs)},
        {"settings", named_json(settings_list(identification.settings))},
        {"tolerances", tolerances_json(identification.settings)},
        {"frequencies_by",
         identification.settings.tolerance[rate_error] ? "tolerance" : "clock of the recorder"},
        {"warnings", warnings_json(identification, inputs)}};
    if (const auto& comparison = result.comparison) {
        json["passport"] = {{"file", comparison->file},
                            {"sha256", comparison->sha256},
                            {"program", comparison->passport.program}};
        json["differences"] = differences_json(comparison->differences);
    }
    json["model"] = fit.model == ResonatorModel::structured ? "structured" : "free";
    json["modes"] = modes_json(fit.modes);
    json["modes_by"] = mode_order_name(fit.mode_order);
    if (fit.modes.empty()) {
        json["modes_reason"] = english(fit.no_modes);
    }
    json["resonator"] = resonator_json(identification);
    if (fit.model == ResonatorModel::free) {
        json["resonator_reason"] = english(Reason{ReasonCode::free_model, {}});
        json["residual_rms"] = residual_json(identification);
    }
    json["runs"] = runs_json(identification, inputs);
    json["identifiable"] = identifiable_json(fit.resonator);
    json["noise"] = noise_json(fit.noise);
    json["chi2_per_dof"] = number_json(fit.chi2_per_dof);
    json["free_over_structured"] = number_json(fit.free_over_structured);
    json["drift_function"] = drift_json(identification);
    json["channel_balance"] = balance_json(identification, inputs);
    return json_text(json);
}

Passport passport_of(const SetResult& result) {
    const Identification& identification = result.identification;
    Passport passport;
    static_cast<ResonatorNumbers&>(passport) = identification.fit;
    passport.program = result.program;
    passport.gyro = gyro_of(result.set);
    passport.date = list_date_of(result.set);
    for (auto& condition : conditions_of(result.set)) {
        if (!condition.second.empty()) {
            passport.conditions.push_back(std::move(condition));
        }
    }
    passport.inputs = result.set.recordings;
    passport.settings = settings_list(identification.settings);
    for (const IdentifiedRun& run : identification.runs) {
        passport.tracks.push_back(run.track);
    }
    return passport;
}

std::string recording_json(const Recording& recording, const std::string& sha256,
                           std::span<const Diagnostic> findings) {
    const auto channel = [](const Channel& each) -> Json {
        return {{"name", each.name}, {"unit", each.unit}};
    };
    const auto check = [](const Diagnostic& each) -> Json {
        return {{"kind", kind_name(each.kind)},
                {"severity", severity_name(severity(each.kind))},
                {"first_frame", each.first_frame},
                {"count", each.count},
                {"text", english(each)}};
    };
    // Of times it is a quotient, whose last digits are those of the machine: 33332.99999999999.
    constexpr int digits_of_times = 12;
    const double rate_hz = recording.rate_from == RateOrigin::time_column
                               ? *parse_number(short_text(recording.rate_hz, digits_of_times))
                               : recording.rate_hz;
    Json info{{"format", english(recording.format)},
              {"frames", recording.frames()},
              {"seconds", recording.seconds()},
              {"rate_hz", rate_hz},
              {"rate_from", rate_origin_name(recording.rate_from)},
              {"channels", list_json(recording.channels, channel)},
              {"start", recording.start},
              {"sha256", sha256},
              {"check", list_json(findings, check)}};
    if (recording.rate_relative_sd > 0) {
        info["rate_relative_sd"] = recording.rate_relative_sd;
    }
    return json_text(info);
}

}  // namespace vybeg
