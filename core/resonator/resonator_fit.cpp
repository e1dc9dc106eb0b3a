#include "core/resonator/resonator_fit.h"

namespace vybeg {

Result<ResonatorFit> fit_resonator(std::span<const PhasorRun> runs, const FitOptions& options,
                                   const JobControl& job) {
    (void)runs;
    (void)options;
    (void)job;
    return Error{ErrorCode::fit_failed, "resonator", {"skeleton"}};
}

}  // namespace vybeg
