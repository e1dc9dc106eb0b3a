#pragma once

#include "core/base/job_control.h"
#include "core/base/result.h"
#include "core/recording/bytes/file_bytes.h"
#include "core/recording/samples/open_options.h"
#include "core/recording/samples/recording.h"

#include <cstdint>
#include <filesystem>
#include <memory>
#include <span>
#include <string>
#include <string_view>

namespace vybeg {

// A format that a file is recognised as by its content, never by its name; but for ZETLAB's samples
// alone, whose content lies in the file beside them.
struct FileFormat {
    enum class Group : std::uint8_t { audio, tables, arrays };

    std::string_view name;     // also of its sound files in tests/fuzz/seeds.cpp
    Group group;               // in a dialog that opens files
    std::string_view endings;  // of the names that its files usually have, with blanks between them
    // By the first bytes (file_head()). A format is asked after those above it.
    bool (*is)(std::string_view head, const FileBytes& file);
    Result<Recording> (*open)(std::shared_ptr<const FileBytes> file, const OpenOptions& options,
                              const JobControl& job);
    bool has_variables = false;  // with names, for --variables
    bool in_helper = false;      // read by vybeg-reader

    bool is_text() const { return group == Group::tables; }
};

std::span<const FileFormat> file_formats();

// First bytes of a file. Errors: file_read_failed.
Result<std::string> file_head(const FileBytes& file);

// The format of a file with this head; null where it has none.
const FileFormat* find_format(std::string_view head, const FileBytes& file);

// Opens a recording by its content, never by its name. Texts from the file are converted by
// plain_text(). Text files are read completely (progress and cancellation through `job`); samples
// are read on demand. Errors: every ErrorCode of the input group, setting_invalid, interrupted.
Result<Recording> open_recording(const std::filesystem::path& path, const OpenOptions& options,
                                 const JobControl& job);

}  // namespace vybeg
