#pragma once

#include <string>
#include <string_view>

namespace vybeg {

enum class TextEncoding { bytes, utf16_little, utf16_big };

// By the byte order mark; "bytes" is UTF-8 or any 8 bit code that has ASCII in it.
TextEncoding encoding_of(std::string_view head);

// Length of the byte order mark at the start of a file, in bytes.
std::size_t mark_length(std::string_view head);

// True where the first bytes of a file hold no byte that text cannot hold.
bool looks_like_text(std::string_view head);

// Appends UTF-16 bytes (an even number) as UTF-8. What lies outside of the basic plane becomes '?'.
void append_utf16(std::string_view bytes, TextEncoding encoding, std::string& utf8);

// `text` itself where it is UTF-8; else read as Windows-1251, what Russian instruments write.
std::string to_utf8(std::string_view text);

// What stands in a file, as it may be quoted in a one-line message.
std::string short_quote(std::string_view text);

}  // namespace vybeg
