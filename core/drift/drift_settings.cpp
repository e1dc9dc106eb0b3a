#include "core/drift/drift_settings.h"

#include "core/recording/samples/open_table.h"

#include <numbers>
#include <string>
#include <utility>

namespace vybeg {
namespace {

using Row = SettingRow<DriftSettings>;

Row columns_row() {
    return value_row<std::string, DriftSettings>(
        {"columns", "NAMES",
         "What the columns are: t, theta, amplitude and quadrature effort, each with =COLUMN, a "
         "name or a number, where the file calls it otherwise, e.g. t,theta=angle (default: by "
         "their names)"},
        [](auto& s) -> auto& { return s.log.names; },
        [](const std::string& from) -> Result<std::string> {
            TRY(check_log_columns(from));
            return from;
        },
        [](const std::string& columns) { return columns; }, any_value);
}

Row angle_unit_row() {
    return choice_row<DriftSettings>(
        {"angle-unit", "deg|rad|cyc",
         "Unit of theta where the file does not tell it; cyc: whole turns"},
        [](auto& s) -> auto& { return s.log.rad_per_angle_unit; },
        {{"deg", log_angle_units[1]}, {"rad", log_angle_units[2]}, {"cyc", log_angle_units[3]}},
        "it is deg, rad or cyc");
}

// Gain ratio and skew, which the drift of an angle knows.
Result<Tolerance> read_pick_offs(const std::string& from) {
    const auto told = TRY(read_tolerance(from));
    Tolerance rest = told;
    rest[kappa_error].reset();
    rest[skew_error].reset();
    if (rest != Tolerance{}) {
        return refused_value("--tolerance", from, "it names kappa and skew");
    }
    return told;
}

Row pick_offs_row() {
    return value_row<Tolerance, DriftSettings>(
        {"tolerance", "NAME=X[,NAME=X]",
         "Standard deviations of the channels: kappa, skew (default kappa=0.01,skew=0.1deg)"},
        [](auto& s) -> auto& { return s.tolerance; }, read_pick_offs, tolerance_text, any_value);
}

std::vector<Row> rows_of_drift() {
    std::vector<Row> rows{columns_row(), angle_unit_row(), pick_offs_row()};
    for (const char* name :
         {"rate", "delimiter", "decimal", "skip-lines", "time-column", "time-unit"}) {
        rows.push_back(row_of_part<DriftSettings>(
            *row_named(open_settings(), name), [](auto& s) -> auto& { return s.open; }));
        rows.back().has_part = true;  // of a table of numbers, which is no recording
    }
    return rows;
}

}  // namespace

const std::vector<SettingRow<DriftSettings>>& drift_settings() {
    static const std::vector<Row> rows = rows_of_drift();
    return rows;
}

std::vector<NamedValue> settings_list(const DriftSettings& settings) {
    DriftSettings in_use = settings;
    for (const ErrorSource source : {kappa_error, skew_error}) {
        std::optional<double>& told = in_use.tolerance[source];
        told = told.value_or(assumed_tolerance(source, 1));
    }
    return listed(drift_settings(), in_use);
}

ChannelTolerance pick_offs(const Tolerance& tolerance) {
    ChannelTolerance channels = usual_pick_offs();
    channels[kappa_error] = tolerance[kappa_error].value_or(channels[kappa_error]);
    if (const std::optional<double>& told = tolerance[skew_error]) {
        // The factor of tolerated_errors would differ in the last digit of what u has been.
        channels[skew_error] = *told * std::numbers::pi / 180;
    }
    return channels;
}

Result<DriftOutcome> drift_of_logs(std::span<const std::filesystem::path> paths,
                                   const DriftSettings& settings, const JobControl& job) {
    std::vector<WholeAngleLog> logs;
    for (const std::filesystem::path& path : paths) {
        auto log = TRY(read_whole_angle_log(path, settings.open, settings.log, job.silent()));
        logs.push_back(std::move(log));
    }
    auto drift = TRY(whole_angle_drift(logs, job, pick_offs(settings.tolerance)));
    return DriftOutcome{settings, std::move(drift)};
}

}  // namespace vybeg
