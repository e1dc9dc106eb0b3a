#include "core/output/batch_csv.h"

#include "core/base/diagnostic.h"
#include "core/base/number_text.h"
#include "core/base/plain_text.h"
#include "core/recording/samples/text_fields.h"
#include "core/recording/text/csv_rows.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <fstream>
#include <iterator>
#include <string_view>
#include <utility>

namespace vybeg {
namespace {

// Those of the table, each with its deviation beside it and its uncertainty u further on: up to the
// gain ratio.
constexpr std::span parameters = std::span(resonator_parameters).first<9>();

constexpr std::string_view byte_order_mark = "\xEF\xBB\xBF";

// A text as a field: in quotes where it holds a separator, a quote or a blank at its end.
std::string field(const std::string& text, char separator) {
    const std::string plain = plain_text(text);
    // A decimal comma between semicolons needs none.
    const bool quoted =
        plain.find_first_of(separator == ';' ? ";\"" : ",;\"") != std::string::npos ||
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

// `results`: from the model to the warnings; empty: there are none.
BatchRow whole_row(const MeasurementSet& set, const std::string& status, const std::string& message,
                   const BatchRow& results, const std::optional<LimitVerdict>& limits) {
    BatchRow texts{
        set.name, gyro_of(set), list_date_of(set), joined(set.recordings, ";", &RecordingRef::file),
        status,   message};
    texts.insert(texts.end(), results.begin(), results.end());
    const auto conditions = conditions_of(set);
    texts.resize(batch_columns().size() - conditions.size());
    if (limits) {
        texts.insert(texts.end(), {passed_text(limits->conformity), joined(limits->failed, ";")});
    }
    for (const auto& [column, field] : conditions) {
        texts.push_back(field);
    }
    for (std::size_t k = 0; k < set.recordings.front().others.size(); ++k) {
        texts.push_back(other_of(set, k));
    }
    std::ranges::transform(texts, texts.begin(), plain_text);
    return texts;
}

// The verdict about the gyro, and the names of the parameters that have changed, without Q, which
// follows from others.
std::pair<std::string, std::string> verdict(const std::optional<PassportComparison>& comparison) {
    if (!comparison) {
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

// Whether a serious warning says that the numbers may be wrong.
bool is_doubtful(const Identification& found) {
    const std::vector<Finding> findings = findings_of(found);
    return !findings.empty() && severity(findings.front().diagnostic.kind) == Severity::serious;
}

}  // namespace

const char* passed_text(const std::optional<Conformity>& conformity) {
    if (!conformity) {
        return "";
    }
    switch (*conformity) {
        case Conformity::within: return "yes";
        case Conformity::outside: return "no";
        case Conformity::unknown: break;
    }
    return "undecided";
}

std::vector<std::string> batch_columns(bool limits) {
    std::vector<std::string> names{"set", "gyro", "date", "files", "status", "message", "model"};
    for (const ResonatorParameter& parameter : parameters) {
        names.emplace_back(parameter.name);
        names.push_back(std::string("sd_") + parameter.name);
    }
    names.insert(names.end(), {"noise", "chi2_per_dof", "verdict", "changed"});
    for (const ResonatorParameter& parameter : parameters) {
        names.push_back(std::string("u_") + parameter.name);
    }
    names.emplace_back("warnings");
    if (limits) {
        names.insert(names.end(), {passed_column, "failed_by"});
    }
    for (const auto& [column, field] : conditions_of({})) {
        names.push_back(column);
    }
    return names;
}

bool is_batch_table(const std::filesystem::path& path) {
    const auto begins = [&path](std::string_view begin) {
        std::string head(begin.size(), '\0');
        std::ifstream file(path, std::ios::binary);
        return file.read(head.data(), std::ssize(head)) && head == begin;
    };
    return (begins("# vybeg-cli ") && csv_has_name(path, "verdict")) ||
           begins(std::string(byte_order_mark) + "set;gyro;");
}

std::string batch_head(std::span<const std::string> header,
                       std::span<const std::string> other_columns, bool limits) {
    std::vector<std::string> names = batch_columns(limits);
    for (std::string name : other_columns) {
        while (std::ranges::find(names, name) != names.end()) {
            name.insert(0, "list_");
        }
        names.push_back(name);
    }
    return comment_lines(header) + csv_row(names);
}

BatchRow batch_row(const MeasurementSet& set) {
    return whole_row(set, "", "", {}, {});
}

BatchRow batch_row(const MeasurementSet& set, const Error& error,
                   const std::optional<LimitVerdict>& limits) {
    return whole_row(set, std::to_string(exit_status(error.code)), english(error), {}, limits);
}

BatchRow batch_row(const SetResult& result, const std::optional<LimitVerdict>& limits) {
    const Identification& found = result.identification;
    const ResonatorFit& fit = found.fit;
    BatchRow results{fit.model == ResonatorModel::structured ? "structured" : "free"};
    for (const ResonatorParameter& parameter : parameters) {
        const Estimate& estimate = fit.resonator.*parameter.member;
        results.push_back(estimate.given() ? csv_number(estimate.value) : "");
        results.push_back(estimate.given() ? csv_number(estimate.sd) : "");
    }
    const std::vector<Finding> findings = findings_of(found);
    // Numbers that may be wrong are compared with nothing: the message says why.
    const bool doubtful = is_doubtful(found);
    const auto [judged, changed] = verdict(doubtful ? std::nullopt : result.comparison);
    results.insert(results.end(), {fit.noise.white() ? "white" : "coloured",
                                   csv_number(fit.chi2_per_dof), judged, changed});
    for (const ResonatorParameter& parameter : parameters) {
        const Estimate& estimate = fit.resonator.*parameter.member;
        results.push_back(estimate.given() ? csv_number(estimate.u) : "");
    }
    results.push_back(warning_kinds(findings));
    return whole_row(result.set, "ok", doubtful ? english(findings.front()) : "", results, limits);
}

std::string excel_head(const std::string& head) {
    return std::string(byte_order_mark) +
           csv_row(csv_fields(head.substr(head.rfind('\n') + 1)), ';');
}

std::string excel_row(BatchRow row, bool limits) {
    const std::vector<std::string> names = batch_columns(limits);
    constexpr std::array texts{"set",     "gyro",    "date",     "files",    "message",
                               "comment", "verdict", "operator", "failed_by"};
    std::vector<std::string_view> parts;
    for (std::size_t k = 0; k < std::min(row.size(), names.size()); ++k) {
        const bool is_text = std::ranges::find(texts, names[k]) != texts.end();
        // Conditions that differ are several numbers: "20.5;21.5".
        split_fields(row[k], ';', parts);
        const bool is_number =
            !parts.empty() && std::ranges::all_of(parts, [](std::string_view part) {
                return parse_number(part).has_value();
            });
        if (!is_text && is_number) {
            std::ranges::replace(row[k], '.', ',');
        }
    }
    return csv_row(row, ';');
}

LimitVerdict limit_verdict(const Identification* found, const std::vector<ParameterLimit>& limits) {
    LimitVerdict verdict =
        found != nullptr ? keeps_limits(found->fit.resonator, limits) : LimitVerdict{};
    if ((found == nullptr || is_doubtful(*found)) && !limits.empty()) {
        verdict.conformity = Conformity::unknown;
    }
    return verdict;
}

std::string csv_row(const std::vector<std::string>& texts, char separator) {
    std::string row;
    for (const std::string& text : texts) {
        if (&text != &texts.front()) {
            row += separator;
        }
        row += field(text, separator);
    }
    return row;
}

std::string csv_number(double value) {
    return std::isfinite(value) ? round_trip_text(value) : "";
}

std::string comment_lines(std::span<const std::string> lines) {
    std::string text;
    for (const std::string& line : lines) {
        text += "# " + plain_text(line) + "\n";
    }
    return text;
}

}  // namespace vybeg
