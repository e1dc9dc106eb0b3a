#pragma once

#include "core/base/result.h"

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <memory>
#include <span>
#include <string>
#include <sys/stat.h>
#include <utility>

namespace vybeg {

// A descriptor that is closed with its object; below 0: none.
class Descriptor {
public:
    explicit Descriptor(int number = -1) : number_(number) {}
    Descriptor(Descriptor&& other) noexcept : number_(std::exchange(other.number_, -1)) {}
    Descriptor& operator=(Descriptor&& other) noexcept {
        std::swap(number_, other.number_);
        return *this;
    }
    ~Descriptor() { close(); }

    // At once, with the result of the system; 0 where there is none.
    int close();
    explicit operator bool() const { return number_ >= 0; }
    int get() const { return number_; }

private:
    int number_;
};

// Fills `out` with a file's bytes from `offset` on. Returns their number, smaller than out.size()
// only at the end of the file, or -1 after an error, whose number is errno.
std::int64_t read_at(int descriptor, std::int64_t offset, std::span<char> out);

// A regular file open for reading at any position, from several threads at once. A file replaced
// under the same path later does not affect it.
class FileBytes {
public:
    // Errors: file_missing, file_permission, file_is_directory, file_empty, file_read_failed.
    static Result<std::shared_ptr<const FileBytes>> open(const std::filesystem::path& path);

    // The same for a descriptor that is open for reading, and is closed with the object.
    static Result<std::shared_ptr<const FileBytes>> adopt(const std::filesystem::path& path,
                                                          Descriptor descriptor);

    const std::filesystem::path& path() const { return path_; }
    std::int64_t size() const { return status_.st_size; }  // bytes, at the time of opening
    // For another process; this object keeps ownership.
    int descriptor() const { return descriptor_.get(); }

    // Checks that size and times of the last change are those at the time of opening: that of the
    // bytes, which a program can put back, and that of the inode, unless names or rights changed.
    // Errors: file_changed, file_read_failed.
    Status unchanged() const;

    // An error about this file.
    Error error(ErrorCode code, std::vector<MessageArg> args = {}) const;

    // format_damaged and format_unsupported: what of a format, with %1, ... for `args`.
    Error damaged(const std::string& format, const char* text,
                  std::vector<MessageArg> args = {}) const;
    Error unsupported(const std::string& format, const char* text,
                      std::vector<MessageArg> args = {}) const;

    // Fills `out` with the bytes from `offset` on and returns their number, which is smaller than
    // out.size() only at the end of the file. Errors: file_read_failed.
    Result<std::int64_t> read(std::int64_t offset, std::span<char> out) const;

    // The `size` bytes from `offset` on, fewer at the end of the file. Errors: file_read_failed.
    Result<std::string> text(std::int64_t offset, std::int64_t size) const;

private:
    FileBytes(std::filesystem::path path, Descriptor descriptor, const struct stat& status);

    std::filesystem::path path_;
    Descriptor descriptor_;
    struct stat status_;
};

// All bytes of a file that the program itself has written: a session, a passport. Errors: those of
// FileBytes; file_read_failed for more than 64 MiB.
Result<std::string> own_file_text(const std::filesystem::path& path);

// The error of a file that has more parts than are read. `text`: which, %1 for their greatest
// number.
Error too_many_parts(const std::string& where, const std::string& format, const char* text,
                     std::size_t most);

// Bytes with random access: part of a file, or unpacked from it. Immutable; may be read from
// several threads at once.
class ByteSource {
public:
    ByteSource() = default;
    ByteSource(const ByteSource&) = delete;
    ByteSource& operator=(const ByteSource&) = delete;
    virtual ~ByteSource() = default;

    virtual std::int64_t size() const = 0;

    // Whether bytes can be read without reading those before them.
    virtual bool seeks() const { return true; }

    // Fills `out` with the bytes from `offset` on. Precondition: they lie in [0, size()). Errors:
    // file_read_failed, format_damaged.
    virtual Status read(std::int64_t offset, std::span<char> out) const = 0;
};

// The bytes [offset, offset + size) of a file. Precondition: the file has them.
std::shared_ptr<const ByteSource> file_part(std::shared_ptr<const FileBytes> file,
                                            std::int64_t offset, std::int64_t size);

}  // namespace vybeg
