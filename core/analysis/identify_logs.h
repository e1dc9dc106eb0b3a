#pragma once

#include "core/analysis/identify.h"
#include "core/analysis/phasor_log.h"
#include "core/resonator/model/power_run.h"

#include <span>
#include <string>

namespace vybeg {

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
