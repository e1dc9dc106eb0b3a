#pragma once

#include "core/base/job_control.h"
#include "core/base/result.h"
#include "core/recording/bytes/file_bytes.h"

#include <memory>
#include <string>
#include <string_view>
#include <vector>

namespace vybeg {

// The long form of LabOne's CSV: a line for each field of each chunk,
// `chunk;timestamp;size;fieldname;v0;v1;...`.

bool is_labone_rows(std::string_view head);

struct LaboneField {
    std::string name;
    std::vector<double> values;  // of all chunks; NaN where missing
};

// Fields of one length. Errors: file_read_failed; format_limit where a line is longer than 1 MiB;
// format_unsupported for several chunks without times; interrupted.
Result<std::vector<LaboneField>> read_labone_rows(std::shared_ptr<const FileBytes> file,
                                                  const JobControl& job);

}  // namespace vybeg
