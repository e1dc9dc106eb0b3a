#pragma once

#include "core/base/number_text.h"
#include "core/base/plain_text.h"
#include "core/base/read_value.h"
#include "core/base/result.h"

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <initializer_list>
#include <limits>
#include <optional>
#include <string>
#include <type_traits>
#include <utility>
#include <vector>

namespace vybeg {

// Least and most of a number, both allowed.
struct Bounds {
    double least = std::numeric_limits<double>::lowest();
    double most = std::numeric_limits<double>::max();
    const char* allowed = "it must be a number";
};

// What command line, track header, JSON, measurement list and session know of one field of the
// settings S; the window's fields take their bounds from it.
template <class S>
struct SettingRow {
    std::string name;  // on the command line, without its dashes; the same in header and JSON
    std::string placeholder;  // of its value in the help, e.g. "HZ"; empty: a switch, yes or no
    std::string help;
    // Takes a value as the command line has it. Errors: setting_invalid.
    std::function<Status(const std::string& text, S& settings)> read = {};
    // The value as read() takes it; digits round-trip.
    std::function<std::string(const S& settings)> text = {};
    // Whether the value lies within its bounds. Errors: setting_invalid.
    std::function<Status(const S& settings)> check = [](const S&) { return Status(); };
    // In the texts of a result: not the number of threads, nor what a result states on its own.
    bool has_part = true;
    // Of each number of the value, in their order on the command line.
    std::vector<Bounds> bounds = {};

    std::string option() const { return "--" + name; }
    // Of a number, by the placeholder; "none" without one.
    std::string unit() const {
        return placeholder == "S"     ? "s"
               : placeholder == "HZ"  ? "Hz"
               : placeholder == "DEG" ? "deg"
                                      : "none";
    }
};

// Name and value as the command line takes them.
using NamedValue = std::pair<std::string, std::string>;

// Those of the rows that have a part in a result.
template <class S>
std::vector<NamedValue> listed(const std::vector<SettingRow<S>>& rows, const S& settings) {
    std::vector<NamedValue> list;
    for (const SettingRow<S>& row : rows) {
        if (row.has_part) {
            list.emplace_back(row.name, row.text(settings));
        }
    }
    return list;
}

// Null: there is none.
template <class S>
const SettingRow<S>* row_named(const std::vector<SettingRow<S>>& rows, const std::string& name) {
    const auto found = std::ranges::find(rows, name, &SettingRow<S>::name);
    return found == rows.end() ? nullptr : &*found;
}

// Kinds of rows. `access` returns a reference to the field: [](auto& s) -> auto& { return s.f; }.

inline const std::string not_set = "none";

// Bounds of a number of the row with that name. Precondition: there is one.
template <class S>
const Bounds& bounds_in(const std::vector<SettingRow<S>>& rows, const std::string& name,
                        std::size_t number = 0) {
    return row_named(rows, name)->bounds.at(number);
}

inline Status within(const Bounds& bounds, const std::string& option, double value) {
    // False for NaN.
    return value >= bounds.least && value <= bounds.most
               ? Status()
               : refused_value(option, short_text(value, 12), bounds.allowed);
}

// What has no bounds of its own.
inline constexpr auto any_value = [](const auto&) { return Status(); };

// The row for settings S, of which `part` returns those that it is for.
template <class S, class Of, class Part>
SettingRow<S> row_of_part(const SettingRow<Of>& of, Part part) {
    return {of.name,
            of.placeholder,
            of.help,
            [=](const std::string& text, S& settings) { return of.read(text, part(settings)); },
            [=](const S& settings) { return of.text(part(settings)); },
            [=](const S& settings) { return of.check(part(settings)); },
            of.has_part,
            of.bounds};
}

template <class S, class Access>
using FieldOf = std::remove_reference_t<std::invoke_result_t<Access, S&>>;

// The field that `access` returns is a T or an optional T, whose text where it is not there is
// `unset`. `read` makes a Result<T> of a text, `text` a text of a T, `check` a Status of a T.
template <class T, class S, class Access, class Read, class Text, class Check>
SettingRow<S> value_row(SettingRow<S> row, Access access, Read read, Text text, Check check,
                        const std::string& unset = not_set) {
    constexpr bool may_be_unset = std::is_same_v<FieldOf<S, Access>, std::optional<T>>;
    row.read = [=](const std::string& from, S& settings) -> Status {
        if constexpr (may_be_unset) {
            if (from == unset) {
                access(settings).reset();
                return {};
            }
        }
        const auto value = TRY(read(from));
        access(settings) = value;
        return {};
    };
    row.text = [=](const S& settings) -> std::string {
        if constexpr (may_be_unset) {
            return access(settings) ? text(*access(settings)) : unset;
        } else {
            return text(access(settings));
        }
    };
    row.check = [=](const S& settings) -> Status {
        if constexpr (may_be_unset) {
            return access(settings) ? check(*access(settings)) : Status();
        } else {
            return check(access(settings));
        }
    };
    return row;
}

template <class S, class Access>
SettingRow<S> number_row(SettingRow<S> row, Access access, Bounds bounds = {}) {
    row.bounds = {bounds};
    return value_row<double>(
        row, access,
        [option = row.option(), unit = row.unit()](const std::string& from) {
            return read_number(option, from, unit);
        },
        round_trip_text,
        [=, option = row.option()](double value) { return within(bounds, option, value); });
}

// A number of 1 or more; the field is 0 where it is not set.
template <class S, class Access>
SettingRow<S> count_row(SettingRow<S> row, Access access, const std::string& unset, Bounds bounds) {
    row.bounds = {bounds};
    row.read = [=, option = row.option()](const std::string& from, S& settings) -> Status {
        const auto value = TRY(from == unset ? 0 : read_whole(option, from));
        const auto number = static_cast<double>(value);
        if (from != unset && !(number >= 1 && number <= bounds.most)) {
            return refused_value(option, from, bounds.allowed);
        }
        access(settings) = static_cast<FieldOf<S, Access>>(value);
        return {};
    };
    row.text = [=](const S& settings) {
        return access(settings) > 0 ? integer_text(access(settings)) : unset;
    };
    row.check = [=, option = row.option()](const S& settings) {
        return within({0, bounds.most, bounds.allowed}, option,
                      static_cast<double>(access(settings)));
    };
    return row;
}

// A field of few values, each with its word.
template <class S, class Access,
          class Words = std::vector<std::pair<std::string, FieldOf<S, Access>>>>
SettingRow<S> choice_row(SettingRow<S> row, Access access, const Words& words,
                         const std::string& allowed) {
    row.read = [=, option = row.option()](const std::string& from, S& settings) -> Status {
        for (const auto& [word, value] : words) {
            if (from == word) {
                access(settings) = value;
                return {};
            }
        }
        return refused_value(option, from, allowed);
    };
    row.text = [=](const S& settings) {
        for (const auto& [word, value] : words) {
            if (access(settings) == value) {
                return std::string(word);
            }
        }
        return std::string();
    };
    return row;
}

template <class S, class Access>
SettingRow<S> switch_row(SettingRow<S> row, Access access) {
    return choice_row(std::move(row), access, {{"yes", true}, {"no", false}}, "it is yes or no");
}

inline std::string joined(std::initializer_list<double> numbers) {
    return joined(numbers, ",", round_trip_text);
}

}  // namespace vybeg
