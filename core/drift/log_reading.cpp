#include "core/drift/log_reading.h"

#include "core/recording/bytes/sha256.h"
#include "core/recording/open/log_columns.h"
#include "core/recording/samples/vocabulary.h"

#include <algorithm>
#include <cstddef>
#include <string_view>
#include <utility>
#include <vector>

namespace vybeg {
namespace {

const std::vector<ColumnRole>& log_roles() {
    static const std::vector<ColumnRole> roles{
        {"t", {"t", "t_s", "time", "time_s", "время"}, false},
        {"theta", wave_angle_names()},
        {"amplitude", amplitude_effort_names(), false},
        {"quadrature", quadrature_effort_names(), false}};
    return roles;
}

}  // namespace

Status check_log_columns(const std::string& columns) {
    const auto wishes = column_wishes(columns, log_roles());
    return wishes ? Status() : Status(wishes.error());
}

Result<WholeAngleLog> read_whole_angle_log(const std::filesystem::path& path,
                                           const LogReading& reading, const JobControl& job) {
    const auto wishes = TRY(column_wishes(reading.columns, log_roles()));
    auto table = TRY(read_log(path, reading.open, wishes, job));
    WholeAngleLog log;
    log.name = path.filename().string();
    auto sha256 = TRY(file_sha256(path, job));
    log.sha256 = std::move(sha256);
    log.time_s = std::move(table.time_s);
    const auto amplitude = std::ranges::find_if(wishes, [](const ColumnWish& wish) {
        return wish.role.name == std::string_view("amplitude");
    });
    for (std::size_t k = 0; k < wishes.size(); ++k) {
        LogColumn& column = table.columns[k];
        const std::string_view role = wishes[k].role.name;
        if (role == "theta") {
            const auto factor = TRY(angle_factor(path, column, reading.rad_per_angle_unit));
            for (const double value : column.values) {
                log.theta.push_back(factor * value);
            }
        } else if (role == "amplitude") {
            log.amplitude_effort = std::move(column.values);
        } else if (role == "quadrature") {
            bring_to_unit_of(table.columns[static_cast<std::size_t>(amplitude - wishes.begin())],
                             column);
            log.quadrature_effort = std::move(column.values);
        }
    }
    return log;
}

}  // namespace vybeg
