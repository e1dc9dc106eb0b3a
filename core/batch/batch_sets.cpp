#include "core/batch/batch_sets.h"

#include "core/analysis/measurement_list.h"
#include "core/analysis/setting_table.h"
#include "core/base/message_arg.h"
#include "core/base/plain_text.h"
#include "core/base/read_value.h"
#include "core/output/batch_csv.h"
#include "core/output/output_file.h"
#include "core/recording/bytes/sha256.h"
#include "core/recording/samples/open_table.h"
#include "core/recording/text/csv_rows.h"

#include <algorithm>
#include <array>
#include <climits>
#include <filesystem>
#include <map>
#include <set>
#include <span>
#include <sys/stat.h>
#include <system_error>
#include <tuple>
#include <utility>

namespace vybeg {
namespace {

constexpr std::size_t most_names = 8;  // in a message

namespace fs = std::filesystem;

// The journal of SQLite beside a database.
std::string rollback_of(const std::string& database) {
    return database + "-journal";
}

// FOLDER/NAME.json. Characters of the name that cannot be in a file name are shown as %2F.
std::filesystem::path json_in(const std::filesystem::path& folder, const std::string& name) {
    std::string file;
    for (const char character : name) {
        const auto byte = static_cast<unsigned char>(character);
        const bool hides = character == '.' && file.empty();
        if (hides || character == '/' || character == '%' || byte < ' ' || byte == 0x7F) {
            file += '%';
            file += "0123456789ABCDEF"[byte >> 4];
            file += "0123456789ABCDEF"[byte & 15];
        } else {
            file += character;
        }
    }
    return folder / (file + ".json");
}

// The passport of the set's gyro in a folder, or of the set where it names no gyro; empty: there is
// none.
std::string passport_in(const std::string& folder, const MeasurementSet& set) {
    if (folder.empty()) {
        return {};
    }
    const std::string gyro = gyro_of(set);
    const std::filesystem::path path = json_in(folder, gyro.empty() ? set.name : gyro);
    std::error_code unknown;
    return std::filesystem::exists(path, unknown) ? path.string() : "";
}

// Value of the list's column gyro_type for a set; empty: not stated. Errors: conditions_differ.
Result<std::string> gyro_type_of(const MeasurementSet& set) {
    const auto type_of = [](const RecordingRef& recording) {
        const auto type = std::ranges::find(recording.others, "gyro_type", &NamedValue::first);
        return type == recording.others.end() ? std::string() : type->second;
    };
    return one_told(set, Phrase::tr("the type of the gyro"), type_of, true);
}

constexpr const char* no_file = "-";  // its stamp

// Size of a file and times of the last change of its bytes and of its inode.
std::string file_stamp(const std::filesystem::path& path) {
    struct stat status {};
    if (stat(path.c_str(), &status) != 0) {
        return no_file;
    }
    std::string text = integer_text(status.st_size);
    for (const timespec& time : {status.st_mtim, status.st_ctim}) {
        for (const std::int64_t part : {std::int64_t{time.tv_sec}, std::int64_t{time.tv_nsec}}) {
            text += ',';
            text += integer_text(part);
        }
    }
    return text;
}

}  // namespace

bool ends_all(ErrorCode code) {
    const int status = exit_status(code);
    return code == ErrorCode::out_of_memory || code == ErrorCode::out_of_threads ||
           status == exit_status(ErrorCode::output_failed) ||
           status == exit_status(ErrorCode::interrupted);
}

Status keep_set(MeasurementList& list, const std::string& option, const std::string& name) {
    const auto found = std::ranges::find(list.sets, name, &MeasurementSet::name);
    if (found != list.sets.end()) {
        list.sets = {MeasurementSet(*found)};
        return {};
    }
    std::string names = joined(std::span(list.sets).first(std::min(list.sets.size(), most_names)),
                               ", ", &MeasurementSet::name);
    names += list.sets.size() > most_names ? ", ..." : "";
    return name.empty() ? Error{ErrorCode::set_not_chosen, "", {option, names}}
                        : refused_value(option, name, "the sets of the list are " + names);
}

Result<std::string> row_key(const BatchRequest& request, const SetTask& task,
                            const std::string& database) {
    const MeasurementSet& set = *task.set;
    std::string text;
    const auto given = [](const std::optional<double>& number) {
        return number ? round_trip_text(*number) : "";
    };
    add_parts(text, {request.program, set.name, task.passport, file_stamp(task.passport),
                     round_trip_text(request.compare.f_limit_ppm),
                     practical_limits_text(request.compare.limits), task.json, task.new_passport,
                     database});
    if (task.limits) {
        for (const ParameterLimit& limit : *task.limits) {
            add_parts(text, {limit.parameter, given(limit.lower), given(limit.upper)});
        }
    }
    // Rows of a table with other columns are computed again.
    add_parts(text, batch_columns(task.limits.has_value()));
    for (const auto& [name, value] : settings_list(set.settings)) {
        add_parts(text, {name, value});
    }
    for (const RecordingRef& recording : set.recordings) {
        const OpenOptions& open = recording.open;
        add_parts(text, {recording.file, recording.path.string(), file_stamp(recording.path),
                         options_text(open), given(open.rate_hz), integer_text(open.channel_c),
                         integer_text(open.channel_d)});
        for (const std::filesystem::path& file : further_files(open)) {
            add_parts(text, {file_stamp(file)});
        }
        for (const auto& [column, field] : fields_of(recording.conditions)) {
            add_parts(text, {field});
        }
        for (const auto& [column, other] : recording.others) {
            add_parts(text, {other});
        }
    }
    return text_sha256(text);
}

const std::string& field_of(const BatchRow& fields, const std::string& column) {
    static const std::vector<std::string> names = batch_columns(true);
    return fields.at(static_cast<std::size_t>(std::ranges::find(names, column) - names.begin()));
}

std::set<std::string> kept_keys(const std::vector<SetTask>& tasks, const RowJournal& journal,
                                bool with_files) {
    const auto is_there = [](const std::string* file) {
        std::error_code unknown;
        return file->empty() ||
               (fs::is_regular_file(*file, unknown) && fs::file_size(*file, unknown) > 0);
    };
    std::map<std::string, const SetTask*> by_name;
    for (const SetTask& task : tasks) {
        by_name.emplace(plain_text(task.set->name), &task);
    }
    std::set<std::string> kept;
    std::set<std::string> seen;
    std::set<std::string> of_others;
    for (auto row = journal.rows().rbegin(); row != journal.rows().rend(); ++row) {
        const BatchRow fields = csv_fields(row->text);
        const auto found = by_name.find(field_of(fields, "set"));
        bool is_free = true;
        for (const std::string_view part : parts_between(field_of(fields, "files"), ';')) {
            const std::string file(part);
            is_free = is_free && !of_others.contains(file);
            if (found == by_name.end()) {
                of_others.insert(file);
            }
        }
        if (found == by_name.end() || !seen.insert(found->first).second ||
            row->key != found->second->key || !is_free) {
            continue;
        }
        const SetTask& task = *found->second;
        if (!with_files || field_of(fields, "status") != "ok" ||
            std::ranges::all_of(std::array{&task.json, &task.new_passport}, is_there)) {
            kept.insert(row->key);
        }
    }
    return kept;
}

std::vector<std::string> rows_of_left_sets(const std::vector<SetTask>& tasks,
                                           const RowJournal& journal, const std::string& request,
                                           bool limits, std::size_t columns) {
    std::set<std::string> sets;
    std::set<std::string> files;
    for (const SetTask& task : tasks) {
        sets.insert(task.set->name);
        for (const RecordingRef& recording : task.set->recordings) {
            files.insert(recording.file);
        }
    }
    std::vector<std::string> rows;
    for (auto row = journal.rows().rbegin(); row != journal.rows().rend(); ++row) {
        if (!row->key.starts_with(request)) {
            continue;
        }
        BatchRow fields = csv_fields(row->text);
        bool known = !sets.insert(field_of(fields, "set")).second;
        for (const std::string_view part : parts_between(field_of(fields, "files"), ';')) {
            known = !files.emplace(part).second || known;
        }
        if (known) {
            continue;
        }
        if (fields.size() != columns) {
            fields.resize(batch_columns(limits).size());
            fields.resize(columns);
        }
        rows.push_back(csv_row(fields));
    }
    std::ranges::reverse(rows);
    return rows;
}

bool is_folder(const std::string& path) {
    std::error_code unknown;
    return fs::is_directory(path, unknown);
}

std::string journal_of(const std::string& output) {
    return output + ".unfinished";
}

Result<MeasurementList> wanted_list(const BatchRequest& request) {
    if (!is_folder(request.list)) {
        return read_measurement_list(request.list, request.open, request.settings);
    }
    const auto left_out = [&request](const fs::path& path) {
        // An output that is a file of another kind stays an input, which check_paths() keeps from
        // being replaced.
        return is_batch_table(path) || path.extension() == journal_of("") ||
               path.extension() == ".json" ||
               (!request.limits.empty() && same_file(path, request.limits)) ||
               (!request.database.empty() && (same_file(path, request.database) ||
                                              same_file(path, rollback_of(request.database))));
    };
    return list_of_folder(request.list, request.open, request.settings, left_out);
}

Result<MeasurementList> FolderWatch::look() {
    auto files = TRY(wanted_list(request_));
    stamps_before_ = std::exchange(stamps_, {});
    fault_.reset();
    const bool had_list = !std::exchange(list_, fs::path()).empty() || looks_without_ > 0;
    MeasurementList come;
    std::set<fs::path> listed;
    std::vector<MeasurementSet> single;
    bool list_in_writing = false;
    for (MeasurementSet& file : files.sets) {
        const fs::path& path = file.recordings.front().path;
        const bool settled = is_settled(path);
        const bool is_list = is_measurement_list(path);
        list_in_writing = list_in_writing || (is_list && !settled);
        if (!settled) {
            continue;
        }
        if (!is_list) {
            single.push_back(std::move(file));
            continue;
        }
        if (!list_.empty()) {
            fault_ =
                Error{ErrorCode::list_invalid,
                      path.string(),
                      {count_arg(1), "file",
                       Phrase::tr("the folder has another list, %1", {list_.filename().string()})}};
            continue;
        }
        list_ = path;
        Result<MeasurementList> list =
            read_measurement_list(path, request_.open, request_.settings);
        if (!list) {
            fault_ = list.error();
            continue;
        }
        come = std::move(*list);
    }
    // A list that is saved anew, or on a share that blinks, is away for a moment.
    constexpr int most_looks = 5;
    const bool gone = list_.empty() && !list_in_writing && had_list;
    looks_without_ = gone && looks_without_ < most_looks ? looks_without_ + 1 : 0;
    if (fault_ || list_in_writing || looks_without_ > 0) {  // which files are its sets' is unknown
        return MeasurementList{};
    }
    std::erase_if(come.sets, [&](const MeasurementSet& set) {
        bool complete = true;
        for (const RecordingRef& recording : set.recordings) {
            std::vector<fs::path> parts = further_files(recording.open);
            parts.push_back(recording.path);
            for (const fs::path& part : parts) {
                listed.insert(part.lexically_normal());
                complete = is_settled(part) && complete;
            }
        }
        return !complete;
    });
    for (MeasurementSet& file : single) {
        RecordingRef& recording = file.recordings.front();
        if (!listed.contains(recording.path.lexically_normal())) {
            for (const std::string& column : come.other_columns) {
                recording.others.emplace_back(column, "");
            }
            come.sets.push_back(std::move(file));
        }
    }
    std::ranges::copy(files.warnings, std::back_inserter(come.warnings));
    return come;
}

// A file is looked at once a look, so that one of the folder and of its list is the same.
bool FolderWatch::is_settled(const fs::path& path) {
    const fs::path key = path.lexically_normal();
    const auto [now, is_new] = stamps_.try_emplace(key);
    if (is_new) {
        now->second = file_stamp(path);
    }
    const auto before = stamps_before_.find(key);
    return before != stamps_before_.end() && before->second == now->second &&
           now->second != no_file;
}

Result<std::vector<SetTask>> tasks_of(const BatchRequest& request, const MeasurementList& list,
                                      const std::vector<TypedLimit>& limits) {
    std::map<std::string, int> sets_of_gyro;
    for (const MeasurementSet& set : list.sets) {
        ++sets_of_gyro[gyro_of(set)];
    }
    std::vector<SetTask> tasks;
    for (const MeasurementSet& set : list.sets) {
        SetTask task{&set, passport_in(request.passports, set), "", "", {}, ""};
        const std::string gyro = gyro_of(set);
        const bool by_gyro = !gyro.empty() && sets_of_gyro[gyro] == 1;
        for (const auto& [option, folder, name, file] :
             {std::tuple{"--json", &request.json, &set.name, &task.json},
              {"--passports-out", &request.new_passports, by_gyro ? &gyro : &set.name,
               &task.new_passport}}) {
            if (folder->empty()) {
                continue;
            }
            const fs::path path = json_in(*folder, *name);
            if (path.filename().string().size() > NAME_MAX) {
                return refused_value(option, *name, Phrase::tr("this name is too long for a file"));
            }
            *file = path.string();
        }
        if (!request.limits.empty()) {
            const Result<std::string> type = gyro_type_of(set);
            task.limits = type ? limits_of_type(limits, *type) : std::vector<ParameterLimit>();
            task.fault = type ? std::nullopt : std::optional(type.error());
        }
        tasks.push_back(std::move(task));
    }
    return tasks;
}

Status check_paths(const BatchRequest& request, const std::vector<SetTask>& tasks) {
    std::vector<InputPath> inputs{{request.list, Phrase::tr("it is the list of the recordings")}};
    inputs.push_back({request.limits, Phrase::tr("it is the table of limits")});
    for (const SetTask& task : tasks) {
        inputs.push_back({task.passport, Phrase::tr("it is one of the passports")});
        for (const RecordingRef& recording : task.set->recordings) {
            add_recording_files(inputs, recording.path, recording.open);
        }
    }
    if (request.database == "-") {
        return refused_value("--database", request.database, Phrase::tr("it must be a file"));
    }
    const MessageArg by_table = Phrase::tr("the table goes there already");
    TRY(check_outputs({{"-o", request.output, by_table}, {"--database", request.database, ""}},
                      inputs));
    if (!request.database.empty()) {
        if (same_file(request.database, journal_of(request.output)) ||
            same_file(rollback_of(request.database), request.output)) {
            return refused_value("--database", request.database, by_table);
        }
        inputs.push_back({request.database, ""});
    }
    for (const auto& [option, folder] :
         {std::pair{"--json", &request.json}, {"--passports-out", &request.new_passports}}) {
        if (*folder == "-") {
            return refused_value(option, *folder, Phrase::tr("it must be a folder"));
        }
        for (const std::string& file : {request.output, request.database}) {
            if (!file.empty() &&
                fs::path(*folder).lexically_normal() == fs::path(file).lexically_normal()) {
                return refused_value(option, *folder, by_table);
            }
        }
    }
    // Many results and many inputs: by device and inode instead of pair by pair.
    std::set<std::pair<dev_t, ino_t>> taken;
    inputs.push_back({request.output, ""});
    for (const InputPath& input : inputs) {
        struct stat status {};
        if (stat(input.path.c_str(), &status) == 0) {
            taken.emplace(status.st_dev, status.st_ino);
        }
    }
    const auto is_free = [&](const std::string& path) {
        struct stat status {};
        const bool is_taken =
            stat(path.c_str(), &status) == 0 && taken.contains({status.st_dev, status.st_ino});
        // The table and the folder of the results may both be still to come.
        return !is_taken && !same_file(path, request.output) &&
               (request.database.empty() || !same_file(path, request.database));
    };
    std::set<FilePlace> places;
    for (const SetTask& task : tasks) {
        for (const auto& [option, path] :
             {std::pair{"--json", &task.json}, std::pair{"--passports-out", &task.new_passport}}) {
            if (path->empty()) {
                continue;
            }
            if (!is_free(*path)) {
                return refused_value(option, *path,
                                     Phrase::tr("it is an input, the table or the database"));
            }
            const auto place = place_of(*path);
            if (place && !places.insert(*place).second) {
                return refused_value(option, *path,
                                     Phrase::tr("another result of this batch goes there"));
            }
        }
    }
    const Status known = check_ending(request.output, {"", ".csv", ".txt"});
    return request.output == "-" ? Status() : known;
}

}  // namespace vybeg
