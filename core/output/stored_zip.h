#pragma once

#include "core/output/output_file.h"

#include <cstdint>
#include <string>
#include <vector>

namespace vybeg {

// Writes a ZIP archive whose members are not packed, with the ZIP64 fields where a member, its
// place or the archive is beyond 32 bits. Members have no time of day, so that equal content makes
// equal files. Errors: output_failed, interrupted.
class StoredZip {
public:
    // `file` must outlive it. `most_of_32_bits`: the largest number that needs no ZIP64 field;
    // tests lower it.
    explicit StoredZip(OutputFile& file, std::uint64_t most_of_32_bits = 0xFFFFFFFE)
        : file_(file), most_(most_of_32_bits) {}

    // Begins a member; then the caller writes its `size` bytes into the file. `crc`: theirs, as
    // zlib computes it.
    Status begin(const std::string& name, std::uint64_t size, std::uint32_t crc);
    // Writes the directory.
    Status finish();

private:
    struct Member {
        std::string name;
        std::uint64_t size = 0;
        std::uint64_t place = 0;
        std::uint32_t crc = 0;
    };
    std::uint32_t field(std::uint64_t number) const;
    // The fields that local headers and the directory share, from the version to the length of the
    // name; `extra`: what the ZIP64 fields hold.
    std::string common_fields(const Member& member, std::uint16_t extra_bytes) const;
    std::string extra(const Member& member, bool with_place) const;

    OutputFile& file_;
    std::uint64_t most_;
    std::vector<Member> members_;
    std::uint64_t at_ = 0;  // bytes written, with those of the member that was begun
};

}  // namespace vybeg
