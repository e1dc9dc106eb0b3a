#include "core/analysis/set_conditions.h"

#include "core/base/number_text.h"

#include <algorithm>

namespace vybeg {
namespace {

std::string first_told(const MeasurementSet& set, std::string Conditions::*member) {
    for (const ListedRecording& recording : set.recordings) {
        if (const std::string& text = recording.conditions.*member; !text.empty()) {
            return text;
        }
    }
    return {};
}

std::string side_by_side(const MeasurementSet& set, auto text_of) {
    std::vector<std::string> texts;
    for (const ListedRecording& recording : set.recordings) {
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

std::string number_field(const std::optional<double>& value) {
    return value ? round_trip_text(*value) : "";
}

}  // namespace

std::string gyro_of(const MeasurementSet& set) {
    return first_told(set, &Conditions::gyro);
}

std::string list_date_of(const MeasurementSet& set) {
    return first_told(set, &Conditions::date);
}

std::vector<std::pair<std::string, std::string>> conditions_of(const MeasurementSet& set) {
    const auto field = [&set](auto text_of) {
        return side_by_side(set, [&text_of](const ListedRecording& recording) {
            return text_of(recording.conditions);
        });
    };
    return {
        {"bias_v", field([](const Conditions& c) { return number_field(c.bias_v); })},
        {"temperature_c", field([](const Conditions& c) { return number_field(c.temperature_c); })},
        {"exchanged",
         field([](const Conditions& c) -> std::string { return c.exchanged ? "yes" : ""; })},
        {"operator", field([](const Conditions& c) { return c.operator_name; })},
        {"comment", field([](const Conditions& c) { return c.comment; })}};
}

std::string other_of(const MeasurementSet& set, std::size_t k) {
    return side_by_side(set, [k](const ListedRecording& recording) {
        return k < recording.others.size() ? recording.others[k] : std::string();
    });
}

}  // namespace vybeg
