#include "core/analysis/power_log.h"

#include "core/recording/open/log_columns.h"

#include <string>
#include <utility>
#include <vector>

namespace vybeg {
namespace {

const std::vector<ColumnRole>& roles_of_powers() {
    static const std::vector<ColumnRole> roles{
        time_of_log(), {"E", {"E"}}, {"R", {"R"}}, {"S", {"S"}}, {"Q", {"Q"}}};
    return roles;
}

// Those of a track, too.
const std::vector<ColumnRole>& roles_of_waves() {
    static const std::vector<ColumnRole> roles{
        time_of_log(),
        {"a", {"a", "a_A"}},
        {"b", {"b", "a_B"}},
        {"theta",
         {"theta", "theta_rad", "theta_deg", "theta_A", "theta_A_rad", "two_theta_A_rad"}}};
    return roles;
}

// Column of a role among the wishes; null: not among them.
LogColumn* column_of(const std::vector<ColumnWish>& wishes, LogTable& table,
                     const std::string& role) {
    for (std::size_t k = 0; k < wishes.size(); ++k) {
        if (wishes[k].role.name == role) {
            return &table.columns[k];
        }
    }
    return nullptr;
}

}  // namespace

Result<PowerRun> read_power_log(const std::filesystem::path& path, const OpenOptions& options,
                                const LogChoice& columns, const SignalSettings& signal,
                                const JobControl& job) {
    const double from_s = signal.from_s.value_or(TimeRange{}.from_s);
    const double to_s = signal.to_s.value_or(TimeRange{}.to_s);
    const auto waves = column_wishes(columns.names, roles_of_waves());
    if (!waves) {
        const auto wishes = TRY(column_wishes(columns.names, roles_of_powers()));
        auto table = TRY(read_log(path, options, wishes, job));
        TRY(keep_times(path, from_s, to_s, table));
        PowerRun run;
        run.e = std::move(column_of(wishes, table, "E")->values);
        run.r = std::move(column_of(wishes, table, "R")->values);
        run.s = std::move(column_of(wishes, table, "S")->values);
        run.q = std::move(column_of(wishes, table, "Q")->values);
        run.time_s = std::move(table.time_s);
        return run;
    }
    auto table = TRY(read_log(path, options, *waves, job));
    TRY(keep_times(path, from_s, to_s, table));
    LogColumn& theta = *column_of(*waves, table, "theta");
    const auto factor = TRY(angle_factor(path, theta, columns.rad_per_angle_unit));
    for (double& value : theta.values) {
        value *= factor;
    }
    return powers_of_waves(std::move(table.time_s), column_of(*waves, table, "a")->values,
                           column_of(*waves, table, "b")->values, theta.values);
}

}  // namespace vybeg
