#include "core/recording/samples/recording_format.h"

#include "core/base/message_arg.h"
#include "core/base/plain_text.h"

namespace vybeg {

namespace {

std::string english(const FormatPart& part) {
    switch (part.kind) {
        case FormatPart::Kind::name:
        case FormatPart::Kind::words: return part.text;
        case FormatPart::Kind::channels: return std::to_string(part.count) + " channels";
        case FormatPart::Kind::columns: return std::to_string(part.count) + " columns";
    }
    return {};
}

}  // namespace

FormatPart byte_order_part(bool big_endian) {
    return FormatPart::words(big_endian ? VYBEG_MESSAGE("Format", "big endian")
                                        : VYBEG_MESSAGE("Format", "little endian"));
}

std::string english(const RecordingFormat& format) {
    return joined(format, ", ", [](const FormatPart& part) { return english(part); });
}

}  // namespace vybeg
