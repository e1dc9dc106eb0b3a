#pragma once

#include "core/recording/bytes/number_type.h"

#include <charconv>
#include <cstdio>
#include <span>
#include <string>
#include <string_view>

// Universal Files as the published layout of dataset 58 has them.
namespace vybeg::test {

// What a test may want to be different.
struct UffText {
    bool doubles = false;  // 4E20.12 instead of 6E13.5
    bool blanks = true;    // between values; a minus fills the column either way
    std::string name = "Pick-off";
    std::string date = "01-MAR-20 12:34:56";
    std::string unit = "V";
    std::string time_unit = "s";
    int function = 1;
    int data_type = 0;  // 0: as `doubles` says
    int spacing = 1;
    int axis = 17;
    double step_s = 3e-5;
    std::string count{};  // empty: as many as there are
    std::string line_end = "\n";
};

inline std::string right(const std::string& text, std::size_t width) {
    return text.size() < width ? std::string(width - text.size(), ' ') + text : text;
}

inline std::string left(const std::string& text, std::size_t width) {
    return text + std::string(text.size() < width ? width - text.size() : 0, ' ');
}

// A number as Fortran's E format has it: a digit, `digits` decimals, two digits of exponent.
inline std::string fortran(double value, int digits, std::size_t width) {
    char text[40];
    const auto end =
        std::to_chars(text, text + sizeof text, value, std::chars_format::scientific, digits);
    std::string number(text, end.ptr);
    number.replace(number.find('e'), 1, "E");
    return right(number, width);
}

// What the first line of a dataset 58b says.
struct UffBytes {
    bool big_endian = false;
    bool doubles = true;
    int float_format = 2;   // IEEE 754
    long long bytes = -1;   // -1: as many as there are
    std::string between{};  // the numbers and the separator after them
};

// One dataset from separator to separator.
inline std::string uff58(std::span<const double> values, const UffText& t = {}) {
    const auto number = [](long long value, std::size_t width) {
        return right(std::to_string(value), width);
    };
    const int digits = t.doubles ? 12 : 5;
    const std::size_t width = t.doubles ? 20 : 13;
    const std::size_t per_line = t.doubles ? 4 : 6;
    const int data_type = t.data_type != 0 ? t.data_type : t.doubles ? 4 : 2;
    std::string text = "    -1\n    58\n" + t.name + "\nNONE\n" + t.date + "\nNONE\nNONE\n";
    text += number(t.function, 5) + number(0, 10) + number(0, 5) + number(0, 10) + " " +
            left("NONE", 10) + number(12, 10) + number(-3, 4) + " " + left("NONE", 10) +
            number(0, 10) + number(0, 4) + "\n";
    text += number(data_type, 10) +
            right(t.count.empty() ? std::to_string(values.size()) : t.count, 10) +
            number(t.spacing, 10) + fortran(0, 5, 13) + fortran(t.step_s, 5, 13) +
            fortran(0, 5, 13) + "\n";
    const auto axis = [&](int type, const std::string& label, const std::string& unit) {
        return number(type, 10) + number(0, 5) + number(0, 5) + number(0, 5) + " " +
               left(label, 20) + " " + left(unit, 20) + "\n";
    };
    text += axis(t.axis, "Time", t.time_unit) + axis(0, "Voltage", t.unit) +
            axis(0, "NONE", "NONE") + axis(0, "NONE", "NONE");
    for (std::size_t i = 0; i < values.size(); ++i) {
        const std::string value = fortran(values[i], digits, width);
        text += t.blanks ? value : value.substr(value.find_first_not_of(' '));
        text += (i + 1) % per_line == 0 || i + 1 == values.size() ? "\n" : "";
    }
    text += "    -1\n";
    if (t.line_end != "\n") {
        for (std::size_t at = 0; (at = text.find('\n', at)) != text.npos; at += t.line_end.size()) {
            text.replace(at, 1, t.line_end);
        }
    }
    return text;
}

// The same with binary numbers.
inline std::string uff58b(std::span<const double> values, UffText t = {}, const UffBytes& b = {}) {
    t.doubles = b.doubles;
    const std::string text = uff58(values, t);
    const auto at = [&](int lines) {
        std::size_t found = 0;
        for (int i = 0; i < lines; ++i) {
            found = text.find(t.line_end, found) + t.line_end.size();
        }
        return found;
    };
    const auto number = [](long long value, std::size_t width) {
        return right(std::to_string(value), width);
    };
    std::string numbers;
    for (const double value : values) {
        numbers +=
            b.doubles ? store(value, b.big_endian) : store(static_cast<float>(value), b.big_endian);
    }
    const auto bytes = b.bytes < 0 ? static_cast<long long>(numbers.size()) : b.bytes;
    return text.substr(0, at(1)) + "    58b" + number(b.big_endian ? 2 : 1, 6) +
           number(b.float_format, 6) + number(11, 12) + number(bytes, 12) + number(0, 6) +
           number(0, 6) + number(0, 12) + number(0, 12) + t.line_end +
           text.substr(at(2), at(13) - at(2)) + numbers + b.between + "    -1" + t.line_end;
}

}  // namespace vybeg::test
