#pragma once

#include "core/base/message_arg.h"

#include <cstdint>
#include <string>
#include <vector>

namespace vybeg {

// What deserves to be known about a recording or an analysis but does not stop it.
enum class DiagnosticKind {
    time_uneven,  // args: largest deviation (s), the same in samples. Resampled to a uniform grid.
    time_gap,     // args: missing samples, at time (s)
    missing_samples,     // args: count of NaN and infinite samples. Windows over them are flagged.
    file_ends_early,     // args: frames promised, frames present
    file_not_closed,     // args: frames present. Nothing says how many there were to be.
    channels_unequal,    // args: C's name, its samples, D's name, its samples
    filter_transients,   // args: seconds lost at each end
    context_missing,     // args: samples that the algorithm needs beyond the window
    not_converged,       // args: windows, of
    over_range,          // args: channel, samples. Of the missing ones, those beyond its range.
    unit_converted,      // args: channel, its unit, the unit of C, in which it is read
    unit_of_one,         // args: channel, its unit, the other channel, which states none
    units_differ,        // args: channel C, its unit, channel D, its unit. No factor between them.
    time_unit_unknown,   // args: unit of the times, which are read as seconds
    channel_delayed,     // args: by how much D's times are later (s, samples). It is interpolated.
    pieces_untimed,      // args: pieces, which are taken to follow each other
    leakage,             // args: windows, of. The closed form is off by more than its deviation.
    wave_moves,          // args: windows, of. Inside a window or between two.
    text_lines_ignored,  // args: count; header and comment lines
    words_passed_over,   // args: columns that hold words where channels hold numbers
    clipped,             // args: channel, samples at the rail, its level
    samples_lost,        // args: samples, at time (s). A phase step common to both channels.
    samples_doubled,     // args: samples, at time (s)
    phase_step,          // args: step (rad), at time (s), numbers of samples that may have been
                         // doubled, and lost. The phase tells them only modulo the period.
    more_samples_lost,   // args: places beyond those told one by one
    below_one_bit,       // args: channel, levels of the converter that it takes
    offset,              // args: channel, offset, per cent of the amplitude
    mains,               // args: frequency (Hz), per cent of the carrier
    start_transient,     // args: seconds
    gaps_inserted,       // args: samples, places. On the engineer's wish.
    lost_counted,        // args: samples, places. Counted in the time of an identification.
    phase_unknown,       // args: places of a phase_step inside an identification
    carrier_elsewhere,   // args: carrier given, carrier found (Hz)
    strike_left_out,     // args: seconds from the start of the range. No free decay there yet.
    no_free_decay,       // args: recording, what the motion is instead (words)
    part_decays,         // args: recording, begin, end (s) of its only part in free decay
    same_projection,     // args: recording. Two modes beat, in one direction of C and D.
    mode_grows,          // args: the mode (Hz), rate of growth, its sd (1/s). Modes are refused.
    frequency_drifts,    // args: recording, Hz per s, its sd. Fitted.
    frequency_follows_amplitude,  // args: Hz per squared unit of amplitude, its sd. Fitted.
    q_disagrees,                  // args: recording, Q from the envelope, Q from the coherent fit
    decay_of_one_direction,       // tau is refused: the decay of the direction is given
    structured_refused,           // args: what speaks against it. The free model is taken.
    foreign_recording,            // args: recording, what differs. It is left out of the set.
    foreign_among,                // args: recordings without which the others agree, what differs
    set_inconsistent,             // no single recording makes the difference
    recordings_differ,            // args: sd of 1/tau, split, gain ratio between recordings, %
    set_too_small,                // args: the same, assumed, as two or three recordings
    frequencies_apart,            // args: ppm, recording, its f (Hz), another, its f (Hz)
    logs_differ,                  // args: harmonic of the drift, deviations, names of the logs
    log_left_out,                 // args: log, harmonic in which it differs from the others
    turn_one_way,                 // args: the fourth harmonic that channels within tolerance make
    angle_of_quarter,             // args: log. Its angle is wrapped at a quarter of a turn.
    phasors_mirrored,             // args: recording, rates of C and of D from the reference
    reference_follows,            // args: recording, the channel that it follows, the other one
    powers_apart,            // args: recording, R^2 + S^2 + Q^2 less E^2 (% of it), at time (s)
    residual_above_noise,    // args: chi^2 per degree of freedom. Deviations enlarged.
    residual_below_noise,    // args: chi^2 per degree of freedom. Deviations too large.
    residual_coloured,       // args: chi^2 per degree of freedom. Deviations hold its colour.
    noise_too_narrow,        // args: width (Hz) below which no residual shows a noise
    misfit_damping,          // args: what the damping follows (words), its share at the
                             // largest amplitude, %
    misfit_settling,         // args: Hz, s. A frequency that settles.
    misfit_neighbour,        // args: frequency (Hz), per cent of the wave. Another mode.
    misfit_channel,          // args: error as --tolerance names it, its size; held at zero
    quadrature_by_channel,   // args: error as --tolerance names it, its size. a_B by angle.
    rotation_or_channel,     // args: rotation of the wave, error that looks like it, its size
    prior_left,              // args: error as --tolerance names it, its size, in tolerances
    anisotropy_not_passive,  // args: damping anisotropy, its greatest value 2/tau (1/s)
    misfit_springs,          // args: Hz at the largest amplitude. Unlike along the axes.
    misfit_pickoff,          // args: change of the gain of C, of D at the largest amplitude, %
    fitted_phase_step,       // args: recording, step (rad), at time (s). The phase is fitted.
    fitted_gain_step,        // args: recording, gain of C, of D (%), at time (s). Fitted.
    fitted_knock,            // args: recording, per cent of the wave, at time (s). Fitted.
    event_left_out,          // args: recording, at time (s), seconds left out
    motion_not_model,        // the halves of the recordings disagree. Deviations hold it.
    fit_not_converged,       // the fit stopped early
    other_gyro,              // args: gyro of the passport, gyro of the recordings
    option_without_effect,   // args: option of the command line, why
    column_like_option,      // args: column of a list that is kept, the option it resembles
    formula_in_list,         // args: line, column, field. A table program runs it.
    earlier_rows,            // args: file, number of its rows. An interrupted batch.
    channels_crossed,        // args: name of the channel read as C, of that read as D
    other_rows,              // args: file, number of its rows. Of other settings.
    limits_not_kept,         // args: sets outside the limits, undecided ones, all
    database_waits,          // args: file, longest wait in s. Another program holds it.
    same_recordings,         // args: set that the database keeps, the other one
};

// first_frame is -1 where the diagnostic has no place in the recording; count is in frames.
struct Diagnostic {
    DiagnosticKind kind{};
    std::vector<MessageArg> args;
    std::int64_t first_frame = -1;
    std::int64_t count = 0;

    friend bool operator==(const Diagnostic&, const Diagnostic&) = default;
};

// The name of a kind as it stands in JSON, e.g. "time-gap".
std::string kind_name(DiagnosticKind kind);

// Weight of a diagnostic: the worst are shown first.
enum class Severity {
    note,     // the numbers are unaffected
    warning,  // deviations are enlarged, or windows flagged
    serious   // numbers are refused, or may be off by more than their deviations
};
Severity severity(DiagnosticKind kind);

// Its name in JSON: "note", "warning" or "serious".
std::string severity_name(Severity severity);

MessageRow message_row(DiagnosticKind kind);

// The whole English sentence.
std::string english(const Diagnostic& diagnostic);

}  // namespace vybeg
