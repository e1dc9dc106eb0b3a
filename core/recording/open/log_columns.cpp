#include "core/recording/open/log_columns.h"

#include "core/base/number_text.h"
#include "core/base/plain_text.h"
#include "core/base/read_value.h"
#include "core/numerics/statistics.h"
#include "core/recording/arrays/npy_reader.h"
#include "core/recording/bytes/file_bytes.h"
#include "core/recording/bytes/packed_parts.h"
#include "core/recording/open/open_recording.h"
#include "core/recording/samples/text_fields.h"
#include "core/recording/samples/vocabulary.h"
#include "core/recording/text/labone_rows.h"
#include "core/recording/text/text_format.h"
#include "core/recording/text/text_reading.h"
#include "core/recording/variables/mat_file.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <limits>
#include <memory>
#include <numbers>
#include <optional>
#include <string_view>
#include <utility>

namespace vybeg {
namespace {

using File = std::shared_ptr<const FileBytes>;

constexpr const char* time_role = "t";

bool is_time(const ColumnWish& wish) {
    return wish.role.name == std::string_view(time_role);
}

bool same_name_as(std::string_view name, std::string_view other) {
    return normal_name(name) == normal_name(other);
}

bool is_usual_name(std::string_view name, const ColumnRole& role) {
    return std::ranges::any_of(role.names,
                               [name](const char* usual) { return same_name_as(name, usual); });
}

bool is_called(std::string_view name, const ColumnWish& wish) {
    return wish.column.empty() ? is_usual_name(name, wish.role) : same_name_as(name, wish.column);
}

Error missing_column(const FileBytes& file, const ColumnWish& wish,
                     const std::vector<Channel>& headings) {
    std::string all;
    for (std::size_t k = 0; k < headings.size(); ++k) {
        all += all.empty() ? "" : ", ";
        all += headings[k].name.empty() ? std::to_string(k + 1) : plain_text(headings[k].name);
    }
    return file.error(ErrorCode::column_missing,
                      {wish.column.empty() ? wish.role.name : wish.column, all});
}

LogTable empty_table(std::span<const ColumnWish> wishes) {
    LogTable table;
    for (const ColumnWish& wish : wishes) {
        table.columns.push_back({wish.role.name, "", "", {}});
    }
    return table;
}

// Leaves the rows for which keep(row) is true.
template <class Keep>
void keep_rows(LogTable& table, Keep keep) {
    std::vector<std::size_t> kept;
    kept.reserve(table.time_s.size());
    for (std::size_t row = 0; row < table.time_s.size(); ++row) {
        if (keep(row)) {
            kept.push_back(row);
        }
    }
    const auto cut = [&kept](std::vector<double>& values) {
        for (std::size_t k = 0; k < kept.size() && !values.empty(); ++k) {
            values[k] = values[kept[k]];
        }
        values.resize(values.empty() ? 0 : kept.size());
    };
    for (LogColumn& column : table.columns) {
        cut(column.values);
    }
    cut(table.time_s);
}

// The wave at zero of a clock that counts from an epoch is none: such times count from the first
// row.
void count_from_start(LogTable& table) {
    constexpr double most = 10;  // lengths of the log before it
    std::vector<double>& times = table.time_s;
    const double first = times.empty() ? 0 : times.front();
    if (!times.empty() && std::abs(first) > most * (times.back() - first)) {
        table.begun_s += first;
        std::ranges::for_each(times, [first](double& t) { t -= first; });
    }
}

// Place of a wished column, from 0; -1: it is not there. A table without names has the stated ones
// in their order, a text all of them.
int place_of(const std::vector<Channel>& headings, std::span<const ColumnWish> wishes,
             std::size_t wish, bool in_text) {
    const std::string& column = wishes[wish].column;
    if (const auto number = parse_number(column);
        number && *number >= 1 && *number <= static_cast<double>(headings.size())) {
        return static_cast<int>(*number) - 1;
    }
    for (std::size_t k = 0; k < headings.size(); ++k) {
        if (is_called(headings[k].name, wishes[wish]) ||
            is_called(name_and_unit(headings[k].name).name, wishes[wish])) {
            return static_cast<int>(k);
        }
    }
    const bool nameless =
        std::ranges::all_of(headings, [](const Channel& each) { return each.name.empty(); });
    const bool ordered = wishes.front().told ? wishes[wish].told : in_text;
    // Beside a column alone there is no time.
    const std::size_t before = headings.size() == 1 && is_time(wishes.front()) ? 1 : 0;
    const std::size_t order = wish - before;
    return nameless && column.empty() && ordered && order < headings.size()
               ? static_cast<int>(order)
               : -1;
}

// The format of a text with the wished time column, which counts although it is one of two columns.
Result<TextFormat> format_with_time(const File& file, const OpenOptions& options,
                                    std::span<const ColumnWish> wishes, const JobControl& job) {
    TextChoice choice = options.text.value_or(TextChoice{});
    const auto head = TRY(read_text_head(file, choice.lines_to_skip, job));
    auto format = TRY(find_text_format(*file, head, choice));
    const auto time = std::ranges::find_if(wishes, is_time);
    const bool alone = format.columns == 1;  // no time beside it
    if (choice.time_column || time == wishes.end() || alone) {
        return format;
    }
    const auto at = static_cast<std::size_t>(time - wishes.begin());
    const int place = place_of(format.headings, wishes, at, true);
    if (place < 0) {
        return !time->told ? Result<TextFormat>(format)
                           : missing_column(*file, *time, format.headings);
    }
    choice.time_column = place + 1;
    return find_text_format(*file, head, choice);
}

// Ticks a second, from the file that LabOne writes beside: dev_demods_0_sample_header_00000.csv.
std::optional<double> clockbase_beside(const std::filesystem::path& path) {
    std::string name = path.stem().string();
    const std::size_t digits = name.find_last_not_of("0123456789") + 1;
    name.insert(digits, "header_");
    const auto text = own_file_text(path.parent_path() / (name + path.extension().string()));
    if (!text) {
        return std::nullopt;
    }
    // A row of names over a row of values, or the value beside its name.
    std::vector<std::vector<std::string_view>> lines;
    for (const std::string_view line : parts_between(*text, '\n')) {
        if (lines.size() < 1000) {
            split_fields(line, ';', lines.emplace_back());
        }
    }
    for (std::size_t row = 0; row < lines.size(); ++row) {
        const auto& names = lines[row];
        const auto found = std::ranges::find(names, "clockbase");
        const auto place = static_cast<std::size_t>(found - names.begin());
        if (found == names.end()) {
            continue;
        }
        const bool is_head = names.size() > 2 && row + 1 < lines.size();
        const auto& values = is_head ? lines[row + 1] : names;
        const std::size_t at = is_head ? place : place + 1;
        const auto number = at < values.size() ? parse_number(values[at]) : std::nullopt;
        if (number && *number > 0) {
            return number;
        }
    }
    return std::nullopt;
}

// Times in ticks become seconds from the first.
Status count_ticks(const FileBytes& file, const OpenOptions& options, LogTable& table) {
    std::vector<double>& t = table.time_s;
    std::vector<double> steps;
    for (std::size_t k = 1; k < t.size(); ++k) {
        steps.push_back(t[k] - t[k - 1]);
    }
    const double step = steps.empty() ? 0 : median(std::move(steps));
    if (step < 1 || std::ranges::any_of(t, [](double tick) { return tick != std::floor(tick); })) {
        return {};
    }
    const auto clockbase = clockbase_beside(file.path());
    if (!clockbase && !options.rate_hz) {
        return file.error(ErrorCode::rate_unknown);
    }
    constexpr double agreement = 1e-3;
    if (clockbase && options.rate_hz &&
        std::abs(*options.rate_hz * step / *clockbase - 1) > agreement) {
        return refused_value(
            "--rate", short_text(*options.rate_hz),
            Phrase::tr("the clockbase in the header beside it makes %1 rows a second",
                       {number_arg(*clockbase / step, 7)}));
    }
    const double tick_s = clockbase ? 1 / *clockbase : 1 / (step * *options.rate_hz);
    table.begun_s = t.front() * tick_s;
    for (std::size_t k = t.size(); k-- > 0;) {
        t[k] = (t[k] - t.front()) * tick_s;
    }
    return {};
}

Result<LogTable> read_text(const File& file, const OpenOptions& options,
                           std::span<const ColumnWish> wishes, const JobControl& job) {
    const auto format = TRY(format_with_time(file, options, wishes, job));
    if (format.time_column < 0 && !options.rate_hz) {
        return file->error(ErrorCode::rate_unknown);
    }
    std::vector<int> places(wishes.size(), -1);
    std::vector<std::size_t> wanted;
    for (std::size_t k = 0; k < wishes.size(); ++k) {
        if (is_time(wishes[k])) {
            continue;
        }
        places[k] = place_of(format.headings, wishes, k, true);
        if (places[k] >= 0 && places[k] != format.time_column) {
            wanted.push_back(k);
        } else if (wishes[k].required()) {
            return missing_column(*file, wishes[k], format.headings);
        }
    }
    LogTable table = empty_table(wishes);
    for (std::size_t k = 0; k < wanted.size(); k += 2) {
        const std::array pair{wanted[k], wanted[std::min(k + 1, wanted.size() - 1)]};
        const TextColumns columns{
            .time = format.time_column, .c = places[pair[0]], .d = places[pair[1]]};
        auto found = TRY(find_table(file, format, columns));
        found.may_repeat = true;
        const auto scan = TRY(scan_text(found, job));
        auto rows = TRY(read_timed_rows(found, scan, job));
        table.columns[pair[1]].values = std::move(rows.d);
        table.columns[pair[0]].values = std::move(rows.c);  // also of a column alone
        table.time_s = std::move(rows.time_s);
    }
    for (const std::size_t k : wanted) {
        const Channel& heading = format.heading(places[k]);
        table.columns[k].name = plain_text(heading.name);
        table.columns[k].unit = plain_text(heading.unit);
    }
    for (std::size_t k = 0; format.time_column < 0 && k < table.time_s.size(); ++k) {
        table.time_s[k] = static_cast<double>(k) / *options.rate_hz;
    }
    if (format.time_column >= 0 &&
        normal_name(format.heading(format.time_column).name) == "timestamp") {
        TRY(count_ticks(*file, options, table));
    }
    return table;
}

// Variables are asked for by name, two at a time, as if they were C and D.
Result<LogTable> read_variables(const std::filesystem::path& path, const OpenOptions& options,
                                std::span<const ColumnWish> wishes, const JobControl& job) {
    LogTable table = empty_table(wishes);
    std::string beside;  // a variable that is there
    for (std::size_t k = 0; k < wishes.size(); ++k) {
        if (is_time(wishes[k])) {
            continue;
        }
        std::vector<std::string> names(wishes[k].role.names.begin(), wishes[k].role.names.end());
        if (!wishes[k].column.empty()) {
            names = {wishes[k].column};
        }
        std::optional<Error> missing;
        for (const std::string& name : names) {
            OpenOptions one = options;
            one.variables = {name, beside.empty() ? name : beside};
            const Result<Recording> found = open_recording(path, one, job);
            if (!found) {
                missing = found.error();
                if (found.error().code == ErrorCode::variable_missing) {
                    missing->args[0] = wishes[k].column.empty() ? wishes[k].role.name : name;
                    continue;
                }
                return found.error();
            }
            missing.reset();
            const auto frames = static_cast<std::size_t>(found->frames());
            std::vector<double> other(frames);
            LogColumn& column = table.columns[k];
            column = {column.role, name, found->channels.front().unit, std::vector<double>(frames)};
            TRY(found->source->read(0, column.values, other));
            table.time_s.resize(frames);
            for (std::size_t row = 0; row < frames; ++row) {
                table.time_s[row] = static_cast<double>(row) / found->rate_hz;
            }
            beside = name;
            break;
        }
        if (missing && (wishes[k].required())) {
            return *missing;
        }
    }
    return table;
}

// A table of numbers that is neither lines nor variables.
struct ArrayTable {
    std::vector<Channel> headings;  // of its columns
    std::vector<std::function<Result<std::vector<double>>()>> read;

    void add(const std::vector<NamedColumn>& columns) {
        for (const auto& [heading, column] : columns) {
            headings.push_back(heading);
            read.emplace_back([column = column]() -> Result<std::vector<double>> {
                std::vector<double> values(static_cast<std::size_t>(column.frames()));
                TRY(read_column(column, 0, values));
                return values;
            });
        }
    }
};

// The table of a file that holds one; without columns: it holds none.
Result<ArrayTable> find_array(const File& file, std::string_view head, const JobControl& job) {
    ArrayTable table;
    if (is_npy(head)) {
        const auto columns = TRY(npy_columns(file));
        table.add(columns);
    } else if (is_mat5(head)) {
        const auto columns = TRY(moku_columns(file, job));
        table.add(columns);
    } else if (is_labone_rows(head)) {
        auto fields = TRY(read_labone_rows(file, job));
        for (LaboneField& each : fields) {
            table.headings.push_back({each.name, ""});
            table.read.emplace_back([values = std::move(each.values)] { return Result(values); });
        }
    }
    return table;
}

Result<LogTable> read_array(const FileBytes& file, const ArrayTable& array,
                            const OpenOptions& options, std::span<const ColumnWish> wishes) {
    LogTable table = empty_table(wishes);
    const Channel* time = nullptr;
    std::size_t rows = std::numeric_limits<std::size_t>::max();
    for (std::size_t k = 0; k < wishes.size(); ++k) {
        const int place = place_of(array.headings, wishes, k, false);
        if (place < 0 && (wishes[k].required())) {
            return missing_column(file, wishes[k], array.headings);
        }
        if (place < 0) {
            continue;
        }
        const Channel& heading = array.headings[static_cast<std::size_t>(place)];
        auto values = TRY(array.read[static_cast<std::size_t>(place)]());
        rows = std::min(rows, values.size());
        if (is_time(wishes[k])) {
            time = &heading;
            table.time_s = std::move(values);
        } else {
            table.columns[k] = {wishes[k].role.name, plain_text(heading.name),
                                plain_text(heading.unit), std::move(values)};
        }
    }
    if (time == nullptr && !options.rate_hz) {
        return file.error(ErrorCode::rate_unknown);
    }
    table.time_s.resize(rows);
    const double unit_s =
        time == nullptr ? 1 / *options.rate_hz : seconds_per(time_unit(*time)).value_or(1);
    for (std::size_t row = 0; row < rows; ++row) {
        table.time_s[row] =
            unit_s * (time == nullptr ? static_cast<double>(row) : table.time_s[row]);
    }
    for (LogColumn& column : table.columns) {
        column.values.resize(column.values.empty() ? 0 : rows);
    }
    // Before ticks are counted and the order is judged, of which a NaN says nothing.
    keep_rows(table, [&table](std::size_t row) { return std::isfinite(table.time_s[row]); });
    if (time != nullptr && normal_name(time->name) == "timestamp") {
        TRY(count_ticks(file, options, table));
    }
    if (!std::ranges::is_sorted(table.time_s)) {
        return file.unsupported("table", VYBEG_MESSAGE("Words",
                                                       "times that do not rise: name their column "
                                                       "as t in --columns"));
    }
    return table;
}

// The file, or the one text that it has packed.
Result<File> unpacked(File file) {
    const auto head = TRY(file_head(*file));
    if (!is_zip(head)) {
        return file;
    }
    auto members = TRY(zip_members(*file));
    std::erase_if(members,
                  [](const ZipMember& member) { return member.name.starts_with("__MACOSX/"); });
    if (members.size() != 1 || members.front().name.ends_with(".npy")) {
        return file;
    }
    return zip_file(file, members.front());
}

}  // namespace

Result<std::vector<ColumnWish>> column_wishes(const std::string& text,
                                              std::span<const ColumnRole> roles) {
    std::vector<ColumnWish> wishes;
    const auto is_wished = [&wishes](std::string_view name) {
        return std::ranges::any_of(
            wishes, [name](const ColumnWish& wish) { return wish.role.name == name; });
    };
    const auto entries = text.empty() ? std::vector<std::string_view>() : parts_between(text, ',');
    for (const std::string_view entry : entries) {
        const std::size_t sign = std::min(entry.find('='), entry.size());
        const std::string column(trimmed(entry.substr(std::min(sign + 1, entry.size()))));
        const std::string_view name = entry.substr(0, sign);
        const auto role = std::ranges::find_if(roles, [&name](const ColumnRole& each) {
            return same_name_as(name, each.name) || is_usual_name(name, each);
        });
        if (role == roles.end()) {
            return refused_value("--columns", text,
                                 Phrase::tr("it names %1, with commas between them, each with "
                                            "=COLUMN where the file calls it otherwise",
                                            {joined(roles, ", ", &ColumnRole::name)}));
        }
        if (is_wished(role->name)) {
            return refused_value("--columns", text, Phrase::tr("%1 is named twice", {role->name}));
        }
        wishes.push_back({*role, column, true});
    }
    for (const ColumnRole& role : roles) {
        if (is_wished(role.name)) {
            continue;
        }
        if (role.needed && !text.empty()) {
            return refused_value("--columns", text, Phrase::tr("%1 is missing", {role.name}));
        }
        wishes.push_back({role, ""});
    }
    return wishes;
}

Result<LogTable> read_log(const std::filesystem::path& path, const OpenOptions& options,
                          std::span<const ColumnWish> wishes, const JobControl& job) {
    if (!options.join.empty()) {
        return refused_value("--join", options.join.front(),
                             Phrase::tr("logs are not joined: put their rows into one file, or "
                                        "read each as a log of its own"));
    }
    const auto packed = TRY(FileBytes::open(path));
    const auto file = TRY(unpacked(packed));
    const auto head = TRY(file_head(*file));
    const FileFormat* const format = find_format(head, *file);
    const auto array = TRY(options.text ? ArrayTable() : find_array(file, head, job));
    const bool is_array = !array.headings.empty();
    const bool is_text = options.text || (format && format->is_text());
    const bool is_variables = !is_array && !options.text && format && format->has_variables;
    if (!is_array && !is_text && !is_variables) {
        return file->error(ErrorCode::no_log);
    }
    auto table = TRY(is_variables ? read_variables(path, options, wishes, job)
                     : is_array   ? read_array(*file, array, options, wishes)
                                  : read_text(file, options, wishes, job));
    double last = -std::numeric_limits<double>::infinity();
    keep_rows(table, [&](std::size_t row) {
        const double before = std::exchange(last, table.time_s[row]);
        return table.time_s[row] != before;
    });
    count_from_start(table);
    return table;
}

ColumnRole time_of_log() {
    return {time_role, {"t", "t_s", "time", "time_s", "timestamp", "время"}, false};
}

Status keep_times(const std::filesystem::path& path, double from_s, double to_s, LogTable& table) {
    std::vector<double>& times = table.time_s;
    const double begin = times.empty() ? 0 : times.front();
    const auto first = std::ranges::lower_bound(times, begin + from_s) - times.begin();
    const auto end = std::ranges::upper_bound(times, begin + to_s) - times.begin();
    if (first >= end) {
        const double length_s = times.empty() ? 0 : times.back() - begin;
        return Error{ErrorCode::range_empty,
                     path.string(),
                     {number_arg(std::max(from_s, 0.0)), number_arg(std::min(to_s, length_s)),
                      number_arg(length_s)}};
    }
    keep_rows(table, [first, end](std::size_t row) {
        return static_cast<std::ptrdiff_t>(row) >= first && static_cast<std::ptrdiff_t>(row) < end;
    });
    return {};
}

void bring_to_unit_of(const LogColumn& other, LogColumn& column) {
    if (const auto ratio = unit_ratio(column.unit, other.unit); ratio && *ratio != 1) {
        for (double& value : column.values) {
            value *= *ratio;
        }
        column.unit = other.unit;
    }
}

std::pair<double, double> range_of(const LogColumn& column) {
    double least = std::numeric_limits<double>::infinity();
    double most = -least;
    for (const double value : column.values) {
        if (std::isfinite(value)) {
            least = std::min(least, value);
            most = std::max(most, value);
        }
    }
    return {least, most};
}

namespace {

// Rad of the unit of a column of angles, by its heading or the end of its name.
std::optional<double> angle_unit_of(const LogColumn& column) {
    constexpr double degree = std::numbers::pi / 180;
    static const std::vector<std::pair<std::vector<const char*>, double>> units{
        {{"mrad", "мрад"}, 1e-3},
        {{"urad", "µrad", "мкрад"}, 1e-6},
        {{"rad", "radians", "рад"}, 1},
        {{"cyc", "cycles", "turns"}, 2 * std::numbers::pi},
        {{"arcmin", "угл.мин"}, degree / 60},
        {{"arcsec", "угл.с"}, degree / 3600},
        {{"deg", "degrees", "°", "град"}, degree}};
    const std::string unit = normal_name(column.unit);
    for (const auto& [spellings, rad] : units) {
        if (std::ranges::any_of(spellings, [&](const char* each) {
                return unit == normal_name(each) || column.name.ends_with(std::string("_") + each);
            })) {
            return rad;
        }
    }
    return std::nullopt;
}

}  // namespace

Result<double> angle_factor(const std::filesystem::path& path, const LogColumn& column,
                            double told) {
    const std::string name = normal_name(column.name);
    const double half = name.starts_with("twotheta") || name.starts_with("2theta") ? 0.5 : 1;
    const std::optional<double> unit = angle_unit_of(column);
    if (told > 0 || unit) {
        return half * unit.value_or(told);
    }
    return Error{ErrorCode::angle_unit_unknown,
                 path.string(),
                 {column.name.empty() ? "theta" : column.name}};
}

}  // namespace vybeg
