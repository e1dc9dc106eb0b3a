#pragma once

#include "core/analysis/identify_settings.h"
#include "core/base/setting_rows.h"
#include "core/drift/whole_angle_drift.h"
#include "core/drift/whole_angle_log.h"
#include "core/resonator/model/channel_tolerance.h"

#include <filesystem>
#include <span>
#include <vector>

namespace vybeg {

// How whole-angle logs are read, and how well the channels of their angle are known.
struct DriftSettings {
    OpenOptions open;
    LogChoice log;        // without phasors
    Tolerance tolerance;  // kappa and skew alone

    friend bool operator==(const DriftSettings&, const DriftSettings&) = default;
};

// A row for each of them, as analysis/setting_table.h has those of an analysis. The text of an
// option that is not given is empty, of the tolerance "none".
const std::vector<SettingRow<DriftSettings>>& drift_settings();

// Names and texts as on the command line, with the tolerances in use.
std::vector<NamedValue> settings_list(const DriftSettings& settings);

// Gain ratio and skew with their tolerances, in place of those that are not stated the usual ones.
ChannelTolerance pick_offs(const Tolerance& tolerance);

// A drift with the settings that it was computed with.
struct DriftOutcome {
    DriftSettings settings;
    WholeAngleDrift drift;
};

// Errors: those of read_whole_angle_log() and whole_angle_drift().
Result<DriftOutcome> drift_of_logs(std::span<const std::filesystem::path> paths,
                                   const DriftSettings& settings, const JobControl& job);

}  // namespace vybeg
