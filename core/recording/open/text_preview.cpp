#include "core/recording/open/text_preview.h"

#include "core/base/number_text.h"
#include "core/recording/bytes/text_encoding.h"
#include "core/recording/samples/reader_rules.h"
#include "core/recording/samples/scaled_source.h"
#include "core/recording/samples/text_fields.h"
#include "core/recording/text/text_head.h"
#include "core/recording/text/text_recording.h"
#include "core/recording/text/text_rows.h"
#include "core/recording/text/text_table.h"

#include <algorithm>
#include <utility>

namespace vybeg {
namespace {

constexpr std::int64_t skipped_shown = 6;  // lines above the first row
constexpr std::size_t longest_cell = 200;  // bytes
constexpr std::int64_t most_blocks = 16;   // of 128 KiB, searched for the first rows

std::string shown(std::string_view text) {
    return to_utf8(text.substr(0, longest_cell));
}

// Lines around the first row; without a format none is a row.
std::vector<PreviewLine> lines_of(const TextHead& head, const TextFormat* format) {
    const std::int64_t first_row = format ? format->lines_to_skip - head.dropped : 0;
    std::vector<PreviewLine> lines;
    std::vector<std::string_view> fields;
    for (std::int64_t i = std::max<std::int64_t>(first_row - skipped_shown, 0);
         i < std::ssize(head.lines) && lines.size() < preview_lines; ++i) {
        const std::string& text = head.lines[static_cast<std::size_t>(i)];
        PreviewLine line{head.dropped + i + 1, false, {}};
        if (format && i >= first_row && !is_comment(text, format->delimiter)) {
            split_fields(text, format->delimiter, fields);
            line.is_row = !fields.empty() && std::ssize(fields) <= format->columns;
        }
        if (line.is_row) {
            std::ranges::transform(fields, std::back_inserter(line.cells), shown);
        } else {
            line.cells.push_back(shown(text));
        }
        lines.push_back(std::move(line));
    }
    return lines;
}

// Reads the first rows; a fault in them becomes the problem.
Status read_rows(const TextTable& table, RecordingPreview& preview) {
    const FileBytes& file = table.blocks.file();
    std::int64_t lines = table.format.lines_to_skip;
    TextBlock block;
    const std::int64_t blocks = std::min(table.blocks.count(), most_blocks);
    for (std::int64_t index = 0; index < blocks && preview.c.size() < preview_frames; ++index) {
        TRY(table.blocks.read(index, block));
        TextRows rows(table.format, table.columns, block, SampleUse::read);
        while (preview.c.size() < preview_frames && rows.next()) {
            preview.c.push_back(rows.c());
            preview.d.push_back(rows.d());
            if (table.columns.time < 0) {
                continue;
            }
            const double before = preview.time_s.empty() ? 0 : preview.time_s.back();
            preview.time_s.push_back(rows.time() * table.format.time_unit_s);
            // Equal times are possible if their digits are coarser than the step.
            if (preview.time_s.size() > 1 && preview.time_s.back() < before) {
                preview.problem =
                    file.error(ErrorCode::text_time_backwards,
                               {count_arg(lines + rows.lines()), exact_arg(rows.time()),
                                exact_arg(before / table.format.time_unit_s)});
                return {};
            }
        }
        if (rows.fault()) {
            preview.problem = fault_error(file, lines + rows.lines(), *rows.fault());
            return {};
        }
        lines += rows.lines();
    }
    return {};
}

Status read_table(const std::shared_ptr<const FileBytes>& file, const OpenOptions& options,
                  RecordingPreview& preview) {
    const TextFormat& format = *preview.used;
    const std::vector<int> columns = channel_columns(format);
    const Status channels = check_channels(*file, static_cast<int>(columns.size()), options);
    if (!channels) {
        preview.problem = channels.error();
        return {};
    }
    preview.c_column = columns[static_cast<std::size_t>(options.channel_c - 1)];
    preview.d_column = columns[static_cast<std::size_t>(options.channel_d - 1)];
    const auto chosen = columns_for(*file, format, options);
    if (!chosen) {
        preview.problem = chosen.error();
        return {};
    }
    const auto table = TRY(find_table(file, format, *chosen));
    return read_rows(table, preview);
}

void find_rate(const FileBytes& file, const OpenOptions& options, RecordingPreview& preview) {
    const std::vector<double>& times = preview.time_s;
    const auto c = static_cast<std::size_t>(preview.c_column);
    const bool named = preview.used && c < preview.used->rates.size();
    if (preview.time_column < 0) {
        preview.rate_hz = named ? preview.used->rates[c].hz : options.rate_hz;
    } else if (times.size() > 1 && times.back() > times.front()) {
        preview.rate_hz = static_cast<double>(times.size() - 1) / (times.back() - times.front());
    }
    if (!preview.problem && preview.time_column < 0 && !preview.rate_hz) {
        preview.problem = file.error(ErrorCode::rate_unknown);
    }
    const Status frames = check_frames(file, std::ssize(preview.c));
    if (!preview.problem && !frames) {
        preview.problem = frames.error();
    }
}

}  // namespace

Status preview_text(std::shared_ptr<const FileBytes> file, const OpenOptions& options,
                    const JobControl& job, RecordingPreview& preview) {
    const TextChoice choice = options.text.value_or(TextChoice{});
    const auto start = read_text_head(file, {}, job);
    const auto head =
        choice.lines_to_skip ? read_text_head(file, choice.lines_to_skip, job) : start;
    if (!start || !head) {
        // The line is too long for a table.
        const Error error = start ? head.error() : start.error();
        if (error.code != ErrorCode::format_limit) {
            return error;
        }
        preview.problem = error;
        return {};
    }
    preview.guessed = guess_text_format(start->lines);
    auto used = find_text_format(*file, *head, choice);
    preview.lines = lines_of(*head, used ? &*used : nullptr);
    if (!used) {
        preview.problem = used.error();
        return {};
    }
    preview.used = std::move(*used);
    preview.format = format_of(*preview.used);
    preview.channels = channels_of(*preview.used);
    if (options.scale != 1) {
        for (Channel& channel : preview.channels) {
            channel.unit.clear();
        }
    }
    preview.time_column = preview.used->time_column;
    for (std::size_t i = 0; i < preview.used->names.size(); ++i) {
        preview.columns.push_back({preview.used->names[i], preview.used->units[i]});
    }
    TRY(read_table(file, options, preview));
    find_rate(*file, options, preview);
    scale_samples(preview.c, options.scale);
    scale_samples(preview.d, options.scale);
    return {};
}

}  // namespace vybeg
