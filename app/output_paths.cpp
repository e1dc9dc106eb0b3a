#include "app/output_paths.h"

#include "core/output/same_file.h"

#include <algorithm>
#include <cctype>
#include <filesystem>

namespace vybeg::cli {

Status check_outputs(const std::vector<OutputPath>& outputs, const std::vector<InputPath>& inputs) {
    for (std::size_t k = 0; k < outputs.size(); ++k) {
        const OutputPath& output = outputs[k];
        if (output.path.empty()) {
            continue;
        }
        const auto refused = [&output](const std::string& reason) {
            return Error{ErrorCode::setting_invalid, "", {output.option, output.path, reason}};
        };
        for (const InputPath& input : inputs) {
            if (!input.path.empty() && same_file(input.path, output.path)) {
                return refused(input.taken);
            }
        }
        for (std::size_t earlier = 0; earlier < k; ++earlier) {
            if (!outputs[earlier].path.empty() && same_file(outputs[earlier].path, output.path)) {
                return refused(outputs[earlier].taken);
            }
        }
    }
    return {};
}

Status check_track_ending(const std::string& path) {
    std::string ending = std::filesystem::path(path).extension().string();
    std::ranges::transform(ending, ending.begin(),
                           [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
    for (const char* other : {".mat", ".h5", ".hdf5", ".npz", ".npy"}) {
        if (ending == other) {
            return Error{ErrorCode::setting_invalid,
                         "",
                         {"-o", path, "a track is written as CSV: let its name end in .csv"}};
        }
    }
    return {};
}

}  // namespace vybeg::cli
