#include "core/batch/batch_paths.h"

#include "core/analysis/set_conditions.h"
#include "core/base/message_arg.h"
#include "core/base/read_value.h"
#include "core/batch/list_sets.h"
#include "core/output/batch_csv.h"
#include "core/output/output_paths.h"

#include <climits>
#include <filesystem>
#include <map>
#include <set>
#include <sys/stat.h>
#include <system_error>
#include <tuple>
#include <utility>

namespace vybeg {
namespace {

namespace fs = std::filesystem;

// The journal of SQLite beside a database.
std::string rollback_of(const std::string& database) {
    return database + "-journal";
}

}  // namespace

bool is_folder(const std::string& path) {
    std::error_code unknown;
    return fs::is_directory(path, unknown);
}

std::string journal_of(const std::string& output) {
    return output + ".unfinished";
}

Result<MeasurementList> wanted_list(const BatchRequest& request) {
    const ListDefaults defaults{request.open, request.settings};
    if (!is_folder(request.list)) {
        return read_measurement_list(request.list, defaults);
    }
    return list_of_folder(request.list, defaults, [&request](const fs::path& path) {
        // An output that is a file of another kind stays an input, which check_paths() keeps from
        // being replaced.
        return is_batch_table(path) || path.extension() == journal_of("") ||
               (!request.database.empty() && (same_file(path, request.database) ||
                                              same_file(path, rollback_of(request.database))));
    });
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
                return refused_value(
                    option, *name,
                    words(VYBEG_MESSAGE("Words", "this name is too long for a file")));
            }
            *file = path.string();
        }
        if (!request.limits.empty()) {
            task.limits = limits_of_type(limits, gyro_type_of(list, set));
        }
        tasks.push_back(std::move(task));
    }
    return tasks;
}

Status check_paths(const BatchRequest& request, const std::vector<SetTask>& tasks) {
    std::vector<InputPath> inputs{
        {request.list, words(VYBEG_MESSAGE("Words", "it is the list of the recordings"))}};
    inputs.push_back({request.limits, words(VYBEG_MESSAGE("Words", "it is the table of limits"))});
    for (const SetTask& task : tasks) {
        inputs.push_back(
            {task.passport, words(VYBEG_MESSAGE("Words", "it is one of the passports"))});
        for (const RecordingRef& recording : task.set->recordings) {
            inputs.push_back({recording.path.string(),
                              words(VYBEG_MESSAGE("Words", "it is one of the recordings"))});
        }
    }
    if (request.database == "-") {
        return refused_value("--database", request.database,
                             words(VYBEG_MESSAGE("Words", "it must be a file")));
    }
    const MessageArg by_table = words(VYBEG_MESSAGE("Words", "the table goes there already"));
    TRY(check_outputs({{"-o", request.output, by_table}, {"--database", request.database, ""}},
                      inputs));
    if (!request.database.empty()) {
        if (same_file(request.database, journal_of(request.output)) ||
            same_file(rollback_of(request.database), request.output)) {
            return refused_value("--database", request.database, by_table);
        }
        inputs.push_back({request.database, ""});
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
    std::set<std::string> files;
    for (const SetTask& task : tasks) {
        for (const auto& [option, path] :
             {std::pair{"--json", &task.json}, std::pair{"--passports-out", &task.new_passport}}) {
            if (path->empty()) {
                continue;
            }
            if (!is_free(*path)) {
                return refused_value(
                    option, *path,
                    words(VYBEG_MESSAGE("Words", "it is an input, the table or the database")));
            }
            std::error_code unknown;
            if (!files.insert(fs::weakly_canonical(*path, unknown).string()).second) {
                return refused_value(
                    option, *path,
                    words(VYBEG_MESSAGE("Words", "another result of this batch goes there")));
            }
        }
    }
    const Status known = check_ending(request.output, {"", ".csv", ".txt"});
    return request.output == "-" ? Status() : known;
}

Status make_folder(const std::string& path) {
    std::error_code failed;
    fs::create_directories(path, failed);
    return failed ? Status(Error{ErrorCode::output_failed, path, {system_reason(failed.value())}})
                  : Status();
}

}  // namespace vybeg
