#include "core/output/array_files.h"

#include "core/base/plain_text.h"
#include "core/recording/variables/mat_file.h"

namespace vybeg {
namespace {

void append_tag(std::string& bytes, mat5::ElementType type, std::size_t size) {
    append_bytes(bytes, static_cast<std::uint32_t>(type), static_cast<std::uint32_t>(size));
}

void append_text(std::string& bytes, mat5::ElementType type, const std::string& text) {
    append_tag(bytes, type, text.size());
    bytes += text;
    bytes.append((8 - text.size() % 8) % 8, '\0');
}

// Class, size and name of an array whose content takes `content` bytes.
std::string array_head(mat5::ArrayClass kind, const std::string& name, std::int64_t rows,
                       std::int64_t columns, std::size_t content) {
    std::string head;
    append_tag(head, mat5::uint32, 8);
    append_bytes(head, static_cast<std::uint32_t>(kind), std::uint32_t{0});
    append_tag(head, mat5::int32, 8);
    append_bytes(head, static_cast<std::int32_t>(rows), static_cast<std::int32_t>(columns));
    append_text(head, mat5::int8, name);
    std::string tag;
    append_tag(tag, mat5::matrix, head.size() + content);
    return tag + head;
}

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

std::string npy_head(std::string_view type, std::string_view shape) {
    std::string dictionary = "{'descr': '";
    dictionary.append(type).append("', 'fortran_order': False, 'shape': (");
    dictionary.append(shape).append("), }");
    // Magic (6), version (2), length (2), dictionary and line feed fill a multiple of 64 bytes.
    dictionary.append(63 - (10 + dictionary.size()) % 64, ' ');
    dictionary += '\n';
    std::string head = "\x93NUMPY";
    head += std::string_view("\x01\x00", 2);
    append_bytes(head, static_cast<std::uint16_t>(dictionary.size()));
    return head + dictionary;
}

std::string mat_file_head() {
    std::string head = "MATLAB 5.0 MAT-file, vybeg";
    head.resize(124, ' ');
    append_bytes(head, std::uint16_t{0x0100});
    return head + "IM";
}

std::string mat_column_head(const std::string& name, std::int64_t rows) {
    const std::size_t bytes = static_cast<std::size_t>(rows) * sizeof(double);
    std::string head = array_head(mat5::double_class, name, rows, 1, mat5::tag_bytes + bytes);
    append_tag(head, mat5::float64, bytes);
    return head;
}

std::string mat_cells_head(const std::string& name, std::int64_t rows, std::int64_t bytes) {
    return array_head(mat5::cell_class, name, rows, 1, static_cast<std::size_t>(bytes));
}

std::string mat_text_cell(const std::string& text) {
    std::string content;
    append_text(content, mat5::utf8, text);
    const auto length = static_cast<std::int64_t>(code_points(text).size());
    return array_head(mat5::char_class, "", length == 0 ? 0 : 1, length, content.size()) + content;
}

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
        // After the disk: internal and external attributes.
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
