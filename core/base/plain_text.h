#pragma once

#include <functional>
#include <string>
#include <string_view>
#include <vector>

namespace vybeg {

// Text from a file, or a file's name, fit for a terminal, a header or a message: valid
// UTF-8 in one line. Control characters (C0, DEL, C1), line and paragraph separators and those that
// turn the direction of writing are shown as escapes, e.g. "\x1b" or "\u202e", and so are bytes
// that are no UTF-8. Text that is plain already is returned unchanged.
std::string plain_text(std::string_view text);

// Whether a character is an ASCII digit, in any locale.
constexpr bool is_digit(char c) {
    return c >= '0' && c <= '9';
}

// The parts of a text between separators, one or more.
std::vector<std::string_view> parts_between(std::string_view text, char separator);

// The texts that `text_of` makes of a list, with a separator between them; none after empty ones at
// its begin.
template <class List, class TextOf = std::identity>
std::string joined(const List& list, std::string_view separator, const TextOf& text_of = {}) {
    std::string text;
    for (const auto& each : list) {
        text += text.empty() ? "" : separator;
        text += std::invoke(text_of, each);
    }
    return text;
}

// The text that all of them are, or each of them with a separator between; empty of none.
std::string one_or_each(const std::vector<std::string>& texts, std::string_view separator);

// Small letters of the Latin alphabets of western Europe and of the Cyrillic ones, in UTF-8.
std::string lower_text(std::string_view text);

// The characters of a text in UTF-8; a byte that is none is U+FFFD.
std::u32string code_points(std::string_view text);

}  // namespace vybeg
