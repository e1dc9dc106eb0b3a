#include "core/recording/mat_hdf5/mat_packed.h"

#include "core/recording/bytes/byte_order.h"
#include "core/recording/bytes/inflated_part.h"
#include "core/recording/mat_hdf5/mat_tag.h"

#include <algorithm>
#include <array>
#include <optional>
#include <string_view>
#include <utility>

namespace vybeg {

using namespace mat5;

namespace {

constexpr std::int64_t zlib_head_bytes = 2;  // before what is deflated, and four behind it
constexpr std::int64_t zlib_bytes = zlib_head_bytes + 4;
constexpr std::int64_t best_ratio = 1032;  // that deflate can pack
constexpr std::int64_t longest_name = 4096;

std::optional<NumberType> number_type(std::uint32_t code) {
    switch (code) {
        case 1: return NumberType::i8;
        case 2: return NumberType::u8;
        case 3: return NumberType::i16;
        case 4: return NumberType::u16;
        case 5: return NumberType::i32;
        case 6: return NumberType::u32;
        case 7: return NumberType::f32;
        case 9: return NumberType::f64;
        case 12: return NumberType::i64;
        case 13: return NumberType::u64;
        default: return std::nullopt;
    }
}

// The elements of one unpacked variable. What lies behind the end, or cannot be unpacked, is
// nothing.
class Elements {
public:
    Elements(const ByteSource& bytes, bool big_endian) : bytes_(bytes), big_endian_(big_endian) {}

    std::optional<Element> at(std::int64_t place) const {
        const std::string tag = text(place, tag_bytes);
        if (tag.empty()) {
            return {};
        }
        const Element element = element_of(tag, place, big_endian_);
        const bool inside = element.size <= bytes_.size() - element.data;
        return inside ? std::optional(element) : std::nullopt;
    }

    // Empty where there are not so many bytes.
    std::string text(std::int64_t place, std::int64_t size) const {
        if (place < 0 || size > longest_name || size > bytes_.size() - place) {
            return {};
        }
        std::string bytes(static_cast<std::size_t>(size), '\0');
        return bytes_.read(place, bytes) ? bytes : std::string{};
    }

    std::uint32_t number(std::int64_t place) const {
        const std::string bytes = text(place, sizeof(std::uint32_t));
        return bytes.empty() ? 0 : load<std::uint32_t>(bytes.data(), big_endian_);
    }

private:
    const ByteSource& bytes_;
    bool big_endian_;
};

// The head of a matrix: what stands before its numbers or fields.
struct Matrix {
    std::uint32_t kind = 0;
    std::string name;
    std::int64_t content = 0;
};

std::optional<Matrix> matrix_at(const Elements& elements, std::int64_t place) {
    const auto matrix = elements.at(place);
    if (!matrix || matrix->type != matrix_type) {
        return {};
    }
    const auto flags = elements.at(matrix->data);
    const auto size = flags ? elements.at(flags->next) : std::nullopt;
    const auto name = size ? elements.at(size->next) : std::nullopt;
    if (!name) {
        return {};
    }
    return Matrix{elements.number(flags->data) & 0xFF, elements.text(name->data, name->size),
                  name->next};
}

// Where the field of a struct begins.
std::optional<std::int64_t> field_at(const Elements& elements, const Matrix& matrix,
                                     std::string_view field) {
    const auto length = elements.at(matrix.content);
    const auto names = length ? elements.at(length->next) : std::nullopt;
    const std::int64_t width = length ? elements.number(length->data) : 0;
    if (!names || matrix.kind != struct_class || width == 0) {
        return {};
    }
    std::int64_t place = names->next;
    for (std::int64_t i = 0; i < names->size / width; ++i) {
        const std::string padded = elements.text(names->data + i * width, width);
        if (std::string_view(padded).substr(0, padded.find('\0')) == field) {
            return place;
        }
        const auto passed = elements.at(place);
        if (!passed) {
            return {};
        }
        place = passed->next;
    }
    return {};
}

}  // namespace

Result<PackedVariables> PackedVariables::open(const std::string& path) {
    const auto file = FileBytes::open(path);
    if (!file) {
        return file.error();
    }
    PackedVariables packed;
    packed.file_ = *file;
    const auto whole = file_part(*file, 0, (*file)->size());
    const Elements ends(*whole, false);
    packed.big_endian_ = ends.text(header_bytes - 2, 1) == "M";
    const Elements elements(*whole, packed.big_endian_);
    for (std::int64_t at = header_bytes;;) {
        const auto element = elements.at(at);
        if (!element) {
            return packed;
        }
        if (element->type == compressed_type) {
            if (auto variable = packed.variable_at(element->data, element->size)) {
                packed.variables_.push_back(std::move(*variable));
            }
        }
        at = element->next;
    }
}

std::shared_ptr<const ByteSource> PackedVariables::unpacked(const Variable& variable) const {
    return inflated_part(file_, {variable.offset, variable.packed_size, variable.size, std::nullopt,
                                 "MAT 5", variable.name});
}

// Nothing where no array is packed there.
std::optional<PackedVariables::Variable> PackedVariables::variable_at(std::int64_t offset,
                                                                      std::int64_t size) const {
    Variable variable{"", offset + zlib_head_bytes, size - zlib_bytes, tag_bytes};
    if (variable.packed_size <= 0) {
        return {};
    }
    // Its own tag says how long it is.
    std::array<char, tag_bytes> tag{};
    if (!unpacked(variable)->read(0, tag)) {
        return {};
    }
    variable.size += load<std::uint32_t>(tag.data() + 4, big_endian_);
    if (variable.size / best_ratio > variable.packed_size) {
        return {};
    }
    const auto bytes = unpacked(variable);
    const auto matrix = matrix_at(Elements(*bytes, big_endian_), 0);
    if (!matrix) {
        return {};
    }
    variable.name = matrix->name;
    return variable;
}

Result<PackedArray> PackedVariables::find(const std::string& name) const {
    const auto damaged = [&] {
        return Error{ErrorCode::format_damaged, "", {"MAT 5", name + " cannot be unpacked"}};
    };
    std::string_view rest = name;
    const auto take_name = [&rest] {
        const std::string_view first = rest.substr(0, rest.find('.'));
        rest.remove_prefix(std::min(first.size() + 1, rest.size()));
        return first;
    };
    const auto variable =
        std::find_if(variables_.begin(), variables_.end(),
                     [first = take_name()](const Variable& v) { return v.name == first; });
    if (variable == variables_.end()) {
        return damaged();
    }
    PackedArray array{unpacked(*variable), NumberType::f64, big_endian_, 0, 0};
    const Elements elements(*array.bytes, big_endian_);
    auto matrix = matrix_at(elements, 0);
    while (matrix && !rest.empty()) {
        const auto field = field_at(elements, *matrix, take_name());
        matrix = field ? matrix_at(elements, *field) : std::nullopt;
    }
    const auto numbers = matrix ? elements.at(matrix->content) : std::nullopt;
    const auto type = numbers ? number_type(numbers->type) : std::nullopt;
    if (!type) {
        return damaged();
    }
    array.type = *type;
    array.offset = numbers->data;
    array.count = numbers->size / bytes_of(*type);
    return array;
}

}  // namespace vybeg
