#pragma once

#include "core/base/translatable.h"

#include <cstddef>
#include <cstdint>
#include <span>
#include <string>
#include <utility>
#include <vector>

namespace vybeg {

// One argument of a message: a text as it is (a name, a path, what a file holds), a number with its
// unit, fixed words with arguments of their own, which the desktop program translates (context
// "Words"), or the number of a recording of a set, until name_recordings() puts its name there.
struct MessageArg {
    enum class Kind : std::uint8_t { text, number, words, recording };

    MessageArg() = default;
    // NOLINTBEGIN(google-explicit-constructor): most arguments are texts
    MessageArg(std::string as_it_is) : text(std::move(as_it_is)) {}
    MessageArg(const char* as_it_is) : text(as_it_is) {}
    // NOLINTEND(google-explicit-constructor)

    Kind kind = Kind::text;
    std::string text;              // digits of a number; template of words, with %1, ...
    std::string unit;              // of a number, e.g. "Hz"
    std::vector<MessageArg> args;  // of words

    // Equal in English.
    friend bool operator==(const MessageArg& a, const MessageArg& b);
};

// A number with so many significant digits;
MessageArg number_arg(double value, int digits = 6, const std::string& unit = {});
// As round_trip_text().
MessageArg exact_arg(double value);
MessageArg count_arg(std::int64_t count);
// A recording of a set, counted from 0 here and from 1 in a sentence.
MessageArg recording_arg(std::size_t recording);
// Replaces recordings by their names, or by their places in a larger set, in words too.
void name_recordings(std::span<const MessageArg> names, std::vector<MessageArg>& args);
// A unit without its number.
MessageArg unit_arg(const std::string& unit);
// E.g. words(VYBEG_MESSAGE("Words", "a line is longer than %1 MiB"), {count_arg(1)}).
MessageArg words(const char* text, std::vector<MessageArg> args = {});

// A text that was an argument before it went into a file: a number where it reads as one.
MessageArg stored_arg(const std::string& text);

// Fills %1 .. %9 of a template with the arguments. A number without an argument stays as it is.
std::string fill_template(const std::string& text, const std::vector<std::string>& args);

// As the command line prints it. Texts that may come from a file: as plain_text().
std::string english(const MessageArg& arg);
std::string english(const std::string& text, const std::vector<MessageArg>& args);

}  // namespace vybeg
