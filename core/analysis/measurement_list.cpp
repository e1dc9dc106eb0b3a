#include "core/analysis/measurement_list.h"

#include "core/analysis/list_fields.h"
#include "core/analysis/setting_table.h"
#include "core/base/diagnostic.h"
#include "core/base/error.h"
#include "core/base/message_arg.h"
#include "core/base/number_text.h"
#include "core/base/plain_text.h"
#include "core/base/read_value.h"
#include "core/recording/samples/open_table.h"
#include "core/recording/text/csv_rows.h"

#include <algorithm>
#include <array>
#include <concepts>
#include <iterator>
#include <map>
#include <set>
#include <system_error>
#include <type_traits>

namespace vybeg {
namespace {

constexpr std::array own_columns{"file",          "set",       "gyro",     "date",   "bias_v",
                                 "temperature_c", "exchanged", "operator", "comment"};

// Options of one fit, and what logs are. Their other companions belong to single recordings.
const std::vector<std::string>& options_of_a_set() {
    static const std::vector<std::string> names = [] {
        std::vector<std::string> all{"model", "window",    "periods", "snap",
                                     "kappa", "tolerance", "threads"};
        for (const SettingRow<LogChoice>& row : log_settings()) {
            all.push_back(row.name);
        }
        return all;
    }();
    return names;
}

bool is_one_of(const auto& names, const std::string& name) {
    return std::ranges::find(names, name) != names.end();
}

// The placeholder of an option's value; none: there is no such option.
std::optional<std::string> placeholder_of(const std::string& name) {
    if (const auto* row = row_named(open_settings(), name)) {
        return row->placeholder;
    }
    if (const auto* row = row_named(identify_settings(), name)) {
        return row->placeholder;
    }
    const auto* row = row_named(analysis_settings(), name);
    return row != nullptr ? std::optional(row->placeholder) : std::nullopt;
}

// The name of the table for a column: that of a condition or an option in other letters, in
// Russian, with a unit; its own for any other.
std::string column_name(const std::string& name) {
    const std::string usual = usual_column(name);
    std::string condition = usual;
    std::ranges::replace(condition, '-', '_');
    if (condition == "gyro_type" || is_one_of(own_columns, condition)) {
        return condition;
    }
    return placeholder_of(usual) ? usual : name;
}

// The column with an effect whose name an unknown one resembles; empty: none.
std::string option_like(const std::string& name) {
    std::vector<std::string> known(own_columns.begin(), own_columns.end());
    const auto add = [&known](const auto& rows) {
        for (const auto& row : rows) {
            known.push_back(row.name);
        }
    };
    add(open_settings());
    add(identify_settings());
    const auto found = std::ranges::find_if(
        known, [&name](const std::string& each) { return names_resemble(name, each); });
    return found == known.end() ? "" : *found;
}

class Reader {
public:
    Reader(CsvRows table, std::filesystem::path folder, const OpenOptions& open,
           const IdentifySettings& settings)
        : table_(std::move(table)), folder_(std::move(folder)), open_(open), settings_(settings) {}

    Result<MeasurementList> read() {
        TRY(name_columns());
        find_formulas();
        make_numbers_usual();
        group_sets();
        TRY(read_sets());
        return std::move(list_);
    }

private:
    // The fault of an option's value, at its place in the list.
    Error refused(std::int64_t line, const Error& error) const {
        const std::string column = english(error.args.at(0)).substr(2);  // without the dashes
        return table_.invalid(
            line, column,
            Phrase::tr("\"%1\" is not possible: %2", {error.args.at(1), error.args.at(2)}));
    }

    Status name_columns() {
        for (const std::string& name : table_.names) {
            if (name.starts_with("--") && placeholder_of(name.substr(2))) {
                return table_.invalid(1, name, Phrase::tr("an option has no dashes here"));
            }
            if (is_idle(name)) {
                list_.warnings.push_back({DiagnosticKind::option_without_effect,
                                          {"--" + name, "an identification does not use it"}});
            }
            if (!name.empty() && !is_one_of(own_columns, name) && !placeholder_of(name)) {
                list_.other_columns.push_back(name);
                if (const std::string option = option_like(name); !option.empty()) {
                    list_.warnings.push_back({DiagnosticKind::column_like_option, {name, option}});
                }
            }
        }
        if (table_.rows.empty()) {
            return table_.invalid(1, "file", Phrase::tr("no row names a recording below it"));
        }
        return {};
    }

    // The table of results has them as they are, and a table program runs them.
    void find_formulas() {
        for (const std::string& name : list_.other_columns) {
            if (is_formula(name)) {
                list_.warnings.push_back(
                    {DiagnosticKind::formula_in_list, {name, Phrase::tr("the name of a column")}});
            }
        }
        for (const CsvRow& row : table_.rows) {
            for (std::size_t k = 0; k < row.fields.size(); ++k) {
                if (is_formula(row.fields[k])) {
                    list_.warnings.push_back(
                        {DiagnosticKind::formula_in_list,
                         {row.fields[k], Phrase::tr("line %1 of the list, column \"%2\"",
                                                    {count_arg(row.line), table_.names[k]})}});
                }
            }
        }
    }

    // An option of analyze alone.
    static bool is_idle(const std::string& name) {
        return row_named(analysis_settings(), name) != nullptr &&
               row_named(identify_settings(), name) == nullptr;
    }

    void make_numbers_usual() {
        for (std::size_t column = 0; column < table_.names.size(); ++column) {
            const std::string& name = table_.names[column];
            std::optional<std::string> placeholder = placeholder_of(name);
            if (name == "bias_v" || name == "temperature_c") {
                placeholder = "X";
            }
            for (CsvRow& row : table_.rows) {
                if (placeholder) {
                    std::string& field = row.fields[column];
                    const std::optional<bool> answer = yes_or_no(field);
                    field = placeholder->empty() && answer
                                ? std::string(*answer ? "yes" : "no")
                                : usual_option(field, placeholder->find(',') != std::string::npos);
                }
            }
        }
    }

    // Rows without the name of a set are sets of their own, named by the file.
    void group_sets() {
        std::map<std::string, std::size_t> places;
        std::set<std::string> taken;
        for (const CsvRow& row : table_.rows) {
            taken.insert(table_.field(row, "set"));
        }
        for (const CsvRow& row : table_.rows) {
            std::string name = table_.field(row, "set");
            if (name.empty()) {
                name = table_.field(row, "file");
                if (!taken.insert(name).second) {
                    name += " (" + integer_text(row.line) + ")";
                }
            }
            const auto [place, is_new] = places.emplace(name, rows_.size());
            if (is_new) {
                list_.sets.push_back({name, {}, settings_});
                rows_.emplace_back();
            }
            rows_[place->second].push_back(&row);
        }
    }

    Status read_sets() {
        for (std::size_t k = 0; k < rows_.size(); ++k) {
            TRY(share_options(rows_[k]));
            std::vector<SignalSettings> signals;
            for (const CsvRow* row : rows_[k]) {
                auto settings = TRY(read_row(*row, list_.sets[k]));
                signals.push_back(settings.signal);
                list_.sets[k].settings = std::move(settings);
            }
            IdentifySettings& settings = list_.sets[k].settings;
            settings.signal = signals.front();
            if (std::ranges::any_of(signals, [&](const auto& s) { return s != settings.signal; })) {
                settings.of_recordings = std::move(signals);
            }
        }
        return {};
    }

    // Gives every row of a set the options that hold for all of it.
    Status share_options(const std::vector<const CsvRow*>& rows) {
        for (const std::string& name : options_of_a_set()) {
            const CsvRow* told = nullptr;
            for (const CsvRow* row : rows) {
                const std::string& text = table_.field(*row, name);
                if (text.empty()) {
                    continue;
                }
                if (told != nullptr && table_.field(*told, name) != text) {
                    return table_.invalid(
                        row->line, name,
                        Phrase::tr(
                            "\"%1\" differs from \"%2\" in line %3, and one value holds for all "
                            "recordings of a set: tell the same, or give the row a set of its own",
                            {text, table_.field(*told, name), count_arg(told->line)}));
                }
                told = told == nullptr ? row : told;
            }
            shared_[name] = told == nullptr ? "" : table_.field(*told, name);
        }
        return {};
    }

    const std::string& option(const CsvRow& row, const std::string& name) const {
        const auto found = shared_.find(name);
        return found == shared_.end() ? table_.field(row, name) : found->second;
    }

    template <class S>
    Status read_option(const SettingRow<S>& each, const CsvRow& row, S& settings) const {
        const std::string& text = option(row, each.name);
        if (text.empty()) {
            return {};
        }
        Status taken = each.read(text, settings);
        taken = taken ? each.check(settings) : taken;
        return taken ? taken : refused(row.line, taken.error());
    }

    // Reads the options of a row that a table has.
    template <class S>
    Status read_options(const std::vector<SettingRow<S>>& table, const CsvRow& row,
                        S& settings) const {
        for (const SettingRow<S>& each : table) {
            TRY(read_option(each, row, settings));
        }
        return {};
    }

    Result<IdentifySettings> read_row(const CsvRow& row, MeasurementSet& set) const {
        RecordingRef recording{table_.field(row, "file"), {}, open_};
        if (recording.file.empty()) {
            return table_.invalid(row.line, "file", Phrase::tr("no file is named"));
        }
        recording.path = file_from(folder_, recording.file);
        const bool has_window = !option(row, "window").empty();
        if (has_window && !option(row, "periods").empty()) {
            return table_.invalid(row.line, "periods",
                                  Phrase::tr("the window is given in samples, too"));
        }
        TRY(read_options(open_settings(), row, recording.open));
        find_files_from(folder_, recording.open);
        if (const Status together = check_options(recording.open); !together) {
            return refused(row.line, together.error());
        }
        IdentifySettings settings = settings_;
        if (has_window) {
            settings.windows.periods.reset();  // of the command line
        }
        TRY(read_options(identify_settings(), row, settings));
        // Options without effect are checked, too.
        for (const SettingRow<Settings>& each : analysis_settings()) {
            Settings idle;
            TRY(is_idle(each.name) ? read_option(each, row, idle) : Status());
        }
        TRY(read_conditions(row, recording.conditions));
        for (const std::string& column : list_.other_columns) {
            recording.others.emplace_back(column, table_.field(row, column));
        }
        set.recordings.push_back(std::move(recording));
        return settings;
    }

    // "23,5 °C" of a column in °C.
    static std::string without_unit(const std::string& field) {
        for (const std::string_view unit : {"°C", "°С", "V", "В"}) {
            if (field.ends_with(unit)) {
                const std::string number = field.substr(0, field.size() - unit.size());
                return usual_option(number.substr(0, number.find_last_not_of(' ') + 1), false);
            }
        }
        return field;
    }

    Status read_conditions(const CsvRow& row, Conditions& told) const {
        told.gyro = table_.field(row, "gyro");
        told.operator_name = table_.field(row, "operator");
        told.comment = table_.field(row, "comment");
        told.date = usual_date(table_.field(row, "date"));
        if (!told.date.empty() && !is_iso_date(told.date)) {
            return table_.invalid(row.line, "date",
                                  Phrase::tr("\"%1\" is no date as in 2026-03-31 or 31.03.2026, "
                                             "with or without a time as in T14:05",
                                             {told.date}));
        }
        for (const auto& [column, value] :
             {std::pair{"bias_v", &told.bias_v}, std::pair{"temperature_c", &told.temperature_c}}) {
            const std::string text = without_unit(table_.field(row, column));
            const Result<double> number = read_number(column, text.empty() ? "0" : text);
            if (!number) {
                return table_.invalid(
                    row.line, column,
                    Phrase::tr("\"%1\" is not a number", {table_.field(row, column)}));
            }
            constexpr double absolute_zero_c = -273.15;
            if (value == &told.temperature_c && *number < absolute_zero_c) {
                return table_.invalid(row.line, column,
                                      Phrase::tr("\"%1\" lies below absolute zero, -273.15 C",
                                                 {table_.field(row, column)}));
            }
            *value = text.empty() ? std::nullopt : std::optional(*number);
        }
        const std::string& exchanged = table_.field(row, "exchanged");
        const std::optional<bool> answer = yes_or_no(exchanged);
        told.exchanged = answer.value_or(false);
        if (!exchanged.empty() && !answer) {
            return table_.invalid(row.line, "exchanged",
                                  Phrase::tr("\"%1\" is neither yes nor no", {exchanged}));
        }
        return {};
    }

    CsvRows table_;
    std::filesystem::path folder_;                  // of the list
    const OpenOptions& open_;                       // where a row gives none
    const IdentifySettings& settings_;              // likewise
    std::vector<std::vector<const CsvRow*>> rows_;  // of each set
    std::map<std::string, std::string> shared_;     // options of the set that is read
    MeasurementList list_;
};

std::string first_told(const MeasurementSet& set, std::string Conditions::*member) {
    for (const RecordingRef& recording : set.recordings) {
        if (const std::string& text = recording.conditions.*member; !text.empty()) {
            return text;
        }
    }
    return {};
}

std::string side_by_side(const MeasurementSet& set, auto text_of) {
    std::vector<std::string> texts;
    std::ranges::transform(set.recordings, std::back_inserter(texts), text_of);
    return one_or_each(texts, ";");
}

}  // namespace

Result<MeasurementList> read_measurement_list(const std::filesystem::path& path,
                                              const OpenOptions& open,
                                              const IdentifySettings& settings) {
    auto table = TRY(read_csv(path, "file", column_name));
    return Reader(std::move(table), path.parent_path(), open, settings).read();
}

void leave_out(MeasurementSet& set, const std::function<bool(const RecordingRef&)>& which) {
    std::vector<SignalSettings>& signals = set.settings.of_recordings;
    for (std::size_t k = 0; k < set.recordings.size();) {
        if (!which(set.recordings[k])) {
            ++k;
            continue;
        }
        const auto place = static_cast<std::ptrdiff_t>(k);
        set.recordings.erase(set.recordings.begin() + place);
        if (!signals.empty()) {
            signals.erase(signals.begin() + place);
        }
    }
}

bool is_measurement_list(const std::filesystem::path& path) {
    const std::string ending = lower_text(path.extension().string());
    return (ending == ".csv" || ending == ".txt") && csv_has_name(path, "file", column_name);
}

Result<MeasurementList> list_of_folder(
    const std::filesystem::path& folder, const OpenOptions& open, const IdentifySettings& settings,
    const std::function<bool(const std::filesystem::path&)>& left_out) {
    std::error_code failed;
    std::filesystem::directory_iterator entries(folder, failed);
    std::vector<std::filesystem::path> files;
    for (; !failed && entries != std::filesystem::directory_iterator(); entries.increment(failed)) {
        const std::filesystem::path& path = entries->path();
        std::error_code unknown;
        if (entries->is_regular_file(unknown) && !path.filename().string().starts_with('.') &&
            !left_out(path)) {
            files.push_back(path);
        }
    }
    if (failed) {
        return failed == std::errc::permission_denied
                   ? Error{ErrorCode::file_permission, folder.string(), {}}
                   : Error{ErrorCode::file_read_failed,
                           folder.string(),
                           {system_reason(failed.value())}};
    }
    std::ranges::sort(files);
    MeasurementList list;
    for (const std::filesystem::path& path : files) {
        const std::string name = path.filename().string();
        if (is_formula(name)) {
            list.warnings.push_back(
                {DiagnosticKind::formula_in_list, {name, Phrase::tr("a file of the folder")}});
        }
        list.sets.push_back({name, {{name, path, open, {}, {}}}, settings});
    }
    return list;
}

Result<std::string> one_told(const MeasurementSet& set, const MessageArg& name,
                             const std::function<std::string(const RecordingRef&)>& text_of,
                             bool any_case) {
    std::string told;
    for (const RecordingRef& recording : set.recordings) {
        const std::string text = text_of(recording);
        const bool same = any_case ? lower_text(text) == lower_text(told) : text == told;
        if (!told.empty() && !text.empty() && !same) {
            return Error{ErrorCode::conditions_differ, set.name, {name, told, text}};
        }
        told = told.empty() ? text : told;
    }
    return told;
}

Status check_conditions(const MeasurementSet& set) {
    TRY(one_told(set, Phrase::tr("the gyro"),
                 [](const RecordingRef& recording) { return recording.conditions.gyro; }));
    TRY(one_told(set, Phrase::tr("the bias voltage"), [](const RecordingRef& recording) {
        const std::optional<double>& bias_v = recording.conditions.bias_v;
        return bias_v ? round_trip_text(*bias_v) + " V" : std::string();
    }));
    TRY(one_told(set, Phrase::tr("the exchange of the amplifiers"),
                 [](const RecordingRef& recording) {
                     return std::string(recording.conditions.exchanged ? "yes" : "no");
                 }));
    return {};
}

std::string gyro_of(const MeasurementSet& set) {
    return first_told(set, &Conditions::gyro);
}

std::string list_date_of(const MeasurementSet& set) {
    return first_told(set, &Conditions::date);
}

std::vector<std::pair<std::string, std::string>> fields_of(const Conditions& conditions) {
    std::vector<std::pair<std::string, std::string>> fields;
    describe(
        [&fields](const char* name, const auto& value) {
            using Value = std::remove_cvref_t<decltype(value)>;
            std::string text;
            if constexpr (std::same_as<Value, std::string>) {
                text = value;
            } else if constexpr (std::same_as<Value, bool>) {
                text = value ? "yes" : "";
            } else {
                text = value ? round_trip_text(*value) : "";
            }
            fields.emplace_back(name, std::move(text));
        },
        conditions);
    return fields;
}

std::vector<std::pair<std::string, std::string>> conditions_of(const MeasurementSet& set) {
    constexpr std::size_t of_the_set = 2;  // gyro and date
    auto columns = fields_of({});
    columns.erase(columns.begin(), columns.begin() + of_the_set);
    for (std::size_t k = 0; k < columns.size(); ++k) {
        columns[k].second = side_by_side(set, [k](const RecordingRef& recording) {
            return fields_of(recording.conditions)[k + of_the_set].second;
        });
    }
    return columns;
}

std::string other_of(const MeasurementSet& set, std::size_t k) {
    return side_by_side(set, [k](const RecordingRef& recording) {
        return k < recording.others.size() ? recording.others[k].second : std::string();
    });
}

}  // namespace vybeg
