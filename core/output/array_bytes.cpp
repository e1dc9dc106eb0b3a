#include "core/output/array_bytes.h"

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

}  // namespace vybeg
