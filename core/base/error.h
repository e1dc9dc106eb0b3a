#pragma once

#include "core/base/message_arg.h"

#include <exception>
#include <string>
#include <vector>

namespace vybeg {

// Everything that can go wrong. The English sentence of each stands in error.cpp, in this order.
enum class ErrorCode {
    // The call itself is wrong: exit status 2.
    setting_invalid,  // args: name of the setting, its value, what is allowed
    set_not_chosen,   // args: option that chooses, names of the sets of a list
    // The input cannot be read: exit status 3.
    file_missing,
    file_permission,
    file_is_directory,
    file_empty,
    file_read_failed,     // args: reason
    file_not_regular,     // a pipe, a socket or a device
    format_unknown,       // neither a known binary format nor text
    format_damaged,       // args: format, reason
    format_unsupported,   // args: format, what in it is not read
    format_limit,         // args: format, what in it is beyond which limit, what to do
    text_not_a_number,    // args: line, column, the text found there
    text_no_data,         // no line with at least two numbers
    text_time_backwards,  // args: line, the time there, the time before it
    rates_differ,         // args: rate that the file states, rate of its times (Hz)
    text_decimal_commas,  // args: a line. Commas separate columns and decimals.
    text_no_table,        // args: options, first line that is no row, what it reads
    text_lines_missing,   // args: lines to skip, lines found
    column_out_of_range,  // args: column asked for, columns found
    no_channels,
    too_few_channels,      // args: channels found, channels needed, file that may hold the other
    header_missing,        // args: name without ending of the file that describes the samples
    parts_differ,          // args: another file, what differs, of the one, of the other
    channel_out_of_range,  // args: channel asked for, channels found
    channel_is_time,       // args: channel. Times or counts, no signal.
    too_few_frames,        // args: frames found, frames needed
    rate_unknown,
    passport_damaged,    // args: reason
    passport_schema,     // args: schema of the file, newest schema known here
    variable_missing,    // args: variable asked for, the variables that the file has
    column_missing,      // args: column asked for, the columns that the file has
    angle_unit_unknown,  // args: column of angles
    holds_log,           // args: what it holds in place of samples, options to read it with
    holds_angle,         // a whole-angle log in place of samples
    no_log,
    file_changed,  // after it was opened: its size, or the time of its last change
    list_invalid,  // args: line, column, reason. Of a measurement list.
    // The analysis is impossible: exit status 4.
    window_too_long,          // args: window in samples, samples in the range
    window_too_short,         // args: window in samples, least window at this frequency
    range_empty,              // args: from, to, length of the recording (s)
    carrier_above_half_rate,  // args: carrier (Hz), half the sample rate (Hz)
    carrier_not_found,
    carrier_not_near,  // args: carrier given (Hz), how far it was looked for (Hz)
    band_invalid,      // args: low, high (Hz), half the sample rate (Hz)
    filter_too_long,   // args: transient in samples, frames in the recording
    no_valid_samples,
    every_window_clipped,     // args: channels, e.g. "C, D"
    simulation_impossible,    // args: reason
    fit_window_too_short,     // args: window in samples, least window at this carrier
    fit_window_turns,         // args: window in samples, two lines (Hz), most samples
    fit_beat_too_fast,        // args: two lines (Hz), least window at this carrier
    fit_too_few_windows,      // args: usable windows, least number, recording
    fit_failed,               // args: reason
    phasors_fold,             // args: rate of the phasors, split (Hz)
    conditions_differ,        // args: condition, its value, another. In one set of recordings.
    turn_too_short,           // args: turn of the wave in degrees. Of a whole-angle log.
    powers_disagree,          // args: R^2 + S^2 + Q^2 over E^2, %. Of a log of powers.
    angle_unit_wrong,         // args: degrees by which the angle of the log comes back
    turn_too_fast,            // args: none. Of a whole-angle log whose angle is wrapped.
    same_recording,           // args: the other recording with the same samples
    band_too_narrow,          // args: low, high, least width (Hz)
    channel_without_samples,  // args: channel, C or D
    out_of_memory,
    out_of_threads,
    program_fault,  // args: what the exception says
    // The output cannot be written: exit status 5.
    output_failed,          // args: reason
    output_format_unknown,  // args: ending
    output_is_recording,    // one of those that are open, or a log
    output_incomplete,      // args: reason. A part has gone out to a device or a pipe.
    // Ctrl-C, SIGTERM or Cancel: exit status 130.
    interrupted_midway,  // args: finished sets, all sets
    interrupted_partly,  // a part has gone out to a device or a pipe
    interrupted,
};

// A failure as a value: `where` is the file or setting it concerns; `args` fill the sentence of
// `code`.
struct Error {
    ErrorCode code{};
    std::string where;
    std::vector<MessageArg> args;

    friend bool operator==(const Error&, const Error&) = default;
};

// The name of a code as it stands in JSON, e.g. "file-missing".
std::string code_name(ErrorCode code);

// Exit status of the command line for an error (help, files.html): 2, 3, 4, 5 or 130.
int exit_status(ErrorCode code);

MessageRow message_row(ErrorCode code);

// All that a sentence is filled with, in the order of its numbers.
std::vector<MessageArg> message_args(const Error& error);

// The whole English sentence: what, where, why, what to do.
std::string english(const Error& error);

// The error behind an exception that no part of the program expects: out_of_memory, out_of_threads,
// or program_fault for a defect.
Error error_of(const std::exception_ptr& exception);

}  // namespace vybeg
