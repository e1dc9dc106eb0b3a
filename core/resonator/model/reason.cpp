#include "core/resonator/model/reason.h"

namespace vybeg {

ReasonRow reason_row(ReasonCode code) {
    switch (code) {
        case ReasonCode::none: return {"none", ""};
        case ReasonCode::one_direction:
            return {
                "one-direction",
                VYBEG_MESSAGE("Reason",
                              "The wave hardly moves, so that one direction of the resonator is "
                              "seen and no other. Add a recording that starts at theta_A = %1 "
                              "degrees and lasts %2 s or longer.")};
        case ReasonCode::within_noise:
            return {"within-noise",
                    VYBEG_MESSAGE("Reason",
                                  "The difference between the modes is within its noise: it is at "
                                  "most %1 %2, and has no axis.")};
        case ReasonCode::confounded_rotation:
            return {"confounded-rotation",
                    VYBEG_MESSAGE("Reason",
                                  "At one angle a rotation and a damping anisotropy turn the wave "
                                  "alike. Add a recording that starts at theta_A = %1 degrees and "
                                  "lasts %2 s or longer.")};
        case ReasonCode::free_model:
            return {"free-model",
                    VYBEG_MESSAGE("Reason",
                                  "The free model takes the channels as any two views of the "
                                  "modes: it has no angles.")};
        case ReasonCode::modes_not_apart:
            return {"modes-not-apart",
                    VYBEG_MESSAGE("Reason", "The two modes cannot be told apart.")};
        case ReasonCode::no_decay:
            return {"no-decay",
                    VYBEG_MESSAGE("Reason",
                                  "The decay is within its noise: tau is at least %1 s. Record "
                                  "longer.")};
        case ReasonCode::circular_wave:
            return {"circular-wave", VYBEG_MESSAGE("Reason", "A circular wave has no angle.")};
        case ReasonCode::few_angles:
            return {"few-angles",
                    VYBEG_MESSAGE("Reason",
                                  "The drift function needs starts at three angles, 22.5 degrees "
                                  "apart or more, or a wave that turns.")};
        case ReasonCode::kappa_like_damping:
            return {
                "kappa-like-damping",
                VYBEG_MESSAGE("Reason",
                              "In a turning wave a gain ratio of the channels and a damping "
                              "anisotropy look the same. Calibrate the channels and state their "
                              "tolerance, or add recordings that start at other angles.")};
        case ReasonCode::as_given:
            return {"as-given",
                    VYBEG_MESSAGE("Reason",
                                  "The recordings hardly narrow the stated tolerance: the value is "
                                  "as given.")};
        case ReasonCode::held:
            return {"held",
                    VYBEG_MESSAGE("Reason",
                                  "Taken as zero, because no tolerance is given for it; the "
                                  "sensitivities say what it would change.")};
        case ReasonCode::not_nonlinear:
            return {"not-nonlinear",
                    VYBEG_MESSAGE("Reason",
                                  "The phasors need no dependence on the amplitude: it is at most "
                                  "%1 Hz per squared recording unit.")};
        case ReasonCode::drift_not_seen:
            return {"drift-not-seen",
                    VYBEG_MESSAGE("Reason",
                                  "A drift of the frequency looks like the motion itself in this "
                                  "recording.")};
        case ReasonCode::decay_limits:
            return {"decay-limits",
                    VYBEG_MESSAGE("Reason",
                                  "The decay is hardly above its noise: tau lies between %1 s and "
                                  "%2 s.")};
        case ReasonCode::grows:
            return {"grows",
                    VYBEG_MESSAGE("Reason",
                                  "The wave grows, at a rate of %1 1/s (standard deviation %2).")};
        case ReasonCode::mode_grows:
            return {"mode-grows",
                    VYBEG_MESSAGE("Reason",
                                  "The mode at %1 Hz would grow, at a rate of %2 1/s (standard "
                                  "deviation %3): the motion is not that of a resonator in free "
                                  "decay.")};
        case ReasonCode::same_projection:
            return {"same-projection",
                    VYBEG_MESSAGE("Reason",
                                  "Both channels show the same projection of the motion: the modes "
                                  "are seen, directions are not.")};
        case ReasonCode::amplitude_or_time:
            return {"amplitude-or-time",
                    VYBEG_MESSAGE("Reason",
                                  "The frequency changes while the amplitude falls: whether it "
                                  "follows the amplitude or settles in time, these recordings do "
                                  "not tell. Add one that starts at another amplitude.")};
        case ReasonCode::rests_on_unseen:
            return {"rests-on-unseen",
                    VYBEG_MESSAGE("Reason",
                                  "It depends on parameters of the resonator that these recordings "
                                  "do not show.")};
        case ReasonCode::too_few_windows:
            return {"too-few-windows",
                    VYBEG_MESSAGE("Reason", "This recording has too few windows for it.")};
        case ReasonCode::set_refused:
            return {"set-refused",
                    VYBEG_MESSAGE("Reason",
                                  "The recordings do not fit one resonator (see the warnings).")};
        case ReasonCode::left_out:
            return {"left-out",
                    VYBEG_MESSAGE("Reason",
                                  "The recording does not fit the others and is left out of the "
                                  "set.")};
        case ReasonCode::frequencies_apart:
            return {"frequencies-apart",
                    VYBEG_MESSAGE("Reason",
                                  "The frequencies of the recordings lie %1 ppm apart: each "
                                  "recording has its own.")};
        case ReasonCode::not_converged:
            return {"not-converged",
                    VYBEG_MESSAGE("Reason", "The fit stopped before it converged.")};
        case ReasonCode::phase_lost:
            return {"phase-lost",
                    VYBEG_MESSAGE("Reason",
                                  "The log keeps no phase of the oscillation, and with it no "
                                  "frequency.")};
        case ReasonCode::logs_differ:
            return {"logs-differ",
                    VYBEG_MESSAGE("Reason", "The logs differ in it, or in what it is found from.")};
        case ReasonCode::effort_missing:
            return {"effort-missing",
                    VYBEG_MESSAGE("Reason", "No log holds the effort of the controller for it.")};
        case ReasonCode::effort_negative:
            return {"effort-negative",
                    VYBEG_MESSAGE("Reason",
                                  "The mean of the amplitude effort is below zero, as if it took "
                                  "energy from the wave. Write both efforts with the signs with "
                                  "which they raise a_A and a_B.")};
        case ReasonCode::effort_unseen:
            return {"effort-unseen",
                    VYBEG_MESSAGE("Reason",
                                  "The fourth harmonic of the effort, or of the drift, is within "
                                  "its noise. Record a longer log.")};
        case ReasonCode::effort_axis_apart:
            return {"effort-axis-apart",
                    VYBEG_MESSAGE("Reason",
                                  "The axes of damping by the effort and by the drift lie %1 "
                                  "degrees apart: the fourth harmonic of the drift is not that of "
                                  "the damping alone.")};
    }
    return {"", ""};
}

std::string reason_name(ReasonCode code) {
    return reason_row(code).name;
}

std::string english(const Reason& reason) {
    return english(reason_row(reason.code).sentence, reason.args);
}

}  // namespace vybeg
