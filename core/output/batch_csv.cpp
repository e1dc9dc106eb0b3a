#include "core/output/batch_csv.h"

#include "core/analysis/set_conditions.h"
#include "core/base/finding.h"
#include "core/base/messages.h"
#include "core/base/number_text.h"
#include "core/base/plain_text.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <fstream>
#include <iterator>
#include <string_view>
#include <utility>

namespace vybeg {
namespace {

struct Parameter {
    const char* name;
    Estimate ResonatorEstimate::*member;
};

// Those of the table, each with its deviation beside it and its uncertainty u further on.
constexpr std::array parameters{
    Parameter{"f_mean_hz", &ResonatorEstimate::f_mean_hz},
    Parameter{"split_hz", &ResonatorEstimate::split_hz},
    Parameter{"theta_w_rad", &ResonatorEstimate::theta_w_rad},
    Parameter{"tau_s", &ResonatorEstimate::tau_s},
    Parameter{"q", &ResonatorEstimate::q},
    Parameter{"damping_anisotropy_per_s", &ResonatorEstimate::damping_anisotropy_per_s},
    Parameter{"theta_tau_rad", &ResonatorEstimate::theta_tau_rad},
    Parameter{"angle_rate_rad_s", &ResonatorEstimate::angle_rate_rad_s},
    Parameter{"kappa", &ResonatorEstimate::kappa}};

// A text as a field: in quotes where it holds a separator, a quote or a blank at its end.
std::string field(const std::string& text) {
    const std::string plain = plain_text(text);
    const bool quoted = plain.find_first_of(",;\"") != std::string::npos ||
                        plain.starts_with(' ') || plain.ends_with(' ') || plain.starts_with('#');
    if (!quoted) {
        return plain;
    }
    std::string field = "\"";
    for (const char character : plain) {
        field += character == '"' ? "\"\"" : std::string(1, character);
    }
    return field + "\"";
}

std::string in_row(const std::vector<std::string>& texts) {
    std::string row;
    for (const std::string& text : texts) {
        row += &text == &texts.front() ? "" : ",";
        row += field(text);
    }
    return row;
}

// An empty field is "not told".
std::string number(double value) {
    return std::isfinite(value) ? round_trip_text(value) : "";
}

// `results`: from the model to the warnings; empty: there are none.
std::string whole_row(const MeasurementSet& set, const std::string& status,
                      const std::string& message, const std::vector<std::string>& results) {
    std::string files;
    for (const ListedRecording& recording : set.recordings) {
        files += (files.empty() ? "" : ";") + recording.file;
    }
    std::vector<std::string> texts{set.name, gyro_of(set), list_date_of(set),
                                   files,    status,       message};
    texts.insert(texts.end(), results.begin(), results.end());
    const auto conditions = conditions_of(set);
    texts.resize(batch_columns().size() - conditions.size());
    for (const auto& [column, field] : conditions) {
        texts.push_back(field);
    }
    for (std::size_t k = 0; k < set.recordings.front().others.size(); ++k) {
        texts.push_back(other_of(set, k));
    }
    return in_row(texts);
}

// The verdict about the gyro, and the names of the parameters that have changed, without Q, which
// follows from others.
std::pair<std::string, std::string> verdict(const PassportComparison* comparison) {
    if (comparison == nullptr) {
        return {};
    }
    std::string verdict = "not-comparable";
    std::string changed;
    for (const Difference& difference : comparison->differences) {
        if (difference.verdict == Verdict::changed && !difference.follows) {
            changed += (changed.empty() ? "" : ";") + difference.name;
        }
        if (difference.verdict == Verdict::unchanged) {
            verdict = "unchanged";
        }
    }
    return {changed.empty() ? verdict : "changed", changed};
}

}  // namespace

std::vector<std::string> batch_columns() {
    std::vector<std::string> names{"set", "gyro", "date", "files", "status", "message", "model"};
    for (const Parameter& parameter : parameters) {
        names.emplace_back(parameter.name);
        names.push_back(std::string("sd_") + parameter.name);
    }
    names.insert(names.end(), {"noise", "chi2_per_dof", "verdict", "changed"});
    for (const Parameter& parameter : parameters) {
        names.push_back(std::string("u_") + parameter.name);
    }
    names.emplace_back("warnings");
    for (const auto& [column, field] : conditions_of({})) {
        names.push_back(column);
    }
    return names;
}

bool is_batch_table(const std::filesystem::path& path) {
    constexpr std::string_view begin = "# vybeg-cli ";
    std::string head(begin.size(), '\0');
    std::ifstream file(path, std::ios::binary);
    return file.read(head.data(), std::ssize(head)) && head == begin;
}

std::string batch_head(std::span<const std::string> header,
                       std::span<const std::string> other_columns) {
    std::string text;
    for (const std::string& line : header) {
        text += "# " + plain_text(line) + "\n";
    }
    std::vector<std::string> names = batch_columns();
    for (std::string name : other_columns) {
        while (std::ranges::find(names, name) != names.end()) {
            name.insert(0, "list_");
        }
        names.push_back(name);
    }
    return text + in_row(names);
}

std::string batch_row(const MeasurementSet& set, const Error& error) {
    return whole_row(set, std::to_string(exit_status(error.code)), english(error), {});
}

std::string batch_row(const MeasurementSet& set, const Identification& found,
                      const PassportComparison* comparison) {
    const ResonatorFit& fit = found.fit;
    std::vector<std::string> results{fit.model == ResonatorModel::structured ? "structured"
                                                                             : "free"};
    for (const Parameter& parameter : parameters) {
        const Estimate& estimate = fit.resonator.*parameter.member;
        results.push_back(estimate.given() ? number(estimate.value) : "");
        results.push_back(estimate.given() ? number(estimate.sd) : "");
    }
    const std::vector<Finding> findings = findings_of(found);
    // Numbers that may be wrong are compared with nothing: the message says why.
    const bool doubtful =
        !findings.empty() && severity(findings.front().diagnostic.kind) == Severity::serious;
    const auto [judged, changed] = verdict(doubtful ? nullptr : comparison);
    results.insert(results.end(), {fit.noise.white() ? "white" : "coloured",
                                   number(fit.chi2_per_dof), judged, changed});
    for (const Parameter& parameter : parameters) {
        const Estimate& estimate = fit.resonator.*parameter.member;
        results.push_back(estimate.given() ? number(estimate.u) : "");
    }
    results.push_back(warning_kinds(findings));
    return whole_row(set, "ok", doubtful ? english(findings.front()) : "", results);
}

std::string csv_row(const std::vector<std::string>& texts) {
    return in_row(texts);
}

}  // namespace vybeg
