#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <string>
#include <utility>
#include <vector>

// Marks a text for lupdate, as QT_TRANSLATE_NOOP does (ui/CMakeLists.txt names this alias); core
// itself has no translations.
#define VYBEG_MESSAGE(context, text) text

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

// Why a call of the system failed, by its errno: English on the command line in every locale.
MessageArg system_reason(int error);

// A text that was an argument before it went into a file: a number where it reads as one.
MessageArg stored_arg(const std::string& text);

// Fills %1 .. %9 of a template with the arguments. A number without an argument stays as it is.
std::string fill_template(const std::string& text, const std::vector<std::string>& args);

// As the command line prints it. Texts that may come from a file: as plain_text().
std::string english(const MessageArg& arg);
std::string english(const std::string& text, const std::vector<MessageArg>& args);

// One code of errors or diagnostics: its name in JSON, its grade, its English sentence, and the
// window's sentence where that of the command line names options. %1 stands for `where` and %2, %3,
// ... for the arguments of an error; %1, %2, ... for the arguments of a diagnostic. The desktop
// program translates a sentence (context "Message") before it fills it.
struct MessageRow {
    const char* name;
    int grade;  // of an error the exit status of the command line, of a diagnostic its Severity
    const char* sentence;
    const char* in_window = nullptr;
};

// A row of the table of all codes.
template <class Code>
struct CodedRow {
    constexpr CodedRow(Code of, const char* name, int grade, const char* sentence,
                       const char* in_window = nullptr)
        : code(of), row{name, grade, sentence, in_window} {}

    Code code;
    MessageRow row;
};

// Empty where there is none.
template <class Rows, class Code>
MessageRow row_of(const Rows& rows, Code code) {
    for (const CodedRow<Code>& each : rows) {
        if (each.code == code) {
            return each.row;
        }
    }
    return {"", 0, ""};
}

}  // namespace vybeg
