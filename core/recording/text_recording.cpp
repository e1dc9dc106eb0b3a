#include "core/recording/text_recording.h"

#include "core/base/number_text.h"
#include "core/recording/memory_source.h"
#include "core/recording/scaled_source.h"
#include "core/recording/selection.h"
#include "core/recording/text_head.h"
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
    // Nobody needs to be told of lines that were said to be skipped.
    const bool said = options.text && options.text->lines_to_skip;
    const std::int64_t above = said ? 0 : table.header_lines - table.format.header_lines_used;
    const std::int64_t lines_ignored = above + scan->lines_ignored;
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

Result<TextTable> choose_table(const std::shared_ptr<const FileBytes>& file,
                               const OpenOptions& options, const JobControl& job) {
    const TextChoice choice = options.text.value_or(TextChoice{});
    const auto head = read_text_head(file, choice.lines_to_skip, job);
    if (!head) {
        return head.error();
    }
    const auto found = find_text_format(*file, *head, choice);
    if (!found) {
        return found.error();
    }
    const TextFormat& format = *found;
    const std::vector<int> columns = channel_columns(format);
    if (const Status status = check_channels(*file, static_cast<int>(columns.size()), options);
        !status) {
        return status.error();
    }
    if (format.time_column < 0 && !options.rate_hz) {
        return file->error(ErrorCode::rate_unknown);  // before the work of reading it
    }
    return find_table(file, format,
                      {.time = format.time_column,
                       .c = columns[static_cast<std::size_t>(options.channel_c - 1)],
                       .d = columns[static_cast<std::size_t>(options.channel_d - 1)]});
}

Result<Recording> open_text(std::shared_ptr<const FileBytes> file, const OpenOptions& options,
                            const JobControl& job) {
    auto table = choose_table(file, options, job);
    if (!table) {
        return table.error();
    }
    Recording recording;
    recording.path = file->path();
    recording.channel_c = options.channel_c;
    recording.channel_d = options.channel_d;
    recording.format = format_text(table->format);
    const double scale = options.text ? options.text->scale : 1;
    recording.channels = channels_of(table->format, scale);
    if (const Status status = take_table(*file, std::move(*table), options, job, recording);
        !status) {
        return status.error();
    }
    if (scale != 1) {
        recording.source = scaled_source(std::move(recording.source), scale);
    }
    return recording;
}

}  // namespace vybeg
