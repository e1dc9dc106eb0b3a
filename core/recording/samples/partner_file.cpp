#include "core/recording/samples/partner_file.h"

#include "core/base/plain_text.h"
#include "core/recording/samples/text_fields.h"

#include <array>
#include <string>
#include <string_view>
#include <system_error>
#include <utility>
#include <vector>

namespace vybeg {
namespace {

// A whole word of the name, or its end behind a digit or a small letter: "run_c", "runC".
bool stands_alone(std::string_view name, std::size_t at, std::size_t length) {
    const bool ends = at + length == name.size() || !is_letter(name[at + length]);
    const bool capital = name[at] >= 'A' && name[at] <= 'Z';
    const bool begins = at == 0 || !is_letter(name[at - 1]) ||
                        (capital && name[at - 1] >= 'a' && name[at - 1] <= 'z');
    return ends && begins;
}

// The number that ends before `end`, and one more, in as many digits.
std::string next_number(std::string name, std::size_t end) {
    std::size_t at = end;
    while (at > 0 && is_digit(name[at - 1])) {
        --at;
        if (name[at] != '9') {
            ++name[at];
            return name;
        }
        name[at] = '0';
    }
    return name.insert(at, 1, '1');
}

// Names that may be the partner's, the likeliest first.
std::vector<std::string> names_like(const std::string& name) {
    constexpr std::array<std::pair<std::string_view, std::string_view>, 12> letters{
        {{"C", "D"},
         {"c", "d"},
         {"X", "Y"},
         {"x", "y"},
         {"A", "B"},
         {"a", "b"},
         {"cos", "sin"},
         {"Cos", "Sin"},
         {"COS", "SIN"},
         {"I", "Q"},
         {"left", "right"},
         {"L", "R"}}};
    std::vector<std::string> names;
    // LabOne counts its files behind the number of the demodulator.
    constexpr std::string_view demodulator = "demods_";
    if (const std::size_t at = name.find(demodulator); at != std::string::npos) {
        std::size_t end = at + demodulator.size();
        while (end < name.size() && is_digit(name[end])) {
            ++end;
        }
        names.push_back(next_number(name, end));
    }
    for (const auto& [from, to] : letters) {
        const std::size_t at = name.rfind(from);
        if (at != std::string::npos && stands_alone(name, at, from.size())) {
            names.push_back(std::string(name).replace(at, from.size(), to));
        }
    }
    for (std::size_t end = name.size(); end > 0; --end) {
        if (is_digit(name[end - 1]) && (end == name.size() || !is_digit(name[end]))) {
            names.push_back(next_number(name, end));
        }
    }
    return names;
}

}  // namespace

std::optional<std::filesystem::path> partner_of(const std::filesystem::path& path) {
    const std::string ending = path.extension().string();
    for (const std::string& name : names_like(path.stem().string())) {
        const std::filesystem::path partner = path.parent_path() / (name + ending);
        std::error_code unknown;
        if (std::filesystem::is_regular_file(partner, unknown)) {
            return partner;
        }
    }
    return std::nullopt;
}

}  // namespace vybeg
