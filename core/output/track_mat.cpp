#include "core/output/track_mat.h"

#include "core/output/array_heads.h"
#include "core/output/flag_cells.h"
#include "core/output/raw_bytes.h"

namespace vybeg {

Status write_track_mat(OutputFile& file, const TrackColumns& columns,
                       std::span<const std::string> header) {
    const auto counts = TRY(count_flags(columns));
    const FlagCells cells = make_cells(counts, mat_text_cell);
    std::int64_t cell_bytes = 0;
    for (const auto& [flags, rows] : counts) {
        cell_bytes += static_cast<std::int64_t>(rows * cells.at(flags).size());
    }
    const auto rows = static_cast<std::int64_t>(columns.rows());
    if (rows > most_mat_rows || cell_bytes > most_mat_bytes) {
        return file.failure(words(VYBEG_MESSAGE("Words",
                                                "a MAT file has room for 4 GiB in each variable, "
                                                "which %1 windows exceed; HDF5, NPZ and CSV have "
                                                "room for any number"),
                                  {count_arg(rows)}));
    }
    TRY(file.write(mat_file_head()));
    for (std::size_t k = 0; k < track_number_columns; ++k) {
        TRY(file.write(mat_column_head(track_column_name(k), rows)));
        TRY(columns.numbers(
            k, [&file](std::span<const double> values) { return file.write(bytes_of(values)); }));
    }
    TRY(file.write(mat_cells_head(flag_column_name, rows, cell_bytes)));
    TRY(pass_cells(columns, cells, [&file](std::string_view bytes) { return file.write(bytes); }));
    std::string lines;
    for (const std::string& line : header) {
        lines += mat_text_cell(line);
    }
    const std::string head = mat_cells_head(header_name, static_cast<std::int64_t>(header.size()),
                                            static_cast<std::int64_t>(lines.size()));
    return file.write(head + lines);
}

}  // namespace vybeg
