#pragma once

#include "core/base/message_arg.h"
#include "core/base/result.h"
#include "core/recording/samples/open_options.h"

#include <compare>
#include <filesystem>
#include <initializer_list>
#include <optional>
#include <string>
#include <string_view>
#include <sys/types.h>
#include <system_error>
#include <vector>

namespace vybeg {

// The file that a path leads to, also where it does not exist yet: without links, of which one, to
// a file or a folder, may lead nowhere. `failed`: why this cannot be told.
std::filesystem::path end_of_links(const std::filesystem::path& path, std::error_code& failed);

// The place of a file at the end of links, whether the file exists or not: the last folder of its
// path that exists, by device and inode, and the rest of the path.
struct FilePlace {
    dev_t device;
    ino_t folder;
    std::filesystem::path name;

    friend auto operator<=>(const FilePlace&, const FilePlace&) = default;
};

// Empty: the links have no end.
std::optional<FilePlace> place_of(const std::filesystem::path& path);

// Whether two paths lead to one file: by device and inode where both exist (including both kinds of
// links), otherwise by the folder of the new file, also by device and inode (a folder that is
// mounted at two places is one), and its name. "-" is standard output. The null device
// is never the same file, because its output is discarded on purpose.
bool same_file(const std::filesystem::path& one, const std::filesystem::path& other);

// The ending of a file's name with its point, in small letters (of A to Z): ".csv".
std::string file_ending(const std::filesystem::path& path);

// Whether a file's ending is one of these; "" among them: it may have none. Errors:
// output_format_unknown, with what can be written.
Status check_ending(const std::filesystem::path& path,
                    std::initializer_list<std::string_view> endings);

// A file that is read; `taken` says so of an output that leads there, e.g. "it is the recording
// itself".
struct InputPath {
    std::string path;
    MessageArg taken;
};

// Adds a recording and its further files: they are read as it is.
void add_recording_files(std::vector<InputPath>& inputs, const std::filesystem::path& recording,
                         const OpenOptions& open);

// A file that is written, "-" for standard output; empty: not asked for.
struct OutputPath {
    std::string option;
    std::string path;
    MessageArg taken;  // of a later output that leads here, e.g. "the result goes there already"
};

// An output replaces neither an input nor another output, whatever their paths are called. Errors:
// setting_invalid.
Status check_outputs(const std::vector<OutputPath>& outputs, const std::vector<InputPath>& inputs);

}  // namespace vybeg
