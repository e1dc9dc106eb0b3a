#include "core/output/track_file.h"

#include "core/analysis/setting_table.h"
#include "core/base/diagnostic.h"
#include "core/base/number_text.h"
#include "core/base/plain_text.h"
#include "core/hdf5/hdf5_layout.h"
#include "core/output/array_files.h"

#include <tbb/parallel_for.h>
#include <tbb/task_arena.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <dlfcn.h>
#include <functional>
#include <map>
#include <memory>
#include <mutex>
#include <string_view>
#include <system_error>
#include <zlib.h>

namespace vybeg {
namespace {

using ByteSink = std::function<Status(std::string_view bytes)>;

void add_results(const AnalysisSummary& analysis, std::vector<std::string>& lines) {
    lines.push_back("f0_Hz: " + round_trip_text(analysis.f0_hz()));
    lines.push_back("residual: " + round_trip_text(analysis.residual));
    if (analysis.means.windows > 0 && !std::isnan(analysis.f0_hz())) {
        lines.push_back("mean_f_Hz: " + round_trip_text(analysis.means.mean_f_hz));
        lines.push_back("mean_f_at_s: " + round_trip_text(analysis.means.mean_at_s));
        lines.push_back("sd_mean_f_Hz: " + round_trip_text(analysis.means.sd_mean_f_hz));
        lines.push_back("noise: " + round_trip_text(analysis.means.noise));
    }
    for (const Diagnostic& diagnostic : analysis.diagnostics) {
        lines.push_back((severity(diagnostic.kind) == Severity::note ? "note: " : "warning: ") +
                        english(diagnostic));
    }
}

// Header lines as they go into a file: a file name may contain a line feed, a line may not.
std::vector<std::string> single_lines(std::span<const std::string> header) {
    std::vector<std::string> lines(header.begin(), header.end());
    for (std::string& line : lines) {
        std::ranges::replace_if(
            line, [](char character) { return static_cast<unsigned char>(character) < ' '; }, ' ');
    }
    return lines;
}

ByteSink into(OutputFile& file) {
    return [&file](std::string_view bytes) { return file.write(bytes); };
}

Status pass_numbers(const TrackColumns& columns, std::size_t column, const ByteSink& sink) {
    return columns.numbers(
        column, [&sink](std::span<const double> values) { return sink(bytes_of(values)); });
}

// The combinations of flags that a track has, each with the number of its rows. There are few, so
// that every format makes their texts once. Errors: those of TrackColumns.
using FlagCounts = std::map<Flags, std::size_t>;
Result<FlagCounts> count_flags(const TrackColumns& columns) {
    FlagCounts counts;
    TRY(columns.flags([&counts](std::span<const Flags> rows) -> Status {
        // Neighbours have the same flags more often than not.
        for (auto at = rows.begin(); at != rows.end();) {
            const auto other = std::find_if(at, rows.end(), [&](Flags f) { return f != *at; });
            counts[*at] += static_cast<std::size_t>(other - at);
            at = other;
        }
        return {};
    }));
    return counts;
}

// What each combination looks like in a file.
using FlagCells = std::map<Flags, std::string>;

// Passes the cells of all rows, many at a time. Errors: those of the sink and of TrackColumns.
Status pass_cells(const TrackColumns& columns, const FlagCells& cells, const ByteSink& sink) {
    std::string bytes;
    return columns.flags([&](std::span<const Flags> rows) {
        bytes.clear();
        auto cell = cells.begin();
        for (const Flags flags : rows) {
            cell = cell->first == flags ? cell : cells.find(flags);
            bytes += cell->second;
        }
        return sink(bytes);
    });
}

// An array of a file whose bytes can be passed as often as they are needed.
struct TrackArray : Hdf5Array {
    std::function<Status(const ByteSink&)> pass;
};

// The bytes of a text in a format.
using TextBytes = std::string (*)(const std::string& text);

// Every array of a file: a column each, the flags and the header's lines. `one_width`: the format
// keeps the texts of an array in one width, with zeros after the last character. `columns` must
// outlive them.
Result<std::vector<TrackArray>> arrays_of(const TrackColumns& columns,
                                          std::span<const std::string> header, TextBytes text_bytes,
                                          bool one_width = true) {
    const auto counts = TRY(count_flags(columns));
    const auto rows = static_cast<std::int64_t>(columns.rows());
    std::vector<TrackArray> arrays;
    for (std::size_t k = 0; k < track_number_columns; ++k) {
        arrays.push_back(
            {{track_column_name(k), rows, rows * static_cast<std::int64_t>(sizeof(double)), 0,
              track_column_unit(k)},
             [&columns, k](const ByteSink& sink) { return pass_numbers(columns, k, sink); }});
    }
    // No format has texts without any room.
    std::size_t width = text_bytes(" ").size();
    std::size_t longest = width;
    for (const auto& [flags, rows_of] : counts) {
        width = std::max(width, text_bytes(flags_text(flags)).size());
    }
    const auto cell_of = [=](const std::string& text, std::size_t size) {
        std::string cell = text_bytes(text);
        cell.resize(one_width ? size : cell.size());
        return cell;
    };
    FlagCells cells;
    std::size_t bytes = 0;
    for (const auto& [flags, rows_of] : counts) {
        cells[flags] = cell_of(flags_text(flags), width);
        bytes += rows_of * cells[flags].size();
    }
    arrays.push_back(
        {{flag_column_name, rows, static_cast<std::int64_t>(bytes),
          static_cast<std::int64_t>(width)},
         [&columns, cells](const ByteSink& sink) { return pass_cells(columns, cells, sink); }});
    for (const std::string& line : header) {
        longest = std::max(longest, text_bytes(line).size());
    }
    std::string lines;
    for (const std::string& line : header) {
        lines += cell_of(line, longest);
    }
    arrays.push_back(
        {{header_name, std::ssize(header), std::ssize(lines), static_cast<std::int64_t>(longest)},
         [lines](const ByteSink& sink) { return sink(lines); }});
    return arrays;
}

std::uint32_t crc_of(std::uint32_t crc, std::string_view bytes) {
    return static_cast<std::uint32_t>(
        crc32_z(crc, reinterpret_cast<const Bytef*>(bytes.data()), bytes.size()));
}

// The checksum comes before the bytes, so that they are passed twice.
Status write_member(OutputFile& file, StoredZip& zip, const TrackArray& array) {
    constexpr std::int64_t character = sizeof(char32_t);
    const std::string type =
        array.text_bytes == 0 ? "<f8" : "<U" + integer_text(array.text_bytes / character);
    const std::string head = npy_head(type, integer_text(array.rows) + ",");
    std::uint32_t crc = crc_of(0, head);
    TRY(array.pass([&crc](std::string_view bytes) -> Status {
        crc = crc_of(crc, bytes);
        return {};
    }));
    TRY(zip.begin(array.name + ".npy", head.size() + static_cast<std::uint64_t>(array.bytes), crc));
    TRY(file.write(head));
    return array.pass(into(file));
}

// As NumPy keeps them: 4 bytes for each character.
std::string numpy_text(const std::string& text) {
    std::string bytes;
    for (const char32_t point : code_points(text)) {
        append_bytes(bytes, point);
    }
    return bytes;
}

// libhdf5 and its libraries take longer to load than the whole program to start: it lies in a
// library of its own, which is loaded for the first HDF5 file.
Result<Hdf5Layout> layout_of(const OutputFile& file, const std::string& program,
                             const std::vector<Hdf5Array>& arrays) {
    static std::mutex one_at_a_time;  // Debian's libhdf5 is not for several threads
    const std::lock_guard lock(one_at_a_time);
    std::error_code ignored;
    const std::filesystem::path library =
        std::filesystem::read_symlink("/proc/self/exe", ignored).parent_path() /
        VYBEG_LIBRARY_FOLDER / hdf5_layout_library;
    void* const loaded = dlopen(library.c_str(), RTLD_NOW | RTLD_LOCAL);
    const auto make =
        loaded == nullptr
            ? nullptr
            : reinterpret_cast<Hdf5LayoutFunction>(dlsym(loaded, hdf5_layout_function));
    if (make == nullptr) {
        const char* const reason = dlerror();
        return file.failure(
            Phrase::tr("libhdf5 cannot be loaded (%1)", {reason == nullptr ? "" : reason}));
    }
    Hdf5Layout layout;
    if (!make(program, arrays, layout)) {
        return file.failure(Phrase::tr("libhdf5 reports an error"));
    }
    return layout;
}

// Writes a track as MAT of level 5: a column of doubles (n x 1) per column, the flags and the
// header's lines as cells of texts (n x 1). Errors: output_failed, also for more rows than the
// format has room for; interrupted; those of TrackColumns.
Status write_track_mat(OutputFile& file, const TrackColumns& columns,
                       std::span<const std::string> header) {
    const auto arrays = TRY(arrays_of(columns, header, mat_text_cell, /*one_width=*/false));
    if (std::ranges::any_of(arrays, [](const auto& each) { return each.bytes > most_mat_bytes; })) {
        return file.failure(
            Phrase::tr("a MAT file has room for 4 GiB in each variable, which %1 windows exceed; "
                       "HDF5, NPZ and CSV have room for any number",
                       {count_arg(static_cast<std::int64_t>(columns.rows()))}));
    }
    TRY(file.write(mat_file_head()));
    for (const TrackArray& array : arrays) {
        TRY(file.write(array.text_bytes == 0
                           ? mat_column_head(array.name, array.rows)
                           : mat_cells_head(array.name, array.rows, array.bytes)));
        TRY(array.pass(into(file)));
    }
    return {};
}

// Writes a track as NPZ, not packed: a float64 array per column, the flags and the header's lines
// as arrays of texts of fixed width (NumPy's U). Errors: output_failed, interrupted, those of
// TrackColumns.
Status write_track_npz(OutputFile& file, const TrackColumns& columns,
                       std::span<const std::string> header) {
    const auto arrays = TRY(arrays_of(columns, header, numpy_text));
    StoredZip zip(file);
    for (const TrackArray& array : arrays) {
        TRY(write_member(file, zip, array));
    }
    return zip.finish();
}

// Writes a track as HDF5: a contiguous float64 dataset per column in the root group, the flags and
// the header's lines as texts of fixed width in UTF-8. Errors: output_failed, also where libhdf5
// cannot be loaded; interrupted; those of TrackColumns.
Status write_track_hdf5(OutputFile& file, const TrackColumns& columns,
                        std::span<const std::string> header) {
    const auto arrays =
        TRY(arrays_of(columns, header, [](const std::string& text) { return text; }));
    const auto layout =
        TRY(layout_of(file, header.empty() ? "" : header.front(), {arrays.begin(), arrays.end()}));
    // The layout's own bytes are before and between the arrays, in order.
    std::int64_t at = 0;
    const auto write_up_to = [&](std::int64_t place) {
        const auto size = static_cast<std::size_t>(place - at);
        std::string own(layout.bytes, std::min(static_cast<std::size_t>(at), layout.bytes.size()),
                        size);
        own.resize(size);
        at = place;
        return file.write(own);
    };
    for (std::size_t k = 0; k < arrays.size(); ++k) {
        if (arrays[k].rows == 0) {
            continue;  // has no place
        }
        TRY(write_up_to(layout.places[k]));
        at += arrays[k].bytes;
        TRY(arrays[k].pass(into(file)));
    }
    return write_up_to(layout.size);
}

// Rows that one task writes as text, a quarter of a megabyte.
constexpr std::size_t rows_per_block = 1024;
// Blocks converted to text in parallel and then written, some megabytes.
constexpr std::size_t blocks_at_once = 32;

std::string head_text(std::span<const std::string> header) {
    std::string text;
    for (const std::string& line : header) {
        text += "# " + line + "\n";
    }
    for (std::size_t column = 0; column < track_number_columns; ++column) {
        text += track_column_name(column) + ",";
    }
    return text + flag_column_name + "\n";
}

// Upper limit of the length of a row.
constexpr std::size_t longest_row =
    track_number_columns * (longest_round_trip + 1) + longest_flags_text + 1;

using Columns = std::array<std::span<const double>, track_number_columns>;

Columns columns_of(const Track& track) {
    Columns columns;
    for (std::size_t k = 0; k < columns.size(); ++k) {
        columns[k] = track_column(track, k);
    }
    return columns;
}

char* write_row(char* to, const Columns& columns, Flags flags, std::size_t row) {
    for (const std::span<const double> column : columns) {
        to = write_round_trip(to, column[row]);
        *to++ = ',';
    }
    if (flags != 0) {
        to = std::ranges::copy(flags_text(flags), to).out;
    }
    *to++ = '\n';
    return to;
}

// Passes the rows to write(text, rows so far), some at a time. All threads convert digits, because
// these take most of the time of a track.
template <class Write>
Status write_rows(const Track& track, Write write) {
    const std::size_t blocks = (track.rows() + rows_per_block - 1) / rows_per_block;
    const std::size_t at_once = std::min(blocks, blocks_at_once);
    const Columns columns = columns_of(track);
    std::vector<std::unique_ptr<char[]>> rooms(at_once);  // allocated once and never cleared
    std::vector<std::string_view> written(at_once);
    const auto end_of = [&](std::size_t block) {
        return std::min((block + 1) * rows_per_block, track.rows());
    };
    for (std::size_t first = 0; first < blocks; first += at_once) {
        const std::size_t count = std::min(at_once, blocks - first);
        // Isolated: a thread that waits here must not begin to estimate or to read.
        tbb::this_task_arena::isolate([&] {
            tbb::parallel_for(std::size_t{0}, count, [&](std::size_t k) {
                if (!rooms[k]) {
                    rooms[k].reset(new char[rows_per_block * longest_row]);
                }
                char* to = rooms[k].get();
                for (std::size_t row = (first + k) * rows_per_block; row < end_of(first + k);
                     ++row) {
                    to = write_row(to, columns, track.flags()[row], row);
                }
                written[k] = {rooms[k].get(), static_cast<std::size_t>(to - rooms[k].get())};
            });
        });
        for (std::size_t k = 0; k < count; ++k) {
            TRY(write(written[k], end_of(first + k)));
        }
    }
    return {};
}

Status write_track_csv(OutputFile& file, const TrackColumns& columns,
                       std::span<const std::string> header, const JobControl& job) {
    TRY(file.write(head_text(header)));
    std::size_t before = 0;
    return columns.whole_rows(rows_per_block * blocks_at_once, [&](const Track& track) {
        const Status written = write_rows(track, [&](std::string_view text, std::size_t done) {
            job.report(static_cast<double>(before + done) / static_cast<double>(columns.rows()));
            return file.write(text);
        });
        before += track.rows();
        return written;
    });
}

}  // namespace

std::vector<std::string> track_header(const std::string& program, const std::filesystem::path& log,
                                      const std::string& sha256, const LogChoice& choice,
                                      const AnalysisSummary& analysis) {
    std::vector<std::string> lines{program, "input: " + plain_text(log.filename().string()),
                                   "sha256: " + sha256};
    IdentifySettings settings;
    settings.signal = analysis.settings;
    settings.logs = choice;
    settings.windows.window = analysis.plan.length;
    for (const auto& [name, value] : settings_list(settings)) {
        constexpr std::array of_both{"window", "from", "to", "kappa", "delay", "f0", "angle-zero"};
        if (std::ranges::find(of_both, name) != of_both.end() ||
            row_named(log_settings(), name) != nullptr) {
            lines.push_back(name + ": " + value);
        }
    }
    add_results(analysis, lines);
    return lines;
}

std::vector<std::string> track_header(const std::string& program, const Recording& recording,
                                      const std::string& sha256, const AnalysisSummary& analysis) {
    std::vector<std::string> lines{
        program,
        "input: " + plain_text(recording.path.filename().string()),
        "sha256: " + sha256,
        "rate: " + round_trip_text(recording.rate_hz) + " (" +
            rate_origin_name(recording.rate_from) + ")",
        "channels: " + integer_text(recording.channel_c) + "," + integer_text(recording.channel_d),
    };
    if (recording.rate_relative_sd > 0) {
        lines.push_back("rate_relative_sd: " + short_text(recording.rate_relative_sd, 3));
    }
    if (!recording.read_with.empty()) {
        lines.push_back("read with: " + recording.read_with);
    }
    for (const auto& [name, value] : settings_list(analysis.settings)) {
        lines.push_back(name + ": " + value);
    }
    add_results(analysis, lines);
    return lines;
}

Result<TrackFormat> track_format(const std::filesystem::path& target) {
    const std::string ending = file_ending(target);
    if (ending == ".npy") {
        return Error{
            ErrorCode::output_failed,
            target.string(),
            {Phrase::tr("a NumPy file has room for one array only; let its name end in .npz")}};
    }
    TRY(check_ending(target, {"", ".csv", ".txt", ".mat", ".h5", ".hdf5", ".npz"}));
    return ending == ".mat"                       ? TrackFormat::mat
           : ending == ".h5" || ending == ".hdf5" ? TrackFormat::hdf5
           : ending == ".npz"                     ? TrackFormat::npz
                                                  : TrackFormat::csv;
}

Status write_track(OutputFile& file, TrackFormat format, const TrackColumns& columns,
                   std::span<const std::string> header, const JobControl& job) {
    const std::vector<std::string> lines = single_lines(header);
    switch (format) {
        case TrackFormat::csv: return write_track_csv(file, columns, lines, job);
        case TrackFormat::mat: return write_track_mat(file, columns, lines);
        case TrackFormat::hdf5: return write_track_hdf5(file, columns, lines);
        case TrackFormat::npz: break;
    }
    return write_track_npz(file, columns, lines);
}

Status write_track(OutputFile& file, TrackFormat format, const Track& track,
                   std::span<const std::string> header, const JobControl& job) {
    return write_track(file, format, MemoryColumns(track), header, job);
}

}  // namespace vybeg
