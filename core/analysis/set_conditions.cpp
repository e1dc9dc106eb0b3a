#include "core/analysis/set_conditions.h"

#include "core/base/number_text.h"

#include <algorithm>
#include <concepts>
#include <type_traits>

namespace vybeg {
namespace {

std::string first_told(const MeasurementSet& set, std::string Conditions::*member) {
    for (const RecordingRef& recording : set.recordings) {
        if (const std::string& text = recording.conditions.*member; !text.empty()) {
            return text;
        }
    }
    return {};
}

std::string side_by_side(const MeasurementSet& set, auto text_of) {
    std::vector<std::string> texts;
    for (const RecordingRef& recording : set.recordings) {
        texts.push_back(text_of(recording));
    }
    const auto differs = [&texts](const std::string& text) { return text != texts.front(); };
    std::string joined = texts.empty() ? "" : texts.front();
    if (std::ranges::any_of(texts, differs)) {
        for (std::size_t k = 1; k < texts.size(); ++k) {
            joined += ";" + texts[k];
        }
    }
    return joined;
}

}  // namespace

std::string gyro_of(const MeasurementSet& set) {
    return first_told(set, &Conditions::gyro);
}

std::string list_date_of(const MeasurementSet& set) {
    return first_told(set, &Conditions::date);
}

std::vector<std::pair<std::string, std::string>> fields_of(const Conditions& conditions) {
    std::vector<std::pair<std::string, std::string>> fields;
    describe(
        [&fields](const char* name, const auto& value) {
            using Value = std::remove_cvref_t<decltype(value)>;
            std::string text;
            if constexpr (std::same_as<Value, std::string>) {
                text = value;
            } else if constexpr (std::same_as<Value, bool>) {
                text = value ? "yes" : "";
            } else {
                text = value ? round_trip_text(*value) : "";
            }
            fields.emplace_back(name, std::move(text));
        },
        conditions);
    return fields;
}

std::vector<std::pair<std::string, std::string>> conditions_of(const MeasurementSet& set) {
    constexpr std::size_t of_the_set = 2;  // gyro and date
    auto columns = fields_of({});
    columns.erase(columns.begin(), columns.begin() + of_the_set);
    for (std::size_t k = 0; k < columns.size(); ++k) {
        columns[k].second = side_by_side(set, [k](const RecordingRef& recording) {
            return fields_of(recording.conditions)[k + of_the_set].second;
        });
    }
    return columns;
}

std::string other_of(const MeasurementSet& set, std::size_t k) {
    return side_by_side(set, [k](const RecordingRef& recording) {
        return k < recording.others.size() ? recording.others[k].second : std::string();
    });
}

}  // namespace vybeg
