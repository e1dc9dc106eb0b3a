#pragma once

#include <QString>

namespace vybeg::ui {

// Numbers as they stand beside an axis: the default locale's decimal sign, a true minus, no
// thousands signs.
QString numberLabel(double value, int decimals);

// "10⁻³".
QString powerOfTen(int exponent);

// The SI prefix of an exponent that is a multiple of 3 in [-15, 12], translated: "m" for -3.
QString siPrefix(int exponent);

}  // namespace vybeg::ui
