#pragma once

#include "core/base/result.h"
#include "core/recording/bytes/file_bytes.h"

#include <string>
#include <string_view>

namespace vybeg {

enum class FileKind { audio, npy, npz, tdms, mat_or_hdf5, uff, text, unknown };

// First bytes of a file, which determine its kind. Errors: file_read_failed.
Result<std::string> file_head(const FileBytes& file);

// Kind of a file by its content, never by its name; `mat_or_hdf5`: told apart later.
FileKind file_kind(std::string_view head, const FileBytes& file);

}  // namespace vybeg
