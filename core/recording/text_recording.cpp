#include "core/recording/text_recording.h"

#include "core/base/number_text.h"
#include "core/recording/memory_source.h"
#include "core/recording/selection.h"
#include "core/recording/text_lines.h"
#include "core/recording/text_reader.h"

#include <cmath>
#include <optional>
#include <utility>
#include <vector>

namespace vybeg {
namespace {

constexpr std::size_t head_bytes = std::size_t{1} << 18;  // what the format is guessed from

Result<std::optional<TextFormat>> guess_from_head(const std::shared_ptr<const FileBytes>& file) {
    TextLines lines(file);
    std::vector<std::string> head;
    for (std::size_t bytes = 0; bytes < head_bytes;) {
        const auto line = lines.next();
        if (!line) {
            return line.error();
        }
        if (!*line) {
            break;
        }
        head.emplace_back(**line);
        bytes += (*line)->size() + 1;
    }
    return guess_text_format(head);
}

// The columns that are channels, from 0: all but the time and the counter.
std::vector<int> channel_columns(const TextFormat& format) {
    std::vector<int> columns;
    for (int column = 0; column < format.columns; ++column) {
        if (column != format.time_column && column != format.counter_column) {
            columns.push_back(column);
        }
    }
    return columns;
}

void describe(const TextFormat& format, const std::vector<int>& columns, Recording& recording) {
    recording.format = format_text(format);
    for (const int column : columns) {
        const auto i = static_cast<std::size_t>(column);
        const std::string number = std::to_string(recording.channels.size() + 1);
        recording.channels.push_back(
            {format.names[i].empty() ? number : format.names[i], format.units[i]});
    }
}

// Gives the recording its rate, samples and diagnostics.
Status take_table(const FileBytes& file, TextTable table, const OpenOptions& options,
                  Recording& recording) {
    const auto rows = static_cast<std::int64_t>(table.rows.c.size());
    if (const Status status = check_frames(file, rows); !status) {
        return status;
    }
    std::int64_t first_missing = table.first_missing_row;
    std::optional<SampleRate> own;
    if (!table.rows.time_s.empty()) {
        auto grid = to_uniform_grid(table.rows, file.path().string());
        if (!grid) {
            return grid.error();
        }
        own = SampleRate{grid->rate_hz, RateOrigin::time_column};
        if (first_missing >= 0) {
            const std::vector<double>& times = table.rows.time_s;
            const double after = times[static_cast<std::size_t>(first_missing)] - times[0];
            first_missing = static_cast<std::int64_t>(std::floor(after * grid->rate_hz + 0.5));
        }
        table.rows.c = std::move(grid->c);
        table.rows.d = std::move(grid->d);
        recording.diagnostics = std::move(grid->diagnostics);
    }
    const auto rate = choose_rate(file, own, options);
    if (!rate) {
        return rate.error();
    }
    recording.rate_hz = rate->hz;
    recording.rate_from = rate->from;
    if (table.missing_samples > 0) {
        recording.diagnostics.push_back({DiagnosticKind::missing_samples,
                                         {integer_text(table.missing_samples)},
                                         first_missing,
                                         table.rows_with_missing});
    }
    if (table.lines_ignored > 0) {
        recording.diagnostics.push_back(
            {DiagnosticKind::text_lines_ignored, {integer_text(table.lines_ignored)}, -1, 0});
    }
    recording.source =
        std::make_shared<MemorySource>(std::move(table.rows.c), std::move(table.rows.d));
    return {};
}

}  // namespace

Result<Recording> open_text(std::shared_ptr<const FileBytes> file, const OpenOptions& options,
                            const JobControl& job) {
    const auto guess = guess_from_head(file);
    if (!guess) {
        return guess.error();
    }
    if (!*guess) {
        return file->error(ErrorCode::text_no_data);
    }
    const TextFormat& format = **guess;
    const std::vector<int> columns = channel_columns(format);
    if (const Status status = check_channels(*file, static_cast<int>(columns.size()), options);
        !status) {
        return status.error();
    }
    if (format.time_column < 0 && !options.rate_hz) {
        return file->error(ErrorCode::rate_unknown);  // before the work of reading it
    }
    Recording recording;
    recording.path = file->path();
    recording.channel_c = options.channel_c;
    recording.channel_d = options.channel_d;
    describe(format, columns, recording);
    auto table =
        read_text_table(file, format, columns[static_cast<std::size_t>(options.channel_c - 1)],
                        columns[static_cast<std::size_t>(options.channel_d - 1)], job);
    if (!table) {
        return table.error();
    }
    if (const Status status = take_table(*file, std::move(*table), options, recording); !status) {
        return status.error();
    }
    return recording;
}

}  // namespace vybeg
