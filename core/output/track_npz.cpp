#include "core/output/track_npz.h"

#include "core/base/number_text.h"
#include "core/base/plain_text.h"
#include "core/output/array_heads.h"
#include "core/output/flag_cells.h"
#include "core/output/raw_bytes.h"
#include "core/output/stored_zip.h"

#include <algorithm>
#include <functional>
#include <string_view>
#include <vector>
#include <zlib.h>

namespace vybeg {
namespace {

using ByteSink = std::function<Status(std::string_view bytes)>;

// An array of the archive, whose bytes can be passed as often as they are needed.
struct NpyMember {
    std::string name;
    std::string type;
    std::size_t rows = 0;
    std::size_t bytes_per_row = 0;
    std::function<Status(const ByteSink&)> pass;
};

std::uint32_t crc_of(std::uint32_t crc, std::string_view bytes) {
    return static_cast<std::uint32_t>(
        crc32_z(crc, reinterpret_cast<const Bytef*>(bytes.data()), bytes.size()));
}

// The checksum stands before the bytes, so that they are passed twice.
Status write_member(OutputFile& file, StoredZip& zip, const NpyMember& member) {
    const std::string head =
        npy_head(member.type, integer_text(static_cast<std::int64_t>(member.rows)) + ",");
    std::uint32_t crc = crc_of(0, head);
    TRY(member.pass([&crc](std::string_view bytes) -> Status {
        crc = crc_of(crc, bytes);
        return {};
    }));
    TRY(zip.begin(member.name + ".npy", head.size() + member.rows * member.bytes_per_row, crc));
    TRY(file.write(head));
    return member.pass([&file](std::string_view bytes) { return file.write(bytes); });
}

// A text of so many characters, as NumPy keeps it: 4 bytes for each, zeros behind the last.
std::string numpy_text(const std::string& text, std::size_t width) {
    std::string bytes;
    for (const char32_t point : code_points(text)) {
        append_bytes(bytes, point);
    }
    bytes.resize(width * sizeof(char32_t), '\0');
    return bytes;
}

std::string numpy_text_type(std::size_t width) {
    return "<U" + integer_text(static_cast<std::int64_t>(width));
}

}  // namespace

Status write_track_npz(OutputFile& file, const TrackColumns& columns,
                       std::span<const std::string> header) {
    const auto counts = TRY(count_flags(columns));
    std::vector<NpyMember> members;
    for (std::size_t k = 0; k < track_number_columns; ++k) {
        members.push_back({track_column_name(k), "<f8", columns.rows(), sizeof(double),
                           [&columns, k](const ByteSink& sink) {
                               return columns.numbers(k, [&sink](std::span<const double> rows) {
                                   return sink(bytes_of(rows));
                               });
                           }});
    }
    const std::size_t width = longest_text(counts);
    const FlagCells cells =
        make_cells(counts, [width](const std::string& text) { return numpy_text(text, width); });
    members.push_back({flag_column_name, numpy_text_type(width), columns.rows(),
                       width * sizeof(char32_t),
                       [&](const ByteSink& sink) { return pass_cells(columns, cells, sink); }});
    std::size_t longest = 1;
    for (const std::string& line : header) {
        longest = std::max(longest, code_points(line).size());
    }
    std::string lines;
    for (const std::string& line : header) {
        lines += numpy_text(line, longest);
    }
    members.push_back({header_name, numpy_text_type(longest), header.size(),
                       longest * sizeof(char32_t),
                       [&lines](const ByteSink& sink) { return sink(lines); }});
    StoredZip zip(file);
    for (const NpyMember& member : members) {
        TRY(write_member(file, zip, member));
    }
    return zip.finish();
}

}  // namespace vybeg
