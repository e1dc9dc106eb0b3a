#include "core/recording/bytes/text_encoding.h"

#include "core/recording/bytes/number_type.h"

#include <algorithm>
#include <array>
#include <cstdint>

namespace vybeg {
namespace {

using namespace std::string_view_literals;

constexpr std::string_view utf8_mark = "\xEF\xBB\xBF"sv;
constexpr std::string_view utf16_little_mark = "\xFF\xFE"sv;
constexpr std::string_view utf16_big_mark = "\xFE\xFF"sv;

constexpr std::size_t longest_quote = 40;  // bytes of the file, in a message

void append_code(std::uint32_t code, std::string& utf8) {
    const auto put = [&utf8](std::uint32_t byte) { utf8 += static_cast<char>(byte); };
    if (code < 0x80) {
        put(code);
    } else if (code < 0x800) {
        put(0xC0 | (code >> 6));
        put(0x80 | (code & 0x3F));
    } else {
        put(0xE0 | (code >> 12));
        put(0x80 | ((code >> 6) & 0x3F));
        put(0x80 | (code & 0x3F));
    }
}

// Length of the UTF-8 sequence at the start of text, 0 without one.
std::size_t sequence_length(std::string_view text) {
    const auto first = static_cast<unsigned char>(text[0]);
    const std::size_t length = first < 0x80                    ? 1
                               : first >= 0xC2 && first < 0xE0 ? 2
                               : first >= 0xE0 && first < 0xF0 ? 3
                               : first >= 0xF0 && first < 0xF5 ? 4
                                                               : 0;
    if (length == 0 || text.size() < length) {
        return 0;
    }
    const auto continues = [](char byte) {
        return (static_cast<unsigned char>(byte) & 0xC0) == 0x80;
    };
    const std::string_view rest = text.substr(1, length - 1);
    return std::all_of(rest.begin(), rest.end(), continues) ? length : 0;
}

bool is_utf8(std::string_view text) {
    while (!text.empty()) {
        const std::size_t length = sequence_length(text);
        if (length == 0) {
            return false;
        }
        text.remove_prefix(length);
    }
    return true;
}

// Characters 0x80 to 0xBF; the one that has none is 0.
constexpr std::array<std::uint16_t, 64> windows_1251_signs{
    0x0402, 0x0403, 0x201A, 0x0453, 0x201E, 0x2026, 0x2020, 0x2021, 0x20AC, 0x2030, 0x0409,
    0x2039, 0x040A, 0x040C, 0x040B, 0x040F, 0x0452, 0x2018, 0x2019, 0x201C, 0x201D, 0x2022,
    0x2013, 0x2014, 0,      0x2122, 0x0459, 0x203A, 0x045A, 0x045C, 0x045B, 0x045F, 0x00A0,
    0x040E, 0x045E, 0x0408, 0x00A4, 0x0490, 0x00A6, 0x00A7, 0x0401, 0x00A9, 0x0404, 0x00AB,
    0x00AC, 0x00AD, 0x00AE, 0x0407, 0x00B0, 0x00B1, 0x0406, 0x0456, 0x0491, 0x00B5, 0x00B6,
    0x00B7, 0x0451, 0x2116, 0x0454, 0x00BB, 0x0458, 0x0405, 0x0455, 0x0457};

std::uint32_t windows_1251(unsigned char byte) {
    if (byte < 0x80) {
        return byte;
    }
    if (byte >= 0xC0) {
        return 0x0410u + byte - 0xC0u;
    }
    const std::uint16_t sign = windows_1251_signs[byte - 0x80u];
    return sign != 0 ? sign : '?';
}

}  // namespace

TextEncoding encoding_of(std::string_view head) {
    if (head.starts_with(utf16_little_mark)) {
        return TextEncoding::utf16_little;
    }
    return head.starts_with(utf16_big_mark) ? TextEncoding::utf16_big : TextEncoding::bytes;
}

std::size_t mark_length(std::string_view head) {
    if (encoding_of(head) != TextEncoding::bytes) {
        return utf16_little_mark.size();
    }
    return head.starts_with(utf8_mark) ? utf8_mark.size() : 0;
}

bool looks_like_text(std::string_view head) {
    const TextEncoding encoding = encoding_of(head);
    std::string utf8;
    head.remove_prefix(mark_length(head));
    if (encoding != TextEncoding::bytes) {
        append_utf16(head.substr(0, head.size() / 2 * 2), encoding, utf8);
        head = utf8;
    }
    return std::none_of(head.begin(), head.end(), [](char byte) {
        // 0x1A is the end mark of old DOS programs.
        return (byte >= 0 && byte < ' ' && "\t\n\v\f\r\x1A"sv.find(byte) == ""sv.npos) ||
               byte == 0x7F;
    });
}

void append_utf16(std::string_view bytes, TextEncoding encoding, std::string& utf8) {
    for (; bytes.size() >= 2; bytes.remove_prefix(2)) {
        const std::uint32_t code =
            load<std::uint16_t>(bytes.data(), encoding == TextEncoding::utf16_big);
        append_code(code >= 0xD800 && code < 0xE000 ? '?' : code, utf8);
    }
}

std::string to_utf8(std::string_view text) {
    if (is_utf8(text)) {
        return std::string(text);
    }
    std::string utf8;
    for (const char byte : text) {
        append_code(windows_1251(static_cast<unsigned char>(byte)), utf8);
    }
    return utf8;
}

std::string short_quote(std::string_view text) {
    std::string quote = to_utf8(text.substr(0, longest_quote));
    if (text.size() > longest_quote) {
        quote += "...";
    }
    std::replace_if(
        quote.begin(), quote.end(), [](char c) { return c >= 0 && c < ' '; }, ' ');
    return quote;
}

}  // namespace vybeg
