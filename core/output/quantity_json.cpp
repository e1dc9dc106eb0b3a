#include "core/output/quantity_json.h"

#include <algorithm>
#include <cmath>
#include <iterator>

namespace vybeg {
namespace {

// The code with this name, of those from `first` up to the first number without a name.
template <class Code>
std::optional<Code> code_named(const std::string& name, Code first, std::string (*name_of)(Code)) {
    for (int number = static_cast<int>(first);; ++number) {
        const auto code = static_cast<Code>(number);
        const std::string known = name_of(code);
        if (known.empty()) {
            return std::nullopt;
        }
        if (known == name) {
            return code;
        }
    }
}

std::vector<MessageArg> stored_args(const std::vector<std::string>& texts) {
    std::vector<MessageArg> args;
    std::ranges::transform(texts, std::back_inserter(args), stored_arg);
    return args;
}

}  // namespace

Json number_json(double value) {
    return std::isfinite(value) ? Json(value) : Json(nullptr);
}

Json numbers_json(std::span<const double> values) {
    return list_json(values, number_json);
}

Json named_json(std::span<const NamedValue> values) {
    Json object = Json::object();
    for (const auto& [name, value] : values) {
        object[name] = value;
    }
    return object;
}

Json quantity_json(const Estimate& estimate) {
    if (!estimate.given()) {
        return {{"value", nullptr}, {"reason", english(estimate.reason)}};
    }
    if (!std::isfinite(estimate.value) || !std::isfinite(estimate.sd)) {
        return {{"value", nullptr}, {"reason", "The fit gave no finite value."}};
    }
    Json json{{"value", estimate.value}, {"sd", estimate.sd}};
    if (std::isfinite(estimate.u)) {
        json["u"] = estimate.u;
    }
    return json;
}

Json inputs_json(std::span<const RecordingRef> inputs) {
    return list_json(inputs, [](const RecordingRef& input) -> Json {
        return {{"name", input.name()},     {"sha256", input.sha256},   {"start", input.start},
                {"seconds", input.seconds}, {"rate_hz", input.rate_hz}, {"f0_hz", input.f0_hz}};
    });
}

Json args_json(std::span<const MessageArg> args) {
    return list_json(args, [](const MessageArg& arg) { return english(arg); });
}

Json finding_json(const Finding& finding) {
    const DiagnosticKind kind = finding.diagnostic.kind;
    return {{"kind", kind_name(kind)},
            {"severity", severity_name(severity(kind))},
            {"count", finding.count},
            {"text", english(finding.diagnostic)}};
}

std::string json_text(const Json& json) {
    return json.dump(2, ' ', false, Json::error_handler_t::replace) + "\n";
}

std::string json_line(const Json& json) {
    return json.dump(-1, ' ', false, Json::error_handler_t::replace);
}

std::optional<Reason> stored_reason(const std::string& name, const std::vector<std::string>& args) {
    const auto code = code_named(name, static_cast<ReasonCode>(1), reason_name);
    return code ? std::optional(Reason{*code, stored_args(args)}) : std::nullopt;
}

std::optional<Diagnostic> stored_diagnostic(const std::string& name,
                                            const std::vector<std::string>& args) {
    const auto kind = code_named(name, DiagnosticKind{}, kind_name);
    return kind ? std::optional(Diagnostic{*kind, stored_args(args)}) : std::nullopt;
}

}  // namespace vybeg
