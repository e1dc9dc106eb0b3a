#include "core/resonator/model/fitted_motion.h"

#include "core/resonator/model/channel_tolerance.h"
#include "core/resonator/model/phasor_model.h"

namespace vybeg {
namespace {

std::vector<Phasors> expected(const FittedMotion& motion, const FittedMotion::Run& run,
                              const Eigen::VectorXd& shared, const std::vector<double>& time_s) {
    ScaledRun frame = run.frame;
    frame.time_s = time_s;
    frame.window_s = 0;  // the instants are no centres of the fit's windows
    std::vector<Phasors> phasors;
    for (const Eigen::Vector2cd& z : expected_phasors(frame, shared, run.own, time_s.size())) {
        phasors.push_back({motion.scale * z[0], motion.scale * z[1]});
    }
    return phasors;
}

}  // namespace

std::vector<Phasors> predicted_phasors(const FittedMotion& motion, std::size_t run,
                                       const std::vector<double>& time_s) {
    return expected(motion, motion.runs[run], motion.shared, time_s);
}

std::vector<Phasors> predicted_waves(const FittedMotion& motion, std::size_t run,
                                     const std::vector<double>& time_s) {
    Eigen::VectorXd ideal = motion.shared;
    for (const ToleratedError& error : channel_errors) {
        ideal[error.parameter] = 0;
    }
    ideal[kappa_at] = 1;
    FittedMotion::Run even = motion.runs[run];
    Eigen::Index at = own_count;
    for (const RunBreak& each : even.frame.breaks) {
        if (each.kind == BreakKind::gain) {
            even.own.segment<2>(at).setZero();
        }
        at += break_size(each.kind);
    }
    return expected(motion, even, ideal, time_s);
}

}  // namespace vybeg
