#include "core/recording/samples/open_options.h"

namespace vybeg {

void find_files_from(const std::filesystem::path& folder, OpenOptions& options) {
    const auto find = [&folder](std::string& name) {
        name = name.empty() ? name : (folder / name).lexically_normal().string();
    };
    find(options.channel_d_file);
    for (std::string& name : options.join) {
        find(name);
    }
}

std::vector<std::filesystem::path> further_files(const OpenOptions& options) {
    std::vector<std::filesystem::path> files(options.join.begin(), options.join.end());
    if (!options.channel_d_file.empty()) {
        files.emplace_back(options.channel_d_file);
    }
    return files;
}

}  // namespace vybeg
