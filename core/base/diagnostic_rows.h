// A row for each diagnostic: code, severity, sentence (MessageRow), with %1, %2, ... for the
// arguments. Included where ROW is defined (diagnostic.h, diagnostic.cpp).

ROW(time_uneven, warning,
    Sentence::tr("The time column is uneven, by up to %1 s (%2 samples); the signals were "
                 "resampled to a uniform grid by local cubic interpolation."))
ROW(time_gap, warning,
    Sentence::tr("%1 samples are missing at %2 s; windows over them are flagged."))
ROW(missing_samples, warning,
    Sentence::tr("%1 samples are NaN or infinite; windows over them are flagged."))
ROW(file_ends_early, warning,
    Sentence::tr(
        "The file ends early: its header promises %1 frames, %2 are there. Those are used."))
ROW(file_not_closed, warning,
    Sentence::tr("The file is still being written, was never closed or has been cut off: nothing "
                 "in it says how many frames there are to be. The %1 that are there are used."))
ROW(text_ends_within_row, warning, Sentence::tr("The file ends within a row, which is left out."))
ROW(channels_unequal, warning,
    Sentence::tr("The channels differ in length: %1 has %2 samples, %3 has %4. Both are counted "
                 "from their first sample, and the end of the longer one is left out."))
ROW(filter_transients, note,
    Sentence::tr(
        "The band-pass takes %1 s at each end for its transient; those windows are flagged."))
ROW(context_missing, warning,
    Sentence::tr("This algorithm needs %1 samples on both sides of a window; windows without them "
                 "are flagged."))
ROW(not_converged, warning, Sentence::tr("%1 of %2 windows did not converge; they are flagged."))
// Of the missing ones, those beyond the range of the channel.
ROW(over_range, warning,
    Sentence::tr(
        "Channel %1: %2 samples lie beyond its range and are missing. Record with a larger range."))
ROW(unit_converted, note,
    Sentence::tr("Channel %1 is in %2 in the file; it was converted to %3, the unit of channel C."))
ROW(unit_of_one, warning,
    Sentence::tr(
        "Channel %1 is in %2 and channel %3 states no unit: both are taken to be in the same one."))
ROW(units_differ, serious,
    Sentence::tr("Channel %1 is in %2 and channel %3 in %4, units without a known ratio: "
                 "amplitudes and angles are wrong. Choose channels of one unit{ with --channels, "
                 "or give the gain ratio with --kappa|, or give the gain ratio}."))
ROW(time_unit_unknown, warning,
    Sentence::tr("The times are in '%1', an unknown unit, and are read as seconds. Choose their "
                 "unit{ with --time-unit, or their rate with --time-column none and --rate|, or "
                 "open the file without a time column and give the sample rate}."))
ROW(channel_delayed, warning,
    Sentence::tr("The times of channel D begin %1 s (%2 samples) after those of channel C; D was "
                 "interpolated to C's times. What its times are wrong by is a phase between the "
                 "channels ({--delay|delay of D})."))
ROW(channel_clocks_apart, warning,
    Sentence::tr("By their own times the sample rate of channel D is %1 ppm above that of channel "
                 "C; D was interpolated to C's times. Where both have one clock, their times are "
                 "wrong, and so is the phase between the channels."))
ROW(pieces_untimed, warning,
    Sentence::tr("The %1 pieces do not tell when they begin: they are taken to follow each other "
                 "without a gap."))
ROW(leakage, warning,
    Sentence::tr("In %1 of %2 windows the algorithm is off by more than one standard deviation, by "
                 "leakage; they are flagged. A window of whole half-periods (Snap) makes it "
                 "smallest; conjugate gradient and maximum likelihood have none."))
ROW(wave_moves, warning,
    Sentence::tr(
        "In %1 of %2 windows the wave moves inside the window, or turns too far from one window to "
        "the next; they are flagged. Choose a shorter window or a smaller step."))
ROW(text_lines_ignored, note, Sentence::tr("%1 header or comment lines were passed over."))
// Columns that hold words where channels hold numbers.
ROW(words_passed_over, note,
    Sentence::tr("Columns that hold words are no channels and were passed over: %1."))
ROW(clipped, warning,
    Sentence::tr(
        "Channel %1 is clipped: %2 samples at its rail, %3. Windows over them are flagged."))
// %1: places; %2: samples.
ROW(samples_still, warning,
    Sentence::tr(
        "Neither channel moves for 16 samples and a period of the carrier, or longer, in %1 "
        "place(s), %2 samples in all, the first at %3 s: lost samples that were filled, or "
        "a wave below one bit. Windows over them are flagged."))
ROW(samples_filled, serious,
    Sentence::tr("In %1 places, the first at %2 s, both channels repeat a sample or are zero, off "
                 "the wave around them: lost samples that were filled. The decay is wrong where "
                 "their number grows or falls. Record without losses."))
ROW(samples_lost, warning,
    Sentence::tr("Samples lost: %1 at %2 s. Windows over the place are flagged."))
ROW(samples_doubled, warning,
    Sentence::tr("Samples doubled: %1 at %2 s. Windows over the place are flagged."))
// %3 and %4: numbers up to a hundred.
ROW(phase_step, warning,
    Sentence::tr("A step of %1 rad in the phase of both channels at %2 s: samples were lost or "
                 "doubled. The phase shows their number only modulo the period: doubled %3, lost "
                 "%4, or more than 100. Windows over the place are flagged."))
// Places beyond those listed one by one.
ROW(more_samples_lost, warning,
    Sentence::tr("Further places where samples were lost or doubled: %1."))
ROW(channel_constant, warning, Sentence::tr("Channel %1 is constant: it holds no signal."))
ROW(channels_alike, serious,
    Sentence::tr("Channels C and D hold the same %1 samples: they are one signal, and the wave of "
                 "two channels is not in it. Choose the other channel{ (--channels)}."))
ROW(below_one_bit, warning,
    Sentence::tr(
        "Channel %1 stays within %2 levels of the converter: its signal is below one bit."))
ROW(offset, warning,
    Sentence::tr("Channel %1 has an offset of %2, %3 % of the amplitude. The calibration removes "
                 "it{ (--offset auto)}."))
ROW(mains, warning,
    Sentence::tr(
        "A line of the mains at %1 Hz, %2 % of the carrier. A band-pass removes it{ (--filter)}."))
ROW(start_transient, warning,
    Sentence::tr("The first %1 s do not decay like the rest of the recording. The range can "
                 "leave them out{ (--from)}."))
ROW(gaps_inserted, warning,
    Sentence::tr(
        "Lost samples made gaps, as asked for: %1; places: %2. Windows over them have no values."))
ROW(lost_counted, note,
    Sentence::tr(
        "Lost samples counted in the time behind them, so that the phase runs on: %1; places: %2."))
ROW(phase_unknown, warning,
    Sentence::tr(
        "Places where an unknown number of samples was lost or doubled: %1. The phase after each "
        "is a parameter of its own; time moves by the smallest possible number."))
ROW(carrier_elsewhere, serious,
    Sentence::tr("The carrier given is %1 Hz, and the signal is at %2 Hz: that is used."))
ROW(strike_left_out, note,
    Sentence::tr("The first %1 s are left out of the fit: a strike, or what a band-pass makes of "
                 "the beginning, is no free decay."))
// %2: what the motion is instead (words).
ROW(no_free_decay, serious,
    Sentence::tr("Recording %1: this is no free decay: %2. Damping, Q and what rests on them may "
                 "be off by more than their deviations."))
// The only part that is in free decay.
ROW(no_free_decay_part, serious,
    Sentence::tr("Recording %1: this is no free decay from start to end. From %2 s to %3 s it "
                 "decays freely: {take this part (--from %2 --to %3)|set the range to this part}."))
ROW(same_projection, serious,
    Sentence::tr("Recording %1: both channels show the same projection of the motion. The modes "
                 "are seen, but no directions: axes and quadrature are refused. Place the "
                 "pick-offs 45 degrees apart."))
ROW(mode_grows, serious,
    Sentence::tr(
        "The mode at %1 Hz would grow, at a rate of %2 1/s (standard deviation %3): the motion is "
        "not that of a resonator in free decay, and modes and resonator are refused."))
ROW(frequency_drifts, note,
    Sentence::tr("Recording %1: the frequency drifts by %2 Hz per second (standard deviation %3); "
                 "the drift is fitted, and Q is free of it."))
ROW(frequency_follows_amplitude, warning,
    Sentence::tr("The frequency depends on the amplitude: %1 Hz per squared recording unit "
                 "(standard deviation %2); this is fitted."))
ROW(q_disagrees, serious,
    Sentence::tr("Recording %1: Q from the envelope, %2, and from the coherent fit, %3, differ by "
                 "more than four standard deviations: the motion is not that of a resonator with "
                 "constant parameters."))
// tau is refused: the decay of the direction is given.
ROW(decay_of_one_direction, warning,
    Sentence::tr("The damping was seen in one direction only: the recording's own decay time is "
                 "given, not the resonator's."))
// %1: what speaks against it (words).
ROW(structured_refused, serious,
    Sentence::tr(
        "The channels are no calibrated pair of pick-offs (%1): the free model gives the modes, "
        "and the resonator has no axes. If they are calibrated, choose the structured model."))
// %2: what differs (words).
ROW(foreign_recording, serious,
    Sentence::tr("%1 does not fit the other recordings of the set: %2. The resonator is that of "
                 "the others."))
// %1: recordings without which the others agree; %2: what differs.
ROW(foreign_among, serious,
    Sentence::tr("The recordings do not fit one resonator, but they do without %1 (%2). Modes and "
                 "resonator are refused: correct or leave out a recording."))
ROW(set_inconsistent, serious,
    Sentence::tr(
        "The recordings do not fit one resonator, and no single one of them makes the difference. "
        "Modes and resonator are refused: identify fewer recordings together."))
// %1: which numbers differ, by how much (words).
ROW(recordings_differ, warning,
    Sentence::tr("The recordings differ by more than their noise: %1 (standard deviations). The "
                 "combined uncertainties hold this spread."))
// Two or three recordings; the spread is assumed.
ROW(set_too_small, note,
    Sentence::tr("Two or three recordings do not show whether all are of one resonator. The "
                 "combined uncertainties hold an assumed spread between them: of the decay rate by "
                 "%1 %, of the split by %2 %, of the gain ratio by %3 %."))
ROW(frequencies_apart, serious,
    Sentence::tr("The frequencies of the recordings lie %1 ppm apart (%2: %3 Hz, %4: %5 Hz). A "
                 "mean frequency and modes are refused."))
ROW(logs_differ, serious,
    Sentence::tr("The logs differ in the harmonic %1 of the drift, by %2 deviations: %3. No common "
                 "value is given."))
ROW(log_left_out, serious,
    Sentence::tr("%1 does not fit the other logs, in the harmonic %2 of the drift. The drift is "
                 "that of the others."))
ROW(turn_one_way, warning,
    Sentence::tr(
        "Gain ratio and non-orthogonality of the channels within their tolerance give a wave that "
        "turns a fourth harmonic of %1, which u holds. A log of the opposite turn tells it from "
        "the drift{; a smaller tolerance (--tolerance kappa=...,skew=...) lowers u}."))
ROW(angle_jumps, serious,
    Sentence::tr(
        "The angle of %1 jumps by %2 degrees at %3 s (places: %4). A false row is left out; "
        "where the controller's reference was set anew, the harmonics mix two angles: give "
        "each part as a log of its own."))
ROW(angle_coarse, serious,
    Sentence::tr(
        "The angle of %1 is written in steps of %2 degrees, coarse beside its turn from row "
        "to row, %3 degrees: the harmonics may be wrong by several of their deviations. "
        "Write more digits."))
ROW(angle_of_quarter, warning,
    Sentence::tr("%1 wraps its angle at 90 degrees: the sign of the second harmonic is that of its "
                 "first quarter of a turn."))
ROW(phasors_mirrored, serious,
    Sentence::tr(
        "%1: the phasors of C turn at %2 from the reference, those of D at %3, as if Y of one had "
        "the other sign. Export both channels with one sign of Y, or exchange its sign in the "
        "file. The numbers hold only if the reference lies in the middle between two modes."))
ROW(reference_follows, serious,
    Sentence::tr("%1: channel %2 beats in its amplitude and not in its phase, while the phase of "
                 "channel %3 turns: the reference follows channel %2, as that of a phase-locked "
                 "loop does, and has taken its frequency away. The numbers do not hold. {Give "
                 "--phasors common with|Choose phasors of an oscillator that moves, with} a column "
                 "of the reference's frequency (F) or phase (P), or log with a fixed reference."))
ROW(carrier_out_of_reach, warning,
    Sentence::tr("The strongest line stands at %1 Hz, beyond the reach of windows about the "
                 "carrier given, %2 Hz{ (--f0)}: unless another line is meant, the numbers are "
                 "those of no wave. Leave the carrier out so that it is looked for, or let a "
                 "band-pass pass its line alone{ (--filter)}."))
ROW(oscillator_backward, serious,
    Sentence::tr("%1: turned by the oscillator's phase the phasors wander, turned the other way "
                 "they are %2 times as steady: the sign of Y is another one than told, or that of "
                 "the phase. The numbers do not hold. {Give the other --y-sign|Choose the other "
                 "sign of Y}, or change the sign of the phase in the file."))
// Per cent of E^2.
ROW(powers_apart, serious,
    Sentence::tr("%1: R^2 + S^2 + Q^2 differs from E^2 by %2 % about %3 s, by more than noise "
                 "explains: a column has an offset, or a gain of its own, or the wave turns far "
                 "within a row. The numbers may be off by more than their uncertainties. Calibrate "
                 "the columns, or log faster."))
ROW(residual_above_noise, warning,
    Sentence::tr("The residual is above the noise of the windows (chi square per degree of freedom "
                 "%1); the standard deviations are enlarged to match."))
ROW(residual_below_noise, note,
    Sentence::tr("The residual is below the noise of the windows (chi square per degree of freedom "
                 "%1): the standard deviations are too large."))
ROW(residual_coloured, serious,
    Sentence::tr("The residual is not white (chi square per degree of freedom %1); the standard "
                 "deviations follow its spectrum."))
ROW(noise_too_narrow, serious,
    Sentence::tr("The noise about the carrier is as narrow as the residual can show. Noise "
                 "narrower than %1 Hz looks like the wave itself: the standard deviations may be "
                 "too small. Record longer, or repeat the recording."))
// %1: what the damping follows (words).
ROW(misfit_damping, serious,
    Sentence::tr("The residual is that of a damping by %1 (about %2 % of the damping at the "
                 "largest amplitude), which the model does not hold: damping, its anisotropy, "
                 "rotation and drifts may be off by more than their deviations. Fit parts of the "
                 "recordings in which the amplitude changes less{ (--from, --to)}."))
ROW(misfit_settling, serious,
    Sentence::tr("The residual is that of a frequency that settles by about %1 Hz in %2 s, which "
                 "the model does not hold: the resonator's numbers may be off by more than their "
                 "deviations. Leave the first seconds out {(--from)|of the range}."))
// %3: its possible origin; %4: whether a filter helps (words).
ROW(misfit_neighbour, serious,
    Sentence::tr("The residual holds a line at about %1 Hz, %2 % of the wave: %3, which the model "
                 "does not hold. Split, axes, rotation and the wave's own numbers may be off by "
                 "more than their deviations. A narrower band-pass{ (--filter)} %4."))
// %1: the error as --tolerance names it. So in the next three.
ROW(misfit_channel, serious,
    Sentence::tr(
        "The residual is that of an error of the channels that is taken as zero: %1, about %2. "
        "Calibrate it, or {tell its tolerance (--tolerance)|state its tolerance}."))
ROW(quadrature_by_channel, serious,
    Sentence::tr("The quadrature of the recordings at their starts follows the angle, as an error "
                 "of the channels makes it: %1, about %2. Split, axes and rotation may be off by "
                 "more than their uncertainties. Measure it and correct the signals{ (a delay by "
                 "--delay), or state its tolerance (--tolerance)|, or state its tolerance}."))
ROW(rotation_or_channel, serious,
    Sentence::tr(
        "The waves turn by %1, faster than the Earth. Where the base turns, that is right. Where "
        "it stands still, it is an error of the channels, %2 of about %3, and split and axes are "
        "off, too: measure it and correct the signals{ (--delay)}."))
ROW(prior_left, serious,
    Sentence::tr("The recordings need a channel error far beyond its tolerance: %1 of %2, %3 "
                 "tolerances. The tolerance is too small, or the motion is not that of the model: "
                 "the numbers may be off by more than their uncertainties."))
ROW(anisotropy_not_passive, serious,
    Sentence::tr("The damping anisotropy, %1 1/s, reaches the greatest value of a passive "
                 "resonator, 2/tau = %2 1/s: one mode hardly decays. The motion may not be that of "
                 "the model, and the numbers may be off by more than their uncertainties."))
ROW(misfit_springs, serious,
    Sentence::tr(
        "The residual is that of springs that follow the amplitude differently along the axes "
        "(about %1 Hz at the largest amplitude), which the model does not hold: split, axes and "
        "rotation may be off by more than their uncertainties. Record smaller amplitudes."))
ROW(misfit_pickoff, serious,
    Sentence::tr("The residual is that of pick-offs whose gain follows the amplitude: by about %1 "
                 "% in channel C and %2 % in D at the largest amplitude, which the model does not "
                 "hold. Split, damping, axes and rotation may be off by more than their "
                 "deviations. Linearise the channels, or record smaller amplitudes."))
ROW(fitted_phase_step, warning,
    Sentence::tr("%1: the phase of both channels steps by %2 rad at %3 s; samples are lost or "
                 "doubled there. The fit leaves the phase open at that place."))
// %5: by what (words).
ROW(fitted_gain_step, warning,
    Sentence::tr("%1: the gain of channel C changes by %2 % and that of D by %3 % at %4 s, as "
                 "where %5. The fit leaves both gains open at that place; {--from|the start of the "
                 "range} can leave out what is before it."))
ROW(fitted_knock, warning,
    Sentence::tr("%1: the wave changes by %2 % of itself at %3 s, as by a knock or as a drive "
                 "ends. The fit leaves the wave open at that place."))
ROW(event_left_out, warning,
    Sentence::tr("%1: the signal is disturbed at %2 s; the fit leaves %3 s out."))
ROW(motion_not_model, serious,
    Sentence::tr(
        "The motion is not that of the model: the residual is no stationary noise, or the two "
        "halves of the recordings disagree by more than noise explains. The standard deviations "
        "contain the disagreement; fit parts of the recordings to see which one differs."))
ROW(fit_not_converged, serious,
    Sentence::tr("The fit of the resonator stopped before it converged: its values are refused."))
ROW(other_gyro, serious,
    Sentence::tr("The passport is that of the gyro %1, the recordings are of the gyro %2: their "
                 "differences are no changes of one resonator."))
// %1: option of the command line; %2: why.
ROW(option_without_effect, warning, Sentence::tr("%1 has no effect: %2."))
ROW(column_like_option, warning,
    Sentence::tr("The column \"%1\" of the list is kept as it is and changes nothing. Did you mean "
                 "\"%2\"? Rename it then."))
ROW(formula_in_list, warning,
    Sentence::tr("The table's field \"%1\" (%2) begins as a formula does, and a table program that "
                 "opens the results runs it."))
ROW(earlier_rows, warning,
    Sentence::tr("%1 holds %2 finished rows of an interrupted batch. All sets are computed again; "
                 "the rows stay until the table is written, and a resumed batch takes them."))
ROW(channels_crossed, warning,
    Sentence::tr("Channel C is read from \"%1\", channel D from \"%2\". Exchange the channels if "
                 "their names are right."))
ROW(other_rows, warning,
    Sentence::tr("%1 holds %2 finished rows that this batch cannot take: their sets, recordings, "
                 "settings, limits or columns are others."))
ROW(limits_not_kept, warning,
    Sentence::tr("The limits are not kept by %1 of %3 sets; %2 are undecided."))
ROW(limits_missing, warning,
    Sentence::tr(
        "Nothing is judged in %1 of %2 sets: the table of limits has none for their type of gyro."))
ROW(database_waits, warning,
    Sentence::tr("%1 is in use by another program. The batch waits for it, up to %2 s."))
// %1: the set that the database keeps.
ROW(same_recordings, warning,
    Sentence::tr("The database holds the result of %1 alone: %2 has the same recordings and "
                 "settings."))
