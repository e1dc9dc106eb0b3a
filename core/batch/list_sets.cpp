#include "core/batch/list_sets.h"

#include "core/analysis/measurement_list.h"
#include "core/analysis/setting_table.h"
#include "core/base/read_value.h"
#include "core/batch/limits.h"
#include "core/output/batch_csv.h"
#include "core/recording/bytes/sha256.h"
#include "core/recording/samples/open_table.h"

#include <algorithm>
#include <sys/stat.h>
#include <system_error>

namespace vybeg {
namespace {

constexpr std::size_t most_names = 8;  // in a message

}  // namespace

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

Result<MeasurementSet> set_named(const MeasurementList& list, const std::string& option,
                                 const std::string& name) {
    const auto found = std::ranges::find(list.sets, name, &MeasurementSet::name);
    if (found != list.sets.end()) {
        return *found;
    }
    std::string names;
    for (std::size_t k = 0; k < std::min(list.sets.size(), most_names); ++k) {
        names += (k == 0 ? "" : ", ") + list.sets[k].name;
    }
    names += list.sets.size() > most_names ? ", ..." : "";
    return name.empty() ? Error{ErrorCode::set_not_chosen, "", {option, names}}
                        : refused_value(option, name, "the sets of the list are " + names);
}

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

std::string passport_in(const std::string& folder, const MeasurementSet& set) {
    if (folder.empty()) {
        return {};
    }
    const std::string gyro = gyro_of(set);
    const std::filesystem::path path = json_in(folder, gyro.empty() ? set.name : gyro);
    std::error_code unknown;
    return std::filesystem::exists(path, unknown) ? path.string() : "";
}

std::string gyro_type_of(const MeasurementList& list, const MeasurementSet& set) {
    const auto column = std::ranges::find(list.other_columns, "gyro_type");
    return column == list.other_columns.end()
               ? ""
               : other_of(set, static_cast<std::size_t>(column - list.other_columns.begin()));
}

Result<std::string> row_key(const BatchRequest& request, const SetTask& task,
                            const std::string& database) {
    const MeasurementSet& set = *task.set;
    std::string text;
    for (const std::string& part :
         {request.program, set.name, task.passport, file_stamp(task.passport),
          round_trip_text(request.compare.f_limit_ppm),
          practical_limits_text(request.compare.limits), task.json, task.new_passport, database}) {
        add_part(text, part);
    }
    if (task.limits) {
        for (const ParameterLimit& limit : *task.limits) {
            add_part(text, limit.parameter);
            for (const std::optional<double>& end : {limit.lower, limit.upper}) {
                add_part(text, end ? round_trip_text(*end) : "");
            }
        }
    }
    // Rows of a table with other columns are computed again.
    for (const std::string& column : batch_columns(task.limits.has_value())) {
        add_part(text, column);
    }
    for (const auto& [name, value] : settings_list(set.settings)) {
        add_part(text, name);
        add_part(text, value);
    }
    for (const RecordingRef& recording : set.recordings) {
        const OpenOptions& open = recording.open;
        for (const std::string& part :
             {recording.file, recording.path.string(), file_stamp(recording.path),
              options_text(open), open.rate_hz ? round_trip_text(*open.rate_hz) : std::string(),
              integer_text(open.channel_c), integer_text(open.channel_d)}) {
            add_part(text, part);
        }
        for (const std::filesystem::path& file : further_files(open)) {
            add_part(text, file_stamp(file));
        }
        for (const auto& [column, field] : fields_of(recording.conditions)) {
            add_part(text, field);
        }
        for (const auto& [column, other] : recording.others) {
            add_part(text, other);
        }
    }
    return text_sha256(text);
}

}  // namespace vybeg
