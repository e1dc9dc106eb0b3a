#include "core/recording/bytes/zip_directory.h"

#include "core/base/message_arg.h"
#include "core/recording/bytes/byte_order.h"
#include "core/recording/bytes/inflated_part.h"

#include <algorithm>
#include <cerrno>
#include <limits>
#include <optional>
#include <span>
#include <sys/mman.h>
#include <unistd.h>
#include <utility>

namespace vybeg {
namespace {

using namespace std::string_view_literals;

// Signatures and least sizes of the records.
constexpr std::string_view end_signature = "PK\x05\x06"sv;
constexpr std::int64_t end_size = 22;
constexpr std::string_view locator64_signature = "PK\x06\x07"sv;
constexpr std::int64_t locator64_size = 20;
constexpr std::string_view end64_signature = "PK\x06\x06"sv;
constexpr std::int64_t end64_size = 56;
constexpr std::string_view entry_signature = "PK\x01\x02"sv;
constexpr std::size_t entry_size = 46;
constexpr std::string_view local_signature = "PK\x03\x04"sv;
constexpr std::int64_t local_size = 30;

constexpr std::size_t most_members = 10000;
constexpr std::int64_t longest_comment = 65535;
constexpr std::uint16_t zip64_extra = 1;
constexpr std::uint32_t in_extra = 0xFFFFFFFF;  // the number is in the ZIP64 extra field
constexpr std::int64_t best_ratio = 1032;       // that deflate can pack

template <class Number>
Number number_at(std::string_view bytes, std::size_t at) {
    return load<Number>(bytes.data() + at, false);
}

// A 64 bit length or position; -1 beyond the largest file size.
std::int64_t length_at(std::string_view bytes, std::size_t at) {
    const auto number = number_at<std::uint64_t>(bytes, at);
    constexpr std::uint64_t most = std::numeric_limits<std::int64_t>::max() / 2;
    return number > most ? -1 : static_cast<std::int64_t>(number);
}

struct Directory {
    std::int64_t offset = 0;
    std::int64_t size = 0;
};

// Position of the directory of a ZIP64 archive; empty for other archives.
Result<std::optional<Directory>> find_directory64(const FileBytes& file, std::int64_t end_offset) {
    if (end_offset < locator64_size) {
        return std::optional<Directory>{};
    }
    const auto locator = TRY(file.text(end_offset - locator64_size, locator64_size));
    if (!locator.starts_with(locator64_signature)) {
        return std::optional<Directory>{};
    }
    const std::int64_t at = length_at(locator, 8);
    if (at < 0 || at > file.size() - end64_size) {
        return file.damaged("ZIP", VYBEG_MESSAGE("Words", "its directory lies outside of it"));
    }
    const auto end = TRY(file.text(at, end64_size));
    if (!end.starts_with(end64_signature)) {
        return file.damaged("ZIP", VYBEG_MESSAGE("Words", "its directory cannot be found"));
    }
    return std::optional(Directory{length_at(end, 48), length_at(end, 40)});
}

Result<Directory> find_directory(const FileBytes& file) {
    const std::int64_t tail_size = std::min(file.size(), end_size + longest_comment);
    const auto tail = TRY(file.text(file.size() - tail_size, tail_size));
    const std::size_t last = static_cast<std::size_t>(std::max(tail_size - end_size, {}));
    const std::size_t at = tail.rfind(end_signature, last);
    if (tail_size < end_size || at == tail.npos) {
        return file.damaged(
            "ZIP",
            VYBEG_MESSAGE("Words", "the directory at its end is missing; the file was cut off"));
    }
    const std::int64_t end_offset = file.size() - tail_size + static_cast<std::int64_t>(at);
    const auto found = TRY(find_directory64(file, end_offset));
    const Directory directory = found ? *found
                                      : Directory{number_at<std::uint32_t>(tail, at + 16),
                                                  number_at<std::uint32_t>(tail, at + 12)};
    if (directory.offset < 0 || directory.size < 0 || directory.offset > file.size() ||
        directory.size > file.size() - directory.offset) {
        return file.damaged("ZIP", VYBEG_MESSAGE("Words", "its directory lies outside of it"));
    }
    return directory;
}

// Reads the numbers beyond 32 bits from the extra field, in this order. False if they are missing.
bool take_extra(std::string_view extra, ZipMember& member) {
    while (extra.size() >= 4) {
        const auto id = number_at<std::uint16_t>(extra, 0);
        const std::size_t size = number_at<std::uint16_t>(extra, 2);
        std::string_view field = extra.substr(4, size);
        if (field.size() < size) {
            return false;
        }
        extra.remove_prefix(4 + size);
        if (id != zip64_extra) {
            continue;
        }
        for (std::int64_t* value : {&member.size, &member.packed_size, &member.header_offset}) {
            if (*value == in_extra) {
                if (field.size() < 8) {
                    return false;
                }
                *value = length_at(field, 0);
                field.remove_prefix(8);
            }
        }
        return true;
    }
    return true;
}

}  // namespace

bool is_zip(std::string_view head) {
    return head.starts_with(local_signature);
}

Result<std::vector<ZipMember>> zip_members(const FileBytes& file) {
    const auto directory = TRY(find_directory(file));
    const auto bytes = TRY(file.text(directory.offset, directory.size));
    std::vector<ZipMember> members;
    for (std::string_view rest = bytes; rest.starts_with(entry_signature);) {
        if (rest.size() < entry_size) {
            return file.damaged("ZIP",
                                VYBEG_MESSAGE("Words", "its directory ends within an entry"));
        }
        const std::size_t name_size = number_at<std::uint16_t>(rest, 28);
        const std::size_t extra_size = number_at<std::uint16_t>(rest, 30);
        const std::size_t comment_size = number_at<std::uint16_t>(rest, 32);
        const std::size_t size = entry_size + name_size + extra_size + comment_size;
        if (rest.size() < size) {
            return file.damaged("ZIP",
                                VYBEG_MESSAGE("Words", "its directory ends within an entry"));
        }
        ZipMember member;
        member.name = rest.substr(entry_size, name_size);
        member.encrypted = (number_at<std::uint16_t>(rest, 8) & 1) != 0;
        member.method = number_at<std::uint16_t>(rest, 10);
        member.crc32 = number_at<std::uint32_t>(rest, 16);
        member.packed_size = number_at<std::uint32_t>(rest, 20);
        member.size = number_at<std::uint32_t>(rest, 24);
        member.header_offset = number_at<std::uint32_t>(rest, 42);
        if (!take_extra(rest.substr(entry_size + name_size, extra_size), member)) {
            return file.damaged("ZIP",
                                VYBEG_MESSAGE("Words", "an entry of its directory is incomplete"));
        }
        if (members.size() == most_members) {
            return too_many_parts(file.path().string(), "ZIP",
                                  VYBEG_MESSAGE("Words", "it has more than %1 members"),
                                  most_members);
        }
        if (!member.name.ends_with('/')) {
            members.push_back(std::move(member));
        }
        rest.remove_prefix(size);
    }
    return members;
}

Result<std::shared_ptr<const ByteSource>> zip_content(std::shared_ptr<const FileBytes> file,
                                                      const ZipMember& member) {
    constexpr int stored = 0;
    constexpr int deflated = 8;
    if (member.encrypted) {
        return file->unsupported("ZIP", VYBEG_MESSAGE("Words", "encrypted members"));
    }
    if (member.method != stored && member.method != deflated) {
        return file->unsupported("ZIP", VYBEG_MESSAGE("Words", "members packed by method %1"),
                                 {count_arg(member.method)});
    }
    const auto outside = [&] {
        return file->damaged("ZIP", VYBEG_MESSAGE("Words", "%1 lies outside of it"), {member.name});
    };
    if (member.header_offset < 0 || member.header_offset > file->size() - local_size) {
        return outside();
    }
    const auto header = TRY(file->text(member.header_offset, local_size));
    if (static_cast<std::int64_t>(header.size()) < local_size ||
        !header.starts_with(local_signature)) {
        return file->damaged("ZIP", VYBEG_MESSAGE("Words", "%1 is not where its directory says"),
                             {member.name});
    }
    const std::int64_t offset = member.header_offset + local_size +
                                number_at<std::uint16_t>(header, 26) +
                                number_at<std::uint16_t>(header, 28);
    if (offset > file->size() || member.packed_size < 0 ||
        member.packed_size > file->size() - offset) {
        return outside();
    }
    if (member.method == stored) {
        return file_part(file, offset, member.packed_size);
    }
    if (member.size < 0 || member.size / best_ratio > member.packed_size) {
        return file->damaged("ZIP",
                             VYBEG_MESSAGE("Words", "%1 cannot be as long as its directory says"),
                             {member.name});
    }
    return inflated_part(
        file, {offset, member.packed_size, member.size, member.crc32, "NPZ", member.name});
}

Result<std::shared_ptr<const FileBytes>> zip_file(std::shared_ptr<const FileBytes> file,
                                                  const ZipMember& member) {
    const auto content = TRY(zip_content(file, member));
    const int copy = ::memfd_create("member", MFD_CLOEXEC);
    std::vector<char> block(std::size_t{1} << 20);
    for (std::int64_t at = 0; copy >= 0 && at < content->size();) {
        const auto part = std::span(block).first(static_cast<std::size_t>(
            std::min<std::int64_t>(static_cast<std::int64_t>(block.size()), content->size() - at)));
        if (const Status got = content->read(at, part); !got) {
            ::close(copy);
            return got.error();
        }
        const ssize_t put = ::write(copy, part.data(), part.size());
        if (put < 0) {
            const int failed = errno;
            ::close(copy);
            return file->error(ErrorCode::file_read_failed, {system_reason(failed)});
        }
        at += put;
    }
    return FileBytes::adopt(file->path(), copy);
}

}  // namespace vybeg
