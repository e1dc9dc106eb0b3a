#include "core/analysis/list_fields.h"
#include "core/analysis/measurement_list.h"
#include "core/analysis/setting_table.h"
#include "core/base/number_text.h"
#include "core/database/results_database.h"
#include "core/output/identify_json.h"
#include "core/output/quantity_json.h"
#include "core/recording/bytes/sha256.h"
#include "core/recording/samples/open_table.h"
#include "core/resonator/results/resonator_parameters.h"

#include <nlohmann/json.hpp>

#include <algorithm>
#include <array>
#include <filesystem>
#include <limits>
#include <string_view>
#include <system_error>
#include <utility>

namespace vybeg {
namespace {

std::string settings_text(IdentifySettings settings) {
    settings.threads = 0;
    settings.of_recordings.clear();
    std::string text;
    for (const auto& [name, value] : settings_list(settings)) {
        add_parts(text, {name, value});
    }
    return text;
}

Result<std::string> result_key(const MeasurementSet& set) {
    std::vector<std::string> each;
    for (std::size_t k = 0; k < set.recordings.size(); ++k) {
        const OpenOptions& open = set.recordings[k].open;
        IdentifySettings own = set.settings;
        own.signal = set.settings.signal_of(k);
        std::string text;
        add_parts(text, {set.recordings[k].sha256, integer_text(open.channel_c),
                         integer_text(open.channel_d), options_text(open),
                         open.rate_hz ? round_trip_text(*open.rate_hz) : "", settings_text(own)});
        each.push_back(text);
    }
    std::ranges::sort(each);
    std::string whole;
    add_parts(whole, {settings_text(set.settings)});
    add_parts(whole, each);
    return text_sha256(whole);
}

std::filesystem::path absolute_path(const std::filesystem::path& path) {
    std::error_code failed;
    const std::filesystem::path whole = std::filesystem::absolute(path, failed);
    return (failed ? path : whole).lexically_normal();
}

std::vector<StoredParameter> parameters_of(const ResonatorFit& fit) {
    std::vector<StoredParameter> parameters;
    parameters.reserve(resonator_parameters.size() + fit.modes.size() * mode_parameters.size());
    for (const ResonatorParameter& parameter : resonator_parameters) {
        parameters.push_back({parameter.name, fit.resonator.*parameter.member});
    }
    for (std::size_t k = 0; k < fit.modes.size(); ++k) {
        for (const ModeParameter& parameter : mode_parameters) {
            parameters.push_back({"modes[" + std::to_string(k) + "]." + parameter.name,
                                  fit.modes[k].*parameter.member});
        }
    }
    return parameters;
}

using Json = nlohmann::ordered_json;

using Texts = std::vector<std::string>;

template <class Value>
Value value_in(const std::string& text) {
    try {
        return Json::parse(text).get<Value>();
    } catch (const Json::parse_error& error) {
        throw DamagedRow("it is no JSON at byte " + std::to_string(error.byte));
    } catch (const Json::type_error&) {
        throw DamagedRow("a number stands in place of a text");
    } catch (const Json::exception&) {
        throw DamagedRow("it holds a number beyond all ranges");
    }
}

// As DateSource.
constexpr std::array<std::string_view, 3> date_sources{"", "list", "recording"};

DateSource source_of(const std::string& name) {
    const auto* const found = std::ranges::find(date_sources, name);
    if (found == date_sources.end()) {
        throw DamagedRow("a date is from \"" + name + "\"");
    }
    return static_cast<DateSource>(found - date_sources.begin());
}

// Columns value, sd, u, reason, reason_args from `column` on.
Estimate read_estimate(const SqliteStatement& row, int column) {
    Estimate estimate;
    estimate.value = row.number(column);
    estimate.sd = row.number(column + 1);
    estimate.u = row.number(column + 2);
    if (const std::string name = row.text(column + 3); !name.empty()) {
        std::optional<Reason> reason = stored_reason(name, value_in<Texts>(row.text(column + 4)));
        if (!reason) {
            throw DamagedRow("the reason \"" + name + "\" is not known");
        }
        estimate.reason = std::move(*reason);
    }
    return estimate;
}

// Archives of describe(): the values of a statement, and columns of a row one after the other.
struct Binder {
    SqliteStatement& row;

    void operator()(const char*, const std::string& text) { row.bind(text); }
    void operator()(const char*, bool value) { row.bind(std::int64_t{value}); }
    void operator()(const char*, const std::optional<double>& value) {
        row.bind(value.value_or(std::numeric_limits<double>::quiet_NaN()));
    }
};

struct ColumnReader {
    const SqliteStatement& row;
    int column;

    void operator()(const char*, std::string& text) { text = row.text(column++); }
    void operator()(const char*, bool& value) { value = row.whole(column++) != 0; }
    void operator()(const char*, std::optional<double>& value) {
        if (!row.is_null(column)) {
            value = row.number(column);
        }
        ++column;
    }
};

std::optional<StoredName> name_of(const SqliteConnection& connection, const std::string& key) {
    SqliteStatement holder(connection, "SELECT set_name, gyro FROM result WHERE key = ?");
    return holder.bind(key).step() ? std::optional(StoredName{holder.text(0), holder.text(1)})
                                   : std::nullopt;
}

std::int64_t write_head(const SqliteConnection& connection, const StoredResult& result,
                        std::optional<std::int64_t> wanted) {
    SqliteStatement head(connection, R"sql(
        INSERT INTO result (id, key, set_name, gyro, date, date_from, program, model, warnings)
        VALUES ((SELECT ?1 WHERE ?1 > 0 AND NOT EXISTS (SELECT 1 FROM result WHERE id = ?1)),
            ?, ?, ?, ?, ?, ?, ?, ?)
        ON CONFLICT (key) DO UPDATE SET set_name = excluded.set_name, gyro = excluded.gyro,
            date = excluded.date, date_from = excluded.date_from, program = excluded.program,
            model = excluded.model, warnings = excluded.warnings
        RETURNING id)sql");
    head.bind(wanted.value_or(0));
    head.bind(result.key).bind(result.set).bind(result.gyro).bind(result.date.text);
    head.bind(date_sources[static_cast<std::size_t>(result.date.source)])
        .bind(result.program)
        .bind(result.model);
    head.bind(result.warnings);
    head.step();
    const std::int64_t id = head.whole(0);
    head.run();
    return id;
}

// The options of opening that are given, by their names, as the command line has them.
std::string opening_of(const OpenOptions& options) {
    Json given = Json::array();
    for (const SettingRow<OpenOptions>& row : open_settings()) {
        if (const std::string text = row.text(options); !text.empty()) {
            given.push_back({row.name, text});
        }
    }
    return json_line(given);
}

// Pairs of a name and a value.
std::vector<std::pair<std::string, std::string>> pairs_in(const std::string& text) {
    std::vector<std::pair<std::string, std::string>> pairs;
    for (const Texts& pair : value_in<std::vector<Texts>>(text)) {
        if (pair.size() != 2) {
            throw DamagedRow("a name has no value");
        }
        pairs.emplace_back(pair[0], pair[1]);
    }
    return pairs;
}

void read_opening(const std::string& text, OpenOptions& options) {
    for (const auto& [name, value] : pairs_in(text)) {
        const auto* row = row_named(open_settings(), name);
        if (row == nullptr || !row->read(value, options)) {
            throw DamagedRow("--" + name + " " + value + " opens no recording");
        }
    }
}

void write_recordings(const SqliteConnection& connection, std::int64_t id,
                      const StoredResult& result) {
    SqliteStatement row(connection,
                        "INSERT INTO recording VALUES "
                        "(?, ?, ?, ?, ?, ?, ?, ?, ?, ?, ?, ?, ?, ?, ?, ?, ?, ?, ?, ?, ?)");
    std::int64_t position = 0;
    for (const RecordingRef& recording : result.recordings) {
        row.bind(id).bind(position++).bind(recording.file).bind(recording.path.string());
        row.bind(recording.name()).bind(recording.sha256).bind(recording.start);
        row.bind(recording.seconds).bind(recording.rate_hz).bind(recording.f0_hz);
        row.bind(std::int64_t{recording.open.channel_c});
        row.bind(std::int64_t{recording.open.channel_d});
        describe(Binder{row}, recording.conditions);
        row.bind(json_line(recording.others));
        row.bind(opening_of(recording.open));
        row.run();
    }
}

void write_parameters(const SqliteConnection& connection, std::int64_t id,
                      const StoredResult& result) {
    SqliteStatement row(connection, "INSERT INTO parameter VALUES (?, ?, ?, ?, ?, ?, ?, ?)");
    std::int64_t position = 0;
    for (const auto& [name, estimate] : result.parameters) {
        row.bind(name).bind(id).bind(position++);
        row.bind(estimate.value).bind(estimate.sd).bind(estimate.u);
        row.bind(estimate.given() ? std::string() : reason_name(estimate.reason.code));
        row.bind(json_line(args_json(estimate.reason.args)));
        row.run();
    }
}

// A column, or its substitute in a database of an older schema.
std::string column_since(const SqliteConnection& connection, int schema, const char* column,
                         const char* otherwise) {
    SqliteStatement version(connection, "PRAGMA user_version");
    version.step();
    return version.whole(0) < schema ? otherwise : column;
}

std::vector<RecordingRef> read_recordings(const SqliteConnection& connection, std::int64_t id) {
    const std::string opening = column_since(connection, 2, "opening", "'[]'");
    SqliteStatement row(connection, (R"sql(
        SELECT file, path, sha256, start, seconds, rate_hz, f0_hz, channel_c, channel_d,
            gyro, date, bias_v, temperature_c, exchanged, operator, comment, others, )sql" +
                                     opening + " FROM recording WHERE result = ? ORDER BY position")
                                        .c_str());
    row.bind(id);
    std::vector<RecordingRef> recordings;
    while (row.step()) {
        RecordingRef recording;
        recording.file = row.text(0);
        recording.path = row.text(1);
        recording.sha256 = row.text(2);
        recording.start = row.text(3);
        recording.seconds = row.number(4);
        recording.rate_hz = row.number(5);
        recording.f0_hz = row.number(6);
        recording.open.channel_c = static_cast<int>(row.whole(7));
        recording.open.channel_d = static_cast<int>(row.whole(8));
        describe(ColumnReader{row, 9}, recording.conditions);
        recording.others = pairs_in(row.text(16));
        read_opening(row.text(17), recording.open);
        recordings.push_back(std::move(recording));
    }
    return recordings;
}

// Row by row up to the diagonal: a covariance is symmetric, but for the rounding of its numbers.
std::vector<double> lower_part(const RawParameters& raw) {
    const std::size_t count = raw.names.size();
    std::vector<double> part;
    for (std::size_t row = 0; row < count; ++row) {
        for (std::size_t column = 0; column <= row; ++column) {
            part.push_back(raw.covariance[row * count + column]);
        }
    }
    return part;
}

}  // namespace

StoredDate date_of(const MeasurementSet& set) {
    if (const std::string date = list_date_of(set); !date.empty()) {
        return {date, DateSource::list};
    }
    for (const RecordingRef& recording : set.recordings) {
        if (is_iso_date(recording.start)) {
            return {recording.start, DateSource::recording};
        }
    }
    return {};
}

Result<StoredResult> stored_result(const SetResult& result, std::string json) {
    const MeasurementSet& set = result.set;
    const Identification& found = result.identification;
    StoredResult stored;
    stored.key = TRY(result_key(set));
    stored.set = set.name;
    stored.gyro = gyro_of(set);
    stored.date = date_of(set);
    stored.program = result.program;
    stored.model = found.fit.model == ResonatorModel::structured ? "structured" : "free";
    stored.warnings = warning_kinds(findings_of(found));
    stored.recordings = set.recordings;
    for (RecordingRef& recording : stored.recordings) {
        recording.path = absolute_path(recording.path);
        find_files_from(absolute_path("."), recording.open);
    }
    stored.parameters = parameters_of(found.fit);
    stored.raw = found.fit.raw;
    stored.json = std::move(json);
    return stored;
}

AddedResult write_result(SqliteConnection& connection, const StoredResult& result,
                         std::optional<std::int64_t> wanted) {
    std::optional<StoredName> replaced = name_of(connection, result.key);
    const std::int64_t id = write_head(connection, result, wanted);
    for (const char* sql :
         {"DELETE FROM recording WHERE result = ?", "DELETE FROM parameter WHERE result = ?",
          "DELETE FROM document WHERE result = ?"}) {
        SqliteStatement(connection, sql).bind(id).run();
    }
    write_recordings(connection, id, result);
    write_parameters(connection, id, result);
    SqliteStatement document(connection, "INSERT INTO document VALUES (?, ?, ?, ?, ?)");
    document.bind(id).bind(json_line(result.raw.names)).bind(json_line(result.raw.values));
    document.bind_packed(json_line(lower_part(result.raw))).bind_packed(result.json).run();
    return {id, std::move(replaced)};
}

std::optional<StoredResult> read_result(SqliteConnection& connection, std::int64_t id) {
    SqliteStatement head(connection, (R"sql(
        SELECT key, set_name, gyro, date, date_from, program, model, json, )sql" +
                                      column_since(connection, 3, "warnings", "''") + R"sql(
        FROM result JOIN document ON document.result = result.id WHERE result.id = ?)sql")
                                         .c_str());
    head.bind(id);
    if (!head.step()) {
        return std::nullopt;
    }
    StoredResult result;
    result.key = head.text(0);
    result.set = head.text(1);
    result.gyro = head.text(2);
    result.date = {head.text(3), source_of(head.text(4))};
    result.program = head.text(5);
    result.model = head.text(6);
    result.json = head.text(7);
    result.warnings = head.text(8);
    result.recordings = read_recordings(connection, id);
    return result;
}

std::vector<HistoryPoint> read_history(SqliteConnection& connection,
                                       const std::optional<std::string>& gyro,
                                       const std::string& parameter) {
    std::string sql = R"sql(
        SELECT r.id, r.set_name, r.gyro, r.date, r.date_from, r.program,
            p.value, p.sd, p.u, p.reason, p.reason_args,
            f.value, f.sd, f.u, f.reason, f.reason_args,
            (SELECT max(bias_v) FROM recording WHERE result = r.id),
            (SELECT avg(temperature_c) FROM recording WHERE result = r.id),
            (SELECT max(exchanged) FROM recording WHERE result = r.id), )sql" +
                      column_since(connection, 3, "r.warnings", "''") + R"sql(
        FROM result r
            JOIN parameter p ON p.name = ? AND p.result = r.id
            JOIN parameter f ON f.name = 'f_mean_hz' AND f.result = r.id)sql";
    sql += gyro ? " WHERE r.gyro = ?" : "";
    SqliteStatement row(connection, sql.c_str());
    row.bind(parameter);
    if (gyro) {
        row.bind(*gyro);
    }
    std::vector<HistoryPoint> points;
    while (row.step()) {
        HistoryPoint point;
        point.id = row.whole(0);
        point.set = row.text(1);
        point.gyro = row.text(2);
        point.date = {row.text(3), source_of(row.text(4))};
        point.time_s = iso_seconds(point.date.text);
        point.program = row.text(5);
        point.value = read_estimate(row, 6);
        point.f_mean_hz = read_estimate(row, 11);
        point.bias_v = row.number(16);
        point.temperature_c = row.number(17);
        point.exchanged = row.whole(18) != 0;
        point.warnings = row.text(19);
        points.push_back(std::move(point));
    }
    return points;
}

}  // namespace vybeg
