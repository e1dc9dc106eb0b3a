#include "core/analysis/identify_settings.h"

#include "core/base/number_text.h"
#include "core/base/plain_text.h"
#include "core/base/read_value.h"

#include <algorithm>
#include <set>

namespace vybeg {

const char* frame_name(PhasorFrame frame) {
    constexpr std::array names{"", "fixed", "common", "pll"};
    return names[static_cast<std::size_t>(frame)];
}

std::optional<std::vector<std::pair<std::string, std::string_view>>> named_texts(
    std::string_view text) {
    std::vector<std::pair<std::string, std::string_view>> named;
    for (const std::string_view part : parts_between(text, ',')) {
        const std::size_t equals = part.find('=');
        if (equals == std::string_view::npos) {
            return std::nullopt;
        }
        named.emplace_back(part.substr(0, equals), part.substr(equals + 1));
    }
    return named;
}

double assumed_tolerance(ErrorSource source, double calibrated_kappa) {
    if (source == kappa_error) {
        return calibrated_kappa == 1 ? untold_channels[kappa_error] : 0;
    }
    const auto usual = std::ranges::find(usual_errors, source, &UsualError::source);
    return usual == usual_errors.end() ? 0 : usual->size;
}

std::vector<ToleranceInUse> tolerances_in_use(const Tolerance& tolerance, double calibrated_kappa) {
    std::vector<ToleranceInUse> used;
    for (const ToleratedError& error : tolerated_errors) {
        const std::optional<double>& told = tolerance[error.source];
        const double value = told ? *told : assumed_tolerance(error.source, calibrated_kappa);
        if (value > 0) {
            used.push_back({error, value, !told});
        }
    }
    return used;
}

Result<Tolerance> read_tolerance(std::string_view text) {
    const auto wrong = [text](const std::string& allowed) {
        return refused_value("--tolerance", std::string(text), allowed);
    };
    Tolerance tolerance;
    if (text == not_set) {
        return tolerance;
    }
    std::set<std::string, std::less<>> given;
    const auto named = named_texts(text);
    if (!named) {
        return wrong("it is NAME=X with commas, as in skew=0.1deg,delay=10ns");
    }
    for (const auto& part : *named) {
        const std::string& name = part.first;
        const auto error = std::ranges::find(tolerated_errors, name, &ToleratedError::name);
        if (error == tolerated_errors.end()) {
            return wrong("\"" + name + "\" is none of " +
                         joined(tolerated_errors, ", ", &ToleratedError::name));
        }
        if (!given.insert(name).second) {
            return wrong(name + " is given twice");
        }
        const std::string unit = error->unit;
        const std::optional<double> value = number_with_unit(part.second, unit);
        if (!value || !within(tolerance_bounds, "--tolerance", *value)) {
            return wrong(name + " must be a number of zero or more" +
                         (unit.empty() ? "" : ", in " + unit));
        }
        tolerance[error->source] = *value;
    }
    return tolerance;
}

std::string tolerance_text(const Tolerance& tolerance) {
    std::string text;
    for (const ToleratedError& error : tolerated_errors) {
        if (const std::optional<double>& told = tolerance[error.source]) {
            text += text.empty() ? "" : ",";
            text += error.name;
            text += '=' + round_trip_text(*told);
        }
    }
    return text.empty() ? not_set : text;
}

}  // namespace vybeg
