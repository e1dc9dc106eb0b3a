#include "core/output/stored_zip.h"

#include "core/output/array_bytes.h"

namespace vybeg {
namespace {

constexpr std::uint16_t plain_version = 20;
constexpr std::uint16_t zip64_version = 45;
constexpr std::uint16_t names_are_utf8 = 1 << 11;
constexpr std::uint16_t stored = 0;
constexpr std::uint16_t no_time = 0;
constexpr std::uint16_t no_comment = 0;
constexpr std::uint16_t one_disk = 0;
constexpr std::uint16_t first_of_1980 = (1 << 5) | 1;  // the earliest date there is
constexpr std::uint32_t in_extra = 0xFFFFFFFF;         // the number is in the ZIP64 field
constexpr std::uint16_t in_end64 = 0xFFFF;

}  // namespace

std::uint32_t StoredZip::field(std::uint64_t number) const {
    return number > most_ ? in_extra : static_cast<std::uint32_t>(number);
}

// The ZIP64 field: the numbers that have no room elsewhere; in a local header both sizes.
std::string StoredZip::extra(const Member& member, bool with_place) const {
    std::string numbers;
    if (member.size > most_) {
        append_bytes(numbers, member.size, member.size);
    }
    if (with_place && member.place > most_) {
        append_bytes(numbers, member.place);
    }
    std::string bytes;
    if (!numbers.empty()) {
        append_bytes(bytes, std::uint16_t{1}, static_cast<std::uint16_t>(numbers.size()));
    }
    return bytes + numbers;
}

std::string StoredZip::common_fields(const Member& member, std::uint16_t extra_bytes) const {
    std::string bytes;
    append_bytes(bytes, extra_bytes > 0 ? zip64_version : plain_version, names_are_utf8, stored,
                 no_time, first_of_1980, member.crc, field(member.size), field(member.size),
                 static_cast<std::uint16_t>(member.name.size()), extra_bytes);
    return bytes;
}

Status StoredZip::begin(const std::string& name, std::uint64_t size, std::uint32_t crc) {
    const Member member{name, size, at_, crc};
    const std::string more = extra(member, false);
    const std::string head =
        "PK\x03\x04" + common_fields(member, static_cast<std::uint16_t>(more.size())) + name + more;
    members_.push_back(member);
    at_ += head.size() + size;
    return file_.write(head);
}

Status StoredZip::finish() {
    std::string directory;
    for (const Member& member : members_) {
        const std::string more = extra(member, true);
        directory += "PK\x01\x02";
        append_bytes(directory, zip64_version);  // of the writer
        directory += common_fields(member, static_cast<std::uint16_t>(more.size()));
        // Behind the disk: internal and external attributes.
        append_bytes(directory, no_comment, one_disk, std::uint16_t{0}, std::uint32_t{0},
                     field(member.place));
        directory += member.name + more;
    }
    const bool large = at_ > most_ || directory.size() > most_;
    std::string end;
    if (large) {
        end += "PK\x06\x06";
        constexpr std::uint64_t bytes_behind = 44;
        const std::uint64_t members = members_.size();
        append_bytes(end, bytes_behind, zip64_version, zip64_version, std::uint32_t{0},
                     std::uint32_t{0}, members, members, std::uint64_t{directory.size()}, at_);
        end += "PK\x06\x07";
        append_bytes(end, std::uint32_t{0}, std::uint64_t{at_ + directory.size()},
                     std::uint32_t{1});
    }
    const auto count = large ? in_end64 : static_cast<std::uint16_t>(members_.size());
    end += "PK\x05\x06";
    append_bytes(end, std::uint32_t{0}, count, count,
                 large ? in_extra : static_cast<std::uint32_t>(directory.size()),
                 large ? in_extra : static_cast<std::uint32_t>(at_), no_comment);
    return file_.write(directory + end);
}

}  // namespace vybeg
