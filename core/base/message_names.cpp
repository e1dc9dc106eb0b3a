// The names of diagnostics and errors as they stand in JSON.
#include "core/base/messages.h"

namespace vybeg {

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
        case DiagnosticKind::time_unit_unknown: return "time-unit-unknown";
        case DiagnosticKind::rates_disagree: return "rates-disagree";
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
        case DiagnosticKind::misfit_damping: return "misfit-damping";
        case DiagnosticKind::misfit_settling: return "misfit-settling";
        case DiagnosticKind::misfit_neighbour: return "misfit-neighbour";
        case DiagnosticKind::misfit_channel: return "misfit-channel";
        case DiagnosticKind::misfit_pickoff: return "misfit-pickoff";
        case DiagnosticKind::fitted_phase_step: return "fitted-phase-step";
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

}  // namespace vybeg
