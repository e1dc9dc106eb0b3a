#include "core/output/output_paths.h"

#include "core/base/read_value.h"

#include <algorithm>
#include <sys/stat.h>
#include <sys/sysmacros.h>
#include <unistd.h>
#include <utility>

namespace vybeg {
namespace {

std::optional<struct stat> status_of(const std::filesystem::path& path) {
    struct stat status {};
    const int failed = path == "-" ? fstat(STDOUT_FILENO, &status) : stat(path.c_str(), &status);
    return failed == 0 ? std::optional(status) : std::nullopt;
}

bool is_null_device(const struct stat& status) {
    return S_ISCHR(status.st_mode) && status.st_rdev == makedev(1, 3);
}

// The first link of a path without others, which thus leads nowhere, and what comes after it;
// empty: there is none.
std::pair<std::filesystem::path, std::filesystem::path> link_to_nowhere(
    const std::filesystem::path& path) {
    std::filesystem::path link;
    for (auto part = path.begin(); part != path.end(); ++part) {
        link /= *part;
        std::error_code unknown;
        if (is_symlink(symlink_status(link, unknown))) {
            std::filesystem::path rest;
            for (++part; part != path.end(); ++part) {
                rest /= *part;
            }
            return {link, rest};
        }
    }
    return {};
}

}  // namespace

std::filesystem::path end_of_links(const std::filesystem::path& path, std::error_code& failed) {
    constexpr int most_links = 40;  // as the system follows
    std::filesystem::path end = weakly_canonical(absolute(path, failed), failed);
    for (int links = 0; !failed; ++links) {
        const auto [link, rest] = link_to_nowhere(end);
        if (link.empty()) {
            break;
        }
        if (links == most_links) {
            failed = std::make_error_code(std::errc::too_many_symbolic_link_levels);
            break;
        }
        const std::filesystem::path target = link.parent_path() / read_symlink(link, failed);
        end = weakly_canonical(rest.empty() ? target : target / rest, failed);
    }
    // That there is no file at the end is no failure.
    if (failed == std::errc::no_such_file_or_directory) {
        failed.clear();
    }
    return end;
}

std::optional<FilePlace> place_of(const std::filesystem::path& path) {
    std::error_code failed;
    std::filesystem::path folder = end_of_links(path, failed);
    std::filesystem::path name;
    while (!failed && folder.has_relative_path()) {
        name = name.empty() ? folder.filename() : folder.filename() / name;
        folder = folder.parent_path();
        if (const auto status = status_of(folder)) {
            return FilePlace{status->st_dev, status->st_ino, name};
        }
    }
    return {};
}

bool same_file(const std::filesystem::path& one, const std::filesystem::path& other) {
    const auto first = status_of(one);
    const auto second = status_of(other);
    if (first && second) {
        return first->st_dev == second->st_dev && first->st_ino == second->st_ino &&
               !is_null_device(*first);
    }
    if (first || second || one == "-" || other == "-" || one.empty() || other.empty()) {
        return one == other && one == "-";
    }
    const auto new_one = place_of(one);
    const auto new_other = place_of(other);
    return new_one && new_other ? *new_one == *new_other : one == other;
}

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

void add_recording_files(std::vector<InputPath>& inputs, const std::filesystem::path& recording,
                         const OpenOptions& open) {
    std::vector<std::filesystem::path> files = further_files(open);
    files.push_back(recording);
    for (const std::filesystem::path& file : files) {
        inputs.push_back(
            {file.string(), words(VYBEG_MESSAGE("Words", "it is one of the recordings"))});
    }
}

Status check_outputs(const std::vector<OutputPath>& outputs, const std::vector<InputPath>& inputs) {
    for (std::size_t k = 0; k < outputs.size(); ++k) {
        const OutputPath& output = outputs[k];
        if (output.path.empty()) {
            continue;
        }
        const auto refused = [&output](const MessageArg& reason) {
            return refused_value(output.option, output.path, reason);
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

}  // namespace vybeg
