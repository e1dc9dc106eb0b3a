#include "core/base/plain_text.h"

#include <algorithm>
#include <cstddef>
#include <cstdint>

namespace vybeg {
namespace {

struct Character {
    std::uint32_t code = 0;
    std::size_t bytes = 0;  // 0: no UTF-8 begins there
};

Character character_at(std::string_view text) {
    const auto byte = [text](std::size_t i) { return static_cast<unsigned char>(text[i]); };
    const unsigned first = byte(0);
    if (first < 0x80) {
        return {first, 1};
    }
    const std::size_t length = first >= 0xF0 ? 4 : first >= 0xE0 ? 3 : 2;
    if (first < 0xC2 || first > 0xF4 || text.size() < length) {
        return {};
    }
    std::uint32_t code = first & (0xFFu >> (length + 1));
    for (std::size_t i = 1; i < length; ++i) {
        if ((byte(i) & 0xC0u) != 0x80) {
            return {};
        }
        code = code << 6 | (byte(i) & 0x3Fu);
    }
    const bool overlong = (length == 3 && code < 0x800) || (length == 4 && code < 0x10000);
    const bool surrogate = code >= 0xD800 && code <= 0xDFFF;
    return overlong || surrogate || code > 0x10FFFF ? Character{} : Character{code, length};
}

bool is_plain(std::uint32_t code) {
    const bool control = code < 0x20 || (code >= 0x7F && code < 0xA0);
    const bool separator = code == 0x2028 || code == 0x2029;
    const bool turns = code == 0x061C || code == 0x200E || code == 0x200F ||
                       (code >= 0x202A && code <= 0x202E) || (code >= 0x2066 && code <= 0x2069);
    return !control && !separator && !turns;
}

std::string hexadecimal(std::uint32_t number, int digits) {
    std::string text;
    for (int shift = 4 * (digits - 1); shift >= 0; shift -= 4) {
        text += "0123456789abcdef"[number >> shift & 0xF];
    }
    return text;
}

// Of a letter of two bytes.
unsigned small_letter(unsigned code) {
    constexpr unsigned multiplication_sign = 0xD7;
    const bool latin = code >= 0xC0 && code <= 0xDE && code != multiplication_sign;
    const bool cyrillic = code >= 0x410 && code <= 0x42F;
    const bool cyrillic_with_marks = code >= 0x400 && code <= 0x40F;  // as Ё
    return code + (latin || cyrillic ? 0x20 : cyrillic_with_marks ? 0x50 : 0);
}

}  // namespace

std::vector<std::string_view> parts_between(std::string_view text, char separator) {
    std::vector<std::string_view> parts;
    for (std::size_t at = 0; at <= text.size();) {
        const std::size_t end = std::min(text.find(separator, at), text.size());
        parts.push_back(text.substr(at, end - at));
        at = end + 1;
    }
    return parts;
}

std::string one_or_each(const std::vector<std::string>& texts, std::string_view separator) {
    std::string all = texts.empty() ? "" : texts.front();
    if (std::ranges::count(texts, all) != std::ssize(texts)) {
        for (std::size_t k = 1; k < texts.size(); ++k) {
            all.append(separator).append(texts[k]);
        }
    }
    return all;
}

std::string lower_text(std::string_view text) {
    std::string small(text);
    for (std::size_t i = 0; i < small.size(); ++i) {
        const auto first = static_cast<unsigned char>(small[i]);
        const auto next = static_cast<unsigned char>(i + 1 < small.size() ? small[i + 1] : 0);
        if (first >= 'A' && first <= 'Z') {
            small[i] = static_cast<char>(first - 'A' + 'a');
        } else if ((first & 0xE0u) == 0xC0 && (next & 0xC0u) == 0x80) {
            const unsigned code = small_letter((first & 0x1Fu) << 6 | (next & 0x3Fu));
            small[i] = static_cast<char>(0xC0 | code >> 6);
            small[++i] = static_cast<char>(0x80 | (code & 0x3F));
        }
    }
    return small;
}

std::string plain_text(std::string_view text) {
    std::string plain;
    plain.reserve(text.size());
    while (!text.empty()) {
        const Character character = character_at(text);
        const std::size_t bytes = character.bytes == 0 ? 1 : character.bytes;
        if (character.bytes == 0) {
            plain += "\\x" + hexadecimal(static_cast<unsigned char>(text[0]), 2);
        } else if (is_plain(character.code)) {
            plain += text.substr(0, bytes);
        } else {
            plain += bytes == 1 ? "\\x" + hexadecimal(character.code, 2)
                                : "\\u" + hexadecimal(character.code, 4);
        }
        text.remove_prefix(bytes);
    }
    return plain;
}

std::u32string code_points(std::string_view text) {
    constexpr char32_t no_character = 0xFFFD;
    std::u32string points;
    while (!text.empty()) {
        const Character character = character_at(text);
        points += character.bytes == 0 ? no_character : static_cast<char32_t>(character.code);
        text.remove_prefix(character.bytes == 0 ? 1 : character.bytes);
    }
    return points;
}

}  // namespace vybeg
