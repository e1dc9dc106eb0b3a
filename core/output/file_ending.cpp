#include "core/output/file_ending.h"

#include <algorithm>

namespace vybeg {

std::string file_ending(const std::filesystem::path& path) {
    std::string ending = path.extension().string();
    std::ranges::transform(ending, ending.begin(), [](char letter) {
        return letter >= 'A' && letter <= 'Z' ? static_cast<char>(letter - 'A' + 'a') : letter;
    });
    return ending;
}

Status check_ending(const std::filesystem::path& path,
                    std::initializer_list<std::string_view> endings) {
    const std::string ending = file_ending(path);
    std::string possible;
    for (const std::string_view each : endings) {
        if (each == ending) {
            return {};
        }
        possible += possible.empty() || each.empty() ? "" : ", ";
        possible += each;
    }
    return Error{ErrorCode::output_format_unknown, path.string(), {ending, possible}};
}

}  // namespace vybeg
