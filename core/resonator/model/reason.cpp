#include "core/resonator/model/reason.h"

#include <array>

namespace vybeg {

MessageRow message_row(ReasonCode code) {
    using enum ReasonCode;
    constexpr int no_grade = 0;
    static constexpr auto rows = std::to_array<CodedRow<ReasonCode>>({
        {none, "none", no_grade, ""},
        {one_direction, "one-direction", no_grade,
         VYBEG_MESSAGE(
             "Reason",
             "The wave hardly moves, so that one direction of the resonator is seen and no other. "
             "Add a recording that starts at theta_A = %1 degrees and lasts %2 s or longer.")},
        {within_noise, "within-noise", no_grade,
         VYBEG_MESSAGE("Reason",
                       "The difference between the modes is within its noise: it is at most %1 %2, "
                       "and has no axis.")},
        {confounded_rotation, "confounded-rotation", no_grade,
         VYBEG_MESSAGE(
             "Reason",
             "At one angle a rotation and a damping anisotropy turn the wave alike. Add a "
             "recording that starts at theta_A = %1 degrees and lasts %2 s or longer.")},
        {free_model, "free-model", no_grade,
         VYBEG_MESSAGE(
             "Reason",
             "The free model takes the channels as any two views of the modes: it has no angles.")},
        {modes_not_apart, "modes-not-apart", no_grade,
         VYBEG_MESSAGE("Reason", "The two modes cannot be told apart.")},
        {no_decay, "no-decay", no_grade,
         VYBEG_MESSAGE("Reason",
                       "The decay is within its noise: tau is at least %1 s. Record longer.")},
        {circular_wave, "circular-wave", no_grade,
         VYBEG_MESSAGE("Reason", "A circular wave has no angle.")},
        {few_angles, "few-angles", no_grade,
         VYBEG_MESSAGE(
             "Reason",
             "The waves stand at too few angles for the drift as a function of the angle: it needs "
             "three starts 22.5 degrees apart or more, or a wave that turns.")},
        {kappa_like_damping, "kappa-like-damping", no_grade,
         VYBEG_MESSAGE("Reason",
                       "In a turning wave a gain ratio of the channels and a damping anisotropy "
                       "look the same. Calibrate the channels and state their tolerance, or add "
                       "recordings that start at other angles.")},
        {as_given, "as-given", no_grade,
         VYBEG_MESSAGE(
             "Reason",
             "The recordings hardly narrow the stated tolerance: the value is as given.")},
        {held, "held", no_grade,
         VYBEG_MESSAGE("Reason",
                       "Taken as zero, because no tolerance is given for it; the sensitivities say "
                       "what it would change.")},
        {not_nonlinear, "not-nonlinear", no_grade,
         VYBEG_MESSAGE("Reason",
                       "The phasors need no dependence on the amplitude: it is at most %1 Hz per "
                       "squared recording unit.")},
        {drift_not_seen, "drift-not-seen", no_grade,
         VYBEG_MESSAGE("Reason",
                       "A drift of the frequency looks like the motion itself in this recording.")},
        {decay_limits, "decay-limits", no_grade,
         VYBEG_MESSAGE("Reason",
                       "The decay is hardly above its noise: tau lies between %1 s and %2 s.")},
        {grows, "grows", no_grade,
         VYBEG_MESSAGE("Reason", "The wave grows, at a rate of %1 1/s (standard deviation %2).")},
        {mode_grows, "mode-grows", no_grade,
         VYBEG_MESSAGE("Reason",
                       "The mode at %1 Hz would grow, at a rate of %2 1/s (standard deviation %3): "
                       "the motion is not that of a resonator in free decay.")},
        {same_projection, "same-projection", no_grade,
         VYBEG_MESSAGE("Reason",
                       "Both channels show the same projection of the motion: the modes are seen, "
                       "directions are not.")},
        {amplitude_or_time, "amplitude-or-time", no_grade,
         VYBEG_MESSAGE("Reason",
                       "The frequency changes while the amplitude falls: whether it follows the "
                       "amplitude or settles in time, these recordings do not tell. Add one that "
                       "starts at another amplitude.")},
        {rests_on_unseen, "rests-on-unseen", no_grade,
         VYBEG_MESSAGE(
             "Reason",
             "It depends on parameters of the resonator that these recordings do not show.")},
        {too_few_windows, "too-few-windows", no_grade,
         VYBEG_MESSAGE("Reason", "This recording has too few windows for it.")},
        {set_refused, "set-refused", no_grade,
         VYBEG_MESSAGE("Reason", "The recordings do not fit one resonator (see the warnings).")},
        {left_out, "left-out", no_grade,
         VYBEG_MESSAGE("Reason",
                       "The recording does not fit the others and is left out of the set.")},
        {frequencies_apart, "frequencies-apart", no_grade,
         VYBEG_MESSAGE(
             "Reason",
             "The frequencies of the recordings lie %1 ppm apart: each recording has its own.")},
        {not_converged, "not-converged", no_grade,
         VYBEG_MESSAGE("Reason", "The fit stopped before it converged.")},
        {phase_lost, "phase-lost", no_grade,
         VYBEG_MESSAGE("Reason",
                       "The log keeps no phase of the oscillation, and with it no frequency.")},
        {logs_differ, "logs-differ", no_grade,
         VYBEG_MESSAGE("Reason", "The logs differ in it, or in what it is found from.")},
        {effort_missing, "effort-missing", no_grade,
         VYBEG_MESSAGE("Reason", "No log holds the effort of the controller for it.")},
        {effort_negative, "effort-negative", no_grade,
         VYBEG_MESSAGE(
             "Reason",
             "The mean of the amplitude effort is below zero, as if it took energy from the wave. "
             "Write both efforts with the signs with which they raise a_A and a_B.")},
        {effort_unseen, "effort-unseen", no_grade,
         VYBEG_MESSAGE("Reason",
                       "The fourth harmonic of the effort, or of the drift, is within its noise. "
                       "Record a longer log.")},
        {effort_axis_apart, "effort-axis-apart", no_grade,
         VYBEG_MESSAGE("Reason",
                       "The axes of damping by the effort and by the drift lie %1 degrees apart: "
                       "the fourth harmonic of the drift is not that of the damping alone.")},
    });
    return row_of(rows, code);
}

std::string reason_name(ReasonCode code) {
    return message_row(code).name;
}

std::string english(const Reason& reason) {
    return english(message_row(reason.code).sentence, reason.args);
}

}  // namespace vybeg
