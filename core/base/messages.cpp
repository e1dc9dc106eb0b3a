#include "core/base/messages.h"

#include "core/base/plain_text.h"

// Marks a text for lupdate (see translations/CMakeLists or ui/CMakeLists: -tr-function-alias); core
// itself has no translations.
#define VYBEG_MESSAGE(context, text) text

namespace vybeg {

const char* message_template(ErrorCode code) {
    switch (code) {
        case ErrorCode::setting_invalid:
            return VYBEG_MESSAGE("Message", "%2 cannot be \"%3\": %4.");
        case ErrorCode::file_missing:
            return VYBEG_MESSAGE("Message",
                                 "%1: there is no such file. Check the name and the folder.");
        case ErrorCode::file_permission:
            return VYBEG_MESSAGE(
                "Message",
                "%1: no permission to read this file. Change its permissions or copy it.");
        case ErrorCode::file_is_directory:
            return VYBEG_MESSAGE("Message",
                                 "%1 is a folder, not a recording. Name one file inside it.");
        case ErrorCode::file_empty:
            return VYBEG_MESSAGE("Message",
                                 "%1: the file is empty (0 bytes). Record or copy it again.");
        case ErrorCode::file_read_failed:
            return VYBEG_MESSAGE("Message",
                                 "%1: reading failed: %2. Check the disk and copy the file again.");
        case ErrorCode::format_unknown:
            return VYBEG_MESSAGE(
                "Message",
                "%1: neither an audio file nor a table of numbers. Save the recording as "
                "WAV or CSV, or give the layout of raw samples with --raw.");
        case ErrorCode::format_damaged:
            return VYBEG_MESSAGE("Message", "%1: the %2 file is damaged: %3. Copy it again.");
        case ErrorCode::format_unsupported:
            return VYBEG_MESSAGE("Message",
                                 "%1: this %2 file holds %3, which is not read here. Export the "
                                 "recording as WAV or CSV.");
        case ErrorCode::text_not_a_number:
            return VYBEG_MESSAGE(
                "Message",
                "%1, line %2, column %3: \"%4\" is not a number. Correct it, or write nan "
                "for a missing sample.");
        case ErrorCode::text_no_data:
            return VYBEG_MESSAGE(
                "Message",
                "%1: no line with two or more numbers. The file needs one column for each "
                "pick-off.");
        case ErrorCode::text_time_backwards:
            return VYBEG_MESSAGE(
                "Message",
                "%1, line %2: the time %3 does not follow %4. The time column must rise.");
        case ErrorCode::text_no_table:
            return VYBEG_MESSAGE(
                "Message",
                "%1: read as text with %2, no line from %3 on has two or more numbers; that "
                "line reads \"%4\". Choose another delimiter, decimal sign or first line.");
        case ErrorCode::text_lines_missing:
            return VYBEG_MESSAGE("Message",
                                 "%1: %2 lines are to be skipped, and the file has only %3.");
        case ErrorCode::column_out_of_range:
            return VYBEG_MESSAGE("Message",
                                 "%1: there is no column %2 to be the time; the file has %3.");
        case ErrorCode::too_few_channels:
            return VYBEG_MESSAGE(
                "Message", "%1 has %2 channel(s), and %3 are needed: the two pick-offs C and D.");
        case ErrorCode::channel_out_of_range:
            return VYBEG_MESSAGE("Message",
                                 "%1: there is no channel %2; the file has %3. Choose other "
                                 "channels with --channels.");
        case ErrorCode::too_few_frames:
            return VYBEG_MESSAGE("Message", "%1 holds %2 sample(s), and at least %3 are needed.");
        case ErrorCode::rate_unknown:
            return VYBEG_MESSAGE(
                "Message",
                "%1: the file does not tell its sample rate. Give it with --rate, in Hz.");
        case ErrorCode::passport_damaged:
            return VYBEG_MESSAGE("Message", "%1 is not a passport that can be read: %2.");
        case ErrorCode::passport_schema:
            return VYBEG_MESSAGE(
                "Message",
                "%1: a passport of schema %2; this program knows schemas up to %3. "
                "Use the program that wrote it, or a newer one.");
        case ErrorCode::variable_missing:
            return VYBEG_MESSAGE("Message",
                                 "%1: there is no variable \"%2\" to read; the file has %3. "
                                 "Choose others with --variables.");
        case ErrorCode::file_changed:
            return VYBEG_MESSAGE("Message",
                                 "%1 changed while it was read: its size or the time of its last "
                                 "change is another. Wait until it is complete, and open it "
                                 "again.");
        case ErrorCode::window_too_long:
            return VYBEG_MESSAGE(
                "Message",
                "%1: the window of %2 samples is longer than the %3 samples to analyse. "
                "Choose a shorter window or a longer range.");
        case ErrorCode::window_too_short:
            return VYBEG_MESSAGE(
                "Message",
                "%1: the window of %2 samples is too short; at this carrier it needs at "
                "least %3 (5 samples, and three quarters of a period of the carrier and of its "
                "distance from half the sample rate).");
        case ErrorCode::range_empty:
            return VYBEG_MESSAGE(
                "Message", "%1: nothing lies between %2 s and %3 s; the recording is %4 s long.");
        case ErrorCode::carrier_above_half_rate:
            return VYBEG_MESSAGE(
                "Message",
                "%1: the carrier of %2 Hz is not below half the sample rate, %3 Hz. Check "
                "the carrier and the rate.");
        case ErrorCode::carrier_not_found:
            return VYBEG_MESSAGE(
                "Message",
                "%1: no carrier stands out of the spectrum. Give it with --f0, or the band "
                "to look in with --band.");
        case ErrorCode::carrier_not_near:
            return VYBEG_MESSAGE(
                "Message",
                "%1: no line stands out of the spectrum within %3 Hz of the carrier given, %2 Hz. "
                "Give a nearer one, or leave it out so that it is looked for.");
        case ErrorCode::band_invalid:
            return VYBEG_MESSAGE(
                "Message",
                "%1: the band from %2 Hz to %3 Hz is impossible; it must rise and lie "
                "between 0 and half the sample rate, %4 Hz.");
        case ErrorCode::filter_too_long:
            return VYBEG_MESSAGE(
                "Message",
                "%1: the filter needs %2 samples at each end, and the recording has only "
                "%3. Choose a wider band or a longer recording.");
        case ErrorCode::no_valid_samples:
            return VYBEG_MESSAGE("Message", "%1: every sample of the range is missing (NaN).");
        case ErrorCode::every_window_clipped:
            return VYBEG_MESSAGE(
                "Message",
                "%1: every window holds clipped samples (channel %2). Record with a lower gain, "
                "begin the range where the wave is weaker (--from), or shorten the window.");
        case ErrorCode::simulation_impossible:
            return VYBEG_MESSAGE("Message", "This decay cannot be simulated: %2.");
        case ErrorCode::fit_window_too_short:
            return VYBEG_MESSAGE(
                "Message",
                "%1: the window of %2 samples is too short for the resonator's fit; at this "
                "carrier it needs at least %3 (16 samples and two periods).");
        case ErrorCode::fit_window_turns:
            return VYBEG_MESSAGE(
                "Message",
                "%1: the window of %2 samples is too long for the beat between the lines at %3 Hz "
                "and %4 Hz. Use at most %5 samples, or leave the window out.");
        case ErrorCode::fit_beat_too_fast:
            return VYBEG_MESSAGE(
                "Message",
                "%1: the lines at %2 Hz and %3 Hz beat too fast for windows of %4 samples, the "
                "shortest at this carrier. Keep one pair of modes with --filter.");
        case ErrorCode::fit_too_few_windows:
            return VYBEG_MESSAGE("Message",
                                 "%1: the resonator needs %3 windows without faults, and there are "
                                 "%2. Use a longer recording or shorter windows.");
        case ErrorCode::fit_failed:
            return VYBEG_MESSAGE("Message", "The resonator cannot be fitted to %1: %2.");
        case ErrorCode::same_recording:
            return VYBEG_MESSAGE("Message",
                                 "%1 and %2 hold the same samples (SHA-256): a recording that is "
                                 "counted twice is no new evidence. Name each recording once.");
        case ErrorCode::band_too_narrow:
            return VYBEG_MESSAGE(
                "Message",
                "%1: the band from %2 Hz to %3 Hz is too narrow for the search for the carrier; at "
                "this length it needs at least %4 Hz. Give the carrier with --f0, or a wider "
                "band.");
        case ErrorCode::channel_without_samples:
            return VYBEG_MESSAGE(
                "Message",
                "%1: channel %2 has no samples in the range: every one is missing (NaN). Choose "
                "other channels or another range.");
        case ErrorCode::out_of_memory:
            return VYBEG_MESSAGE("Message",
                                 "There is not enough memory. Choose a shorter range, or end other "
                                 "programs.");
        case ErrorCode::out_of_threads:
            return VYBEG_MESSAGE("Message",
                                 "The system starts no more threads. Raise the limit of processes, "
                                 "or give a smaller number with --threads.");
        case ErrorCode::output_failed:
            return VYBEG_MESSAGE("Message", "%1 cannot be written: %2. Nothing was changed there.");
        case ErrorCode::output_format_unknown:
            return VYBEG_MESSAGE("Message",
                                 "%1: the ending \"%2\" is not one that can be written here.");
        case ErrorCode::output_is_recording:
            return VYBEG_MESSAGE("Message",
                                 "%1 is one of the open recordings, and stays as it is. Choose "
                                 "another name.");
        case ErrorCode::output_incomplete:
            return VYBEG_MESSAGE(
                "Message", "%1 cannot be written: %2. What has gone out there is incomplete.");
        case ErrorCode::interrupted_partly:
            return VYBEG_MESSAGE("Message", "Interrupted; what has gone out to %1 is incomplete.");
        case ErrorCode::interrupted:
            return VYBEG_MESSAGE("Message", "Interrupted; nothing was written.");
    }
    return "";
}

const char* message_template(DiagnosticKind kind) {
    switch (kind) {
        case DiagnosticKind::time_uneven:
            return VYBEG_MESSAGE(
                "Message",
                "The time column is uneven, by up to %1 s (%2 samples); the signals were "
                "resampled to a uniform grid by local cubic interpolation.");
        case DiagnosticKind::time_gap:
            return VYBEG_MESSAGE("Message",
                                 "%1 samples are missing at %2 s; windows over them are flagged.");
        case DiagnosticKind::missing_samples:
            return VYBEG_MESSAGE("Message",
                                 "%1 samples are NaN or infinite; windows over them are flagged.");
        case DiagnosticKind::file_ends_early:
            return VYBEG_MESSAGE(
                "Message",
                "The file ends early: its header promises %1 frames, %2 are there. Those "
                "are used.");
        case DiagnosticKind::file_not_closed:
            return VYBEG_MESSAGE(
                "Message",
                "The file is still being written, was never closed or has been cut off: nothing "
                "in it says how many frames there are to be. The %1 that are there are used.");
        case DiagnosticKind::channels_unequal:
            return VYBEG_MESSAGE(
                "Message",
                "The channels differ in length: %1 has %2 samples, %3 has %4. Both are counted "
                "from their first sample, and the end of the longer one is left out.");
        case DiagnosticKind::filter_transients:
            return VYBEG_MESSAGE(
                "Message",
                "The band-pass takes %1 s at each end for its transient; those windows "
                "are flagged.");
        case DiagnosticKind::context_missing:
            return VYBEG_MESSAGE(
                "Message",
                "This algorithm needs %1 samples on both sides of a window; windows "
                "without them are flagged.");
        case DiagnosticKind::not_converged:
            return VYBEG_MESSAGE("Message", "%1 of %2 windows did not converge; they are flagged.");
        case DiagnosticKind::over_range:
            return VYBEG_MESSAGE("Message",
                                 "Channel %1: %2 samples lie beyond its range and are missing. "
                                 "Record with a larger range.");
        case DiagnosticKind::unit_converted:
            return VYBEG_MESSAGE("Message",
                                 "Channel %1 is in %2 in the file; it was converted to %3, the "
                                 "unit of channel C.");
        case DiagnosticKind::units_differ:
            return VYBEG_MESSAGE("Message",
                                 "Channel %1 is in %2 and channel %3 in %4, units without a known "
                                 "ratio: amplitudes and angles are wrong. Choose channels of one "
                                 "unit with --channels, or give the gain ratio with --kappa.");
        case DiagnosticKind::leakage:
            return VYBEG_MESSAGE(
                "Message",
                "In %1 of %2 windows the algorithm is off by more than one standard deviation, by "
                "leakage; they are flagged. A window of whole half-periods (Snap) makes it "
                "smallest; conjugate gradient and maximum likelihood have none.");
        case DiagnosticKind::wave_moves:
            return VYBEG_MESSAGE(
                "Message",
                "In %1 of %2 windows the wave moves inside the window, or turns too far from one "
                "window to the next; they are flagged. Choose a shorter window or a smaller hop.");
        case DiagnosticKind::text_lines_ignored:
            return VYBEG_MESSAGE("Message", "%1 header or comment lines were passed over.");
        case DiagnosticKind::clipped:
            return VYBEG_MESSAGE("Message",
                                 "Channel %1 is clipped: %2 samples at its rail, %3. Windows over "
                                 "them are flagged.");
        case DiagnosticKind::samples_lost:
            return VYBEG_MESSAGE("Message",
                                 "Samples lost: %1 at %2 s. Windows over the place are flagged.");
        case DiagnosticKind::samples_doubled:
            return VYBEG_MESSAGE(
                "Message", "Samples doubled: %1 at %2 s. Windows over the place are flagged.");
        case DiagnosticKind::phase_step:
            return VYBEG_MESSAGE(
                "Message",
                "A step of %1 rad in the phase of both channels at %2 s. Samples doubled: %3, or "
                "lost: %4; the phase shows them only modulo the period. Windows over the place "
                "are flagged.");
        case DiagnosticKind::more_samples_lost:
            return VYBEG_MESSAGE("Message", "Samples were lost or doubled at %1 more places.");
        case DiagnosticKind::below_one_bit:
            return VYBEG_MESSAGE(
                "Message",
                "Channel %1 stays within %2 levels of the converter: its signal is below "
                "one bit.");
        case DiagnosticKind::offset:
            return VYBEG_MESSAGE("Message",
                                 "Channel %1 has an offset of %2, %3 % of the amplitude. The "
                                 "calibration takes it out (--offset auto).");
        case DiagnosticKind::mains:
            return VYBEG_MESSAGE(
                "Message",
                "A line of the mains at %1 Hz, %2 % of the carrier. A band-pass takes it out "
                "(--filter).");
        case DiagnosticKind::start_transient:
            return VYBEG_MESSAGE(
                "Message",
                "The first %1 s do not decay as what follows. The range can leave them out "
                "(--from).");
        case DiagnosticKind::gaps_inserted:
            return VYBEG_MESSAGE("Message",
                                 "%1 lost samples at %2 places were made gaps, as asked for; "
                                 "windows over them have no values.");
        case DiagnosticKind::lost_counted:
            return VYBEG_MESSAGE(
                "Message",
                "%1 lost samples at %2 places are counted in the time behind them, "
                "so that the phase runs on.");
        case DiagnosticKind::phase_unknown:
            return VYBEG_MESSAGE(
                "Message",
                "At %1 places an unknown number of samples was lost or doubled: the phase after "
                "each is a parameter of its own. Time moves by the smallest possible number.");
        case DiagnosticKind::carrier_elsewhere:
            return VYBEG_MESSAGE("Message",
                                 "The carrier given is %1 Hz, and the signal is at %2 Hz: that is "
                                 "used.");
        case DiagnosticKind::strike_left_out:
            return VYBEG_MESSAGE("Message",
                                 "The first %1 s are left out of the fit: the strike and what the "
                                 "band-pass makes of it are no free decay.");
        case DiagnosticKind::frequency_drifts:
            return VYBEG_MESSAGE("Message",
                                 "Recording %1: the frequency drifts by %2 Hz per second (standard "
                                 "deviation %3); the drift is fitted, and Q is free of it.");
        case DiagnosticKind::frequency_follows_amplitude:
            return VYBEG_MESSAGE("Message",
                                 "The frequency depends on the amplitude: %1 Hz per squared "
                                 "recording unit (standard deviation %2); this is fitted.");
        case DiagnosticKind::q_disagrees:
            return VYBEG_MESSAGE("Message",
                                 "Recording %1: Q from the envelope, %2, and from the coherent "
                                 "fit, %3, differ by more than three standard deviations: the "
                                 "motion is not that of a resonator with constant parameters.");
        case DiagnosticKind::decay_of_one_direction:
            return VYBEG_MESSAGE("Message",
                                 "The damping was seen in one direction only: the recording's own "
                                 "decay time is given, not the resonator's.");
        case DiagnosticKind::structured_refused:
            return VYBEG_MESSAGE("Message",
                                 "The channels are no calibrated pair of pick-offs (%1): the free "
                                 "model gives the modes, and the resonator has no axes.");
        case DiagnosticKind::residual_above_noise:
            return VYBEG_MESSAGE(
                "Message",
                "The residual is above the noise of the windows (chi square per degree of freedom "
                "%1); the standard deviations are enlarged to match.");
        case DiagnosticKind::residual_below_noise:
            return VYBEG_MESSAGE(
                "Message",
                "The residual is below the noise of the windows (chi square per degree of freedom "
                "%1): the standard deviations are too large.");
        case DiagnosticKind::residual_coloured:
            return VYBEG_MESSAGE(
                "Message",
                "The residual is not white (chi square per degree of freedom %1); the standard "
                "deviations follow its spectrum.");
        case DiagnosticKind::noise_too_narrow:
            return VYBEG_MESSAGE(
                "Message",
                "The noise about the carrier is as narrow as the residual can show. Noise narrower "
                "than %1 Hz looks like the wave itself: the standard deviations may be too small. "
                "Record longer, or repeat the recording.");
        case DiagnosticKind::fit_not_converged:
            return VYBEG_MESSAGE(
                "Message",
                "The fit of the resonator stopped before it converged; its values are doubtful.");
        case DiagnosticKind::option_without_effect:
            return VYBEG_MESSAGE("Message", "%1 has no effect: %2.");
    }
    return "";
}

std::string kind_name(DiagnosticKind kind) {
    switch (kind) {
        case DiagnosticKind::time_uneven: return "time-uneven";
        case DiagnosticKind::time_gap: return "time-gap";
        case DiagnosticKind::missing_samples: return "missing-samples";
        case DiagnosticKind::file_ends_early: return "file-ends-early";
        case DiagnosticKind::file_not_closed: return "file-not-closed";
        case DiagnosticKind::channels_unequal: return "channels-unequal";
        case DiagnosticKind::filter_transients: return "filter-transients";
        case DiagnosticKind::context_missing: return "context-missing";
        case DiagnosticKind::not_converged: return "not-converged";
        case DiagnosticKind::over_range: return "over-range";
        case DiagnosticKind::unit_converted: return "unit-converted";
        case DiagnosticKind::units_differ: return "units-differ";
        case DiagnosticKind::leakage: return "leakage";
        case DiagnosticKind::wave_moves: return "wave-moves";
        case DiagnosticKind::text_lines_ignored: return "text-lines-ignored";
        case DiagnosticKind::clipped: return "clipped";
        case DiagnosticKind::samples_lost: return "samples-lost";
        case DiagnosticKind::samples_doubled: return "samples-doubled";
        case DiagnosticKind::phase_step: return "phase-step";
        case DiagnosticKind::more_samples_lost: return "more-samples-lost";
        case DiagnosticKind::below_one_bit: return "below-one-bit";
        case DiagnosticKind::offset: return "offset";
        case DiagnosticKind::mains: return "mains";
        case DiagnosticKind::start_transient: return "start-transient";
        case DiagnosticKind::gaps_inserted: return "gaps-inserted";
        case DiagnosticKind::lost_counted: return "lost-counted";
        case DiagnosticKind::phase_unknown: return "phase-unknown";
        case DiagnosticKind::carrier_elsewhere: return "carrier-elsewhere";
        case DiagnosticKind::strike_left_out: return "strike-left-out";
        case DiagnosticKind::frequency_drifts: return "frequency-drifts";
        case DiagnosticKind::frequency_follows_amplitude: return "frequency-follows-amplitude";
        case DiagnosticKind::q_disagrees: return "q-disagrees";
        case DiagnosticKind::decay_of_one_direction: return "decay-of-one-direction";
        case DiagnosticKind::structured_refused: return "structured-refused";
        case DiagnosticKind::residual_above_noise: return "residual-above-noise";
        case DiagnosticKind::residual_below_noise: return "residual-below-noise";
        case DiagnosticKind::residual_coloured: return "residual-coloured";
        case DiagnosticKind::noise_too_narrow: return "noise-too-narrow";
        case DiagnosticKind::fit_not_converged: return "fit-not-converged";
        case DiagnosticKind::option_without_effect: return "option-without-effect";
    }
    return "";
}

std::string code_name(ErrorCode code) {
    switch (code) {
        case ErrorCode::setting_invalid: return "setting-invalid";
        case ErrorCode::file_missing: return "file-missing";
        case ErrorCode::file_permission: return "file-permission";
        case ErrorCode::file_is_directory: return "file-is-directory";
        case ErrorCode::file_empty: return "file-empty";
        case ErrorCode::file_read_failed: return "file-read-failed";
        case ErrorCode::format_unknown: return "format-unknown";
        case ErrorCode::format_damaged: return "format-damaged";
        case ErrorCode::format_unsupported: return "format-unsupported";
        case ErrorCode::text_not_a_number: return "text-not-a-number";
        case ErrorCode::text_no_data: return "text-no-data";
        case ErrorCode::text_time_backwards: return "text-time-backwards";
        case ErrorCode::text_no_table: return "text-no-table";
        case ErrorCode::text_lines_missing: return "text-lines-missing";
        case ErrorCode::column_out_of_range: return "column-out-of-range";
        case ErrorCode::too_few_channels: return "too-few-channels";
        case ErrorCode::channel_out_of_range: return "channel-out-of-range";
        case ErrorCode::too_few_frames: return "too-few-frames";
        case ErrorCode::rate_unknown: return "rate-unknown";
        case ErrorCode::passport_damaged: return "passport-damaged";
        case ErrorCode::passport_schema: return "passport-schema";
        case ErrorCode::variable_missing: return "variable-missing";
        case ErrorCode::file_changed: return "file-changed";
        case ErrorCode::window_too_long: return "window-too-long";
        case ErrorCode::window_too_short: return "window-too-short";
        case ErrorCode::range_empty: return "range-empty";
        case ErrorCode::carrier_above_half_rate: return "carrier-above-half-rate";
        case ErrorCode::carrier_not_found: return "carrier-not-found";
        case ErrorCode::carrier_not_near: return "carrier-not-near";
        case ErrorCode::band_invalid: return "band-invalid";
        case ErrorCode::filter_too_long: return "filter-too-long";
        case ErrorCode::no_valid_samples: return "no-valid-samples";
        case ErrorCode::every_window_clipped: return "every-window-clipped";
        case ErrorCode::simulation_impossible: return "simulation-impossible";
        case ErrorCode::fit_window_too_short: return "fit-window-too-short";
        case ErrorCode::fit_window_turns: return "fit-window-turns";
        case ErrorCode::fit_beat_too_fast: return "fit-beat-too-fast";
        case ErrorCode::fit_too_few_windows: return "fit-too-few-windows";
        case ErrorCode::fit_failed: return "fit-failed";
        case ErrorCode::same_recording: return "same-recording";
        case ErrorCode::band_too_narrow: return "band-too-narrow";
        case ErrorCode::channel_without_samples: return "channel-without-samples";
        case ErrorCode::out_of_memory: return "out-of-memory";
        case ErrorCode::out_of_threads: return "out-of-threads";
        case ErrorCode::output_failed: return "output-failed";
        case ErrorCode::output_format_unknown: return "output-format-unknown";
        case ErrorCode::output_is_recording: return "output-is-recording";
        case ErrorCode::output_incomplete: return "output-incomplete";
        case ErrorCode::interrupted_partly: return "interrupted-partly";
        case ErrorCode::interrupted: return "interrupted";
    }
    return "";
}

int exit_status(ErrorCode code) {
    if (code >= ErrorCode::interrupted_partly) {
        return 130;
    }
    if (code >= ErrorCode::output_failed) {
        return 5;
    }
    if (code >= ErrorCode::window_too_long) {
        return 4;
    }
    return code == ErrorCode::setting_invalid ? 2 : 3;
}

std::string fill_template(const std::string& text, const std::vector<std::string>& args) {
    std::string filled;
    for (std::size_t i = 0; i < text.size(); ++i) {
        const std::size_t number = text[i] == '%' && i + 1 < text.size()
                                       ? static_cast<std::size_t>(text[i + 1] - '1')
                                       : args.size();
        if (number < args.size()) {
            filled += plain_text(args[number]);
            ++i;
        } else {
            filled += text[i];
        }
    }
    return filled;
}

std::string english(const Error& error) {
    std::vector<std::string> args{error.where};
    args.insert(args.end(), error.args.begin(), error.args.end());
    return fill_template(message_template(error.code), args);
}

std::string english(const Diagnostic& diagnostic) {
    return fill_template(message_template(diagnostic.kind), diagnostic.args);
}

}  // namespace vybeg
