// A row for each reason for which a number of the resonator is not given: code and sentence, with
// %1, %2, ... for the arguments. Included where ROW is defined (reason.h, reason.cpp).

// it is given
ROW(none, "")
// args: another start angle (deg), seconds. The wave hardly moves.
ROW(one_direction,
    ReasonSentence::tr(
        "The wave hardly moves, so that one direction of the resonator is seen and no other. Add a "
        "recording that starts at theta_A = %1 degrees and lasts %2 s or longer."))
// args: greatest value, unit. The difference between the modes.
ROW(within_noise, ReasonSentence::tr("The difference between the modes is within its noise: it is "
                                     "at most %1 %2, and has no axis."))
// Args: another start angle (deg), seconds. Only determined together with the damping.
ROW(confounded_rotation,
    ReasonSentence::tr("At one angle a rotation and a damping anisotropy turn the wave alike. Add "
                       "a recording that starts at theta_A = %1 degrees and lasts %2 s or longer."))
// the free model has modes, but no axes
ROW(free_model,
    ReasonSentence::tr(
        "The free model takes the channels as any two views of the modes: it has no angles."))
// the modes' difference is within its noise
ROW(modes_not_apart, ReasonSentence::tr("The two modes cannot be told apart."))
// args: least tau (s)
ROW(no_decay,
    ReasonSentence::tr("The decay is within its noise: tau is at least %1 s. Record longer, and "
                       "with the drive off, which holds the amplitude as well."))
// no angle where a_A = |a_B|
ROW(circular_wave, ReasonSentence::tr("A circular wave has no angle."))
// no drift function: too few angles of the waves
ROW(few_angles, ReasonSentence::tr("The drift function needs starts at three angles, 22.5 degrees "
                                   "apart or more, or a wave that turns."))
// gain ratio and damping anisotropy are indistinguishable
ROW(kappa_like_damping,
    ReasonSentence::tr("In a turning wave a gain ratio of the channels and a damping anisotropy "
                       "look the same. Calibrate the channels and state their tolerance, or add "
                       "recordings that start at other angles."))
// the recordings narrow the tolerance of the channels by less than ten
ROW(as_given,
    ReasonSentence::tr("The recordings hardly narrow its tolerance: the value is as given."))
// a channel error without a tolerance: taken as zero
ROW(held, ReasonSentence::tr("Taken as zero in the fit, because no tolerance is given for it; the "
                             "sensitivities say what it would change."))
// args: limit, unit. A dependence on the amplitude is within its uncertainty.
ROW(not_nonlinear, ReasonSentence::tr("The recordings show no dependence on the amplitude: it is "
                                      "at most %1 Hz per squared recording unit."))
// a drift is indistinguishable from the motion in this recording
ROW(drift_not_seen,
    ReasonSentence::tr("A drift of the frequency looks like the motion itself in this recording."))
// args: least and greatest tau (s)
ROW(decay_limits,
    ReasonSentence::tr("The decay is hardly above its noise: tau lies between %1 s and %2 s."))
// args: rate of growth, its sd (1/s)
ROW(grows, ReasonSentence::tr("The wave grows, at a rate of %1 1/s (standard deviation %2)."))
// args: the mode (Hz), rate of growth, its sd (1/s). The model is wrong.
ROW(mode_grows,
    ReasonSentence::tr("The mode at %1 Hz would grow, at a rate of %2 1/s (standard deviation %3): "
                       "the motion is not that of a resonator in free decay."))
// both channels show the same projection of the motion
ROW(same_projection, ReasonSentence::tr("Both channels show the same projection of the motion: the "
                                        "modes are seen, directions are not."))
// a settling frequency explains the phasors as well
ROW(amplitude_or_time,
    ReasonSentence::tr(
        "The frequency changes while the amplitude falls: whether it follows the amplitude or "
        "settles in time, these recordings do not tell. Add one that starts at another amplitude."))
// more than half of its variance is due to undetermined parameters
ROW(rests_on_unseen,
    ReasonSentence::tr(
        "It depends on parameters of the resonator that these recordings do not show."))
// not enough windows for it in this run
ROW(too_few_windows, ReasonSentence::tr("This recording has too few windows for it."))
// the recordings are not of one resonator
ROW(set_refused, ReasonSentence::tr("The recordings do not fit one resonator (see the warnings)."))
// this recording does not belong to the set
ROW(left_out,
    ReasonSentence::tr("The recording does not fit the others and is left out of the set."))
// args: ppm. Those of the recordings.
ROW(frequencies_apart,
    ReasonSentence::tr(
        "The frequencies of the recordings lie %1 ppm apart: each recording has its own."))
// the fit stopped early
ROW(not_converged, ReasonSentence::tr("The fit stopped before it converged."))
// E, R, S, Q have no frequency
ROW(phase_lost,
    ReasonSentence::tr("The log keeps no phase of the oscillation, and with it no frequency."))
// whole-angle logs differ in it, or in its inputs
ROW(logs_differ, ReasonSentence::tr("The logs differ in it, or in what it is found from."))
// of a whole-angle log: no column of it
ROW(effort_missing, ReasonSentence::tr("No log holds the effort of the controller for it."))
// its mean takes energy from the wave
ROW(effort_negative,
    ReasonSentence::tr(
        "The mean of the amplitude effort is below zero, as if it took energy from the wave. Write "
        "both efforts with the signs with which they raise a_A and a_B."))
// its fourth harmonic, or that of the drift, is within its noise
ROW(effort_unseen, ReasonSentence::tr("The fourth harmonic of the effort, or of the drift, is "
                                      "within its noise. Record a longer log."))
// args: degrees between the damping axes of effort and drift
ROW(effort_axis_apart,
    ReasonSentence::tr("The axes of damping by the effort and by the drift lie %1 degrees apart: "
                       "the fourth harmonic of the drift is not that of the damping alone."))
