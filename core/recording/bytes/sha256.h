#pragma once

#include "core/base/job_control.h"
#include "core/base/result.h"
#include "core/recording/bytes/file_bytes.h"

#include <filesystem>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace vybeg {

// Lower-case hexadecimal SHA-256 of a file's bytes.
Result<std::string> file_sha256(const std::filesystem::path& path, const JobControl& job);

// The same of the bytes of open files, one or more, one after the other, independent of their
// paths.
Result<std::string> files_sha256(std::span<const FileBytes* const> files, const JobControl& job);

// The same of a text.
Result<std::string> text_sha256(std::string_view text);

// Adds parts to a text that is hashed, each with its length before it: no two lists of parts give
// the same text.
void add_parts(std::string& text, const std::vector<std::string>& parts);

// Loads what OpenSSL loads on first use. Call it before parallel hashing, because loading in one
// thread while another runs out of memory may terminate the program.
void prepare_sha256();

}  // namespace vybeg
