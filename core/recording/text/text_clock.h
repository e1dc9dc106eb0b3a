#pragma once

#include <cstdint>
#include <optional>
#include <string_view>

namespace vybeg {

// A date, a time of day, or both, in one field of a table.
struct ClockField {
    bool timed = false;        // else a date alone
    std::int64_t whole_s = 0;  // seconds from midnight
    double fraction_s = 0;     // below one second
    int decimals = 0;          // digits of the fraction
};

// "12:00:05.25", "12:00:05,25 PM", "2024-05-01T12:00:05.25Z", "01.05.2024 12:00:05", "5/1/2024",
// "12:00:05+03:00 2024-05-01", "01-May-2024", ... Nothing for any other text. Zones and the order
// of day and month do not matter: a recording counts from its first row.
std::optional<ClockField> parse_clock(std::string_view field);

// Seconds from the second `from_s` of the day on. Half a day back is the next day.
double seconds_after(const ClockField& clock, std::int64_t from_s);

}  // namespace vybeg
