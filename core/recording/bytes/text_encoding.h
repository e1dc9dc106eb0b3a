#pragma once

#include <string>
#include <string_view>

namespace vybeg {

enum class TextEncoding { bytes, utf16_little, utf16_big };

// Encoding by the byte order mark; "bytes" is UTF-8 or any 8 bit extension of ASCII.
TextEncoding encoding_of(std::string_view head);

// Length of the byte order mark at the start of a file, in bytes.
std::size_t mark_length(std::string_view head);

// Whether the first bytes of a file contain only bytes possible in text.
bool looks_like_text(std::string_view head);

// Appends UTF-16 bytes (an even number) as UTF-8. Characters outside the basic plane become '?'.
void append_utf16(std::string_view bytes, TextEncoding encoding, std::string& utf8);

// `text` itself if it is UTF-8; otherwise decoded from Windows-1251, the encoding of Russian
// instruments.
std::string to_utf8(std::string_view text);

// Text of a file as a quote for a one-line message.
std::string short_quote(std::string_view text);

}  // namespace vybeg
