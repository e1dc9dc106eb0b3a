#include "core/recording/text_recording.h"

#include "core/base/number_text.h"
#include "core/recording/memory_source.h"
#include "core/recording/selection.h"
#include "core/recording/text_lines.h"
#include "core/recording/text_scan.h"
#include "core/recording/text_source.h"
#include "core/recording/text_table.h"

#include <algorithm>
#include <cmath>
#include <iterator>
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

std::vector<TimeGap> gaps_of(const EvenTimes& even) {
    std::vector<TimeGap> gaps;
    for (std::size_t s = 1; s < even.stretches.size(); ++s) {
        const RowStretch& before = even.stretches[s - 1];
        const TimeGap gap{before.first_frame + before.rows - 1, even.stretches[s].first_frame};
        if (gap.after > gap.before + 1) {
            gaps.push_back(gap);
        }
    }
    return gaps;
}

std::int64_t frame_of(const EvenTimes& even, std::int64_t row) {
    const auto behind = std::ranges::upper_bound(even.stretches, row, {}, &RowStretch::first_row);
    const RowStretch& stretch = *std::prev(behind);
    return stretch.first_frame + row - stretch.first_row;
}

// Samples whose time or place tells their frame, and what is known of them.
struct Samples {
    std::shared_ptr<const SampleSource> source;
    std::optional<SampleRate> rate;
    std::int64_t first_missing = -1;  // frame
    std::vector<Diagnostic> diagnostics;
};

Samples streamed(TextTable table, TextScan scan) {
    Samples samples;
    samples.first_missing = scan.first_missing_row;
    if (scan.even) {
        samples.rate = SampleRate{scan.even->rate_hz, RateOrigin::time_column};
        report_gaps(gaps_of(*scan.even), scan.even->rate_hz, samples.diagnostics);
        if (samples.first_missing >= 0) {
            samples.first_missing = frame_of(*scan.even, samples.first_missing);
        }
    }
    samples.source = text_source(std::move(table), std::move(scan));
    return samples;
}

// Uneven times are brought onto a grid, which takes all of them at once.
Result<Samples> resampled(const TextTable& table, const TextScan& scan, const JobControl& job) {
    const auto rows = read_timed_rows(table, scan, job);
    if (!rows) {
        return rows.error();
    }
    auto grid = to_uniform_grid(*rows, table.blocks.file().path().string());
    if (!grid) {
        return grid.error();
    }
    Samples samples;
    samples.rate = SampleRate{grid->rate_hz, RateOrigin::time_column};
    if (scan.first_missing_row >= 0) {
        const double after =
            rows->time_s[static_cast<std::size_t>(scan.first_missing_row)] - rows->time_s[0];
        samples.first_missing = static_cast<std::int64_t>(std::floor(after * grid->rate_hz + 0.5));
    }
    samples.diagnostics = std::move(grid->diagnostics);
    samples.source = std::make_shared<MemorySource>(std::move(grid->c), std::move(grid->d));
    return samples;
}

// Gives the recording its rate, samples and diagnostics.
Status take_table(const FileBytes& file, TextTable table, const OpenOptions& options,
                  const JobControl& job, Recording& recording) {
    auto scan = scan_text(table, job);
    if (!scan) {
        return scan.error();
    }
    if (const Status status = check_frames(file, scan->rows()); !status) {
        return status;
    }
    const std::int64_t missing = scan->missing_samples;
    const std::int64_t rows_with_missing = scan->rows_with_missing;
    const std::int64_t lines_ignored =
        table.header_lines + scan->lines_ignored - table.format.header_lines_used;
    const bool uneven = table.columns.time >= 0 && !scan->even;
    auto samples = uneven ? resampled(table, *scan, job)
                          : Result(streamed(std::move(table), std::move(*scan)));
    if (!samples) {
        return samples.error();
    }
    const auto rate = choose_rate(file, samples->rate, options);
    if (!rate) {
        return rate.error();
    }
    recording.rate_hz = rate->hz;
    recording.rate_from = rate->from;
    recording.diagnostics = std::move(samples->diagnostics);
    if (missing > 0) {
        recording.diagnostics.push_back({DiagnosticKind::missing_samples,
                                         {integer_text(missing)},
                                         samples->first_missing,
                                         rows_with_missing});
    }
    if (lines_ignored > 0) {
        recording.diagnostics.push_back(
            {DiagnosticKind::text_lines_ignored, {integer_text(lines_ignored)}, -1, 0});
    }
    recording.source = std::move(samples->source);
    return {};
}

}  // namespace

Result<ChosenTable> choose_table(const std::shared_ptr<const FileBytes>& file,
                                 const OpenOptions& options) {
    const auto guess = guess_from_head(file);
    if (!guess) {
        return guess.error();
    }
    if (!*guess) {
        return file->error(ErrorCode::text_no_data);
    }
    const TextFormat& format = **guess;
    std::vector<int> columns = channel_columns(format);
    if (const Status status = check_channels(*file, static_cast<int>(columns.size()), options);
        !status) {
        return status.error();
    }
    if (format.time_column < 0 && !options.rate_hz) {
        return file->error(ErrorCode::rate_unknown);  // before the work of reading it
    }
    auto table = find_table(file, format,
                            {.time = format.time_column,
                             .c = columns[static_cast<std::size_t>(options.channel_c - 1)],
                             .d = columns[static_cast<std::size_t>(options.channel_d - 1)]});
    if (!table) {
        return table.error();
    }
    return ChosenTable{std::move(*table), std::move(columns)};
}

Result<Recording> open_text(std::shared_ptr<const FileBytes> file, const OpenOptions& options,
                            const JobControl& job) {
    auto chosen = choose_table(file, options);
    if (!chosen) {
        return chosen.error();
    }
    Recording recording;
    recording.path = file->path();
    recording.channel_c = options.channel_c;
    recording.channel_d = options.channel_d;
    describe(chosen->table.format, chosen->channels, recording);
    if (const Status status = take_table(*file, std::move(chosen->table), options, job, recording);
        !status) {
        return status.error();
    }
    return recording;
}

}  // namespace vybeg
