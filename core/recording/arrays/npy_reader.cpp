#include "core/recording/arrays/npy_reader.h"

#include "core/base/message_arg.h"
#include "core/recording/bytes/number_type.h"
#include "core/recording/samples/reader_rules.h"
#include "core/recording/samples/text_fields.h"

#include <algorithm>
#include <array>
#include <limits>
#include <optional>
#include <utility>

namespace vybeg {
namespace {

using namespace std::string_view_literals;

constexpr std::string_view magic = "\x93NUMPY"sv;
constexpr std::int64_t most_channels = 4096;
constexpr std::int64_t longest_npy_header = std::int64_t{1} << 16;  // NumPy itself stops at 10000

// The tokens of a Python literal: texts in quotes, words, whole numbers and single characters. None
// where a quote is not closed.
std::vector<std::string_view> tokens_of(std::string_view literal) {
    constexpr std::string_view of_words =
        "0123456789ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz_";
    std::vector<std::string_view> tokens;
    for (;;) {
        literal.remove_prefix(std::min(literal.find_first_not_of(" \t\r\n"), literal.size()));
        if (literal.empty()) {
            return tokens;
        }
        std::size_t size = std::min(literal.find_first_not_of(of_words), literal.size());
        if (literal.front() == '\'' || literal.front() == '"') {
            size = literal.find(literal.front(), 1) + 1;
            if (size == 0) {
                return {};
            }
        }
        tokens.push_back(literal.substr(0, std::max(size, std::size_t{1})));
        literal.remove_prefix(tokens.back().size());
    }
}

std::optional<std::string_view> unquoted(std::string_view token) {
    const bool quoted = token.starts_with('\'') || token.starts_with('"');
    return quoted ? std::optional(token.substr(1, token.size() - 2)) : std::nullopt;
}

// Python 2 appended an L.
std::optional<std::int64_t> length_in(std::string_view token) {
    token.remove_suffix(token.ends_with('L') ? 1 : 0);
    return whole_number<std::int64_t>(token);
}

struct Header {
    std::optional<std::string> descr;  // empty: a list, that is, records
    std::optional<bool> fortran_order;
    std::optional<std::vector<std::int64_t>> shape;
};

// Empty if the text is no dictionary of the three known keys.
std::optional<Header> parse_header(std::string_view text) {
    const std::vector<std::string_view> tokens = tokens_of(text);
    auto next = tokens.begin();
    const auto at = [&](std::string_view token) { return next != tokens.end() && *next == token; };
    const auto take = [&](std::string_view token) {
        const bool there = at(token);
        next += there ? 1 : 0;
        return there;
    };
    const auto any = [&] { return next == tokens.end() ? std::string_view() : *next++; };
    Header header;
    if (!take("{")) {
        return std::nullopt;
    }
    while (!take("}")) {
        const auto key = unquoted(any());
        if (!key || !take(":")) {
            return std::nullopt;
        }
        if (*key == "descr" && take("[")) {
            header.descr = "";
            return header;
        }
        if (*key == "descr") {
            header.descr = unquoted(any());
        } else if (*key == "fortran_order" && (at("True") || at("False"))) {
            header.fortran_order = any() == "True";
        } else if (*key == "shape" && take("(")) {
            header.shape.emplace();
            while (!take(")")) {
                const auto number = length_in(any());
                if (!number || !(take(",") || at(")"))) {
                    return std::nullopt;
                }
                header.shape->push_back(*number);
            }
        } else {
            return std::nullopt;
        }
        if (!take(",") && !at("}")) {
            return std::nullopt;
        }
    }
    const bool whole = header.descr && header.fortran_order && header.shape && next == tokens.end();
    return whole ? std::optional(header) : std::nullopt;
}

// Type codes such as "<f8". NumPy writes '|' for one byte; '=' or no sign means the byte order of
// the writing machine, almost certainly little endian.
std::optional<std::pair<NumberType, bool>> parse_type(std::string_view descr) {
    bool big_endian = false;
    if (!descr.empty() && "<>=|"sv.find(descr.front()) != ""sv.npos) {
        big_endian = descr.front() == '>';
        descr.remove_prefix(1);
    }
    constexpr std::array<std::pair<std::string_view, NumberType>, 11> types{{
        {"i1", NumberType::i8},
        {"u1", NumberType::u8},
        {"i2", NumberType::i16},
        {"u2", NumberType::u16},
        {"i4", NumberType::i32},
        {"u4", NumberType::u32},
        {"i8", NumberType::i64},
        {"u8", NumberType::u64},
        {"f2", NumberType::f16},
        {"f4", NumberType::f32},
        {"f8", NumberType::f64},
    }};
    for (const auto& [name, type] : types) {
        if (name == descr) {
            return std::pair(type, big_endian);
        }
    }
    return std::nullopt;
}

// Text for a one-line message.
std::string printable(std::string_view text) {
    std::string copy(text.substr(0, 20));
    std::replace_if(
        copy.begin(), copy.end(), [](char c) { return c < ' ' || c > '~'; }, '?');
    return copy;
}

// Of the columns of a phasemeter's log; empty: it is none.
std::vector<Channel> moku_headings(const NpyArray& array) {
    constexpr std::int64_t header_of_moku = 96;  // NumPy ends it at a multiple of 64, once of 16
    constexpr std::array<std::pair<const char*, const char*>, 5> of_input{
        {{"Set Frequency", "Hz"}, {"Frequency", "Hz"}, {"Phase", "cyc"}, {"I", "V"}, {"Q", "V"}}};
    constexpr std::int64_t each = of_input.size();
    constexpr std::int64_t most_inputs = 4;
    const std::int64_t columns = array.channels;
    if (array.offset != header_of_moku || array.type != NumberType::f64 || array.big_endian ||
        array.fortran_order || array.frames < columns || columns % each != 1 || columns <= each ||
        columns > most_inputs * each + 1) {
        return {};
    }
    std::vector<Channel> headings{{"Time", "s"}};
    for (std::int64_t input = 1; input <= columns / each; ++input) {
        for (const auto& [name, unit] : of_input) {
            headings.push_back({"Input " + std::to_string(input) + " " + name, unit});
        }
    }
    return headings;
}

bool size_fits(const std::vector<std::int64_t>& shape) {
    // Limits the size, so that products with the size of a number do not overflow.
    std::int64_t room = std::numeric_limits<std::int64_t>::max() / 16;
    for (const std::int64_t length : shape) {
        if (length > room) {
            return false;
        }
        room /= std::max<std::int64_t>(length, 1);
    }
    return true;
}

}  // namespace

Result<Recording> open_npy(std::shared_ptr<const FileBytes> file, const OpenOptions& options,
                           const JobControl& job) {
    const auto bytes = file_part(file, 0, file->size());
    const auto array = TRY(read_npy_header(*file, *bytes, "NPY"));
    if (!moku_headings(array).empty()) {
        return holds_phasors(*file);
    }
    FoundSamples found;
    // Of three columns or more, the first may be the time, which is no channel.
    if (array.channels > 2) {
        found.own_rate = TRY(rate_of_times(array_column(array, bytes, 0), 1, job));
    }
    const int first = found.own_rate ? 1 : 0;  // channel
    const auto channels = static_cast<int>(array.channels) - first;
    TRY(check_channels(*file, channels, options));
    found.format = {FormatPart::name("NPY"), FormatPart::words(name_of(array.type)),
                    byte_order_part(array.big_endian),
                    FormatPart::words(array.fortran_order ? VYBEG_MESSAGE("Format", "Fortran order")
                                                          : VYBEG_MESSAGE("Format", "C order")),
                    FormatPart::channels(channels)};
    found.channels = numbered_channels(channels);
    found.promised_frames = array.frames;
    found.source = array_source(file, array, first + options.channel_c, first + options.channel_d);
    found.present_frames = found.source->frames();
    return complete_recording(*file, std::move(found), options);
}

Result<std::vector<NamedColumn>> npy_columns(const std::shared_ptr<const FileBytes>& file) {
    const auto bytes = file_part(file, 0, file->size());
    const auto array = TRY(read_npy_header(*file, *bytes, "NPY"));
    std::vector<Channel> headings = moku_headings(array);
    headings.resize(static_cast<std::size_t>(array.channels));
    std::vector<NamedColumn> columns;
    for (Channel& heading : headings) {
        columns.push_back({std::move(heading), array_column(array, bytes, std::ssize(columns))});
    }
    return columns;
}

bool is_npy(std::string_view head) {
    return head.starts_with(magic);
}

void set_matrix(std::int64_t rows, std::int64_t columns, bool by_columns, NumberArray& array) {
    const bool row_is_channel = rows > 0 && rows < columns;
    array.frames = row_is_channel ? columns : rows;
    array.channels = row_is_channel ? rows : columns;
    array.interleaved = row_is_channel == by_columns;
}

Result<NpyArray> read_npy_header(const FileBytes& file, const ByteSource& bytes,
                                 const std::string& name) {
    std::array<char, 12> start{};
    const auto start_size = std::min<std::int64_t>(bytes.size(), start.size());
    TRY(bytes.read(0, std::span(start).first(static_cast<std::size_t>(start_size))));
    if (start_size < 10 || !is_npy({start.data(), start.size()})) {
        return file.damaged(name,
                            VYBEG_MESSAGE("Words", "its first bytes are not those of an array"));
    }
    const int version = start[6];
    if (version < 1 || version > 3) {
        return file.unsupported(name, VYBEG_MESSAGE("Words", "the format version %1"),
                                {count_arg(version)});
    }
    const std::int64_t text_at = version == 1 ? 10 : 12;
    const std::int64_t text_size = version == 1 ? load<std::uint16_t>(start.data() + 8, false)
                                                : load<std::uint32_t>(start.data() + 8, false);
    if (text_size > longest_npy_header || text_at + text_size > bytes.size()) {
        return file.damaged(name, VYBEG_MESSAGE("Words", "its header is longer than it can be"));
    }
    std::string text(static_cast<std::size_t>(text_size), '\0');
    TRY(bytes.read(text_at, text));
    const auto header = parse_header(text);
    if (!header) {
        return file.damaged(name, VYBEG_MESSAGE("Words", "its header cannot be understood"));
    }
    if (header->descr->empty()) {
        return file.unsupported(name, VYBEG_MESSAGE("Words", "records of several fields"));
    }
    const auto type = parse_type(*header->descr);
    if (!type) {
        return file.unsupported(name, VYBEG_MESSAGE("Words", "values of the type %1"),
                                {printable(*header->descr)});
    }
    if (header->shape->size() > 2) {
        return file.unsupported(name, VYBEG_MESSAGE("Words", "an array of %1 dimensions"),
                                {count_arg(std::ssize(*header->shape))});
    }
    if (!size_fits(*header->shape)) {
        return file.damaged(
            name,
            VYBEG_MESSAGE("Words", "its header promises more samples than any file can hold"));
    }
    NpyArray array;
    array.type = type->first;
    array.big_endian = type->second;
    array.fortran_order = *header->fortran_order;
    array.offset = text_at + text_size;
    const std::vector<std::int64_t>& shape = *header->shape;
    array.frames = shape.empty() ? 1 : shape[0];
    if (shape.size() == 2) {
        set_matrix(shape[0], shape[1], array.fortran_order, array);
    }
    if (array.channels > most_channels) {
        return file.unsupported(name, VYBEG_MESSAGE("Words", "%1 channels"),
                                {count_arg(array.channels)});
    }
    return array;
}

}  // namespace vybeg
