#include "core/output/quantity_json.h"

#include <nlohmann/json.hpp>

#include <cmath>

namespace vybeg {

using Json = nlohmann::ordered_json;

Json number_json(double value) {
    return std::isfinite(value) ? Json(value) : Json(nullptr);
}

Json numbers_json(std::span<const double> values) {
    Json list = Json::array();
    for (const double value : values) {
        list.push_back(number_json(value));
    }
    return list;
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

std::string json_text(const Json& json) {
    return json.dump(2, ' ', false, Json::error_handler_t::replace) + "\n";
}

}  // namespace vybeg
