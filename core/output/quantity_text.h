#pragma once

#include <limits>
#include <string>

namespace vybeg {

// A value and its standard deviation as text, both to the same decimal place: the second
// significant digit of the deviation if it begins with 1 or 2, otherwise the first.
struct QuantityText {
    std::string value;   // "1.00034"; "nan" where there is no value
    std::string sd;      // "0.00005"; empty where there is no deviation
    int exponent = 0;    // all are to be multiplied by 10^exponent; 0 for ordinary sizes
    std::string u{};     // combined uncertainty, rounded by itself; empty: none, or as sd
    int u_exponent = 0;  // of u: as `exponent` if that is 0 or u has one digit then

    friend bool operator==(const QuantityText&, const QuantityText&) = default;
};

// Without a deviation (NaN, infinite or not positive) the value has six significant digits. An
// exponent is used if the larger of the two is below 1e-4 or not below 1e7. `u`: a combined
// uncertainty; NaN: none.
QuantityText quantity_text(double value, double sd,
                           double u = std::numeric_limits<double>::quiet_NaN());

}  // namespace vybeg
