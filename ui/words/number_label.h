#pragma once

#include <QString>

#include <cstdint>

namespace vybeg::ui {

// Runs of more than four digits of a number, before and behind its decimal sign, in groups of
// three: "5300.000 171 7". The gap is a narrow no-break space, which number fields read over.
QString groupedDigits(const QString& number);

// Numbers as they stand beside an axis: the default locale's decimal sign, a true minus, digits in
// groups.
QString numberLabel(double value, int decimals);
// A number of things.
QString countLabel(std::int64_t count);

// "10⁻³".
QString powerOfTen(int exponent);

// The SI prefix of an exponent that is a multiple of 3 in [-15, 12], translated: "m" for -3.
QString siPrefix(int exponent);

}  // namespace vybeg::ui
