#include "core/analysis/identify_settings.h"
#include "core/analysis/list_fields.h"
#include "core/base/number_text.h"
#include "core/base/plain_text.h"
#include "core/base/read_value.h"
#include "core/batch/batch_sets.h"
#include "core/recording/text/csv_rows.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <span>
#include <utility>

namespace vybeg {
namespace {

// The parameter whose name is `alike` this one, which may lack its unit.
const ResonatorParameter* parameter_named(
    std::span<const ResonatorParameter> parameters, std::string_view name,
    bool (*alike)(const std::string&, const std::string&) =
        [](const std::string& a, const std::string& b) { return a == b; }) {
    const auto found = std::ranges::find_if(parameters, [&](const ResonatorParameter& each) {
        return alike(std::string(name), each.name) ||
               std::ranges::any_of(name_units, [&](const char* unit) {
                   return alike(std::string(name) + unit, each.name);
               });
    });
    return found == parameters.end() ? nullptr : &*found;
}

// Why a name is no parameter: those that there are, and the one that it resembles.
MessageArg no_parameter(std::span<const ResonatorParameter> parameters, const std::string& name) {
    const std::string names = joined(parameters, ", ", &ResonatorParameter::name);
    const ResonatorParameter* const like = parameter_named(parameters, name, names_resemble);
    return like == nullptr
               ? Phrase::tr("\"%1\" is none of %2", {name, names})
               : Phrase::tr("\"%1\" is none of %2 (did you mean %3?)", {name, names, like->name});
}

// A column of the table in other letters or in Russian.
std::string column_name(const std::string& name) {
    std::string usual = usual_column(name);
    std::ranges::replace(usual, '-', '_');
    return usual;
}

// Refuses unknown columns: a limit there would be ignored.
Status check_columns(const CsvRows& table) {
    constexpr std::array<std::string_view, 5> columns{"parameter", "least", "greatest", "gyro_type",
                                                      "comment"};
    for (const std::string& name : table.names) {
        if (!name.empty() && std::ranges::find(columns, name) == columns.end()) {
            return table.invalid(
                1, name,
                Phrase::tr("the columns are parameter, least, greatest, gyro_type and comment"));
        }
    }
    if (!table.has("least") && !table.has("greatest")) {
        return table.invalid(1, "least", Phrase::tr("neither least nor greatest is there"));
    }
    return {};
}

}  // namespace

Result<std::vector<TypedLimit>> read_limits(const std::filesystem::path& path) {
    const auto table = TRY(read_csv(path, "parameter", column_name));
    TRY(check_columns(table));
    const std::vector<ResonatorParameter> parameters = limited_parameters();
    std::vector<TypedLimit> limits;
    for (const CsvRow& row : table.rows) {
        const std::string& name = table.field(row, "parameter");
        const ResonatorParameter* const parameter = parameter_named(parameters, name);
        if (parameter == nullptr) {
            return table.invalid(row.line, "parameter", no_parameter(parameters, name));
        }
        TypedLimit read{table.field(row, "gyro_type"), {parameter->name, {}, {}}};
        for (const auto& [column, end] :
             {std::pair{"least", &read.limit.lower}, {"greatest", &read.limit.upper}}) {
            const std::string text = usual_option(table.field(row, column), false);
            *end = number_with_unit(text, parameter->unit);
            if (!text.empty() && !(*end && std::isfinite(**end))) {
                return table.invalid(row.line, column,
                                     Phrase::tr("\"%1\" is not a number", {text}));
            }
        }
        if (!read.limit.lower && !read.limit.upper) {
            return table.invalid(row.line, "least",
                                 Phrase::tr("least and greatest are both empty"));
        }
        if (read.limit.lower && read.limit.upper && *read.limit.lower > *read.limit.upper) {
            return table.invalid(row.line, "least", Phrase::tr("it is above the greatest value"));
        }
        const bool twice = std::ranges::any_of(limits, [&read](const TypedLimit& each) {
            return lower_text(each.gyro_type) == lower_text(read.gyro_type) &&
                   each.limit.parameter == read.limit.parameter;
        });
        if (twice) {
            return table.invalid(
                row.line, "parameter",
                Phrase::tr("%1 has a limit above already", {read.limit.parameter}));
        }
        limits.push_back(std::move(read));
    }
    return limits;
}

std::vector<ParameterLimit> limits_of_type(const std::vector<TypedLimit>& limits,
                                           const std::string& gyro_type) {
    std::vector<ParameterLimit> of_type;
    for (const bool own : {true, false}) {
        for (const TypedLimit& each : limits) {
            const bool fits =
                own ? !each.gyro_type.empty() && lower_text(each.gyro_type) == lower_text(gyro_type)
                    : each.gyro_type.empty();
            if (fits && limit_of(of_type, each.limit.parameter.c_str()) == nullptr) {
                of_type.push_back(each.limit);
            }
        }
    }
    return of_type;
}

Result<std::vector<PracticalLimit>> read_practical_limits(std::string_view text) {
    const auto wrong = [text](const MessageArg& allowed) {
        return refused_value("--limit", std::string(text), allowed);
    };
    std::vector<PracticalLimit> limits;
    const auto named = named_texts(text);
    if (!named) {
        return wrong("it is NAME=X with commas, as in tau=0.5%,f_mean=10ppm");
    }
    for (const auto& [name, size] : *named) {
        const ResonatorParameter* const parameter = parameter_named(resonator_parameters, name);
        if (parameter == nullptr) {
            return wrong(no_parameter(resonator_parameters, name));
        }
        if (std::ranges::find(limits, parameter->name, &PracticalLimit::parameter) !=
            limits.end()) {
            return wrong(name + " is given twice");
        }
        const bool relative = size.ends_with('%') || size.ends_with("ppm");
        if (relative && parameter->period > 0) {
            return wrong(name + " is an angle, whose limit is in rad or deg");
        }
        const std::optional<double> value = number_with_unit(size, relative ? "" : parameter->unit);
        if (!value || !(*value >= 0) || !std::isfinite(*value)) {
            const std::string unit = parameter->unit;
            return wrong(name + " must be a number of zero or more" +
                         (unit.empty() ? "" : ", in " + unit) +
                         (parameter->period > 0 ? "" : ", or a part of it as in 0.5% or 10ppm"));
        }
        limits.push_back({parameter->name, *value, relative});
    }
    return limits;
}

std::string practical_limits_text(const std::vector<PracticalLimit>& limits) {
    return joined(limits, ",", [](const PracticalLimit& limit) {
        return limit.parameter + '=' +
               (limit.relative ? round_trip_text(100 * limit.size) + "%"
                               : round_trip_text(limit.size));
    });
}

}  // namespace vybeg
