#include "core/base/read_value.h"

#include "core/base/number_text.h"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <optional>

namespace vybeg {

Error refused_value(const std::string& option, const std::string& text,
                    const std::string& allowed) {
    return {ErrorCode::setting_invalid, "", {option, text, allowed}};
}

Result<double> read_number(const std::string& option, const std::string& text) {
    const std::optional<double> number = parse_number(text);
    if (!number || !std::isfinite(*number)) {
        return refused_value(option, text, "it must be a number, with a point and without a unit");
    }
    return *number;
}

Result<std::int64_t> read_whole(const std::string& option, const std::string& text) {
    std::int64_t number = 0;
    const char* const end = text.data() + text.size();
    const auto parsed = std::from_chars(text.data(), end, number);
    if (parsed.ec != std::errc{} || parsed.ptr != end) {
        return refused_value(option, text, "it must be a whole number");
    }
    return number;
}

Result<std::vector<double>> read_numbers(const std::string& option, const std::string& text,
                                         std::size_t count, const std::string& allowed) {
    std::vector<double> numbers;
    for (std::size_t begin = 0; begin <= text.size();) {
        const std::size_t end = std::min(text.find(',', begin), text.size());
        const std::optional<double> number = parse_number(text.substr(begin, end - begin));
        if (!number || !std::isfinite(*number)) {
            return refused_value(option, text, allowed);
        }
        numbers.push_back(*number);
        begin = end + 1;
    }
    if (numbers.size() != count) {
        return refused_value(option, text, allowed);
    }
    return numbers;
}

}  // namespace vybeg
