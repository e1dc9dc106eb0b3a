#include "core/output/track_hdf5.h"

#include "core/hdf5/hdf5_layout.h"
#include "core/output/flag_cells.h"
#include "core/output/raw_bytes.h"

#include <algorithm>
#include <cstdint>
#include <dlfcn.h>
#include <filesystem>
#include <mutex>
#include <string_view>
#include <system_error>
#include <vector>

namespace vybeg {
namespace {

// libhdf5 and what it needs take longer to load than the whole program to start: it lies in a
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
        return file.failure(words(VYBEG_MESSAGE("Words", "libhdf5 cannot be loaded (%1)"),
                                  {reason == nullptr ? "" : reason}));
    }
    Hdf5Layout layout;
    if (!make(program, arrays, layout)) {
        return file.failure(words(VYBEG_MESSAGE("Words", "libhdf5 reports an error")));
    }
    return layout;
}

// Writes the layout's own bytes, which stand before and between the arrays, in order.
class LayoutBytes {
public:
    LayoutBytes(OutputFile& file, const Hdf5Layout& layout) : file_(file), layout_(layout) {}

    // Those up to `place`.
    Status write_up_to(std::int64_t place) {
        const auto end = static_cast<std::size_t>(place);
        const std::string_view own = layout_.bytes;
        std::string piece(own.substr(std::min(at_, own.size()), end - at_));
        piece.resize(end - at_, '\0');
        at_ = end;
        return file_.write(piece);
    }
    void skip(std::int64_t bytes) { at_ += static_cast<std::size_t>(bytes); }

private:
    OutputFile& file_;
    const Hdf5Layout& layout_;
    std::size_t at_ = 0;
};

std::string padded(std::string text, std::size_t width) {
    text.resize(width, '\0');
    return text;
}

}  // namespace

Status write_track_hdf5(OutputFile& file, const TrackColumns& columns,
                        std::span<const std::string> header) {
    const auto counts = TRY(count_flags(columns));
    const auto rows = static_cast<std::int64_t>(columns.rows());
    std::vector<Hdf5Array> arrays;
    for (std::size_t k = 0; k < track_number_columns; ++k) {
        arrays.push_back({track_column_name(k), rows, 0, track_column_unit(k)});
    }
    const std::size_t width = longest_text(counts);
    arrays.push_back({flag_column_name, rows, static_cast<std::int64_t>(width)});
    std::size_t longest = 1;
    for (const std::string& line : header) {
        longest = std::max(longest, line.size());
    }
    arrays.push_back({header_name, static_cast<std::int64_t>(header.size()),
                      static_cast<std::int64_t>(longest)});
    const auto layout = TRY(layout_of(file, header.empty() ? "" : header.front(), arrays));
    LayoutBytes own(file, layout);
    const FlagCells cells =
        make_cells(counts, [width](const std::string& text) { return padded(text, width); });
    for (std::size_t k = 0; k < arrays.size(); ++k) {
        if (arrays[k].rows == 0) {
            continue;  // has no place
        }
        TRY(own.write_up_to(layout.places[k]));
        own.skip(arrays[k].bytes());
        if (k < track_number_columns) {
            TRY(columns.numbers(k, [&file](std::span<const double> values) {
                return file.write(bytes_of(values));
            }));
        } else if (k == track_number_columns) {
            TRY(pass_cells(columns, cells,
                           [&file](std::string_view bytes) { return file.write(bytes); }));
        } else {
            for (const std::string& line : header) {
                TRY(file.write(padded(line, longest)));
            }
        }
    }
    return own.write_up_to(layout.size);
}

}  // namespace vybeg
