#include "core/output/stored_zip.h"

#include "core/output/array_bytes.h"

namespace vybeg {
namespace {

constexpr std::uint16_t plain_version = 20;
constexpr std::uint16_t zip64_version = 45;
constexpr std::uint16_t names_are_utf8 = 1 << 11;
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
        append_bytes(numbers, member.size);
        append_bytes(numbers, member.size);
    }
    if (with_place && member.place > most_) {
        append_bytes(numbers, member.place);
    }
    std::string bytes;
    if (!numbers.empty()) {
        append_bytes(bytes, std::uint16_t{1});
        append_bytes(bytes, static_cast<std::uint16_t>(numbers.size()));
    }
    return bytes + numbers;
}

std::string StoredZip::common_fields(const Member& member, std::uint16_t extra_bytes) const {
    std::string bytes;
    append_bytes(bytes, extra_bytes > 0 ? zip64_version : plain_version);
    append_bytes(bytes, names_are_utf8);
    append_bytes(bytes, std::uint16_t{0});  // stored
    append_bytes(bytes, std::uint16_t{0});  // time
    append_bytes(bytes, first_of_1980);
    append_bytes(bytes, member.crc);
    append_bytes(bytes, field(member.size));
    append_bytes(bytes, field(member.size));
    append_bytes(bytes, static_cast<std::uint16_t>(member.name.size()));
    append_bytes(bytes, extra_bytes);
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
        append_bytes(directory, std::uint16_t{0});  // comment
        append_bytes(directory, std::uint16_t{0});  // disk
        append_bytes(directory, std::uint16_t{0});  // internal and
        append_bytes(directory, std::uint32_t{0});  // external attributes
        append_bytes(directory, field(member.place));
        directory += member.name + more;
    }
    const bool large = at_ > most_ || directory.size() > most_;
    std::string end;
    if (large) {
        end += "PK\x06\x06";
        append_bytes(end, std::uint64_t{44});  // bytes behind this number
        append_bytes(end, zip64_version);
        append_bytes(end, zip64_version);
        append_bytes(end, std::uint32_t{0});
        append_bytes(end, std::uint32_t{0});
        append_bytes(end, std::uint64_t{members_.size()});
        append_bytes(end, std::uint64_t{members_.size()});
        append_bytes(end, std::uint64_t{directory.size()});
        append_bytes(end, at_);
        end += "PK\x06\x07";
        append_bytes(end, std::uint32_t{0});
        append_bytes(end, at_ + directory.size());
        append_bytes(end, std::uint32_t{1});
    }
    const auto count = large ? in_end64 : static_cast<std::uint16_t>(members_.size());
    end += "PK\x05\x06";
    append_bytes(end, std::uint32_t{0});
    append_bytes(end, count);
    append_bytes(end, count);
    append_bytes(end, large ? in_extra : static_cast<std::uint32_t>(directory.size()));
    append_bytes(end, large ? in_extra : static_cast<std::uint32_t>(at_));
    append_bytes(end, std::uint16_t{0});
    return file_.write(directory + end);
}

}  // namespace vybeg
