#include "core/recording/variables/mat_file.h"

#include "core/base/plain_text.h"
#include "core/recording/bytes/packed_parts.h"
#include "core/recording/samples/reader_rules.h"
#include "core/recording/samples/text_fields.h"
#include "core/recording/samples/vocabulary.h"
#include "core/recording/variables/array_variables.h"

#include <algorithm>
#include <array>
#include <map>
#include <optional>
#include <string>
#include <utility>

namespace vybeg {
namespace {

constexpr std::int64_t most_name_bytes = 256;
constexpr std::array<NumberType, 6> types_by_precision{NumberType::f64, NumberType::f32,
                                                       NumberType::i32, NumberType::i16,
                                                       NumberType::u16, NumberType::u8};

// The header before every variable of a MAT file of level 4.
struct Mat4Header {
    std::int64_t rows = 0;
    std::int64_t columns = 0;
    std::int64_t name_bytes = 0;  // with the zero at its end
    std::int64_t data_bytes = 0;
    NumberType type = NumberType::f64;  // as the numbers are stored
    bool big_endian = false;
    bool is_complex = false;
    bool is_full = false;  // an array of numbers; else a text or a sparse matrix
};

constexpr int mat4_header_bytes = 20;

bool is_name(std::string_view name) {
    return !name.empty() && is_letter(name.front()) &&
           std::all_of(name.begin(), name.end(),
                       [](char c) { return is_letter(c) || is_digit(c) || c == '_'; });
}

// Nothing where the bytes are fewer or cannot be such a header: level 4 has no signature, and most
// combinations of its five numbers are impossible.
std::optional<Mat4Header> mat4_header(std::string_view bytes) {
    if (bytes.size() < mat4_header_bytes) {
        return {};
    }
    // The type is MOPT in decimal: byte order, zero, precision, kind of matrix.
    const bool big_endian = load<std::int32_t>(bytes.data(), false) > 9999 ||
                            load<std::int32_t>(bytes.data(), false) < 0;
    std::array<std::int32_t, 5> numbers{};
    for (std::size_t i = 0; i < numbers.size(); ++i) {
        numbers[i] = load<std::int32_t>(bytes.data() + 4 * i, big_endian);
    }
    const auto [type, rows, columns, complex, name_bytes] = numbers;
    if (type < 0 || type / 1000 != (big_endian ? 1 : 0) || type / 100 % 10 != 0 ||
        type / 10 % 10 >= static_cast<std::int32_t>(types_by_precision.size()) || type % 10 > 2) {
        return {};
    }
    if (rows < 0 || columns < 0 || complex < 0 || complex > 1 || name_bytes < 2 ||
        name_bytes > most_name_bytes) {
        return {};
    }
    const NumberType number = types_by_precision[static_cast<std::size_t>(type / 10 % 10)];
    // 2^31 rows, 2^31 columns and 16 bytes do not fit into 63 bits.
    if (columns > 0 && rows > (std::int64_t{1} << 50) / columns) {
        return {};
    }
    return Mat4Header{rows,         columns,
                      name_bytes,   std::int64_t{rows} * columns * bytes_of(number) * (1 + complex),
                      number,       big_endian,
                      complex == 1, type % 10 == 0};
}

}  // namespace

bool is_mat4(std::string_view head, std::int64_t size) {
    const auto header = mat4_header(head);
    if (!header || header->rows == 0 || header->columns == 0) {
        return false;
    }
    const std::string_view name = head.substr(
        mat4_header_bytes,
        std::min(static_cast<std::size_t>(header->name_bytes), head.size() - mat4_header_bytes));
    return name.size() == static_cast<std::size_t>(header->name_bytes) && name.back() == '\0' &&
           is_name(name.substr(0, name.size() - 1)) &&
           size > mat4_header_bytes + header->name_bytes;
}

bool is_mat5(std::string_view head) {
    return head.starts_with("MATLAB 5.0 MAT-file");
}

using namespace mat5;

namespace {

constexpr std::int64_t header_bytes = 128;
constexpr std::uint32_t class_mask = 0xFF;
constexpr std::uint32_t logical_flag = 0x200;
constexpr std::uint32_t complex_flag = 0x800;

// A piece of a level 5 file: tag and bytes.
struct Element {
    std::uint32_t type = 0;
    std::int64_t data = 0;  // where its bytes begin
    std::int64_t size = 0;
    std::int64_t next = 0;  // where the next element begins

    std::int64_t end() const { return data + size; }
};

// The element whose tag, of tag_bytes, is at `at`. The tag itself may hold up to four bytes;
// compressed elements are not padded.
Element element_of(std::string_view tag, std::int64_t at, bool big_endian) {
    const auto type = load<std::uint32_t>(tag.data(), big_endian);
    if (type >> 16 != 0) {
        return {type & 0xFFFF, at + 4, type >> 16, at + tag_bytes};
    }
    const std::int64_t size = load<std::uint32_t>(tag.data() + 4, big_endian);
    const std::int64_t padding = type == compressed ? 0 : (8 - size % 8) % 8;
    return {type, at + tag_bytes, size, at + tag_bytes + size + padding};
}

// Of an element; nothing where it holds no numbers.
std::optional<NumberType> number_type(std::uint32_t element_type) {
    switch (element_type) {
        case int8: return NumberType::i8;
        case 2: return NumberType::u8;
        case 3: return NumberType::i16;
        case uint16: return NumberType::u16;
        case int32: return NumberType::i32;
        case uint32: return NumberType::u32;
        case 7: return NumberType::f32;
        case float64: return NumberType::f64;
        case 12: return NumberType::i64;
        case 13: return NumberType::u64;
        default: return std::nullopt;
    }
}

// That the numbers of a class have in MATLAB; a file may store them narrower. Nothing where it is
// no class of numbers.
std::optional<NumberType> class_type(std::uint32_t array_class) {
    constexpr std::array<NumberType, 10> types{
        NumberType::f64, NumberType::f32, NumberType::i8,  NumberType::u8,  NumberType::i16,
        NumberType::u16, NumberType::i32, NumberType::u32, NumberType::i64, NumberType::u64};
    const std::uint32_t place = array_class - double_class;  // of smaller ones a large number
    return place < types.size() ? std::optional(types[place]) : std::nullopt;
}

constexpr int most_struct_depth = 8;
constexpr int most_variables = 10000;  // and fields, of any kind
constexpr std::int64_t longest_name = 4096;
constexpr std::int64_t zlib_head_bytes = 2;  // before the deflated bytes, and four after them
constexpr std::int64_t zlib_bytes = zlib_head_bytes + 4;

using Arrays = std::vector<StoredArray>;

Error cut_off(const FileBytes& file) {
    return file.damaged("MAT", VYBEG_MESSAGE("Words", "it ends at byte %1, inside of a variable"),
                        {count_arg(file.size())});
}

Error too_many(const FileBytes& file) {
    return too_many_parts(file.path().string(), "MAT",
                          VYBEG_MESSAGE("Words", "it has more than %1 variables"), most_variables);
}

// A matrix of numbers, column after column. `shown`: the type that MATLAB shows.
StoredArray stored_matrix(std::string name, std::int64_t rows, std::int64_t columns,
                          NumberType shown, bool is_complex) {
    StoredArray stored;
    FileVariable& variable = stored.variable;
    variable.name = std::move(name);
    variable.frames = std::max(rows, columns);
    variable.channels = std::min(rows, columns);
    const bool is_float = shown == NumberType::f64 || shown == NumberType::f32;
    variable.type = number_type_text(8 * bytes_of(shown), is_float);
    if (is_complex) {
        variable.unsupported = Phrase::tr("complex numbers");
    }
    set_matrix(rows, columns, /*by_columns=*/true, stored.array);
    return stored;
}

Result<Arrays> level4_arrays(const std::shared_ptr<const FileBytes>& file) {
    Arrays arrays;
    const auto whole = file_part(file, 0, file->size());
    int variables = 0;
    for (std::int64_t at = 0; at < file->size();) {
        if (++variables > most_variables) {
            return too_many(*file);
        }
        const auto bytes = TRY(file->text(at, mat4_header_bytes));
        const auto header = mat4_header(bytes);
        if (!header) {
            return file->damaged("MAT", VYBEG_MESSAGE("Words", "there is no variable at byte %1"),
                                 {count_arg(at)});
        }
        const std::int64_t data = at + mat4_header_bytes + header->name_bytes;
        std::string name(static_cast<std::size_t>(header->name_bytes), '\0');
        if (data + header->data_bytes > file->size()) {
            return cut_off(*file);
        }
        TRY(whole->read(at + mat4_header_bytes, name));
        if (header->is_full) {
            // Level 4 knows doubles alone, however few bytes they are stored in.
            StoredArray stored =
                stored_matrix(name.substr(0, name.find('\0')), header->rows, header->columns,
                              NumberType::f64, header->is_complex);
            stored.array.type = header->type;
            stored.array.big_endian = header->big_endian;
            stored.array.offset = data;
            stored.content = [whole] { return whole; };
            arrays.push_back(std::move(stored));
        }
        at = data + header->data_bytes;
    }
    return arrays;
}

// The bytes that hold elements: the file, or one unpacked variable.
struct Content {
    std::shared_ptr<const ByteSource> bytes;
    std::function<Result<std::shared_ptr<const ByteSource>>()> again;  // with a decoder of its own
};

// The arrays of a file of level 5. A size that leads out of what encloses it is damage: no sample
// is read from the bytes after its array. After the first failure, all else is empty.
class Level5 {
public:
    Level5(std::shared_ptr<const FileBytes> file, bool big_endian)
        : file_(std::move(file)), big_endian_(big_endian) {}

    Result<Arrays> arrays(const JobControl& job) {
        const std::int64_t size = file_->size();
        const auto whole = file_part(file_, 0, size);
        const Content plain{whole, [whole] { return whole; }};
        for (top_ = header_bytes; top_ < size && status_;) {
            count_element();
            // The last one need not be padded.
            const Element element =
                top_ + tag_bytes > size
                    ? Element{0, top_, size, size}
                    : element_of(text(*whole, top_, tag_bytes), top_, big_endian_);
            if (element.end() > size) {
                fail(cut_off(*file_));
            } else if (element.type == matrix) {
                add(plain, element, "", 0);
            } else if (element.type == compressed) {
                add_packed(element);
            }
            if (const Status going = job.go_on(); !going) {
                fail(going.error());
            }
            top_ = element.next;
        }
        return status_ ? Result(std::move(arrays_)) : status_.error();
    }

    // The names of the columns of an array `data` in a struct, where it has them in a cell array
    // `legend`, by the array's name.
    const std::map<std::string, std::vector<Channel>>& legends() const { return legends_; }

private:
    void fail(Error error) {
        if (status_) {
            status_ = std::move(error);
        }
    }

    void count_element() {
        if (++elements_ > most_variables) {
            fail(too_many(*file_));
        }
    }

    void misfit() {
        fail(file_->damaged(
            "MAT",
            VYBEG_MESSAGE("Words", "the size of the variable at byte %1 does not fit its numbers"),
            {count_arg(top_)}));
    }

    // As many zeros after a failure.
    std::string text(const ByteSource& bytes, std::int64_t at, std::int64_t size) {
        if (size > longest_name || at + size > bytes.size()) {
            misfit();
            size = std::min(size, longest_name);
        }
        std::string text(static_cast<std::size_t>(size), '\0');
        if (status_) {
            if (const Status status = bytes.read(at, text); !status) {
                fail(status.error());
            }
        }
        return text;
    }

    template <class Number>
    Number number(const ByteSource& bytes, std::int64_t at) {
        return load<Number>(text(bytes, at, sizeof(Number)).data(), big_endian_);
    }

    // One that lies before `end`.
    Element element(const ByteSource& bytes, std::int64_t at, std::int64_t end) {
        const Element found = element_of(text(bytes, at, tag_bytes), at, big_endian_);
        if (at + tag_bytes > end || found.end() > end) {
            misfit();
        }
        return found;
    }

    void add_packed(const Element& packed) {
        DeflatedPart part{packed.data + zlib_head_bytes,
                          packed.size - zlib_bytes,
                          tag_bytes,
                          std::nullopt,
                          "MAT 5",
                          "the variable at byte " + std::to_string(top_)};
        if (part.packed_size <= 0) {
            return misfit();
        }
        // Its own tag says how long it is.
        const Element inner =
            element_of(text(*inflated_part(file_, part), 0, tag_bytes), 0, big_endian_);
        part.size = inner.end();
        if (inner.type != matrix || part.size / best_ratio > part.packed_size) {
            return misfit();
        }
        const auto again = [file = file_, part] { return inflated_part(file, part); };
        add({again(), again}, inner, "", 0);
    }

    // The array, or those in a struct. `path`: of the struct or field that it is, with a point.
    void add(const Content& content, const Element& whole, std::string path, int depth) {
        if (whole.size == 0 || !status_) {  // a field without a value
            return;
        }
        const ByteSource& bytes = *content.bytes;
        const Element flags = element(bytes, whole.data, whole.end());
        const auto bits = number<std::uint32_t>(bytes, flags.data);
        const auto shown = class_type(bits & class_mask);
        const bool is_struct = (bits & class_mask) == struct_class && depth < most_struct_depth;
        if (const std::string legend = ".legend";
            (bits & class_mask) == cell_class && path.ends_with(legend)) {
            path.resize(path.size() - legend.size());
            return add_legend(bytes, {0, flags.next, whole.end() - flags.next, 0}, path + ".data");
        }
        if ((!shown && !is_struct) || (bits & logical_flag) != 0) {
            return;
        }
        const Element size = element(bytes, flags.next, whole.end());
        const Element name = element(bytes, size.next, whole.end());
        path += text(bytes, name.data, name.size);
        constexpr std::int64_t width = sizeof(std::int32_t);
        if (size.size != 2 * width) {
            return add_unsupported(path, shown ? size.size / width : 0);
        }
        const std::int64_t rows = number<std::int32_t>(bytes, size.data);
        const std::int64_t columns = number<std::int32_t>(bytes, size.data + width);
        if (is_struct && std::min(rows, columns) == 1) {
            add_fields(content, {0, name.next, whole.end() - name.next, 0}, path, depth,
                       std::max(rows, columns));
        }
        if (is_struct || !status_) {
            return;
        }
        const Element data = element(bytes, name.next, whole.end());
        const auto type = number_type(data.type);
        if (!type || rows < 0 || columns < 0 ||
            rows > (std::int64_t{1} << 60) / (8 * columns + 1) ||
            rows * columns * bytes_of(*type) != data.size) {
            return misfit();
        }
        StoredArray stored = stored_matrix(path, rows, columns, *shown, (bits & complex_flag) != 0);
        stored.array.type = *type;
        stored.array.big_endian = big_endian_;
        stored.array.offset = data.data;
        stored.content = content.again;
        arrays_.push_back(std::move(stored));
    }

    // `rest`: size, name and cells, each a text.
    void add_legend(const ByteSource& bytes, const Element& rest, const std::string& of) {
        const Element size = element(bytes, rest.data, rest.end());
        const Element name = element(bytes, size.next, rest.end());
        std::vector<Channel>& legend = legends_[of];
        for (std::int64_t at = name.next; at < rest.end() && status_;) {
            count_element();
            const Element cell = element(bytes, at, rest.end());
            legend.push_back(name_and_unit(cell_text(bytes, cell)));
            at = cell.next;
        }
    }

    // Of a cell with a text; empty for another one.
    std::string cell_text(const ByteSource& bytes, const Element& cell) {
        if (cell.type != matrix || cell.size == 0) {
            return {};
        }
        const Element flags = element(bytes, cell.data, cell.end());
        if ((number<std::uint32_t>(bytes, flags.data) & class_mask) != char_class) {
            return {};
        }
        const Element size = element(bytes, flags.next, cell.end());
        const Element name = element(bytes, size.next, cell.end());
        const Element data = element(bytes, name.next, cell.end());
        if (data.size > longest_name) {
            return {};
        }
        std::string found = text(bytes, data.data, data.size);
        if (data.type == uint16 || data.type == utf16) {
            // Of names in Latin letters every second byte is zero.
            std::erase(found, '\0');
        }
        return found;
    }

    void add_unsupported(const std::string& name, std::int64_t dimensions) {
        if (dimensions > 2) {
            StoredArray stored;
            stored.variable.name = name;
            stored.variable.unsupported = dimensions_text(dimensions);
            arrays_.push_back(std::move(stored));
        }
    }

    // `fields`: the length of their names, the names, then the fields of each struct of a row,
    // numbered from 1 in the names where there are several.
    void add_fields(const Content& content, const Element& fields, const std::string& path,
                    int depth, std::int64_t structs) {
        const ByteSource& bytes = *content.bytes;
        const Element length = element(bytes, fields.data, fields.end());
        const Element names = element(bytes, length.next, fields.end());
        const std::int64_t width = number<std::int32_t>(bytes, length.data);
        if (width <= 0) {
            return misfit();
        }
        std::int64_t at = names.next;
        const std::int64_t count = names.size / width;
        for (std::int64_t k = 0; k < structs * count && status_; ++k) {
            count_element();
            std::string name = path;
            if (structs > 1) {
                name.append("(").append(std::to_string(k / count + 1)).append(")");
            }
            const std::string padded = text(bytes, names.data + k % count * width, width);
            name.append(".").append(padded, 0, padded.find('\0'));
            const Element field = element(bytes, at, fields.end());
            if (field.type != matrix) {
                misfit();
            }
            add(content, field, std::move(name), depth + 1);
            at = field.next;
        }
    }

    std::shared_ptr<const FileBytes> file_;
    bool big_endian_;
    std::int64_t top_ = 0;  // where the variable begins
    int elements_ = 0;      // variables and fields so far
    Status status_;
    Arrays arrays_;
    std::map<std::string, std::vector<Channel>> legends_;
};

bool is_big_endian(std::string_view head) {
    return head[header_bytes - 2] == 'M';
}

constexpr const char* moku_table = "moku.data";

bool is_of_phasemeter(const std::vector<Channel>& legend) {
    return std::ranges::any_of(legend, [](const Channel& column) {
        const std::string name = normal_name(column.name);
        return name == normal_name("Input 1 I") || name == normal_name("Input 1 X");
    });
}

}  // namespace

Result<Recording> open_mat(std::shared_ptr<const FileBytes> file, const OpenOptions& options,
                           const JobControl& job) {
    const auto head = TRY(file->text(0, header_bytes));
    const bool is_level5 = is_mat5(head);
    if (is_level5 && std::ssize(head) < header_bytes) {
        return file->damaged("MAT", VYBEG_MESSAGE("Words", "it ends in its header"));
    }
    if (!is_level5) {
        auto arrays = TRY(level4_arrays(file));
        return open_arrays(*file, "MAT 4", std::move(arrays), options, job);
    }
    Level5 level5(file, is_big_endian(head));
    auto arrays = TRY(level5.arrays(job));
    const auto legend = level5.legends().find(moku_table);
    if (legend != level5.legends().end() && is_of_phasemeter(legend->second)) {
        return holds_phasors(*file);
    }
    return open_arrays(*file, "MAT 5", std::move(arrays), options, job);
}

Result<std::vector<NamedColumn>> moku_columns(const std::shared_ptr<const FileBytes>& file,
                                              const JobControl& job) {
    const auto head = TRY(file->text(0, header_bytes));
    std::vector<NamedColumn> columns;
    if (!is_mat5(head) || std::ssize(head) < header_bytes) {
        return columns;
    }
    Level5 level5(file, is_big_endian(head));
    const auto arrays = TRY(level5.arrays(job));
    const auto table = std::ranges::find(
        arrays, moku_table, [](const StoredArray& stored) { return stored.variable.name; });
    const auto legend = level5.legends().find(moku_table);
    if (table == arrays.end() || legend == level5.legends().end()) {
        return columns;
    }
    const NumberArray& array = table->array;
    if ((array.interleaved ? array.frames : array.channels) != std::ssize(legend->second)) {
        return columns;
    }
    for (const Channel& heading : legend->second) {
        auto content = TRY(table->content());
        columns.push_back({heading, array_column(array, std::move(content), std::ssize(columns))});
    }
    return columns;
}

}  // namespace vybeg
