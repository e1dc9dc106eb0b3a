#include "core/recording/samples/open_options.h"

#include "core/base/number_text.h"

#include <array>
#include <cmath>
#include <cstddef>

namespace vybeg {
namespace {

// Text of --raw.
std::string type_text(const RawLayout& layout) {
    constexpr std::array names = {"i16", "i32", "f32", "f64"};
    return std::string(names[static_cast<std::size_t>(layout.type)]) +
           (layout.big_endian ? ":be" : "");
}

}  // namespace

std::string options_text(const OpenOptions& options) {
    std::string text;
    const auto add = [&text](const std::string& words) {
        text += (text.empty() || words.empty() ? "" : " ") + words;
    };
    if (!options.variables.empty()) {
        std::string names;
        for (const std::string& name : options.variables) {
            names += (&name == &options.variables.front() ? "" : ",") + name;
        }
        add("--variables " + names);
    }
    if (options.raw) {
        const RawLayout& raw = *options.raw;
        add("--raw " + type_text(raw) + " --raw-channels " + std::to_string(raw.channels) +
            " --skip " + integer_text(raw.skip_bytes) + " --scale " + round_trip_text(raw.scale));
    }
    if (options.text) {
        add(choice_text(*options.text));
    }
    if (!options.unit.empty()) {
        add("--unit " + options.unit);
    }
    return text;
}

Status check_options(const OpenOptions& options) {
    constexpr double least_hz = 1e-6;
    constexpr double most_hz = 1e12;
    if (options.rate_hz && !(*options.rate_hz >= least_hz && *options.rate_hz <= most_hz)) {
        return Error{ErrorCode::setting_invalid,
                     "",
                     {"--rate", number_arg(*options.rate_hz),
                      words(VYBEG_MESSAGE("Words", "it must lie between 1e-6 and 1e12 Hz"))}};
    }
    if (options.channel_c == options.channel_d) {
        const std::string channel = std::to_string(options.channel_c);
        return Error{ErrorCode::setting_invalid,
                     "",
                     {"--channels", channel + "," + channel,
                      words(VYBEG_MESSAGE("Words", "C and D must be two channels"))}};
    }
    if (options.text && options.raw) {
        return Error{ErrorCode::setting_invalid,
                     "",
                     {"--raw", choice_text(*options.text),
                      words(VYBEG_MESSAGE("Words", "a file is read as text or as raw"))}};
    }
    return options.text ? check_choice(*options.text) : Status{};
}

}  // namespace vybeg
