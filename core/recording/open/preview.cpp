#include "core/recording/open/preview.h"

#include "core/base/number_text.h"
#include "core/recording/arrays/raw_reader.h"
#include "core/recording/bytes/file_bytes.h"
#include "core/recording/bytes/number_type.h"
#include "core/recording/bytes/text_encoding.h"
#include "core/recording/samples/open_table.h"
#include "core/recording/samples/reader_rules.h"
#include "core/recording/samples/sample_source.h"
#include "core/recording/samples/text_fields.h"
#include "core/recording/text/text_lines.h"
#include "core/recording/text/text_reading.h"
#include "core/recording/text/text_recording.h"

#include <algorithm>
#include <limits>
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

// Reads the first rows. Errors: file_read_failed; a fault in them.
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
                return fault_error(
                    file, lines,
                    time_fault(rows.lines(), rows.time(), before / table.format.time_unit_s));
            }
        }
        if (rows.fault()) {
            return fault_error(file, lines, *rows.fault());
        }
        lines += rows.lines();
    }
    return {};
}

Status read_table(const std::shared_ptr<const FileBytes>& file, const OpenOptions& options,
                  RecordingPreview& preview) {
    const TextFormat& format = *preview.used;
    const std::vector<int> columns = channel_columns(format);
    TRY(check_channels(*file, static_cast<int>(columns.size()), options));
    preview.c_column = columns[static_cast<std::size_t>(options.channel_c - 1)];
    preview.d_column = columns[static_cast<std::size_t>(options.channel_d - 1)];
    const auto table = TRY(table_for(file, format, options));
    return read_rows(table, preview);
}

// Errors of what the file holds, which other options may read, are the preview's problem.
Status take_problem(const Status& read, RecordingPreview& preview) {
    if (!read && (read.error().code == ErrorCode::file_read_failed ||
                  read.error().code == ErrorCode::interrupted)) {
        return read;
    }
    if (!read) {
        preview.problem = read.error();
    }
    return {};
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
    const double stated_hz = named ? preview.used->rates[c].hz : 0;
    if (!preview.problem && preview.time_column >= 0 && preview.rate_hz && stated_hz > 0 &&
        !options.rate_hz && !same_written_rate(stated_hz, *preview.rate_hz, 1e-2)) {
        preview.problem = file.error(ErrorCode::rates_differ,
                                     {number_arg(stated_hz), number_arg(*preview.rate_hz)});
    }
    const Status frames = check_frames(file, std::ssize(preview.c));
    if (!preview.problem && !frames) {
        preview.problem = frames.error();
    }
}

// Fills `preview` from the beginning of a text file under options.text. Errors: file_read_failed,
// interrupted; faults of the text are in preview.problem.
Status preview_text(std::shared_ptr<const FileBytes> file, const OpenOptions& options,
                    const JobControl& job, RecordingPreview& preview) {
    const TextChoice choice = options.text.value_or(TextChoice{});
    const auto start = read_text_head(file, {}, job);
    const auto head =
        choice.lines_to_skip ? read_text_head(file, choice.lines_to_skip, job) : start;
    if (!start || !head) {
        return take_problem(start ? head.error() : start.error(), preview);
    }
    preview.guessed = guess_text_format(start->lines);
    auto used = find_text_format(*file, *head, choice);
    preview.lines = lines_of(*head, used ? &*used : nullptr);
    if (!used) {
        return take_problem(used.error(), preview);
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
    preview.columns = preview.used->headings;
    TRY(take_problem(read_table(file, options, preview), preview));
    find_rate(*file, options, preview);
    scale_samples(preview.c, options.scale);
    scale_samples(preview.d, options.scale);
    return {};
}

constexpr int most_raw_columns = 64;  // of a raw file, in the table
constexpr int cell_digits = 9;

// Reads the first frames of an open recording.
Status take_samples(const Recording& recording, RecordingPreview& preview) {
    const auto frames = std::min(static_cast<std::size_t>(recording.frames()), preview_frames);
    preview.c.resize(frames);
    preview.d.resize(frames);
    return recording.source->read(0, preview.c, preview.d);
}

// Fills the table with so many frames of all columns.
template <class Value>
void take_cells(std::size_t frames, Value value, RecordingPreview& preview) {
    for (std::size_t frame = 0; frame < frames; ++frame) {
        PreviewLine line{static_cast<std::int64_t>(frame), true, {}};
        for (std::size_t k = 0; k < preview.columns.size(); ++k) {
            line.cells.push_back(short_text(value(frame, k), cell_digits));
        }
        preview.lines.push_back(std::move(line));
    }
}

// Fills the table with every channel, from the bytes.
Status take_raw_cells(const FileBytes& file, const OpenOptions& options,
                      RecordingPreview& preview) {
    const RawLayout& layout = *options.raw;
    const NumberType type = number_type(layout.type);
    const auto width = static_cast<std::size_t>(bytes_of(type));
    const auto channels = static_cast<std::size_t>(layout.channels);
    std::string bytes(preview_lines * channels * width, '\0');
    const auto got = TRY(file.read(layout.skip_bytes, bytes));
    const std::size_t frames = static_cast<std::size_t>(got) / (channels * width);
    std::vector<double> values(frames * channels);
    if (!values.empty()) {
        decode(type, layout.big_endian, bytes.data(), static_cast<std::int64_t>(width),
               {options.scale, 0}, values);
    }
    preview.columns.resize(std::min<std::size_t>(channels, most_raw_columns));
    take_cells(
        frames, [&](std::size_t frame, std::size_t k) { return values[frame * channels + k]; },
        preview);
    return {};
}

// Preview of other files, through their reader. A file without rate is opened with an arbitrary
// one, so that its samples are visible.
Status preview_opened(const FileBytes& file, const OpenOptions& options, const JobControl& job,
                      RecordingPreview& preview) {
    OpenOptions rated = options;
    rated.rate_hz = options.rate_hz.value_or(1);
    const auto recording = open_recording(file.path(), rated, job);
    if (!recording) {
        if (recording.error().code == ErrorCode::interrupted) {
            return recording.error();
        }
        preview.problem = recording.error();
        return {};
    }
    preview.format = recording->format;
    preview.channels = recording->channels;
    if (recording->rate_from != RateOrigin::option || options.rate_hz) {
        preview.rate_hz = recording->rate_hz;
    } else {
        preview.problem = file.error(ErrorCode::rate_unknown);
    }
    TRY(take_samples(*recording, preview));
    if (!options.raw) {
        preview.columns = {recording->channel(recording->channel_c),
                           recording->channel(recording->channel_d)};
        preview.c_column = 0;
        preview.d_column = 1;
        take_cells(
            std::min(preview.c.size(), preview_lines),
            [&](std::size_t frame, std::size_t k) {
                return k == 0 ? preview.c[frame] : preview.d[frame];
            },
            preview);
        return {};
    }
    Status status = take_raw_cells(file, options, preview);
    for (std::size_t k = 0; k < preview.columns.size(); ++k) {
        preview.columns[k] = recording->channels[k];
    }
    preview.c_column = recording->channel_c - 1;
    preview.d_column = recording->channel_d - 1;
    return status;
}

}  // namespace

Result<RecordingPreview> preview_recording(const std::filesystem::path& path,
                                           const OpenOptions& options, const JobControl& job) {
    TRY(check_options(options));
    const auto file = TRY(FileBytes::open(path));
    const auto head = TRY(file_head(*file));
    RecordingPreview preview;
    preview.file_format = find_format(head, *file);
    // Of several files only what comes of them is shown.
    const bool text =
        further_files(options).empty() &&
        (options.text || (!options.raw && preview.file_format && preview.file_format->is_text()));
    TRY(text ? preview_text(file, options, job, preview)
             : preview_opened(*file, options, job, preview));
    if (!options.unit.empty()) {
        for (auto* const named : {&preview.channels, &preview.columns}) {
            for (Channel& channel : *named) {
                channel.unit = options.unit;
            }
        }
    }
    return preview;
}

namespace {

constexpr std::int64_t most_text_parts = 1024;
// Shorter text files open so fast that a first look is useless.
constexpr std::int64_t blocks_to_look_at = 256;
constexpr std::size_t rows_per_look = 256;

constexpr std::size_t all_rows = std::numeric_limits<std::size_t>::max();

// The first rows of a block, at most `most`; empty for a fault or no row.
std::optional<TimedSamples> rows_of(const TextTable& table, std::int64_t index, std::size_t most) {
    TextBlock block;
    TimedSamples rows;
    const bool read = table.blocks.read(index, block) && append_rows(table, block, most, rows);
    return read && !rows.c.empty() ? std::optional(std::move(rows)) : std::nullopt;
}

// Extent of a table, from its ends.
struct Extent {
    double rate_hz = 0;
    double frames = 0;
    double first_s = 0;
    double last_s = 0;
};

std::optional<Extent> extent_of(const TextTable& table, const OpenOptions& options) {
    const std::int64_t last = table.blocks.count() - 1;
    const auto head = rows_of(table, 0, all_rows);
    auto tail = rows_of(table, last, all_rows);
    if (!tail) {
        tail = rows_of(table, last - 1, all_rows);
    }
    if (!head || !tail || head->c.size() < 2) {
        return {};
    }
    Extent extent;
    if (table.columns.time < 0) {
        const auto c = static_cast<std::size_t>(table.columns.c);
        const std::vector<SampleRate>& named = table.format.rates;
        extent.rate_hz = named.empty() ? options.rate_hz.value_or(0) : named[c].hz;
        extent.frames = static_cast<double>(head->c.size()) * static_cast<double>(last + 1);
        return extent;
    }
    extent.first_s = head->time_s.front();
    extent.last_s = tail->time_s.back();
    extent.rate_hz =
        static_cast<double>(head->time_s.size() - 1) / (head->time_s.back() - extent.first_s);
    extent.frames = (extent.last_s - extent.first_s) * extent.rate_hz + 1;
    return extent;
}

std::optional<QuickOverview> look_at_table(const TextTable& table, const OpenOptions& options,
                                           const JobControl& job) {
    const std::int64_t blocks = table.blocks.count();
    if (blocks < blocks_to_look_at) {
        return {};
    }
    const auto extent = extent_of(table, options);
    // More frames than characters are impossible for uniform times.
    const double most_frames = static_cast<double>(table.blocks.file().size());
    if (!extent || !(extent->rate_hz > 0) || !(extent->frames >= 1) ||
        extent->frames > most_frames) {
        return {};
    }
    const auto look = [&](std::int64_t part, std::int64_t parts) -> Result<ScannedPlace> {
        auto rows = rows_of(table, blocks * part / parts, rows_per_look);
        if (!rows) {
            return table.blocks.file().error(ErrorCode::file_read_failed);
        }
        scale_samples(rows->c, options.scale);
        scale_samples(rows->d, options.scale);
        ScannedPlace seen{static_cast<double>(part) / static_cast<double>(parts),
                          bucket_of(rows->c, rows->d)};
        if (table.columns.time >= 0) {
            seen.place =
                (rows->time_s.front() - extent->first_s) / (extent->last_s - extent->first_s);
        }
        return seen;
    };
    auto seen = sparse_scan(std::min(most_text_parts, blocks), job, look);
    if (!seen || seen->empty()) {
        return {};
    }
    const auto frames = static_cast<std::int64_t>(extent->frames);
    return QuickOverview{extent->rate_hz, sampled_envelope(frames, std::move(*seen))};
}

}  // namespace

std::optional<QuickOverview> quick_overview(const std::filesystem::path& path,
                                            const OpenOptions& options, const JobControl& job) {
    const auto file = FileBytes::open(path);
    if (options.raw || !file) {
        return {};
    }
    const auto head = file_head(**file);
    const FileFormat* const format = head ? find_format(*head, **file) : nullptr;
    if (!format || !format->is_text()) {
        return {};
    }
    const auto table = choose_table(*file, options, job);
    return table ? look_at_table(*table, options, job) : std::nullopt;
}

}  // namespace vybeg
