#include "core/recording/bytes/text_encoding.h"

#include "core/recording/bytes/byte_order.h"

#include <algorithm>
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

std::uint32_t windows_1251(unsigned char byte) {
    if (byte < 0x80) {
        return byte;
    }
    if (byte >= 0xC0) {
        return 0x0410u + byte - 0xC0u;
    }
    switch (byte) {
        case 0xA8: return 0x0401;
        case 0xB0: return 0x00B0;
        case 0xB5: return 0x00B5;
        case 0xB8: return 0x0451;
        default: return '?';
    }
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
