#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace vybeg {

// What the eleven records at the head of a dataset 58 (function at a nodal degree of freedom) say
// of its values.
struct UffFunction {
    std::string name;   // from the first identification line, else node and direction; may be empty
    std::string start;  // third identification line: date and time
    std::string unit;   // of the values
    int function = 0;   // 0 general, 1 time response, others are spectra and the like
    int abscissa = 0;   // 0 unknown, 17 time, 18 frequency, ...
    int data_type = 0;  // 2 and 4: real, of single and of double precision
    bool is_complex = false;
    bool is_even = false;
    std::int64_t count = 0;
    double step_s = 0;  // seconds from value to value
    // Standard deviation of step_s relative to it, by its six digits.
    double step_relative_sd = 0;

    bool is_time_response() const;
};

inline constexpr std::size_t uff_header_lines = 11;

// What the identifier of a dataset 58b says of the bytes that follow its header.
struct UffBinary {
    int byte_order = 0;    // 1 little endian, 2 big endian
    int float_format = 0;  // 1 DEC VMS, 2 IEEE 754, 3 IBM 5/370
    std::int64_t header_lines = 0;
    std::int64_t bytes = 0;
};

// "58b" and the numbers after it. Nothing where they are none.
std::optional<UffBinary> parse_uff_binary(std::string_view line);

// Precondition: as many lines as uff_header_lines. Nothing where a number in them is none.
std::optional<UffFunction> parse_uff_header(const std::vector<std::string>& lines);

// The values of a data line, written side by side or with blanks between them; appended to
// `values`, missing ones as NaN. Fortran's D is read as E. False where there is anything else in
// the line.
bool parse_uff_values(std::string_view line, std::vector<double>& values);

}  // namespace vybeg
