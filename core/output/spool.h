#pragma once

#include "core/output/output_file.h"

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <span>
#include <string>
#include <string_view>

namespace vybeg {

// Bytes stored until the preceding part of an output is known: a few MiB in memory, the rest in an
// unnamed file, which the system removes in any case. Every write checks the stop token. Errors:
// output_failed, interrupted.
class Spool {
public:
    // Spool for `output`, which must outlive it, with its file in output.spool_folder().
    Spool(const OutputFile& output, const JobControl& job) : output_(output), job_(job) {}
    Spool(const Spool&) = delete;
    Spool& operator=(const Spool&) = delete;
    ~Spool();

    Status write(std::span<const std::byte> bytes);

    // Reads bytes from the position `from` on. Preconditions: as many were written; no more writes.
    Status read(std::int64_t from, std::span<std::byte> to) const;

private:
    Status spill();
    Status write_out(std::string_view bytes);
    Status create();
    Error failed(int error) const;

    const OutputFile& output_;
    JobControl job_;
    std::string memory_;
    int descriptor_ = -1;
    std::int64_t spilled_ = 0;  // bytes
};

}  // namespace vybeg
