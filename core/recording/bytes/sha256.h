#pragma once

#include "core/base/job_control.h"
#include "core/base/result.h"
#include "core/recording/bytes/file_bytes.h"

#include <filesystem>
#include <string>
#include <string_view>

namespace vybeg {

// Lower-case hexadecimal SHA-256 of a file's bytes.
Result<std::string> file_sha256(const std::filesystem::path& path, const JobControl& job);

// The same of an open file, independent of its path.
Result<std::string> file_sha256(const FileBytes& file, const JobControl& job);

// The same of a text.
Result<std::string> text_sha256(std::string_view text);

// Loads what OpenSSL loads on first use. Call it before parallel hashing, because loading in one
// thread while another runs out of memory may terminate the program.
void prepare_sha256();

}  // namespace vybeg
