#pragma once

#include "core/output/output_file.h"

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <span>
#include <string>
#include <string_view>

namespace vybeg {

// Bytes that wait until what comes before them in an output is known: a few MiB in memory, the rest
// in a file without a name, which the system removes whatever becomes of the program. Every write
// hears the stop token. Errors: output_failed, interrupted.
class Spool {
public:
    // For what goes to `output`, which must outlive the spool; its file is made in
    // output.spool_folder().
    Spool(const OutputFile& output, const JobControl& job) : output_(output), job_(job) {}
    Spool(const Spool&) = delete;
    Spool& operator=(const Spool&) = delete;
    ~Spool();

    Status write(std::span<const std::byte> bytes);

    // The next bytes in the order in which they were written. Precondition: so many are left, and
    // nothing is written any more.
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
