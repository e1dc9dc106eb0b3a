#pragma once

#include "core/analysis/measurement_list.h"
#include "core/analysis/passport.h"
#include "core/base/result.h"
#include "core/batch/batch_request.h"
#include "core/output/batch_csv.h"
#include "core/output/row_journal.h"
#include "core/resonator/results/resonator_parameters.h"

#include <filesystem>
#include <map>
#include <optional>
#include <set>
#include <string>
#include <string_view>
#include <vector>

namespace vybeg {

// A row of a table of limits.
struct TypedLimit {
    std::string gyro_type;  // empty: of every gyro whose type has no limit of its own
    ParameterLimit limit;
};

// Reads a table of limits, CSV as a measurement list is one: parameter, least, greatest, gyro_type
// (may be missing). Parameters are named as in the table of results; an empty field is no limit.
// Errors: those of read_csv(); list_invalid.
Result<std::vector<TypedLimit>> read_limits(const std::filesystem::path& path);

// The limits of one type of gyro, those of its own in place of those of all.
std::vector<ParameterLimit> limits_of_type(const std::vector<TypedLimit>& limits,
                                           const std::string& gyro_type);

// Reads NAME=X[,NAME=X]: parameters named as in the table of results, whose unit may be left out
// (tau, f_mean). X is in the parameter's unit or, as X% or Xppm, relative to the passport's value.
// Errors: setting_invalid of --limit.
Result<std::vector<PracticalLimit>> read_practical_limits(std::string_view text);

// The text that reads back as these limits.
std::string practical_limits_text(const std::vector<PracticalLimit>& limits);

// Sets of a measurement list or a batch, and the files that belong to them.

// Whether a fault is no property of a set: memory, threads, an output, an interruption. It ends the
// work on all sets, and the set is computed again later.
bool ends_all(ErrorCode code);

// Leaves the set alone that an option names. Errors, with the names that there are:
// setting_invalid; set_not_chosen without a name.
Status keep_set(MeasurementList& list, const std::string& option, const std::string& name);

// All that the row of a task depends on, as a hash: program, columns of the table, set, conditions,
// settings, limits, the files by size and time of change, and what else its result goes into;
// `database`: its identity, empty: none. Errors: file_read_failed.
Result<std::string> row_key(const BatchRequest& request, const SetTask& task,
                            const std::string& database);

// A field of a row by the name of its column, which each table has or, if it has limits, this one.
const std::string& field_of(const BatchRow& fields, const std::string& column);

// Keys of the rows that need not be computed: each is the last one of its set, no set that is not
// there any more has a later one of the same files, and, `with_files`, the files of its result are
// there. What else has been written meanwhile, as into the database, is then of this row.
std::set<std::string> kept_keys(const std::vector<SetTask>& tasks, const RowJournal& journal,
                                bool with_files);

// Rows of sets whose recordings have left a watched folder, in the order of their computation,
// whose keys begin with `request`. A row counts no more where its set, or a file of it, has a later
// one. `columns`: of the table; without those of the list where these were others.
std::vector<std::string> rows_of_left_sets(const std::vector<SetTask>& tasks,
                                           const RowJournal& journal, const std::string& request,
                                           bool limits, std::size_t columns);

bool is_folder(const std::string& path);

// Finished rows of a table that is not complete, beside it.
std::string journal_of(const std::string& output);

// The sets of the list, or of the folder without what the batch itself writes there. Errors: those
// of read_measurement_list() and list_of_folder().
Result<MeasurementList> wanted_list(const BatchRequest& request);

// What has come to a folder so far: the sets of its measurement list, where it has one, whose
// recordings are all there, and every other file as a set of its own. A file counts when its size
// and times are those of the look before: nothing writes it any more.
class FolderWatch {
public:
    static constexpr double pause_s = 1;  // between two looks

    // `request` must outlive this object.
    explicit FolderWatch(const BatchRequest& request) : request_(request) {}

    // Nothing while the folder's list has a fault or is being written. Errors: those of
    // list_of_folder().
    Result<MeasurementList> look();

    // The folder's measurement list at the last look; empty: none.
    const std::filesystem::path& list() const { return list_; }

    // Why the folder's list does not count at the last look: those of read_measurement_list(), and
    // list_invalid for a second list.
    const std::optional<Error>& fault() const { return fault_; }

private:
    bool is_settled(const std::filesystem::path& path);

    const BatchRequest& request_;
    std::filesystem::path list_;
    int looks_without_ = 0;  // since the list was there
    std::optional<Error> fault_;
    std::map<std::filesystem::path, std::string> stamps_;         // of this look
    std::map<std::filesystem::path, std::string> stamps_before_;  // of the look before
};

// The sets with their passports, limits, and the files of their results. A new passport has the
// name of the gyro, as a later comparison looks for it, or of the set where several sets are of one
// gyro or of an unnamed one. `list` must outlive the tasks. Errors: setting_invalid for a set whose
// name is too long for a file.
Result<std::vector<SetTask>> tasks_of(const BatchRequest& request, const MeasurementList& list,
                                      const std::vector<TypedLimit>& limits);

// No output may take the place of an input or of another output. Errors: setting_invalid.
Status check_paths(const BatchRequest& request, const std::vector<SetTask>& tasks);

}  // namespace vybeg
