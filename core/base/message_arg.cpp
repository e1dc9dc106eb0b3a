#include "core/base/message_arg.h"

#include "core/base/number_text.h"
#include "core/base/plain_text.h"

#include <array>
#include <cstring>
#include <utility>

namespace vybeg {

bool operator==(const MessageArg& a, const MessageArg& b) {
    return english(a) == english(b);
}

namespace {

MessageArg number(std::string digits, const std::string& unit = {}) {
    MessageArg arg(std::move(digits));
    arg.kind = MessageArg::Kind::number;
    arg.unit = unit;
    return arg;
}

// The texts of glibc that the window has translations for.
[[maybe_unused]] constexpr std::array translated{
    VYBEG_MESSAGE("Words", "Disk quota exceeded"),
    VYBEG_MESSAGE("Words", "File name too long"),
    VYBEG_MESSAGE("Words", "File too large"),
    VYBEG_MESSAGE("Words", "Input/output error"),
    VYBEG_MESSAGE("Words", "Is a directory"),
    VYBEG_MESSAGE("Words", "No space left on device"),
    VYBEG_MESSAGE("Words", "No such file or directory"),
    VYBEG_MESSAGE("Words", "Not a directory"),
    VYBEG_MESSAGE("Words", "Operation not permitted"),
    VYBEG_MESSAGE("Words", "Permission denied"),
    VYBEG_MESSAGE("Words", "Read-only file system"),
    VYBEG_MESSAGE("Words", "Too many open files"),
};

}  // namespace

MessageArg number_arg(double value, int digits, const std::string& unit) {
    return number(short_text(value, digits), unit);
}

MessageArg exact_arg(double value) {
    return number(round_trip_text(value));
}

MessageArg count_arg(std::int64_t count) {
    return number(integer_text(count));
}

MessageArg recording_arg(std::size_t recording) {
    MessageArg arg = count_arg(static_cast<std::int64_t>(recording) + 1);
    arg.kind = MessageArg::Kind::recording;
    return arg;
}

void name_recordings(std::span<const MessageArg> names, std::vector<MessageArg>& args) {
    for (MessageArg& arg : args) {
        if (arg.kind != MessageArg::Kind::recording) {
            name_recordings(names, arg.args);
            continue;
        }
        for (std::size_t k = 0; k < names.size(); ++k) {
            if (arg.text == integer_text(static_cast<std::int64_t>(k) + 1)) {
                arg = names[k];
                break;
            }
        }
    }
}

MessageArg unit_arg(const std::string& unit) {
    return number("", unit);
}

MessageArg words(const char* text, std::vector<MessageArg> args) {
    MessageArg arg(text);
    arg.kind = MessageArg::Kind::words;
    arg.args = std::move(args);
    return arg;
}

MessageArg system_reason(int error) {
    const char* reason = strerrordesc_np(error);  // unlike strerror, the same in every locale
    return words(reason != nullptr ? reason : VYBEG_MESSAGE("Words", "unknown error"));
}

MessageArg stored_arg(const std::string& text) {
    MessageArg arg(text);
    arg.kind = parse_number(text) ? MessageArg::Kind::number : MessageArg::Kind::text;
    return arg;
}

std::string fill_template(const std::string& text, const std::vector<std::string>& args) {
    std::string filled;
    for (std::size_t i = 0; i < text.size(); ++i) {
        const std::size_t number = text[i] == '%' && i + 1 < text.size()
                                       ? static_cast<std::size_t>(text[i + 1] - '1')
                                       : args.size();
        if (number < args.size()) {
            filled += args[number];
            ++i;
        } else {
            filled += text[i];
        }
    }
    return filled;
}

std::string english(const MessageArg& arg) {
    switch (arg.kind) {
        case MessageArg::Kind::text: return plain_text(arg.text);
        case MessageArg::Kind::number:
            return arg.text + (arg.text.empty() || arg.unit.empty() ? "" : " ") + arg.unit;
        case MessageArg::Kind::words: return english(arg.text, arg.args);
        case MessageArg::Kind::recording: return arg.text;
    }
    return {};
}

std::string english(const std::string& text, const std::vector<MessageArg>& args) {
    std::vector<std::string> texts;
    texts.reserve(args.size());
    for (const MessageArg& arg : args) {
        texts.push_back(english(arg));
    }
    return fill_template(text, texts);
}

std::string MessageRow::name() const {
    std::string name = code;
    std::ranges::replace(name, '_', '-');
    return name;
}

std::string sentence_for(bool window, std::string_view sentence) {
    std::string text;
    pass_sentence(sentence, window, [&text](std::string_view piece) { text += piece; });
    return text;
}

std::string english(const MessageRow& row, const std::vector<MessageArg>& args) {
    return english(sentence_for(false, row.sentence), args);
}

}  // namespace vybeg
