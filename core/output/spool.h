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

    // Reads the next bytes in the order of writing. Preconditions: as many bytes are left; no more
    // writes.
    Status read(std::span<std::byte> to);

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
    std::int64_t read_ = 0;     // bytes
};

}  // namespace vybeg
