#include "core/recording/samples/open_table.h"

#include "core/base/message_arg.h"
#include "core/base/number_text.h"
#include "core/base/read_value.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <utility>

namespace vybeg {
namespace {

using Row = SettingRow<OpenOptions>;

const Bounds rate_bounds{1e-6, 1e12};
constexpr int most_raw_channels = 4096;
// Enough for a header, too few for a second table.
constexpr std::int64_t most_skipped_lines = 1'000'000;
const Bounds raw_channels_bounds{1, most_raw_channels};
const Bounds skip_bounds{0, 1e15};  // exact as a double
const Bounds skip_lines_bounds{0, most_skipped_lines};
const Bounds any_number{};

// Row of an option whose reader gets the option's name, dashes included.
template <class Read, class Text>
Row row(const char* name, const char* placeholder, const char* help, Read read, Text text) {
    Row made{name, placeholder, help};
    made.read = [option = made.option(), read](const std::string& from, OpenOptions& options) {
        return Status(read(option, from, options));
    };
    made.text = text;
    return made;
}

Row bounded(Row row, const Bounds& bounds) {
    row.bounds = {bounds};
    return row;
}

// One that the results state on their own.
Row without_part(Row row) {
    row.has_part = false;
    return row;
}

// A whole number from `least` on that fits into an int.
Result<int> small_whole(const std::string& option, const std::string& text, int least,
                        const std::string& allowed) {
    const auto number = TRY(read_whole(option, text));
    if (number < least || number > std::numeric_limits<int>::max()) {
        return refused_value(option, text, allowed);
    }
    return static_cast<int>(number);
}

bool is_channel(double number) {
    return number >= 1 && number <= std::numeric_limits<int>::max() && number == std::floor(number);
}

Status read_rate(const std::string& option, const std::string& text, OpenOptions& options) {
    const auto rate = TRY(read_number(option, text, "Hz"));
    options.rate_hz = rate;
    return {};
}

std::string rate_text(const OpenOptions& options) {
    return options.rate_hz ? round_trip_text(*options.rate_hz) : "";
}

Status read_channels(const std::string& option, const std::string& text, OpenOptions& options) {
    const std::string allowed = "it must be two channel numbers from 1, as in 1,2";
    const auto pair = TRY(read_numbers(option, text, 2, allowed));
    if (!is_channel(pair[0]) || !is_channel(pair[1])) {
        return refused_value(option, text, allowed);
    }
    options.channel_c = static_cast<int>(pair[0]);
    options.channel_d = static_cast<int>(pair[1]);
    return {};
}

std::string channels_text(const OpenOptions& options) {
    return joined({static_cast<double>(options.channel_c), static_cast<double>(options.channel_d)});
}

std::vector<std::string> names_in(const std::string& text) {
    std::vector<std::string> names;
    for (std::size_t begin = 0; begin <= text.size();) {
        const std::size_t end = std::min(text.find(',', begin), text.size());
        names.push_back(text.substr(begin, end - begin));
        begin = end + 1;
    }
    return names;
}

std::string names_text(const std::vector<std::string>& names) {
    std::string text;
    for (const std::string& name : names) {
        text += &name == &names.front() ? "" : ",";
        text += name;
    }
    return text;
}

// The names between the commas, of which only the middle one of three may be empty.
Status read_variables(const std::string& option, const std::string& text, OpenOptions& options) {
    std::vector<std::string> names = names_in(text);
    if (names.size() > 3 || names.front().empty() || names.back().empty()) {
        return refused_value(option, text,
                             "it is one to three names with commas, as in C,D,fs or XY,,fs");
    }
    options.variables = std::move(names);
    return {};
}

Status read_join(const std::string& option, const std::string& text, OpenOptions& options) {
    std::vector<std::string> names = names_in(text);
    if (std::ranges::find(names, "") != names.end()) {
        return refused_value(option, text, "it is names of files with commas, as in 2.wav,3.wav");
    }
    options.join = std::move(names);
    return {};
}

Status read_raw(const std::string& option, const std::string& text, OpenOptions& options) {
    RawLayout layout;
    std::string type = text;
    if (const std::size_t colon = text.find(':'); colon != std::string::npos) {
        const std::string order = text.substr(colon + 1);
        layout.big_endian = order == "be";
        type = order == "be" || order == "le" ? text.substr(0, colon) : text;
    }
    const auto* const found = std::ranges::find(raw_type_names, std::string_view(type));
    if (found == raw_type_names.end()) {
        return refused_value(option, text, "it is i16, i32, f32 or f64, with :be for big-endian");
    }
    layout.type = static_cast<RawType>(found - raw_type_names.begin());
    options.raw = layout;
    return {};
}

// Text of a field of the raw layout; empty where the file is not read as raw.
template <class Text>
auto raw_text(Text text) {
    return [text](const OpenOptions& options) {
        return options.raw ? std::string(text(*options.raw)) : std::string();
    };
}

std::string type_text(const RawLayout& layout) {
    return std::string(raw_type_names.at(static_cast<std::size_t>(layout.type))) +
           (layout.big_endian ? ":be" : "");
}

Status read_raw_channels(const std::string& option, const std::string& text, OpenOptions& options) {
    if (!options.raw) {
        return refused_value(option, text, "it needs --raw");
    }
    const auto channels = TRY(small_whole(option, text, 1, "it must be at least 1"));
    options.raw->channels = channels;
    return {};
}

Status read_skip(const std::string& option, const std::string& text, OpenOptions& options) {
    if (!options.raw) {
        return refused_value(option, text, "it needs --raw");
    }
    const auto bytes = TRY(read_whole(option, text));
    if (bytes < 0) {
        return refused_value(option, text, "it cannot be negative");
    }
    options.raw->skip_bytes = bytes;
    return {};
}

// Row of an option of text files. `read` returns the fault of a value, or none; `text` an empty
// text where nothing is chosen.
template <class Read, class Text>
Row text_row(const char* name, const char* placeholder, const char* help, Read read, Text text) {
    return row(
        name, placeholder, help,
        [read](const std::string& option, const std::string& from, OpenOptions& options) -> Status {
            if (options.raw) {
                return refused_value(option, from, "it is for text, and --raw reads no text");
            }
            TextChoice choice = options.text.value_or(TextChoice{});
            TRY(read(option, from, choice));
            options.text = choice;
            return {};
        },
        [text](const OpenOptions& options) {
            return options.text ? std::string(text(*options.text)) : std::string();
        });
}

Status read_skip_lines(const std::string& option, const std::string& text, TextChoice& choice) {
    const auto lines = TRY(read_whole(option, text));
    choice.lines_to_skip = lines;
    return {};
}

Status read_time_column(const std::string& option, const std::string& text, TextChoice& choice) {
    const auto column =
        TRY(text == "none"
                ? 0
                : small_whole(option, text, 1, "it is the number of a column, from 1, or none"));
    choice.time_column = column;
    return {};
}

template <class Words, class Value>
std::string word_of(const Words& words, const Value& value) {
    const auto* const found =
        std::ranges::find(words, value, [](const auto& each) { return each.second; });
    return found == words.end() ? "" : found->first;
}

// Row of a choice between words of text files.
template <class Value, std::size_t count>
Row word_row(const char* name, const char* placeholder, const char* help,
             std::optional<Value> TextChoice::*field,
             const std::array<std::pair<const char*, Value>, count>& words, const char* allowed) {
    return text_row(
        name, placeholder, help,
        [=](const std::string& option, const std::string& from, TextChoice& choice) -> Status {
            const auto* const found =
                std::ranges::find_if(words, [&](const auto& each) { return from == each.first; });
            if (found == words.end()) {
                return refused_value(option, from, allowed);
            }
            choice.*field = found->second;
            return {};
        },
        [=](const TextChoice& choice) {
            return choice.*field ? word_of(words, *(choice.*field)) : std::string();
        });
}

constexpr std::array delimiters{std::pair{"comma", ','}, std::pair{"semicolon", ';'},
                                std::pair{"tab", '\t'}, std::pair{"space", ' '},
                                std::pair{"bar", '|'}};
constexpr const char* allowed_delimiters = "it is comma, semicolon, tab, space or bar";
constexpr std::array time_units{std::pair{"s", 1.0}, std::pair{"ms", 1e-3}, std::pair{"us", 1e-6},
                                std::pair{"ns", 1e-9}};
constexpr const char* allowed_time_units = "it is s, ms, us or ns";
constexpr std::array decimal_signs{std::pair{"point", false}, std::pair{"comma", true}};

Status check_choice(const TextChoice& choice) {
    if (choice.delimiter && word_of(delimiters, *choice.delimiter).empty()) {
        return refused_value("--delimiter", std::string(1, *choice.delimiter), allowed_delimiters);
    }
    if (choice.lines_to_skip &&
        (*choice.lines_to_skip < 0 || *choice.lines_to_skip > most_skipped_lines)) {
        return refused_value("--skip-lines", integer_text(*choice.lines_to_skip),
                             "it must lie between 0 and " + integer_text(most_skipped_lines));
    }
    if (choice.time_column && *choice.time_column < 0) {
        return refused_value("--time-column", std::to_string(*choice.time_column),
                             "it is the number of a column, from 1, or none");
    }
    if (choice.time_unit_s && word_of(time_units, *choice.time_unit_s).empty()) {
        return refused_value("--time-unit", short_text(*choice.time_unit_s), allowed_time_units);
    }
    return {};
}

Status read_scale(const std::string& option, const std::string& text, OpenOptions& options) {
    const auto scale = TRY(read_number(option, text));
    options.scale = scale;
    return {};
}

std::string scale_text(const OpenOptions& options) {
    return options.raw || options.scale != 1 ? round_trip_text(options.scale) : "";
}

// Row of an option whose text is the value.
Row plain_row(const char* name, const char* placeholder, const char* help,
              std::string OpenOptions::*field) {
    return row(
        name, placeholder, help,
        [field](const std::string& /*option*/, const std::string& text, OpenOptions& options) {
            options.*field = text;
            return Status();
        },
        [field](const OpenOptions& options) { return options.*field; });
}

}  // namespace

const std::vector<SettingRow<OpenOptions>>& open_settings() {
    static const std::vector<Row> rows{
        without_part(bounded(
            row("rate", "HZ", "Sample rate where the file has none, Hz", read_rate, rate_text),
            rate_bounds)),
        without_part(
            row("channels", "I,J",
                "Which two channels or columns are C and D, from 1; a time column does not count "
                "(default 1,2)",
                read_channels, channels_text)),
        row("variables", "C,D[,RATE]",
            "Names of the variables of a MAT, HDF5 or NPZ file that hold C and D, and the rate; D "
            "is left out where one holds both: XY or XY,,RATE",
            read_variables,
            [](const OpenOptions& options) { return names_text(options.variables); }),
        row("raw", "TYPE", "Headerless interleaved samples: i16, i32, f32, f64 [:be]", read_raw,
            raw_text(type_text)),
        bounded(row("raw-channels", "N", "Channels of --raw (default 2)", read_raw_channels,
                    raw_text([](const RawLayout& raw) { return integer_text(raw.channels); })),
                raw_channels_bounds),
        bounded(
            row("skip", "BYTES", "Bytes before the first sample of --raw (default 0)", read_skip,
                raw_text([](const RawLayout& raw) { return integer_text(raw.skip_bytes); })),
            skip_bounds),
        word_row("delimiter", "NAME",
                 "Between the columns of a text file: comma, semicolon, tab, space or bar "
                 "(default: guessed, as is all that follows)",
                 &TextChoice::delimiter, delimiters, allowed_delimiters),
        word_row("decimal", "SIGN", "Decimal sign of a text file: point or comma",
                 &TextChoice::decimal_comma, decimal_signs, "it is point or comma"),
        bounded(text_row("skip-lines", "N", "Lines of a text file above its first row of numbers",
                         read_skip_lines,
                         [](const TextChoice& choice) {
                             return choice.lines_to_skip ? integer_text(*choice.lines_to_skip) : "";
                         }),
                skip_lines_bounds),
        text_row("time-column", "N|none",
                 "Column of a text file that is the time, from 1; none: every column is a channel",
                 read_time_column,
                 [](const TextChoice& choice) {
                     return !choice.time_column        ? ""
                            : *choice.time_column == 0 ? not_set
                                                       : integer_text(*choice.time_column);
                 }),
        word_row("time-unit", "UNIT", "Unit of the time column: s, ms, us or ns",
                 &TextChoice::time_unit_s, time_units, allowed_time_units),
        bounded(row("scale", "X",
                    "Recording units per count of --raw or unit of the file, e.g. volts at full "
                    "scale of a WAV file (default 1)",
                    read_scale, scale_text),
                any_number),
        plain_row("unit", "NAME", "Unit of the samples, e.g. V (default: the file's)",
                  &OpenOptions::unit),
        plain_row("channel-d", "FILE",
                  "File of channel D, where each channel has a file of its own; --channels then "
                  "counts in each",
                  &OpenOptions::channel_d_file),
        row("join", "FILE[,FILE]",
            "Files of the recording's further pieces, in their order; gaps between them are "
            "missing samples",
            read_join, [](const OpenOptions& options) { return names_text(options.join); }),
    };
    return rows;
}

std::string options_text(const OpenOptions& options) {
    std::string text;
    for (const Row& row : open_settings()) {
        const std::string value = row.has_part ? row.text(options) : "";
        if (!value.empty()) {
            text += text.empty() ? "" : " ";
            text += row.option() + ' ' + value;
        }
    }
    return text;
}

Status check_scale(double scale) {
    if (!std::isfinite(scale) || scale == 0) {
        return refused_value("--scale", number_arg(scale),
                             words(VYBEG_MESSAGE("Words", "it must be a number other than 0")));
    }
    return {};
}

Status check_layout(const RawLayout& layout) {
    if (!within(raw_channels_bounds, "--raw-channels", layout.channels)) {
        return refused_value("--raw-channels", count_arg(layout.channels),
                             words(VYBEG_MESSAGE("Words", "it must lie between 2 and %1"),
                                   {count_arg(most_raw_channels)}));
    }
    if (!within(skip_bounds, "--skip", static_cast<double>(layout.skip_bytes))) {
        return refused_value("--skip", count_arg(layout.skip_bytes),
                             words(VYBEG_MESSAGE("Words", "it must be 0 to 1e15 bytes")));
    }
    return {};
}

Status check_options(const OpenOptions& options) {
    if (options.rate_hz && !within(rate_bounds, "--rate", *options.rate_hz)) {
        return refused_value("--rate", number_arg(*options.rate_hz),
                             words(VYBEG_MESSAGE("Words", "it must lie between 1e-6 and 1e12 Hz")));
    }
    if (options.channel_c == options.channel_d && options.channel_d_file.empty()) {
        const std::string channel = std::to_string(options.channel_c);
        return refused_value("--channels", channel + "," + channel,
                             words(VYBEG_MESSAGE("Words", "C and D must be two channels")));
    }
    if (!options.channel_d_file.empty() && !options.join.empty()) {
        return refused_value(
            "--join", names_text(options.join),
            words(VYBEG_MESSAGE("Words",
                                "it is for files with both channels, not for a file for "
                                "each channel")));
    }
    if (options.text && options.raw) {
        return refused_value("--raw", options_text({.text = options.text}),
                             words(VYBEG_MESSAGE("Words", "a file is read as text or as raw")));
    }
    TRY(check_scale(options.scale));
    if (options.raw) {
        return check_layout(*options.raw);
    }
    return options.text ? check_choice(*options.text) : Status{};
}

std::filesystem::path file_from(const std::filesystem::path& folder, std::string name) {
    std::error_code unknown;
    if (!std::filesystem::exists(folder / name, unknown)) {
        std::ranges::replace(name, '\\', '/');
    }
    return folder / name;
}

void find_files_from(const std::filesystem::path& folder, OpenOptions& options) {
    const auto find = [&folder](std::string& name) {
        name = name.empty() ? name : file_from(folder, name).lexically_normal().string();
    };
    find(options.channel_d_file);
    for (std::string& name : options.join) {
        find(name);
    }
}

std::vector<std::filesystem::path> further_files(const OpenOptions& options) {
    std::vector<std::filesystem::path> files(options.join.begin(), options.join.end());
    if (!options.channel_d_file.empty()) {
        files.emplace_back(options.channel_d_file);
    }
    return files;
}

}  // namespace vybeg
