#pragma once

#include "core/base/result.h"

#include <cstdint>
#include <filesystem>
#include <memory>
#include <span>
#include <string>

namespace vybeg {

// A regular file open for reading at any position, from several threads at once. A file replaced
// under the same path later does not affect it.
class FileBytes {
public:
    // Errors: file_missing, file_permission, file_is_directory, file_empty, file_read_failed.
    static Result<std::shared_ptr<const FileBytes>> open(const std::filesystem::path& path);

    FileBytes(const FileBytes&) = delete;
    FileBytes& operator=(const FileBytes&) = delete;
    ~FileBytes();

    const std::filesystem::path& path() const { return path_; }
    std::int64_t size() const { return size_; }  // bytes, at the time of opening
    // For another process; this object keeps ownership.
    int descriptor() const { return descriptor_; }

    // Checks that size and modification time are those at the time of opening. Errors:
    // file_changed, file_read_failed.
    Status unchanged() const;

    // An error about this file.
    Error error(ErrorCode code, std::vector<MessageArg> args = {}) const;

    // Fills `out` with the bytes from `offset` on and returns their number, which is smaller than
    // out.size() only at the end of the file. Errors: file_read_failed.
    Result<std::int64_t> read(std::int64_t offset, std::span<char> out) const;

private:
    // The time of the last change, s and ns.
    struct ChangeTime {
        std::int64_t s = 0;
        std::int64_t ns = 0;

        friend bool operator==(const ChangeTime&, const ChangeTime&) = default;
    };

    FileBytes(std::filesystem::path path, int descriptor, std::int64_t size, ChangeTime changed);

    std::filesystem::path path_;
    int descriptor_;
    std::int64_t size_;
    ChangeTime changed_;
};

}  // namespace vybeg
