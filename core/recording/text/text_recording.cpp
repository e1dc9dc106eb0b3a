#include "core/recording/text/text_recording.h"

#include "core/base/plain_text.h"
#include "core/recording/samples/reader_rules.h"
#include "core/recording/samples/sample_source.h"
#include "core/recording/samples/vocabulary.h"
#include "core/recording/text/labone_rows.h"
#include "core/recording/text/text_format.h"
#include "core/recording/text/text_reading.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace vybeg {
namespace {

// Adds samples whose frame follows from their place or their even times; returns the first frame
// with a missing one, -1 without any.
std::int64_t take_rows(const TextTable& table, const TextScan& scan, FoundSamples& found) {
    found.source = text_source(table, scan);
    const std::int64_t missing = scan.left_out.first_missing_row;
    if (!scan.even) {
        return missing;
    }
    found.own_rate =
        SampleRate{scan.even->rate_hz, RateOrigin::time_column, scan.even->rate_relative_sd};
    report_gaps(scan.even->gaps(), scan.even->rate_hz, found.diagnostics);
    return missing < 0 ? missing : scan.even->frame_of(missing);
}

// The same of uneven times, which are brought onto a grid: that takes all of them at once.
Result<std::int64_t> take_resampled(const TextTable& table, const TextScan& scan,
                                    const JobControl& job, FoundSamples& found) {
    const auto rows = TRY(read_timed_rows(table, scan, job));
    auto grid = TRY(to_uniform_grid(rows, table.blocks.file().path().string()));
    found.own_rate = SampleRate{grid.rate_hz, RateOrigin::time_column, grid.rate_relative_sd};
    found.diagnostics.insert(found.diagnostics.end(), grid.diagnostics.begin(),
                             grid.diagnostics.end());
    found.source = memory_source(std::move(grid.c), std::move(grid.d));
    const std::int64_t missing = scan.left_out.first_missing_row;
    if (missing < 0) {
        return missing;
    }
    const double after = rows.time_s[static_cast<std::size_t>(missing)] - rows.time_s[0];
    return static_cast<std::int64_t>(std::floor(after * grid.rate_hz + 0.5));
}

// The rate of a table whose times have this one: that which the lines above the table name, where
// the times leave it open or are known less well. Where the two contradict each other, one counts
// in another unit, and the option says which holds. Errors: rates_differ.
Result<std::optional<SampleRate>> agreed_rate(const std::optional<SampleRate>& of_times,
                                              const TextTable& table, const OpenOptions& options) {
    if (table.format.rates.empty()) {
        return of_times;
    }
    const SampleRate& named = table.format.rates[static_cast<std::size_t>(table.columns.c)];
    if (!of_times) {
        return std::optional(named);
    }
    if (same_written_rate(named.hz, of_times->hz, of_times->relative_sd)) {
        constexpr double deviations = 3;
        constexpr double arithmetic = 1e-12;
        const double apart = std::abs(named.hz / of_times->hz - 1);
        const bool agree =
            apart <= deviations * (named.relative_sd + of_times->relative_sd) + arithmetic;
        return std::optional(agree && named.relative_sd < of_times->relative_sd ? named
                                                                                : *of_times);
    }
    for (const double hz : {of_times->hz, named.hz}) {
        if (options.rate_hz && same_written_rate(*options.rate_hz, hz, of_times->relative_sd)) {
            return std::optional(SampleRate{hz, RateOrigin::option, of_times->relative_sd});
        }
    }
    return table.blocks.file().error(ErrorCode::rates_differ,
                                     {number_arg(named.hz), number_arg(of_times->hz)});
}

// Adds rate, samples and diagnostics.
Status take_table(const std::shared_ptr<const FileBytes>& file, const TextTable& table,
                  const OpenOptions& options, const JobControl& job, FoundSamples& found) {
    const TextScan scan = TRY(scan_text(table, job));
    found.present_frames = scan.rows();
    TRY(check_frames(*file, found.present_frames));
    const LeftOut& left_out = scan.left_out;
    // Lines that were said to be skipped raise no warning.
    const bool said = options.text && options.text->lines_to_skip;
    const std::int64_t above = said ? 0 : table.header_lines - table.format.header_lines_used;
    const std::int64_t lines_ignored = above + left_out.lines_ignored + table.footer_lines;
    if (table.columns.time >= 0) {
        found.first_time_s = scan.first_time * table.format.time_unit_s +
                             static_cast<double>(table.format.clock_from_s.value_or(0));
    }
    const auto written = [&](int number, int column) {
        return Channel{found.channel(number).name, table.format.heading(column).unit};
    };
    // The rows are read with the factor; their units may have gone with --scale.
    note_units(written(options.channel_c, table.columns.c),
               written(options.channel_d, table.columns.d), found.diagnostics);
    if (table.columns.time >= 0 && !table.format.unknown_time_unit.empty()) {
        found.diagnostics.push_back(
            {DiagnosticKind::time_unit_unknown, {table.format.unknown_time_unit}});
    }
    const bool uneven = table.columns.time >= 0 && !scan.even;
    const auto first_missing = TRY(uneven ? take_resampled(table, scan, job, found)
                                          : Result(take_rows(table, scan, found)));
    const auto rate = TRY(agreed_rate(found.own_rate, table, options));
    // Samples that were brought onto a grid have its rate.
    found.own_rate = uneven ? found.own_rate : rate;
    if (left_out.missing_samples > 0) {
        found.diagnostics.push_back({DiagnosticKind::missing_samples,
                                     {count_arg(left_out.missing_samples)},
                                     first_missing,
                                     left_out.rows_with_missing});
    }
    for (std::size_t i = 0; i < left_out.over_range.size(); ++i) {
        const Channel& channel = found.channel(i == 0 ? options.channel_c : options.channel_d);
        if (const std::int64_t count = left_out.over_range.at(i); count > 0) {
            found.diagnostics.push_back(
                {DiagnosticKind::over_range, {channel.name, count_arg(count)}});
        }
    }
    if (left_out.ends_within_row) {
        found.diagnostics.push_back({DiagnosticKind::text_ends_within_row, {}});
    }
    if (lines_ignored > 0) {
        found.diagnostics.push_back(
            {DiagnosticKind::text_lines_ignored, {count_arg(lines_ignored)}});
    }
    return {};
}

void note_words(const TextFormat& format, FoundSamples& found) {
    if (const std::string columns = joined(format.words, ", "); !columns.empty()) {
        found.diagnostics.push_back({DiagnosticKind::words_passed_over, {columns}});
    }
}

// C and D with a time column each.
Result<Recording> open_apart(const std::shared_ptr<const FileBytes>& file,
                             const OpenOptions& options, const JobControl& job) {
    const auto alone = [&](int channel) {
        OpenOptions one = options;
        one.channel_c = channel;
        one.channel_d = channel;
        return open_text(file, one, job);
    };
    auto c = TRY(alone(options.channel_c));
    auto d = TRY(alone(options.channel_d));
    const std::vector<Channel> channels = c.channels;
    const std::string name_d = channels[static_cast<std::size_t>(options.channel_d - 1)].name;
    auto pair = TRY(pair_channels(std::move(c), std::move(d), name_d));
    pair.channels = channels;
    pair.channel_c = options.channel_c;
    pair.channel_d = options.channel_d;
    return pair;
}

// Liquid Instruments' devices say in the first line what they are.
bool is_of_phasemeter(const TextHead& head) {
    const std::string& first = head.lines.empty() ? std::string() : head.lines.front();
    return first.starts_with("% Moku") && (first.find("Phasemeter") != std::string::npos ||
                                           first.find("Lock-in") != std::string::npos);
}

// Whether every column beside the time is known of whole-angle logs, an angle among them.
bool is_whole_angle(const TextFormat& format) {
    bool angle = false;
    for (int column = 0; column < std::ssize(format.headings); ++column) {
        const std::string name = normal_name(format.heading(column).name);
        const auto is_one_of = [&name](const std::vector<const char*>& known) {
            return std::ranges::any_of(known,
                                       [&](const char* each) { return normal_name(each) == name; });
        };
        if (column == format.time_column || is_time_name(name)) {
            continue;
        }
        const bool is_angle = is_one_of(wave_angle_names);
        if (!is_angle && !is_one_of(amplitude_effort_names) &&
            !is_one_of(quadrature_effort_names)) {
            return false;
        }
        angle = angle || is_angle;
    }
    return angle;
}

// Tracks, whose columns are known, too, open: their values are numbers over time, which may be
// looked at, but not analysed.
Status check_holds_samples(const FileBytes& file, const TextHead& head, const TextFormat& format) {
    const auto has = [&](std::initializer_list<const char*> columns) {
        return std::ranges::all_of(columns, [&](const char* column) {
            return std::ranges::find(format.headings, column, &Channel::name) !=
                   format.headings.end();
        });
    };
    const auto has_row_of = [&head](const char* field) {
        const std::string between = std::string(";") + field + ';';
        return std::ranges::any_of(head.lines, [&](const std::string& line) {
            return line.find(between) != std::string::npos;
        });
    };
    const bool long_form = !head.lines.empty() && is_labone_rows(head.lines.front()) &&
                           has_row_of("x") && has_row_of("y");
    if (is_of_phasemeter(head) || has({"Xc", "Yc", "Xd", "Yd"}) || long_form ||
        has({"chunk", "timestamp", "x", "y"})) {  // a demodulator of LabOne
        return holds_phasors(file);
    }
    if (has({"a", "b", "theta"})) {
        return holds_waves(file);
    }
    if (has({"E", "R", "S", "Q"})) {
        return file.error(ErrorCode::holds_log,
                          {Phrase::tr("the powers E, R, S and Q"), "--columns E,R,S,Q"});
    }
    return is_whole_angle(format) ? Status(file.error(ErrorCode::holds_angle)) : Status();
}

}  // namespace

Result<TextTable> table_for(const std::shared_ptr<const FileBytes>& file, TextFormat format,
                            const OpenOptions& options) {
    const std::vector<int> channels = channel_columns(format);
    TextColumns columns{.time = format.time_column,
                        .c = channels[static_cast<std::size_t>(options.channel_c - 1)],
                        .d = channels[static_cast<std::size_t>(options.channel_d - 1)]};
    const auto c = static_cast<std::size_t>(columns.c);
    const auto d = static_cast<std::size_t>(columns.d);
    constexpr double same_rate = 1e-9;
    if (!format.rates.empty() &&
        std::abs(format.rates[c].hz / format.rates[d].hz - 1) > same_rate) {
        return file->unsupported(
            "text", VYBEG_MESSAGE("Words", "columns %1 and %2 of different sample rates"),
            {count_arg(columns.c + 1), count_arg(columns.d + 1)});
    }
    columns.d_factor = unit_ratio(format.headings[d].unit, format.headings[c].unit).value_or(1);
    if (!format.own_times.empty() && format.own_times[c] != format.time_column) {
        columns.time = format.time_column = format.own_times[c];
        format.time_unit_s =
            seconds_per(time_unit(format.heading(columns.time))).value_or(format.own_time_unit_s);
    }
    return find_table(file, format, columns);
}

Result<TextTable> choose_table(const std::shared_ptr<const FileBytes>& file,
                               const OpenOptions& options, const JobControl& job) {
    const TextChoice choice = options.text.value_or(TextChoice{});
    const auto head = TRY(read_text_head(file, choice.lines_to_skip, job));
    const auto format = find_text_format(*file, head, choice);
    TRY(check_holds_samples(*file, head, format ? *format : TextFormat()));
    if (!format) {
        return format.error();
    }
    const auto channels = static_cast<int>(channel_columns(*format).size());
    TRY(check_channels(*file, channels, options));
    auto table = TRY(table_for(file, *format, options));
    if (table.columns.time < 0 && table.format.rates.empty() && !options.rate_hz) {
        return file->error(ErrorCode::rate_unknown);  // before the work of reading it
    }
    return table;
}

bool same_written_rate(double stated_hz, double hz, double relative_sd) {
    constexpr double rounding = 2e-3;
    return std::abs(stated_hz / hz - 1) <= rounding + 5 * relative_sd;
}

Result<Recording> open_text(std::shared_ptr<const FileBytes> file, const OpenOptions& options,
                            const JobControl& job) {
    const auto table = TRY(choose_table(file, options, job));
    const std::vector<int>& own_times = table.format.own_times;
    if (!own_times.empty() && own_times[static_cast<std::size_t>(table.columns.c)] !=
                                  own_times[static_cast<std::size_t>(table.columns.d)]) {
        return open_apart(file, options, job);
    }
    FoundSamples found;
    found.format = format_of(table.format);
    found.channels = channels_of(table.format);
    found.one_unit = true;
    note_words(table.format, found);
    TRY(take_table(file, table, options, job, found));
    return complete_recording(*file, std::move(found), options);
}

}  // namespace vybeg
