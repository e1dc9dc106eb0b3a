#include "core/recording/samples/open_table.h"

#include "core/base/message_arg.h"
#include "core/base/number_text.h"
#include "core/base/plain_text.h"
#include "core/base/read_value.h"
#include "core/recording/samples/text_fields.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <limits>
#include <optional>
#include <utility>

namespace vybeg {
namespace {

using Row = SettingRow<OpenOptions>;
using TextRow = SettingRow<TextChoice>;
using RawRow = SettingRow<RawLayout>;

const Bounds rate_bounds{1e-6, 1e12};
constexpr int most_raw_channels = 4096;
// Enough for a header, too few for a second table.
constexpr std::int64_t most_skipped_lines = 1'000'000;
const Bounds raw_channels_bounds{1, most_raw_channels};
const Bounds skip_bounds{0, 1e15};  // exact as a double
const Bounds skip_lines_bounds{0, most_skipped_lines};
const Bounds any_number{};

// Row of a field. `read` gets the option's name, dashes included, and its text; the text of a value
// that is not there is empty.
template <class S, class Field, class Read, class Text>
SettingRow<S> field_row(SettingRow<S> row, Field S::*field, Read read, Text text) {
    row.read = [=, option = row.option()](const std::string& from, S& settings) -> Status {
        settings.*field = TRY(read(option, from));
        return {};
    };
    row.text = [=](const S& settings) -> std::string {
        if constexpr (requires { (settings.*field).has_value(); }) {
            return settings.*field ? text(*(settings.*field)) : "";
        } else {
            return text(settings.*field);
        }
    };
    return row;
}

// The row of a field of `part`, which it makes where it is not there. `refusal`: why the options
// have no such part; null: they may have one.
template <class Part, class Refusal>
Row part_row(SettingRow<Part> row, std::optional<Part> OpenOptions::*part, Refusal refusal) {
    Row made{row.name, row.placeholder, row.help};
    made.read = [=](const std::string& from, OpenOptions& options) -> Status {
        if (const char* const reason = refusal(options)) {
            return refused_value(row.option(), from, reason);
        }
        Part changed = (options.*part).value_or(Part{});
        TRY(row.read(from, changed));
        options.*part = changed;
        return {};
    };
    made.text = [=](const OpenOptions& options) {
        return options.*part ? row.text(*(options.*part)) : std::string();
    };
    return made;
}

Row of_text(TextRow row) {
    return part_row(std::move(row), &OpenOptions::text, [](const OpenOptions& options) {
        return options.raw ? "it is for text, and --raw reads no text" : nullptr;
    });
}

// Of a whole number of the raw layout, from `least` on.
template <class Number>
Row of_raw(RawRow row, Number RawLayout::*field, Number least, const char* allowed) {
    const auto read = [=](const std::string& option, const std::string& text) -> Result<Number> {
        const auto number = TRY(read_whole(option, text));
        if (number < least || !std::in_range<Number>(number)) {
            return refused_value(option, text, allowed);
        }
        return static_cast<Number>(number);
    };
    return part_row(
        field_row(std::move(row), field, read, integer_text), &OpenOptions::raw,
        [](const OpenOptions& options) { return options.raw ? nullptr : "it needs --raw"; });
}

// Names between commas.
template <class Allowed>
Row names_row(Row row, std::vector<std::string> OpenOptions::*field, Allowed are_allowed,
              const char* allowed) {
    using Names = std::vector<std::string>;
    return field_row(
        std::move(row), field,
        [=](const std::string& option, const std::string& text) -> Result<Names> {
            const auto parts = parts_between(text, ',');
            Names names(parts.begin(), parts.end());
            if (!are_allowed(names)) {
                return refused_value(option, text, allowed);
            }
            return names;
        },
        [](const Names& names) { return joined(names, ","); });
}

// Row of an option whose text is the value.
Row plain_row(Row row, std::string OpenOptions::*field) {
    return field_row(
        std::move(row), field,
        [](const std::string& /*option*/, const std::string& text) { return Result(text); },
        std::identity());
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

bool is_channel(double number) {
    return number >= 1 && number <= std::numeric_limits<int>::max() && number == std::floor(number);
}

Row channels_row(Row row) {
    row.read = [option = row.option()](const std::string& text, OpenOptions& options) -> Status {
        const std::string allowed = "it must be two channel numbers from 1, as in 1,2";
        const auto pair = TRY(read_numbers(option, text, 2, allowed));
        if (!is_channel(pair[0]) || !is_channel(pair[1])) {
            return refused_value(option, text, allowed);
        }
        options.channel_c = static_cast<int>(pair[0]);
        options.channel_d = static_cast<int>(pair[1]);
        return {};
    };
    row.text = [](const OpenOptions& options) {
        return joined(
            {static_cast<double>(options.channel_c), static_cast<double>(options.channel_d)});
    };
    return row;
}

Row scale_row(Row row) {
    row = field_row(
        std::move(row), &OpenOptions::scale,
        [](const std::string& option, const std::string& text) {
            return read_number(option, text);
        },
        round_trip_text);
    row.text = [text = row.text](const OpenOptions& options) {
        return options.raw || options.scale != 1 ? text(options) : "";
    };
    return row;
}

// Only the middle one of three may be empty.
bool are_variables(const std::vector<std::string>& names) {
    return names.size() <= 3 && !names.front().empty() && !names.back().empty();
}

bool are_files(const std::vector<std::string>& names) {
    return std::ranges::find(names, "") == names.end();
}

Result<RawLayout> read_raw(const std::string& option, const std::string& text) {
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
    return layout;
}

std::string raw_text(const RawLayout& layout) {
    return std::string(raw_type_names.at(static_cast<std::size_t>(layout.type))) +
           (layout.big_endian ? ":be" : "");
}

constexpr const char* allowed_time_columns = "it is the number of a column, from 1, or none";

Result<int> read_time_column(const std::string& option, const std::string& text) {
    const auto column = TRY(text == not_set ? std::int64_t{0} : read_whole(option, text));
    if (text != not_set && (column < 1 || !std::in_range<int>(column))) {
        return refused_value(option, text, allowed_time_columns);
    }
    return static_cast<int>(column);
}

constexpr const char* allowed_delimiters = "it is comma, semicolon, tab, space or bar";
constexpr const char* allowed_time_units = "it is s, ms, us or ns";

// Whether the value has a word; a value that is not there needs none.
template <class Words, class Value>
bool has_word(const Words& words, const std::optional<Value>& value) {
    return !value ||
           std::ranges::any_of(words, [&](const auto& each) { return each.second == *value; });
}

Status check_choice(const TextChoice& choice) {
    if (!has_word(delimiters, choice.delimiter)) {
        return refused_value("--delimiter", std::string(1, *choice.delimiter), allowed_delimiters);
    }
    if (choice.lines_to_skip &&
        (*choice.lines_to_skip < 0 || *choice.lines_to_skip > most_skipped_lines)) {
        return refused_value("--skip-lines", integer_text(*choice.lines_to_skip),
                             "it must lie between 0 and " + integer_text(most_skipped_lines));
    }
    if (choice.time_column && *choice.time_column < 0) {
        return refused_value("--time-column", std::to_string(*choice.time_column),
                             allowed_time_columns);
    }
    if (!has_word(time_units, choice.time_unit_s)) {
        return refused_value("--time-unit", short_text(*choice.time_unit_s), allowed_time_units);
    }
    return {};
}

}  // namespace

const std::vector<SettingRow<OpenOptions>>& open_settings() {
    static const std::vector<Row> rows{
        without_part(bounded(
            field_row(
                Row{"rate", "HZ", "Sample rate where the file has none, Hz"}, &OpenOptions::rate_hz,
                [](const std::string& option, const std::string& text) {
                    return read_number(option, text, "Hz");
                },
                round_trip_text),
            rate_bounds)),
        without_part(channels_row(
            {"channels", "I,J",
             "Which two channels or columns are C and D, from 1; a time column does not count "
             "(default 1,2)"})),
        names_row({"variables", "C,D[,RATE]",
                   "Names of the variables of a MAT, HDF5 or NPZ file that hold C and D, and the "
                   "rate; D is left out where one holds both: XY or XY,,RATE"},
                  &OpenOptions::variables, are_variables,
                  "it is one to three names with commas, as in C,D,fs or XY,,fs"),
        field_row(Row{"raw", "TYPE", "Headerless interleaved samples: i16, i32, f32, f64 [:be]"},
                  &OpenOptions::raw, read_raw, raw_text),
        bounded(of_raw({"raw-channels", "N", "Channels of --raw (default 2)"}, &RawLayout::channels,
                       1, "it must be at least 1"),
                raw_channels_bounds),
        bounded(of_raw({"skip", "BYTES", "Bytes before the first sample of --raw (default 0)"},
                       &RawLayout::skip_bytes, std::int64_t{0}, "it cannot be negative"),
                skip_bounds),
        of_text(choice_row(
            TextRow{"delimiter", "NAME",
                    "Between the columns of a text file: comma, semicolon, tab, space or bar "
                    "(default: guessed, as is all that follows)"},
            [](auto& text) -> auto& { return text.delimiter; }, delimiters, allowed_delimiters)),
        of_text(choice_row(
            TextRow{"decimal", "SIGN", "Decimal sign of a text file: point or comma"},
            [](auto& text) -> auto& { return text.decimal_comma; }, decimal_signs,
            "it is point or comma")),
        bounded(of_text(field_row(TextRow{"skip-lines", "N",
                                          "Lines of a text file above its first row of numbers"},
                                  &TextChoice::lines_to_skip, read_whole, integer_text)),
                skip_lines_bounds),
        of_text(field_row(
            TextRow{"time-column", "N|none",
                    "Column of a text file that is the time, from 1; none: every column is a "
                    "channel"},
            &TextChoice::time_column, read_time_column,
            [](int column) { return column == 0 ? not_set : integer_text(column); })),
        of_text(choice_row(
            TextRow{"time-unit", "UNIT", "Unit of the time column: s, ms, us or ns"},
            [](auto& text) -> auto& { return text.time_unit_s; }, time_units, allowed_time_units)),
        bounded(scale_row({"scale", "X",
                           "Recording units per count of --raw or unit of the file, e.g. volts at "
                           "full scale of a WAV file (default 1)"}),
                any_number),
        plain_row({"unit", "NAME", "Unit of the samples, e.g. V (default: the file's)"},
                  &OpenOptions::unit),
        plain_row({"channel-d", "FILE",
                   "File of channel D, where each channel has a file of its own; --channels then "
                   "counts in each"},
                  &OpenOptions::channel_d_file),
        names_row({"join", "FILE[,FILE]",
                   "Files of the recording's further pieces, in their order; gaps between them are "
                   "missing samples"},
                  &OpenOptions::join, are_files,
                  "it is names of files with commas, as in 2.wav,3.wav"),
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

Status check_layout(const RawLayout& layout) {
    if (!within(raw_channels_bounds, "--raw-channels", layout.channels)) {
        return refused_value(
            "--raw-channels", count_arg(layout.channels),
            Phrase::tr("it must lie between 2 and %1", {count_arg(most_raw_channels)}));
    }
    if (!within(skip_bounds, "--skip", static_cast<double>(layout.skip_bytes))) {
        return refused_value("--skip", count_arg(layout.skip_bytes),
                             Phrase::tr("it must be 0 to 1e15 bytes"));
    }
    return {};
}

Status check_options(const OpenOptions& options) {
    if (options.rate_hz && !within(rate_bounds, "--rate", *options.rate_hz)) {
        return refused_value("--rate", number_arg(*options.rate_hz),
                             Phrase::tr("it must lie between 1e-6 and 1e12 Hz"));
    }
    if (options.channel_c == options.channel_d && options.channel_d_file.empty()) {
        const std::string channel = std::to_string(options.channel_c);
        return refused_value("--channels", channel + "," + channel,
                             Phrase::tr("C and D must be two channels"));
    }
    if (!options.channel_d_file.empty() && !options.join.empty()) {
        return refused_value(
            "--join", joined(options.join, ","),
            Phrase::tr("it is for files with both channels, not for a file for each channel"));
    }
    if (options.text && options.raw) {
        return refused_value("--raw", options_text({.text = options.text}),
                             Phrase::tr("a file is read as text or as raw"));
    }
    if (!std::isfinite(options.scale) || options.scale == 0) {
        return refused_value("--scale", number_arg(options.scale),
                             Phrase::tr("it must be a number other than 0"));
    }
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
