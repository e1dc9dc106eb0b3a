#pragma once

#include "core/analysis/measurement_list.h"
#include "core/base/result.h"
#include "core/batch/batch_request.h"
#include "core/batch/limits.h"

#include <string>
#include <vector>

namespace vybeg {

// Files and folders of a batch.

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
