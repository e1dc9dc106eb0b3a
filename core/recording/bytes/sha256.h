#pragma once

#include "core/base/job_control.h"
#include "core/base/result.h"
#include "core/recording/bytes/file_bytes.h"

#include <filesystem>
#include <string>

namespace vybeg {

// Lower-case hexadecimal SHA-256 of a file's bytes.
Result<std::string> file_sha256(const std::filesystem::path& path, const JobControl& job);

// The same of an open file, which its path need not name any more.
Result<std::string> file_sha256(const FileBytes& file, const JobControl& job);

// Loads what OpenSSL loads when it is used first, so that a hash can be made beside other work: a
// thread that loads it while another one runs out of memory may end the program.
void prepare_sha256();

}  // namespace vybeg
