#include "core/analysis/recording_carrier.h"

#include "core/analysis/prepare.h"
#include "core/analysis/setting_table.h"

namespace vybeg {

Result<double> find_recording_carrier(const Recording& recording, const SignalSettings& settings,
                                      const JobControl& job) {
    TRY(validate(settings));
    const auto prepared = TRY(prepare(recording, settings, job));
    return prepared.f0_hz;
}

}  // namespace vybeg
