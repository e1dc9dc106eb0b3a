#include "core/output/quantity_text.h"

#include "core/base/number_text.h"

#include <algorithm>
#include <charconv>
#include <cmath>

namespace vybeg {

namespace {

// Of numbers without an exponent.
constexpr double least = 1e-4;
constexpr double most = 1e7;

// Place of the last digit worth printing, as a power of ten: -5 for a deviation of 0.00005.
int last_place(double sd) {
    const int leading = static_cast<int>(std::floor(std::log10(sd)));
    const double mantissa = sd * std::pow(10.0, -leading);
    // From 2.95 on, two digits round to 3.0, which counts as one digit.
    return mantissa < 2.95 ? leading - 1 : leading;
}

std::string fixed_text(double value, int decimals) {
    char buffer[400];
    const auto end =
        std::to_chars(buffer, buffer + sizeof buffer, value, std::chars_format::fixed, decimals);
    const std::string text(buffer, end.ptr);
    // A value that rounds to zero is printed without sign.
    const bool nought = text.find_first_not_of("-0.") == std::string::npos;
    return nought && text.starts_with('-') ? text.substr(1) : text;
}

std::string rounded_text(double value, int place) {
    if (place >= 0) {
        const double unit = std::pow(10.0, place);
        return fixed_text(std::round(value / unit) * unit, 0);
    }
    return fixed_text(value, -place);
}

}  // namespace

QuantityText quantity_text(double value, double sd, double u) {
    if (!std::isfinite(value)) {
        return {"nan", "", 0};
    }
    const bool has_sd = std::isfinite(sd) && sd > 0;
    const double size = has_sd ? std::max(std::abs(value), sd) : std::abs(value);
    const bool ordinary = size == 0 || (size >= least && size < most);
    const int exponent = ordinary ? 0 : static_cast<int>(std::floor(std::log10(size)));
    const double scale = std::pow(10.0, -exponent);
    if (!has_sd) {
        return {short_text(value * scale), "", exponent};
    }
    const int place = last_place(sd * scale);
    const QuantityText statistical{rounded_text(value * scale, place),
                                   rounded_text(sd * scale, place), exponent};
    if (!std::isfinite(u) || u <= sd) {
        return statistical;
    }
    QuantityText both = statistical;
    const double most_shared = exponent == 0 ? most : 10;
    if (u * scale < most_shared) {
        both.u_exponent = exponent;
    } else if (u < least || u >= most) {
        // From 9.5 on, the one digit rounds to 10.
        both.u_exponent = static_cast<int>(std::floor(std::log10(u / 0.95)));
    }
    const double own_scale = std::pow(10.0, -both.u_exponent);
    both.u = rounded_text(u * own_scale, last_place(u * own_scale));
    return both.u == statistical.sd && both.u_exponent == exponent ? statistical : both;
}

}  // namespace vybeg
