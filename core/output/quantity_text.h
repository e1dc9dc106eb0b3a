#pragma once

#include <string>

namespace vybeg {

// A value and its standard deviation as people write them: both to the same decimal place, which is
// the second significant digit of the deviation where it begins with 1 or 2, else the first.
struct QuantityText {
    std::string value;  // "1.00034"; "nan" where there is no value
    std::string sd;     // "0.00005"; empty where there is no deviation
    int exponent = 0;   // all are to be multiplied by 10^exponent; 0 for ordinary sizes
    std::string u{};    // combined uncertainty, rounded by itself; empty: none, or as sd

    friend bool operator==(const QuantityText&, const QuantityText&) = default;
};

// A deviation that is NaN, infinite or not positive counts as none, and
// the value is then given with six significant digits. An exponent is used where the larger of the
// two is below 1e-4 or not below 1e7.
QuantityText quantity_text(double value, double sd);

// With a combined uncertainty u of the same exponent; NaN: none.
QuantityText quantity_text(double value, double sd, double u);

}  // namespace vybeg
