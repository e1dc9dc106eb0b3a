#pragma once

#include "core/analysis/measurement_list.h"
#include "core/base/result.h"
#include "core/batch/batch_request.h"
#include "core/batch/limits.h"

#include <filesystem>
#include <string>
#include <vector>

namespace vybeg {

// Sets of a measurement list or a batch, and the files that belong to them.

// The set that an option names. Errors, with the names that there are: setting_invalid;
// set_not_chosen without a name.
Result<MeasurementSet> set_named(const MeasurementList& list, const std::string& option,
                                 const std::string& name);

// Size of a file and times of the last change of its bytes and of its inode.
std::string file_stamp(const std::filesystem::path& path);
inline constexpr const char* no_file = "-";  // its stamp

// All that the row of a task depends on, as a hash: program, columns of the table, set, conditions,
// settings, limits, the files by size and time of change, and what else its result goes into;
// `database`: its identity, empty: none. Errors: file_read_failed.
Result<std::string> row_key(const BatchRequest& request, const SetTask& task,
                            const std::string& database);

bool is_folder(const std::string& path);

// Finished rows of a table that is not complete, beside it.
std::string journal_of(const std::string& output);

// The sets of the list, or of the folder without what the batch itself writes there. Errors: those
// of read_measurement_list() and list_of_folder().
Result<MeasurementList> wanted_list(const BatchRequest& request);

// The sets with their passports, limits, and the files of their results. A new passport has the
// name of the gyro, as a later comparison looks for it, or of the set where several sets are of one
// gyro or of an unnamed one. `list` must outlive the tasks. Errors: setting_invalid for a set whose
// name is too long for a file.
Result<std::vector<SetTask>> tasks_of(const BatchRequest& request, const MeasurementList& list,
                                      const std::vector<TypedLimit>& limits);

// No output may take the place of an input or of another output. Errors: setting_invalid.
Status check_paths(const BatchRequest& request, const std::vector<SetTask>& tasks);

// A folder for results, made where there is none. Errors: output_failed.
Status make_folder(const std::string& path);

}  // namespace vybeg
