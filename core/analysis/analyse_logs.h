#pragma once

#include "core/analysis/analysis.h"
#include "core/analysis/identify.h"
#include "core/analysis/identify_settings.h"
#include "core/analysis/logs.h"
#include "core/base/job_control.h"
#include "core/base/result.h"
#include "core/recording/samples/open_options.h"
#include "core/resonator/model/power_run.h"

#include <filesystem>
#include <span>
#include <string>

namespace vybeg {

// The slow variables of a log in place of a recording, a row per window of its phasors or per row
// of its powers, with the deviations that their noise gives. f is the mean rate of phase from the
// window before to the one after, weighted with power. Values that no log has (rms, orthogonality,
// and where it has no phase alpha and f) are NaN, as are the angles where a_A = |a_B| within the
// noise.
//
// Of the settings those of the signal count, as for read_phasor_log() and read_power_log(), whose
// errors are these. In the summary f0_hz is the frequency of reference, NaN without a phase; the
// plan and the noise are in rows of the log, its rate that of the rows.
Result<Analysis> analyse_log(const std::filesystem::path& path, const OpenOptions& options,
                             const LogChoice& choice, const Settings& settings,
                             const JobControl& job);

// The resonator from logs that keep E, R, S, Q, or from tracks: the same result as from samples,
// with all that needs the frequency absent. `names`: of the logs. Errors: setting_invalid, those of
// fit_powers().
Result<Identification> identify_powers(std::span<const PowerRun> runs,
                                       std::span<const std::string> names,
                                       const IdentifySettings& settings, const JobControl& job);

// The resonator from logs of phasors, all as from samples. Errors: setting_invalid, phasors_fold,
// those of fit_resonator().
Result<Identification> identify_phasors(std::span<const PhasorLog> logs,
                                        std::span<const std::string> names,
                                        const IdentifySettings& settings, const JobControl& job);

}  // namespace vybeg
