#include "core/output/drift_json.h"

#include "core/base/diagnostic.h"
#include "core/base/number_text.h"
#include "core/base/plain_text.h"
#include "core/output/quantity_json.h"

#include <array>
#include <cmath>
#include <numbers>
#include <utility>

namespace vybeg {
namespace {

constexpr double degree = std::numbers::pi / 180;
constexpr double deg_h = 3600 / degree;

Json covariance_json(const Eigen::MatrixXd& covariance) {
    Json rows = Json::array();
    for (Eigen::Index row = 0; row < covariance.rows(); ++row) {
        Json values = Json::array();
        for (Eigen::Index column = 0; column < covariance.cols(); ++column) {
            values.push_back(number_json(deg_h * deg_h * covariance(row, column)));
        }
        rows.push_back(std::move(values));
    }
    return rows;
}

std::string term_key(std::size_t term) {
    return std::string(log_term_names.at(term)) + "_deg_h";
}

// White noise of the angle, the walk of a white rate, and a slow noise beside them.
Json series_noise_json(const SeriesNoise& noise) {
    Json json{{"angle_deg", number_json(std::sqrt(noise.white) / degree)},
              {"walk_deg_per_root_h", number_json(std::sqrt(noise.walk * 3600) / degree)}};
    if (noise.slow == SeriesNoise::Slow::none) {
        json["slow"] = nullptr;
        return json;
    }
    const bool rate = noise.slow == SeriesNoise::Slow::rate;
    const double size = std::sqrt(noise.slow_variance);
    json["slow"] = {
        {"of", rate ? "rate" : "angle"},
        {rate ? "sd_deg_h" : "sd_deg", number_json(rate ? deg_h * size : size / degree)},
        {"correlation_s", number_json(1 / noise.slow_rate)}};
    return json;
}

Json log_json(const LogDrift& drift, bool left_out) {
    Json harmonics;
    for (std::size_t k = 0; k < log_term_names.size(); ++k) {
        harmonics[term_key(k)] =
            quantity_json(degrees_per_hour(drift.coefficient(static_cast<Eigen::Index>(k))));
    }
    return {{"name", drift.name},
            {"sha256", drift.sha256},
            {"seconds", number_json(drift.seconds)},
            {"turn_deg", number_json(drift.turn / degree)},
            {"rows", drift.rows},
            {"missing", drift.missing},
            {"left_out", left_out},
            {"harmonics", harmonics},
            {"covariance_deg_h2", covariance_json(drift.covariance)},
            {"noise", series_noise_json(drift.noise)}};
}

}  // namespace

double degrees_per_hour(double rad_per_s) {
    return deg_h * rad_per_s;
}

Estimate degrees_per_hour(Estimate rad_per_s) {
    return deg_h * std::move(rad_per_s);
}

std::string drift_json(const std::string& program, const DriftOutcome& outcome) {
    const auto& [settings, drift] = outcome;
    Json inputs = Json::array();
    for (std::size_t k = 0; k < drift.logs.size(); ++k) {
        inputs.push_back(log_json(drift.logs[k], drift.left_out == k));
    }
    Json harmonics;
    for (std::size_t k = 0; k < drift.harmonics.size(); ++k) {
        harmonics[term_key(k)] = quantity_json(degrees_per_hour(drift.harmonics[k]));
    }
    const auto agreement = [](const LogAgreement& each) -> Json {
        return {{"harmonic", each.harmonic},
                {"chi2", number_json(each.chi2)},
                {"dof", number_json(each.freedom)},
                {"deviations", number_json(each.deviations)},
                {"agrees", each.agrees}};
    };
    const auto bin = [](const LogBin& each) -> Json {
        return {{"theta_deg", number_json(each.theta / degree)},
                {"rate_deg_h", number_json(degrees_per_hour(each.rate))},
                {"sd_deg_h", number_json(degrees_per_hour(each.sd))},
                {"seconds", number_json(each.seconds)}};
    };
    return json_text({{"program", program},
                      {"settings", named_json(settings_list(settings))},
                      {"warnings", list_json(findings_of(drift.warnings), finding_json)},
                      {"harmonics", harmonics},
                      {"covariance_deg_h2", covariance_json(drift.covariance)},
                      {"agreement", list_json(drift.agreement, agreement)},
                      {"resonator", parameters_json(drift.resonator, held_parameters)},
                      {"logs", inputs},
                      {"bins", list_json(drift.bins, bin)}});
}

std::string drift_csv(const std::string& program, const DriftOutcome& outcome) {
    const auto& [settings, drift] = outcome;
    std::string text = "# " + program + "\n# drift of whole-angle logs, less the turn of each\n";
    for (const LogDrift& log : drift.logs) {
        text += "# input: " + plain_text(log.name) + ", sha256 " + log.sha256 + "\n";
    }
    for (const auto& [name, value] : settings_list(settings)) {
        text += "# " + name + ": " + plain_text(value) + "\n";
    }
    for (const Diagnostic& warning : drift.warnings) {
        text += "# warning: " + english(warning) + "\n";
    }
    text += "theta_deg,rate_deg_h,sd_rate_deg_h,curve_deg_h,sd_curve_deg_h,seconds\n";
    for (const LogBin& bin : drift.bins) {
        const std::array values{bin.theta / degree,
                                degrees_per_hour(bin.rate),
                                degrees_per_hour(bin.sd),
                                degrees_per_hour(drift.rate(bin.theta)),
                                degrees_per_hour(drift.sd_rate(bin.theta)),
                                bin.seconds};
        for (std::size_t k = 0; k < values.size(); ++k) {
            text += k == 0 ? "" : ",";
            append_round_trip(text, values[k]);
        }
        text += "\n";
    }
    return text;
}

}  // namespace vybeg
