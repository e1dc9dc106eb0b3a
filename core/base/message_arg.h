#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

// Mark texts for lupdate, as QT_TRANSLATE_NOOP and Q_DECLARE_TR_FUNCTIONS do (ui/CMakeLists.txt
// names these aliases); core itself has no translations.
#define VYBEG_MESSAGE(context, text) text
#define VYBEG_CONTEXT(context)

namespace vybeg {

// The sentences of errors and diagnostics.
struct Sentence {
    VYBEG_CONTEXT(Message)
    static constexpr const char* tr(const char* text) { return text; }
};

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
// Of a table's text, which VYBEG_MESSAGE("Words", ...) marks there; Phrase::tr() otherwise.
MessageArg words(const char* text, std::vector<MessageArg> args = {});

// E.g. Phrase::tr("a line is longer than %1 MiB", {count_arg(1)}).
struct Phrase {
    VYBEG_CONTEXT(Words)
    static MessageArg tr(const char* text, std::vector<MessageArg> args = {}) {
        return words(text, std::move(args));
    }
};

// Why a call of the system failed, by its errno: English on the command line in every locale.
MessageArg system_reason(int error);

// A text that was an argument before it went into a file: a number where it reads as one.
MessageArg stored_arg(const std::string& text);

// Fills %1 .. %9 of a template with the arguments. A number without an argument stays as it is.
std::string fill_template(const std::string& text, const std::vector<std::string>& args);

// As the command line prints it. Texts that may come from a file: as plain_text().
std::string english(const MessageArg& arg);
std::string english(const std::string& text, const std::vector<MessageArg>& args);

// One code of errors or diagnostics. %1, %2, ... are arguments in its English sentence, which
// the desktop program translates (context "Message") before it fills it. Where command line and
// window say different things it has both, {command line|window}, or {command line} alone.
struct MessageRow {
    const char* code;
    int grade;  // of an error the exit status of the command line, of a diagnostic its Severity
    const char* sentence;

    // In JSON: "time-gap" of time_gap.
    std::string name() const;
};

template <class Rows>
MessageRow row_at(const Rows& rows, std::size_t place) {
    return place < rows.size() ? rows[place] : MessageRow{"", 0, ""};
}

// Passes to `take` what the command line, or the window, says of a sentence, piece by piece.
template <class Take>
void pass_sentence(std::string_view sentence, bool window, const Take& take) {
    for (;;) {
        const std::size_t begin = sentence.find('{');
        const std::size_t end = sentence.find('}', begin);
        if (end == std::string_view::npos) {
            break;
        }
        const std::size_t bar = std::min(sentence.find('|', begin), end);
        take(sentence.substr(0, begin));
        const std::size_t other = std::min(bar + 1, end);
        take(window ? sentence.substr(other, end - other)
                    : sentence.substr(begin + 1, bar - begin - 1));
        sentence.remove_prefix(end + 1);
    }
    take(sentence);
}
std::string sentence_for(bool window, std::string_view sentence);

// As the command line prints it.
std::string english(const MessageRow& row, const std::vector<MessageArg>& args);

}  // namespace vybeg
