#pragma once

#include "core/base/result.h"
#include "core/recording/bytes/file_bytes.h"

#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <string_view>

namespace vybeg {

// The lines of a Universal File one after the other, without their ends (LF, CRLF, CR). What is
// binary between them is skipped by its length. Holds one chunk of the file in memory.
class UffLines {
public:
    explicit UffLines(std::shared_ptr<const FileBytes> file) : file_(std::move(file)) {}

    // The next line, valid until the next call; nothing after the last one. Errors:
    // file_read_failed; format_limit where a line is longer than 1 MiB.
    Result<std::optional<std::string_view>> next();

    // Precondition: `bytes` is not negative.
    void skip(std::int64_t bytes);

    std::int64_t number() const { return number_; }  // of the line last returned, from 1
    bool ended() const { return ended_; }            // whether that line had a line end
    // Of what follows that line, bytes from the start of the file.
    std::int64_t position() const { return offset_ - static_cast<std::int64_t>(rest().size()); }

private:
    std::string_view rest() const { return std::string_view(buffer_).substr(begin_); }
    Result<bool> fill();

    std::shared_ptr<const FileBytes> file_;
    std::string buffer_;  // bytes before offset_; from begin_ on they are not yet returned
    std::size_t begin_ = 0;
    std::int64_t offset_ = 0;  // in the file
    std::int64_t number_ = 0;
    bool ended_ = true;
};

}  // namespace vybeg
