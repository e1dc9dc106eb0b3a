#include "core/base/read_value.h"

#include "core/base/number_text.h"
#include "core/base/plain_text.h"

#include <array>
#include <cmath>
#include <numbers>
#include <utility>

namespace vybeg {
namespace {

// A unit that may follow a number, in units of the member's own.
struct UnitSuffix {
    const char* own;  // unit of the member
    const char* suffix;
    double factor;
};

constexpr double degree = std::numbers::pi / 180;

constexpr std::array<UnitSuffix, 25> suffixes{{
    {"deg", "deg", 1},
    {"deg", "mrad", 1e-3 / degree},  // before rad, of which it is a longer form
    {"deg", "rad", 1 / degree},
    {"rad", "mrad", 1e-3},
    {"rad", "rad", 1},
    {"rad", "deg", degree},
    {"deg", "°", 1},
    {"rad", "°", degree},
    {"s", "ms", 1e-3},
    {"s", "us", 1e-6},
    {"s", "µs", 1e-6},  // the micro sign
    {"s", "μs", 1e-6},  // the Greek letter
    {"s", "ns", 1e-9},
    {"s", "ps", 1e-12},
    {"s", "min", 60},
    {"s", "s", 1},
    {"s", "h", 3600},
    {"Hz", "kHz", 1e3},
    {"Hz", "MHz", 1e6},
    {"Hz", "Hz", 1},
    {"", "%", 1e-2},
    {"", "ppm", 1e-6},
    {"ppm", "ppm", 1},
    {"ppm", "ppb", 1e-3},
    {"ppm", "%", 1e4},
}};

}  // namespace

Error refused_value(MessageArg option, MessageArg text, MessageArg allowed) {
    return {
        ErrorCode::setting_invalid, "", {std::move(option), std::move(text), std::move(allowed)}};
}

std::optional<double> number_with_unit(std::string_view text, std::string_view unit) {
    double factor = 1;
    for (const UnitSuffix& suffix : suffixes) {
        if (unit == suffix.own && text.ends_with(suffix.suffix)) {
            factor = suffix.factor;
            text.remove_suffix(std::string_view(suffix.suffix).size());
            text = text.substr(0, text.find_last_not_of(' ') + 1);
            break;
        }
    }
    const std::optional<double> number = parse_number(text);
    return number ? std::optional(factor * *number) : std::nullopt;
}

Result<double> read_number(const std::string& option, const std::string& text,
                           const std::string& unit) {
    const std::optional<double> number = number_with_unit(text, unit);
    if (!number || !std::isfinite(*number)) {
        return refused_value(option, text,
                             unit == "none" ? "it must be a number, with a point and without a unit"
                                            : "it must be a number, with a point, in " + unit +
                                                  " or with its unit behind it");
    }
    return *number;
}

Result<std::int64_t> read_whole(const std::string& option, const std::string& text) {
    const auto number = whole_number<std::int64_t>(text);
    return number ? Result(*number) : refused_value(option, text, "it must be a whole number");
}

Result<std::vector<double>> read_numbers(const std::string& option, const std::string& text,
                                         std::size_t count, const std::string& allowed,
                                         const std::string& unit) {
    std::vector<double> numbers;
    for (const std::string_view part : parts_between(text, ',')) {
        const std::optional<double> number = number_with_unit(part, unit);
        if (!number || !std::isfinite(*number)) {
            return refused_value(option, text, allowed);
        }
        numbers.push_back(*number);
    }
    return numbers.size() == count ? Result(std::move(numbers))
                                   : refused_value(option, text, allowed);
}

}  // namespace vybeg
