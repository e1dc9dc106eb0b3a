#include "core/recording/text/text_columns.h"

#include "core/numerics/statistics.h"
#include "core/recording/samples/text_fields.h"
#include "core/recording/samples/vocabulary.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <utility>

namespace vybeg {
namespace {

constexpr double no_number = std::numeric_limits<double>::quiet_NaN();
constexpr double equal_times = 1e-3;     // of a step
constexpr std::size_t enough_rows = 20;  // fewer rise within a period of a vibration, too

// The first numbers of a column.
struct ColumnStart {
    std::vector<double> values;  // of times of day: seconds from midnight
    std::size_t filled = 0;      // fields that are not empty
    std::size_t clocks = 0;      // of these, dates and times of day
    std::size_t timed = 0;       // of these, those with a time of day
    std::size_t words = 0;       // fields that are neither
    std::int64_t clock_from_s = 0;

    bool is_clock() const { return timed > 0 && timed == filled; }
    bool is_date() const { return clocks > 0 && clocks == filled && timed == 0; }
};

void take(std::string_view field, bool decimal_comma, ColumnStart& column) {
    column.filled += field.empty() ? 0 : 1;
    if (const auto value = parse_field(field, decimal_comma)) {
        column.values.push_back(*value);
        return;
    }
    const auto clock = parse_clock(field);
    if (!clock) {
        ++column.words;
        return;
    }
    if (column.timed == 0) {
        column.clock_from_s = clock->whole_s;
    }
    ++column.clocks;
    column.timed += clock->timed ? 1 : 0;
    column.values.push_back(clock->timed ? seconds_after(*clock, column.clock_from_s) : no_number);
}

// The numbers of all columns, also from rows that are wrong elsewhere; but not from a last line
// that was cut off.
std::vector<ColumnStart> column_starts(std::span<const std::string> rows,
                                       const TextFormat& format) {
    std::vector<ColumnStart> starts(static_cast<std::size_t>(format.columns));
    std::vector<std::string_view> fields;
    for (const std::string& row : rows) {
        if (is_comment(row, format.delimiter) ||
            row.find_first_not_of(no_content) == std::string::npos) {
            continue;
        }
        split_fields(row, format.delimiter, fields);
        const bool whole = fields.size() == starts.size();
        if (!whole && &row == &rows.back()) {
            continue;
        }
        for (std::size_t i = 0; i < std::min(fields.size(), starts.size()); ++i) {
            take(fields[i], format.decimal_comma, starts[i]);
        }
    }
    return starts;
}

std::vector<double> steps_of(const std::vector<double>& values) {
    std::vector<double> steps;
    for (std::size_t i = 1; i < values.size(); ++i) {
        steps.push_back(values[i] - values[i - 1]);
    }
    return steps;
}

// Rises by steps of which nine in ten, or all but one, lie within a half of the median step: a
// clock with jitter, gaps and perhaps an error that the reader will report, but no vibration.
bool rises_evenly(const std::vector<double>& values) {
    const std::vector<double> steps = steps_of(values);
    if (steps.size() < 2) {
        return false;
    }
    const double usual = median(steps);
    const auto odd = std::count_if(steps.begin(), steps.end(), [usual](double step) {
        return !(step >= 0.5 * usual && step <= 1.5 * usual);
    });
    const auto count = static_cast<std::ptrdiff_t>(steps.size());
    return usual > 0 && odd <= std::max<std::ptrdiff_t>(count / 10, count >= 4 ? 1 : 0);
}

bool is_whole(const std::vector<double>& values) {
    return std::ranges::all_of(values, [](double value) { return value == std::floor(value); });
}

// Whole numbers of which each is the one before and one more.
bool counts_by_one(const std::vector<double>& values) {
    const std::vector<double> steps = steps_of(values);
    return steps.size() >= 2 && is_whole(values) &&
           std::ranges::all_of(steps, [](double step) { return step == 1; });
}

class ColumnSearch {
public:
    ColumnSearch(std::span<const std::string> rows, const TextChoice& choice,
                 std::vector<int> words, TextFormat& format)
        : choice_(choice),
          words_(std::move(words)),
          format_(format),
          starts_(column_starts(rows, format)) {}

    void run() {
        std::erase_if(words_, [this](int i) { return at(i).words == 0; });
        for (const int i : words_) {
            format_.no_channels.push_back(i);
            format_.words.push_back(name(i).name.empty() ? std::to_string(i + 1) : name(i).name);
        }
        leave_out([this](int i) { return at(i).filled == 0 || at(i).is_date(); });
        find_time();
        leave_out([this](int i) { return counts_by_one(at(i).values); });
        leave_out(
            [this](int i) { return is_time_again(i) || (!choice_.time_column && is_ramp(i)); });
        find_own_times();
    }

private:
    const ColumnStart& at(int column) const { return starts_[static_cast<std::size_t>(column)]; }
    const Channel& name(int column) const { return format_.heading(column); }

    // Leaves columns out of the channels as long as there are two others.
    template <class Predicate>
    void leave_out(Predicate predicate) {
        for (int i = 0; i < format_.columns; ++i) {
            if (is_channel(format_, i) && channel_columns(format_).size() > 2 && predicate(i)) {
                format_.no_channels.push_back(i);
            }
        }
    }

    bool can_be_time(int column) const {
        return at(column).filled > 0 && !at(column).is_date() &&
               !std::ranges::binary_search(words_, column);
    }

    // A ramp, or the milliseconds beside a time of day: no vibration.
    bool is_ramp(int column) const {
        const bool rises =
            at(column).values.size() >= enough_rows && rises_evenly(at(column).values);
        return rises || (name(column).name.size() > 1 && seconds_per(name(column).name));
    }

    // Of two columns: the time of the other one.
    bool is_time_of_one(int column) const {
        return format_.columns - column == 2 && !is_whole(at(column).values) &&
               at(column).values.size() >= enough_rows;
    }

    // Frames, if the lines above the table say how fast they follow each other: a step of one would
    // be one second.
    bool counts_frames(int column) const {
        return !format_.rates.empty() && counts_by_one(at(column).values) &&
               format_.rates[0].hz * seconds_per(time_unit(name(column))).value_or(1) > 2;
    }

    // A unit that is none of time: a ramp of a voltage, a temperature.
    bool counts_other(int column) const {
        const std::string& unit = name(column).unit;
        return !unit.empty() && !seconds_per(unit) && !is_time_name(unit);
    }

    void find_time() {
        const bool said = choice_.time_column.has_value();
        const bool unit_said = choice_.time_unit_s.has_value();
        int candidate = said ? *choice_.time_column - 1 : -1;
        for (int i = 0; !said && i < format_.columns && candidate < 0; ++i) {
            candidate = is_time_name(name(i).name) && can_be_time(i) ? i : -1;
        }
        for (int i = 0; !said && i < format_.columns && candidate < 0; ++i) {
            candidate = at(i).is_clock() ? i : -1;
        }
        int first = 0;  // column of numbers
        while (std::ranges::binary_search(words_, first)) {
            ++first;
        }
        const bool may_be_time = format_.columns - first >= 3 || is_time_of_one(first);
        if (candidate != first && may_be_time && rises_evenly(at(first).values) &&
            can_be_time(first)) {
            const bool counts = is_whole(at(first).values) && time_unit(name(first)).empty() &&
                                (said || !unit_said);
            if (counts && meaning_of(name(first).name) == Meaning::counter) {
                format_.counter_column = first;
            } else if (!counts && candidate < 0 && !said && !counts_other(first)) {
                candidate = first;
            }
        }
        if (candidate < 0 || candidate >= format_.columns) {
            return;
        }
        const std::string unit = time_unit(name(candidate));
        const bool guessed = !said && !unit_said && !at(candidate).is_clock();
        if (guessed &&
            ((unit.empty() && is_whole(at(candidate).values)) || counts_frames(candidate))) {
            format_.counter_column = candidate;
            return;
        }
        format_.time_column = candidate;
        if (at(candidate).is_clock()) {
            format_.clock_from_s = at(candidate).clock_from_s;
        } else {
            constexpr double day_s = 86400;
            const bool days = !unit_said && unit.empty() && counts_days(candidate);
            format_.time_unit_s = choice_.time_unit_s.value_or(seconds_per(unit).value_or(1));
            format_.own_time_unit_s = format_.time_unit_s;
            format_.time_unit_s *= days ? day_s : 1;
            if (!unit_said && unit.empty() && counts_other(candidate)) {
                format_.unknown_time_unit = name(candidate).unit;
            }
        }
    }

    // Dates as spreadsheets hold them, in days since 1900: as seconds, hours after the first one,
    // they would step by less than 10 us.
    bool counts_days(int column) const {
        constexpr double first = 20000;  // 1954
        constexpr double last = 80000;   // 2119
        constexpr double least_step = 1e-5;
        const std::vector<double>& values = at(column).values;
        return values.size() > 1 && values.front() > first && values.back() < last &&
               values.back() - values.front() < least_step * static_cast<double>(values.size() - 1);
    }

    double unit_of(int column) const {
        return column == format_.time_column ? format_.time_unit_s
               : at(column).is_clock()
                   ? 1
                   : seconds_per(time_unit(name(column))).value_or(format_.own_time_unit_s);
    }

    // The same times at each row but for a thousandth of a step and the digits of one.
    bool same_times(int a, int b) const {
        const std::vector<double>& left = at(a).values;
        const std::vector<double>& right = at(b).values;
        if (left.size() != right.size() || left.size() < 2) {
            return false;
        }
        const double step_s = std::abs(median(steps_of(left))) * unit_of(a);
        for (std::size_t i = 0; i < left.size(); ++i) {
            const double late_s = left[i] * unit_of(a) - right[i] * unit_of(b);
            if (!(std::abs(late_s) <= equal_times * step_s)) {
                return false;
            }
        }
        return true;
    }

    bool is_time_again(int column) const {
        if (format_.time_column < 0) {
            return false;
        }
        const bool named =
            is_time_name(name(column).name) || begins_as_time_name(name(column).name);
        return at(column).is_clock() || (named && rises_evenly(at(column).values)) ||
               at(column).values == at(format_.time_column).values;
    }

    // Where there is more than one column of times: the one of each column is the next on its left.
    void find_own_times() {
        if (format_.time_column < 0 || choice_.time_column) {
            return;
        }
        std::vector<int> times(static_cast<std::size_t>(format_.columns), format_.time_column);
        bool differ = false;
        int own = format_.time_column;
        for (int i = format_.time_column + 1; i < format_.columns; ++i) {
            if (!is_channel(format_, i) && is_time_again(i)) {
                own = same_times(format_.time_column, i) ? format_.time_column : i;
                differ = differ || own != format_.time_column;
            }
            times[static_cast<std::size_t>(i)] = own;
        }
        if (differ) {
            format_.own_times = std::move(times);
        }
    }

    const TextChoice& choice_;
    std::vector<int> words_;
    TextFormat& format_;
    std::vector<ColumnStart> starts_;
};

}  // namespace

bool is_channel(const TextFormat& format, int column) {
    return column != format.time_column && column != format.counter_column &&
           std::ranges::find(format.no_channels, column) == format.no_channels.end();
}

std::vector<int> channel_columns(const TextFormat& format) {
    std::vector<int> columns;
    for (int column = 0; column < format.columns; ++column) {
        if (is_channel(format, column)) {
            columns.push_back(column);
        }
    }
    return columns;
}

FirstColumn first_column(std::span<const std::string> rows, char delimiter, bool decimal_comma) {
    std::vector<double> values;
    std::vector<std::string_view> fields;
    for (const std::string& row : rows) {
        split_fields(row, delimiter, fields);
        const auto value = fields.size() > 1 ? parse_field(fields[0], decimal_comma) : std::nullopt;
        if (value) {
            values.push_back(*value);
        }
    }
    return !rises_evenly(values)   ? FirstColumn::other
           : counts_by_one(values) ? FirstColumn::counter
                                   : FirstColumn::time;
}

bool is_behind_table(std::string_view line, const TextFormat& format) {
    if (trimmed(line).empty() || is_comment(line, format.delimiter)) {
        return true;
    }
    std::vector<std::string_view> fields;
    split_fields(line, format.delimiter, fields);
    const auto is_word = [&](std::string_view field) {
        return !field.empty() && !parse_field(field, format.decimal_comma) && !parse_clock(field);
    };
    const bool first_holds_words =
        std::ranges::find(format.no_channels, 0) != format.no_channels.end();
    return !fields.empty() && is_word(fields.front()) &&
           (!first_holds_words || std::ssize(fields) < format.columns);
}

void find_columns(std::span<const std::string> rows, const TextChoice& choice,
                  std::vector<int> words, TextFormat& format) {
    ColumnSearch(rows, choice, std::move(words), format).run();
}

}  // namespace vybeg
