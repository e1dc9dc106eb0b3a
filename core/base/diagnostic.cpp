#include "core/base/diagnostic.h"

#include <array>

namespace vybeg {
namespace {

// Grades, by Severity.
constexpr int note = 0;
constexpr int warning = 1;
constexpr int serious = 2;

}  // namespace

// What each diagnostic is called and says.
MessageRow message_row(DiagnosticKind kind) {
    using enum DiagnosticKind;
    static constexpr auto rows = std::to_array<CodedRow<DiagnosticKind>>({
        {time_uneven, "time-uneven", warning,
         VYBEG_MESSAGE("Message",
                       "The time column is uneven, by up to %1 s (%2 samples); the signals were "
                       "resampled to a uniform grid by local cubic interpolation.")},
        {time_gap, "time-gap", warning,
         VYBEG_MESSAGE("Message",
                       "%1 samples are missing at %2 s; windows over them are flagged.")},
        {missing_samples, "missing-samples", warning,
         VYBEG_MESSAGE("Message",
                       "%1 samples are NaN or infinite; windows over them are flagged.")},
        {file_ends_early, "file-ends-early", warning,
         VYBEG_MESSAGE(
             "Message",
             "The file ends early: its header promises %1 frames, %2 are there. Those are used.")},
        {file_not_closed, "file-not-closed", warning,
         VYBEG_MESSAGE(
             "Message",
             "The file is still being written, was never closed or has been cut off: nothing in it "
             "says how many frames there are to be. The %1 that are there are used.")},
        {channels_unequal, "channels-unequal", warning,
         VYBEG_MESSAGE(
             "Message",
             "The channels differ in length: %1 has %2 samples, %3 has %4. Both are counted from "
             "their first sample, and the end of the longer one is left out.")},
        {filter_transients, "filter-transients", note,
         VYBEG_MESSAGE(
             "Message",
             "The band-pass takes %1 s at each end for its transient; those windows are flagged.")},
        {context_missing, "context-missing", warning,
         VYBEG_MESSAGE("Message",
                       "This algorithm needs %1 samples on both sides of a window; windows without "
                       "them are flagged.")},
        {not_converged, "not-converged", warning,
         VYBEG_MESSAGE("Message", "%1 of %2 windows did not converge; they are flagged.")},
        {over_range, "over-range", warning,
         VYBEG_MESSAGE("Message",
                       "Channel %1: %2 samples lie beyond its range and are missing. Record with a "
                       "larger range.")},
        {unit_converted, "unit-converted", note,
         VYBEG_MESSAGE(
             "Message",
             "Channel %1 is in %2 in the file; it was converted to %3, the unit of channel C.")},
        {unit_of_one, "unit-of-one", warning,
         VYBEG_MESSAGE("Message",
                       "Channel %1 is in %2 and channel %3 states no unit: both are taken to be in "
                       "the same one.")},
        {units_differ, "units-differ", serious,
         VYBEG_MESSAGE("Message",
                       "Channel %1 is in %2 and channel %3 in %4, units without a known ratio: "
                       "amplitudes and angles are wrong. Choose channels of one unit with "
                       "--channels, or give the gain ratio with --kappa."),
         VYBEG_MESSAGE(
             "Message",
             "Channel %1 is in %2 and channel %3 in %4, units without a known ratio: amplitudes "
             "and angles are wrong. Choose channels of one unit, or give the gain ratio.")},
        {time_unit_unknown, "time-unit-unknown", warning,
         VYBEG_MESSAGE(
             "Message",
             "The times are in '%1', an unknown unit, and are read as seconds. Choose their unit "
             "with --time-unit, or their rate with --time-column none and --rate."),
         VYBEG_MESSAGE(
             "Message",
             "The times are in '%1', an unknown unit, and are read as seconds. Choose their unit, "
             "or open the file without a time column and give the sample rate.")},
        {channel_delayed, "channel-delayed", warning,
         VYBEG_MESSAGE("Message",
                       "The times of channel D begin %1 s (%2 samples) after those of channel C; D "
                       "was interpolated to C's times. What its times are wrong by is a phase "
                       "between the channels (--delay)."),
         VYBEG_MESSAGE("Message",
                       "The times of channel D begin %1 s (%2 samples) after those of channel C; D "
                       "was interpolated to C's times. What its times are wrong by is a phase "
                       "between the channels (delay of D).")},
        {pieces_untimed, "pieces-untimed", warning,
         VYBEG_MESSAGE("Message",
                       "The %1 pieces do not tell when they begin: they are taken to follow each "
                       "other without a gap.")},
        {leakage, "leakage", warning,
         VYBEG_MESSAGE(
             "Message",
             "In %1 of %2 windows the algorithm is off by more than one standard deviation, by "
             "leakage; they are flagged. A window of whole half-periods (Snap) makes it smallest; "
             "conjugate gradient and maximum likelihood have none.")},
        {wave_moves, "wave-moves", warning,
         VYBEG_MESSAGE(
             "Message",
             "In %1 of %2 windows the wave moves inside the window, or turns too far from one "
             "window to the next; they are flagged. Choose a shorter window or a smaller hop.")},
        {text_lines_ignored, "text-lines-ignored", note,
         VYBEG_MESSAGE("Message", "%1 header or comment lines were passed over.")},
        {words_passed_over, "words-passed-over", note,
         VYBEG_MESSAGE("Message",
                       "Columns that hold words are no channels and were passed over: %1.")},
        {clipped, "clipped", warning,
         VYBEG_MESSAGE(
             "Message",
             "Channel %1 is clipped: %2 samples at its rail, %3. Windows over them are flagged.")},
        {samples_lost, "samples-lost", warning,
         VYBEG_MESSAGE("Message", "Samples lost: %1 at %2 s. Windows over the place are flagged.")},
        {samples_doubled, "samples-doubled", warning,
         VYBEG_MESSAGE("Message",
                       "Samples doubled: %1 at %2 s. Windows over the place are flagged.")},
        {phase_step, "phase-step", warning,
         VYBEG_MESSAGE("Message",
                       "A step of %1 rad in the phase of both channels at %2 s. Samples doubled: "
                       "%3, or lost: %4; the phase shows them only modulo the period. Windows over "
                       "the place are flagged.")},
        {more_samples_lost, "more-samples-lost", warning,
         VYBEG_MESSAGE("Message", "Further places where samples were lost or doubled: %1.")},
        {below_one_bit, "below-one-bit", warning,
         VYBEG_MESSAGE(
             "Message",
             "Channel %1 stays within %2 levels of the converter: its signal is below one bit.")},
        {offset, "offset", warning,
         VYBEG_MESSAGE("Message",
                       "Channel %1 has an offset of %2, %3 % of the amplitude. The calibration "
                       "takes it out (--offset auto)."),
         VYBEG_MESSAGE("Message",
                       "Channel %1 has an offset of %2, %3 % of the amplitude. The calibration "
                       "takes it out.")},
        {mains, "mains", warning,
         VYBEG_MESSAGE("Message",
                       "A line of the mains at %1 Hz, %2 % of the carrier. A band-pass takes it "
                       "out (--filter)."),
         VYBEG_MESSAGE(
             "Message",
             "A line of the mains at %1 Hz, %2 % of the carrier. A band-pass takes it out.")},
        {start_transient, "start-transient", warning,
         VYBEG_MESSAGE(
             "Message",
             "The first %1 s do not decay as what follows. The range can leave them out (--from)."),
         VYBEG_MESSAGE("Message",
                       "The first %1 s do not decay like the rest. The range can leave them out.")},
        {gaps_inserted, "gaps-inserted", warning,
         VYBEG_MESSAGE("Message",
                       "Lost samples made gaps, as asked for: %1; places: %2. Windows over them "
                       "have no values.")},
        {lost_counted, "lost-counted", note,
         VYBEG_MESSAGE("Message",
                       "Lost samples counted in the time behind them, so that the phase runs on: "
                       "%1; places: %2.")},
        {phase_unknown, "phase-unknown", warning,
         VYBEG_MESSAGE(
             "Message",
             "Places where an unknown number of samples was lost or doubled: %1. The phase after "
             "each is a parameter of its own; time moves by the smallest possible number.")},
        {carrier_elsewhere, "carrier-elsewhere", serious,
         VYBEG_MESSAGE("Message",
                       "The carrier given is %1 Hz, and the signal is at %2 Hz: that is used.")},
        {strike_left_out, "strike-left-out", note,
         VYBEG_MESSAGE("Message",
                       "The first %1 s are left out of the fit: a strike, or what a band-pass "
                       "makes of the beginning, is no free decay.")},
        {no_free_decay, "no-free-decay", serious,
         VYBEG_MESSAGE("Message",
                       "Recording %1: this is no free decay: %2. Damping, Q and what rests on them "
                       "may be off by more than their deviations.")},
        {part_decays, "no-free-decay-part", serious,
         VYBEG_MESSAGE("Message",
                       "Recording %1: this is no free decay from start to end. From %2 s to %3 s "
                       "it decays freely: take this part (--from %2 --to %3)."),
         VYBEG_MESSAGE("Message",
                       "Recording %1: this is no free decay from start to end. From %2 s to %3 s "
                       "it decays freely: set the range to this part.")},
        {same_projection, "same-projection", serious,
         VYBEG_MESSAGE("Message",
                       "Recording %1: both channels show the same projection of the motion. The "
                       "modes are seen, but no directions: axes and quadrature are refused. Place "
                       "the pick-offs 45 degrees apart.")},
        {mode_grows, "mode-grows", serious,
         VYBEG_MESSAGE("Message",
                       "The mode at %1 Hz would grow, at a rate of %2 1/s (standard deviation %3): "
                       "the motion is not that of a resonator in free decay, and modes and "
                       "resonator are refused.")},
        {frequency_drifts, "frequency-drifts", note,
         VYBEG_MESSAGE("Message",
                       "Recording %1: the frequency drifts by %2 Hz per second (standard deviation "
                       "%3); the drift is fitted, and Q is free of it.")},
        {frequency_follows_amplitude, "frequency-follows-amplitude", warning,
         VYBEG_MESSAGE("Message",
                       "The frequency depends on the amplitude: %1 Hz per squared recording unit "
                       "(standard deviation %2); this is fitted.")},
        {q_disagrees, "q-disagrees", serious,
         VYBEG_MESSAGE("Message",
                       "Recording %1: Q from the envelope, %2, and from the coherent fit, %3, "
                       "differ by more than four standard deviations: the motion is not that of a "
                       "resonator with constant parameters.")},
        {decay_of_one_direction, "decay-of-one-direction", warning,
         VYBEG_MESSAGE("Message",
                       "The damping was seen in one direction only: the recording's own decay time "
                       "is given, not the resonator's.")},
        {structured_refused, "structured-refused", serious,
         VYBEG_MESSAGE("Message",
                       "The channels are no calibrated pair of pick-offs (%1): the free model "
                       "gives the modes, and the resonator has no axes. If they are calibrated, "
                       "choose the structured model.")},
        {foreign_recording, "foreign-recording", serious,
         VYBEG_MESSAGE("Message",
                       "%1 does not fit the other recordings of the set: %2. The resonator is that "
                       "of the others.")},
        {foreign_among, "foreign-among", serious,
         VYBEG_MESSAGE("Message",
                       "The recordings do not fit one resonator, but they do without %1 (%2). "
                       "Modes and resonator are refused: correct or leave out a recording.")},
        {set_inconsistent, "set-inconsistent", serious,
         VYBEG_MESSAGE(
             "Message",
             "The recordings do not fit one resonator, and no single one of them makes the "
             "difference. Modes and resonator are refused: identify fewer recordings together.")},
        {phasors_mirrored, "phasors-mirrored", serious,
         VYBEG_MESSAGE("Message",
                       "%1: the phasors of C turn at %2 from the reference, those of D at %3, as "
                       "if Y of one had the other sign. Export both channels with one sign of Y, "
                       "or exchange its sign in the file. The numbers hold only if the reference "
                       "lies in the middle between two modes.")},
        {reference_follows, "reference-follows", serious,
         VYBEG_MESSAGE("Message",
                       "%1: channel %2 beats in its amplitude and not in its phase, while the "
                       "phase of channel %3 turns: the reference follows channel %2, as that of a "
                       "phase-locked loop does, and has taken its frequency away. The numbers do "
                       "not hold. Give --phasors common with a column of the reference's frequency "
                       "(F) or phase (P), or log with a fixed reference.")},
        {powers_apart, "powers-apart", serious,
         VYBEG_MESSAGE("Message",
                       "%1: R^2 + S^2 + Q^2 differs from E^2 by %2 % about %3 s, by more than "
                       "noise explains: a column has an offset, or a gain of its own, or the wave "
                       "turns far within a row. The numbers may be off by more than their "
                       "uncertainties. Calibrate the columns, or log faster.")},
        {recordings_differ, "recordings-differ", warning,
         VYBEG_MESSAGE("Message",
                       "The recordings differ by more than their noise: the decay rate by %1 %, "
                       "the split by %2 %, the gain ratio by %3 % (standard deviations). The "
                       "combined uncertainties hold this spread.")},
        {set_too_small, "set-too-small", note,
         VYBEG_MESSAGE("Message",
                       "Two or three recordings do not show whether all are of one resonator. The "
                       "combined uncertainties hold an assumed spread between them: of the decay "
                       "rate by %1 %, of the split by %2 %, of the gain ratio by %3 %.")},
        {frequencies_apart, "frequencies-apart", serious,
         VYBEG_MESSAGE("Message",
                       "The frequencies of the recordings lie %1 ppm apart (%2: %3 Hz, %4: %5 Hz). "
                       "A mean frequency and modes are refused.")},
        {logs_differ, "logs-differ", serious,
         VYBEG_MESSAGE("Message",
                       "The logs differ in the harmonic %1 of the drift, by %2 deviations: %3. No "
                       "common value is given.")},
        {log_left_out, "log-left-out", serious,
         VYBEG_MESSAGE("Message",
                       "%1 does not fit the other logs, in the harmonic %2 of the drift. The drift "
                       "is that of the others.")},
        {turn_one_way, "turn-one-way", warning,
         VYBEG_MESSAGE(
             "Message",
             "Gain ratio and skew of the channels within their tolerance give a wave that turns a "
             "fourth harmonic of %1, which u holds. A log of the opposite turn tells it from the "
             "drift; a smaller tolerance (--tolerance kappa=...,skew=...) lowers u."),
         VYBEG_MESSAGE("Message",
                       "Gain ratio and skew of the channels within their tolerance give a wave "
                       "that turns a fourth harmonic of %1, which u holds. A log of the opposite "
                       "turn tells it from the drift.")},
        {angle_of_quarter, "angle-of-quarter", warning,
         VYBEG_MESSAGE("Message",
                       "%1 wraps its angle at 90 degrees: the sign of the second harmonic is that "
                       "of its first quarter of a turn.")},
        {residual_above_noise, "residual-above-noise", warning,
         VYBEG_MESSAGE("Message",
                       "The residual is above the noise of the windows (chi square per degree of "
                       "freedom %1); the standard deviations are enlarged to match.")},
        {residual_below_noise, "residual-below-noise", note,
         VYBEG_MESSAGE("Message",
                       "The residual is below the noise of the windows (chi square per degree of "
                       "freedom %1): the standard deviations are too large.")},
        {residual_coloured, "residual-coloured", serious,
         VYBEG_MESSAGE("Message",
                       "The residual is not white (chi square per degree of freedom %1); the "
                       "standard deviations follow its spectrum.")},
        {noise_too_narrow, "noise-too-narrow", serious,
         VYBEG_MESSAGE("Message",
                       "The noise about the carrier is as narrow as the residual can show. Noise "
                       "narrower than %1 Hz looks like the wave itself: the standard deviations "
                       "may be too small. Record longer, or repeat the recording.")},
        {misfit_damping, "misfit-damping", serious,
         VYBEG_MESSAGE(
             "Message",
             "The residual is that of a damping by %1 (about %2 % of the damping at the largest "
             "amplitude), which the model does not hold: damping, its anisotropy, rotation and "
             "drifts may be off by more than their deviations. Fit parts of the recordings in "
             "which the amplitude changes less (--from, --to)."),
         VYBEG_MESSAGE("Message",
                       "The residual is that of a damping by %1 (about %2 % of the damping at the "
                       "largest amplitude), which the model does not hold: damping, its "
                       "anisotropy, rotation and drifts may be off by more than their deviations. "
                       "Fit parts of the recordings in which the amplitude changes less.")},
        {misfit_settling, "misfit-settling", serious,
         VYBEG_MESSAGE("Message",
                       "The residual is that of a frequency that settles by about %1 Hz in %2 s, "
                       "which the model does not hold: the resonator's numbers may be off by more "
                       "than their deviations. Leave the first seconds out (--from)."),
         VYBEG_MESSAGE("Message",
                       "The residual is that of a frequency that settles by about %1 Hz in %2 s, "
                       "which the model does not hold: the resonator's numbers may be off by more "
                       "than their deviations. Leave the first seconds out of the range.")},
        {misfit_neighbour, "misfit-neighbour", serious,
         VYBEG_MESSAGE("Message",
                       "The residual holds a line at about %1 Hz, %2 % of the wave: another mode, "
                       "or a disturbance that folds there, which the model does not hold. Split, "
                       "axes, rotation and the wave's own numbers may be off by more than their "
                       "deviations. Take it out with a narrower band-pass (--filter)."),
         VYBEG_MESSAGE("Message",
                       "The residual holds a line at about %1 Hz, %2 % of the wave: another mode, "
                       "or a disturbance that folds there, which the model does not hold. Split, "
                       "axes, rotation and the wave's own numbers may be off by more than their "
                       "deviations. Take it out with a narrower band-pass.")},
        {misfit_channel, "misfit-channel", serious,
         VYBEG_MESSAGE("Message",
                       "The residual is that of an error of the channels that is taken as zero: "
                       "%1, about %2. Calibrate it, or tell its tolerance (--tolerance)."),
         VYBEG_MESSAGE("Message",
                       "The residual is that of an error of the channels that is taken as zero: "
                       "%1, about %2. Calibrate it, or state its tolerance.")},
        {quadrature_by_channel, "quadrature-by-channel", serious,
         VYBEG_MESSAGE("Message",
                       "The quadrature of the recordings at their starts follows the angle, as an "
                       "error of the channels makes it: %1, about %2. Split, axes and rotation may "
                       "be off by more than their uncertainties. Measure it and correct the "
                       "signals (--delay), or state its tolerance (--tolerance)."),
         VYBEG_MESSAGE("Message",
                       "The quadrature of the recordings at their starts follows the angle, as an "
                       "error of the channels makes it: %1, about %2. Split, axes and rotation may "
                       "be off by more than their uncertainties. Measure it and correct the "
                       "signals, or state its tolerance.")},
        {rotation_or_channel, "rotation-or-channel", serious,
         VYBEG_MESSAGE(
             "Message",
             "The waves turn by %1, faster than the Earth. Where the base turns, that is right. "
             "Where it stands still, it is an error of the channels, %2 of about %3, and split and "
             "axes are off, too: measure it and correct the signals (--delay)."),
         VYBEG_MESSAGE("Message",
                       "The waves turn by %1, faster than the Earth. Where the base turns, that is "
                       "right. Where it stands still, it is an error of the channels, %2 of about "
                       "%3, and split and axes are off, too: measure it and correct the signals.")},
        {prior_left, "prior-left", serious,
         VYBEG_MESSAGE("Message",
                       "The recordings need a channel error far beyond its tolerance: %1 of %2, %3 "
                       "tolerances. The tolerance is too small, or the motion is not that of the "
                       "model: the numbers may be off by more than their uncertainties.")},
        {anisotropy_not_passive, "anisotropy-not-passive", serious,
         VYBEG_MESSAGE(
             "Message",
             "The damping anisotropy, %1 1/s, reaches the greatest value of a passive resonator, "
             "2/tau = %2 1/s: one mode hardly decays. The motion may not be that of the model, and "
             "the numbers may be off by more than their uncertainties.")},
        {misfit_springs, "misfit-springs", serious,
         VYBEG_MESSAGE("Message",
                       "The residual is that of springs that follow the amplitude differently "
                       "along the axes (about %1 Hz at the largest amplitude), which the model "
                       "does not hold: split, axes and rotation may be off by more than their "
                       "uncertainties. Record smaller amplitudes.")},
        {misfit_pickoff, "misfit-pickoff", serious,
         VYBEG_MESSAGE(
             "Message",
             "The residual is that of pick-offs whose gain follows the amplitude: by about %1 % in "
             "channel C and %2 % in D at the largest amplitude, which the model does not hold. "
             "Split, damping, axes and rotation may be off by more than their deviations. "
             "Linearise the channels, or record smaller amplitudes.")},
        {fitted_phase_step, "fitted-phase-step", warning,
         VYBEG_MESSAGE("Message",
                       "%1: the phase of both channels steps by %2 rad at %3 s; samples are lost "
                       "or doubled there. The fit leaves the phase open at that place.")},
        {fitted_gain_step, "fitted-gain-step", warning,
         VYBEG_MESSAGE(
             "Message",
             "%1: the gain of channel C changes by %2 % and that of D by %3 % at %4 s, as where an "
             "amplifier changes its range. The fit leaves both gains open at that place.")},
        {fitted_knock, "fitted-knock", warning,
         VYBEG_MESSAGE("Message",
                       "%1: the wave changes by %2 % of itself at %3 s, as by a knock or as a "
                       "drive ends. The fit leaves the wave open at that place.")},
        {event_left_out, "event-left-out", warning,
         VYBEG_MESSAGE("Message", "%1: the signal is disturbed at %2 s; the fit leaves %3 s out.")},
        {motion_not_model, "motion-not-model", serious,
         VYBEG_MESSAGE("Message",
                       "The motion is not that of the model: the residual is no stationary noise, "
                       "or the two halves of the recordings disagree by more than noise explains. "
                       "The standard deviations contain the disagreement; fit parts of the "
                       "recordings to see which one differs.")},
        {fit_not_converged, "fit-not-converged", serious,
         VYBEG_MESSAGE(
             "Message",
             "The fit of the resonator stopped before it converged: its values are refused.")},
        {other_gyro, "other-gyro", serious,
         VYBEG_MESSAGE("Message",
                       "The passport is that of the gyro %1, the recordings are of the gyro %2: "
                       "their differences are no changes of one resonator.")},
        {option_without_effect, "option-without-effect", warning,
         VYBEG_MESSAGE("Message", "%1 has no effect: %2.")},
        {column_like_option, "column-like-option", warning,
         VYBEG_MESSAGE("Message",
                       "The column \"%1\" of the list is kept as it is and changes nothing. Did "
                       "you mean \"%2\"? Rename it then.")},
        {formula_in_list, "formula-in-list", warning,
         VYBEG_MESSAGE("Message",
                       "Line %1 of the list, column \"%2\": \"%3\" begins as a formula does, and a "
                       "table program that opens the results runs it.")},
        {earlier_rows, "earlier-rows", warning,
         VYBEG_MESSAGE(
             "Message",
             "%1 holds %2 finished rows of an interrupted batch. All sets are computed again; the "
             "rows stay until the table is written, and a resumed batch takes them.")},
        {channels_crossed, "channels-crossed", warning,
         VYBEG_MESSAGE("Message",
                       "Channel C is read from \"%1\", channel D from \"%2\". Exchange the "
                       "channels if their names are right.")},
        {other_rows, "other-rows", warning,
         VYBEG_MESSAGE("Message",
                       "%1 holds %2 finished rows that this batch cannot take: their sets, "
                       "recordings, settings, limits or columns are others.")},
        {limits_not_kept, "limits-not-kept", warning,
         VYBEG_MESSAGE("Message", "The limits are not kept by %1 of %3 sets; %2 are undecided.")},
        {database_waits, "database-waits", warning,
         VYBEG_MESSAGE("Message",
                       "%1 is in use by another program. The batch waits for it, up to %2 s.")},
        {same_recordings, "same-recordings", warning,
         VYBEG_MESSAGE("Message",
                       "%1 and %2 have the same recordings and settings: the database holds one "
                       "result for both, that of %1.")},
    });
    return row_of(rows, kind);
}

std::string kind_name(DiagnosticKind kind) {
    return message_row(kind).name;
}

Severity severity(DiagnosticKind kind) {
    return static_cast<Severity>(message_row(kind).grade);
}

std::string severity_name(Severity severity) {
    switch (severity) {
        case Severity::note: return "note";
        case Severity::warning: return "warning";
        case Severity::serious: return "serious";
    }
    return "";
}

std::string english(const Diagnostic& diagnostic) {
    return english(message_row(diagnostic.kind).sentence, diagnostic.args);
}

}  // namespace vybeg
