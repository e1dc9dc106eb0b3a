#include "core/analysis/recording_carrier.h"

#include "core/analysis/prepare.h"
#include "core/analysis/setting_table.h"

namespace vybeg {

Result<double> find_recording_carrier(const Recording& recording, const SignalSettings& settings,
                                      const JobControl& job) {
    if (const Status valid = validate(settings); !valid) {
        return valid.error();
    }
    const Result<ConditionedRecording> prepared = prepare(recording, settings, job);
    if (!prepared) {
        return prepared.error();
    }
    return prepared->f0_hz;
}

}  // namespace vybeg
