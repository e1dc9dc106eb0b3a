#include "core/base/error.h"

#include <array>
#include <cstdlib>
#include <cxxabi.h>
#include <memory>
#include <new>
#include <stdexcept>
#include <system_error>
#include <typeinfo>

namespace vybeg {
namespace {

// Exit statuses (help, files.html).
constexpr int wrong_call = 2;
constexpr int bad_input = 3;
constexpr int impossible = 4;
constexpr int no_output = 5;
constexpr int stopped = 130;

// Its type and its text: either may say nothing by itself.
Error program_fault(const std::exception& error) {
    int status = 0;
    const std::unique_ptr<char, decltype(&std::free)> type(
        abi::__cxa_demangle(typeid(error).name(), nullptr, nullptr, &status), &std::free);
    return {ErrorCode::program_fault,
            {},
            {std::string(status == 0 ? type.get() : typeid(error).name()) + ": " + error.what()}};
}

}  // namespace

// What each error is called and says.
MessageRow message_row(ErrorCode code) {
    using enum ErrorCode;
    static constexpr auto rows = std::to_array<CodedRow<ErrorCode>>({
        {setting_invalid, "setting-invalid", wrong_call,
         VYBEG_MESSAGE("Message", "%2 cannot be \"%3\": %4.")},
        {set_not_chosen, "set-not-chosen", wrong_call,
         VYBEG_MESSAGE("Message", "The list has several sets. Choose one by %2: %3.")},
        {file_missing, "file-missing", bad_input,
         VYBEG_MESSAGE("Message", "%1: there is no such file. Check the name and the folder.")},
        {file_permission, "file-permission", bad_input,
         VYBEG_MESSAGE("Message",
                       "%1: no permission to read this file. Change its permissions or copy it.")},
        {file_is_directory, "file-is-directory", bad_input,
         VYBEG_MESSAGE("Message", "%1 is a folder, not a recording. Name one file inside it.")},
        {file_empty, "file-empty", bad_input,
         VYBEG_MESSAGE("Message", "%1: the file is empty (0 bytes). Record or copy it again.")},
        {file_read_failed, "file-read-failed", bad_input,
         VYBEG_MESSAGE("Message",
                       "%1: reading failed: %2. Check the disk and copy the file again.")},
        {file_not_regular, "file-not-regular", bad_input,
         VYBEG_MESSAGE("Message",
                       "%1 is a pipe or a device, and a recording is read more than once. Save it "
                       "to a file first, as in cat %1 > run.wav, and name that file.")},
        {format_unknown, "format-unknown", bad_input,
         VYBEG_MESSAGE("Message",
                       "%1: neither an audio file nor a table of numbers. Save the recording as "
                       "WAV or CSV, or give the layout of raw samples with --raw."),
         VYBEG_MESSAGE("Message",
                       "%1: neither an audio file nor a table of numbers. Save the recording as "
                       "WAV or CSV, or give the layout of raw samples under Import.")},
        {format_damaged, "format-damaged", bad_input,
         VYBEG_MESSAGE("Message", "%1: the %2 file is damaged: %3. Copy it again.")},
        {format_unsupported, "format-unsupported", bad_input,
         VYBEG_MESSAGE("Message",
                       "%1: this %2 file holds %3, which is not read here. Export the recording as "
                       "WAV or CSV.")},
        {format_limit, "format-limit", bad_input,
         VYBEG_MESSAGE("Message", "%1: this %2 file is beyond a limit of this program: %3. %4.")},
        {text_not_a_number, "text-not-a-number", bad_input,
         VYBEG_MESSAGE("Message",
                       "%1, line %2, column %3: \"%4\" is not a number. Correct it, or write nan "
                       "for a missing sample.")},
        {text_no_data, "text-no-data", bad_input,
         VYBEG_MESSAGE(
             "Message",
             "%1: no line with two or more numbers. The file needs one column for each pick-off.")},
        {rates_differ, "rates-differ", bad_input,
         VYBEG_MESSAGE("Message",
                       "%1 states a sample rate of %2 Hz, and its times give %3 Hz. Say which "
                       "holds: --time-unit for the unit of the times, or --rate with one of both."),
         VYBEG_MESSAGE("Message",
                       "%1 states a sample rate of %2 Hz, and its times give %3 Hz. Choose the "
                       "unit of the times, or give the one that holds as the sample rate.")},
        {text_time_backwards, "text-time-backwards", bad_input,
         VYBEG_MESSAGE("Message",
                       "%1, line %2: the time %3 does not follow %4. The time column must rise.")},
        {text_decimal_commas, "text-decimal-commas", bad_input,
         VYBEG_MESSAGE(
             "Message",
             "%1: commas separate both columns and decimals, as in \"%2\". Export the table with "
             "semicolons or tabs between its columns, or with decimal points.")},
        {text_no_table, "text-no-table", bad_input,
         VYBEG_MESSAGE("Message",
                       "%1: read as text with %2, no line from %3 on has two or more numbers; that "
                       "line reads \"%4\". Choose another delimiter, decimal sign or first line.")},
        {text_lines_missing, "text-lines-missing", bad_input,
         VYBEG_MESSAGE("Message", "%1: %2 lines are to be skipped, and the file has only %3.")},
        {column_out_of_range, "column-out-of-range", bad_input,
         VYBEG_MESSAGE("Message", "%1: there is no column %2 to be the time; the file has %3.")},
        {no_channels, "no-channels", bad_input,
         VYBEG_MESSAGE("Message",
                       "%1 holds no channel: it has no column or variable of several numbers that "
                       "is no time. A recording holds the two pick-offs C and D.")},
        {too_few_channels, "too-few-channels", bad_input,
         VYBEG_MESSAGE("Message",
                       "%1 has %2 channel(s), and %3 are needed: the two pick-offs C and D. Where "
                       "D has a file of its own, name it: --channel-d %4."),
         VYBEG_MESSAGE("Message",
                       "%1 has %2 channel(s), and %3 are needed: the two pick-offs C and D. Where "
                       "D has a file of its own, drop both files into the window together, or "
                       "choose it under Import (%4).")},
        {header_missing, "header-missing", bad_input,
         VYBEG_MESSAGE(
             "Message",
             "%1 holds samples alone, and neither %2.anp nor %2.xml beside it tells their sample "
             "rate. Copy that file, too, or give --raw f32 --raw-channels 1 --rate HZ."),
         VYBEG_MESSAGE(
             "Message",
             "%1 holds samples alone, and neither %2.anp nor %2.xml beside it tells their sample "
             "rate. Copy that file, too, or read it as raw samples under Import.")},
        {parts_differ, "parts-differ", bad_input,
         VYBEG_MESSAGE("Message",
                       "%1 and %2 are no parts of one recording: the %3 do not fit (%4 and %5). "
                       "Choose files that were recorded together.")},
        {channel_out_of_range, "channel-out-of-range", bad_input,
         VYBEG_MESSAGE(
             "Message",
             "%1: there is no channel %2; the file has %3. Choose other channels with --channels."),
         VYBEG_MESSAGE("Message",
                       "%1: there is no channel %2; the file has %3. Choose other channels.")},
        {channel_is_time, "channel-is-time", bad_input,
         VYBEG_MESSAGE("Message",
                       "%1: channel %2 rises by equal steps: it holds times or numbers of rows, no "
                       "signal. Choose other channels with --channels."),
         VYBEG_MESSAGE("Message",
                       "%1: channel %2 rises by equal steps: it holds times or numbers of rows, no "
                       "signal. Choose other channels.")},
        {too_few_frames, "too-few-frames", bad_input,
         VYBEG_MESSAGE("Message", "%1 holds %2 sample(s), and at least %3 are needed.")},
        {rate_unknown, "rate-unknown", bad_input,
         VYBEG_MESSAGE("Message",
                       "%1: the file does not tell its sample rate. Give it with --rate, in Hz."),
         VYBEG_MESSAGE("Message", "%1: the file does not tell its sample rate. Give it, in Hz.")},
        {passport_damaged, "passport-damaged", bad_input,
         VYBEG_MESSAGE("Message", "%1 is not a passport that can be read: %2.")},
        {passport_schema, "passport-schema", bad_input,
         VYBEG_MESSAGE("Message",
                       "%1: a passport of schema %2; this program knows schemas up to %3. Use the "
                       "program that wrote it, or a newer one.")},
        {variable_missing, "variable-missing", bad_input,
         VYBEG_MESSAGE("Message",
                       "%1: there is no variable \"%2\" to read; the file has %3. Choose others "
                       "with --variables."),
         VYBEG_MESSAGE("Message",
                       "%1: there is no variable \"%2\" to read; the file has %3. Choose others.")},
        {column_missing, "column-missing", bad_input,
         VYBEG_MESSAGE(
             "Message",
             "%1: there is no column \"%2\"; the file has %3. Name the columns with --columns."),
         VYBEG_MESSAGE("Message", "%1: there is no column \"%2\"; the file has %3. Name others.")},
        {holds_log, "holds-log", bad_input,
         VYBEG_MESSAGE("Message",
                       "%1 is a log, no recording: it holds %2. Read it with %3, options of "
                       "identify, compare, analyze and batch and columns of a measurement list; a "
                       "set has logs or recordings, not both. If the columns are samples all the "
                       "same, give them other names."),
         VYBEG_MESSAGE(
             "Message",
             "%1 is a log, no recording: it holds %2. Open it with File, Open logs, or say in the "
             "measurement list what it is (%3); a set has logs or recordings, not both. If the "
             "columns are samples all the same, give them other names.")},
        {holds_angle, "holds-angle", bad_input,
         VYBEG_MESSAGE("Message",
                       "%1 is a whole-angle log, no recording: it holds the angle of a standing "
                       "wave over time. The command drift reads it."),
         VYBEG_MESSAGE("Message",
                       "%1 is a whole-angle log, no recording: it holds the angle of a standing "
                       "wave over time. The page Drift opens it.")},
        {no_log, "no-log", bad_input,
         VYBEG_MESSAGE(
             "Message",
             "%1 is no log: logs are tables as text, NPY, NPZ, MAT or HDF5. A recording has a "
             "set of its own.")},
        {angle_unit_unknown, "angle-unit-unknown", bad_input,
         VYBEG_MESSAGE("Message",
                       "%1: column \"%2\" does not tell the unit of its angles. Give it with "
                       "--angle-unit: deg, rad or cyc."),
         VYBEG_MESSAGE("Message",
                       "%1: column \"%2\" does not tell the unit of its angles. Choose degrees, "
                       "radians or turns.")},
        {file_changed, "file-changed", bad_input,
         VYBEG_MESSAGE("Message",
                       "%1 changed while it was read: its size or the time of its last change is "
                       "another. Wait until it is complete, and open it again.")},
        {list_invalid, "list-invalid", bad_input,
         VYBEG_MESSAGE("Message", "%1, line %2, column \"%3\": %4.")},
        {window_too_long, "window-too-long", impossible,
         VYBEG_MESSAGE("Message",
                       "%1: the window of %2 samples is longer than the %3 samples to analyse. "
                       "Choose a shorter window or a longer range.")},
        {window_too_short, "window-too-short", impossible,
         VYBEG_MESSAGE("Message",
                       "%1: the window of %2 samples is too short; at this carrier it needs at "
                       "least %3 (5 samples, and three quarters of a period of the carrier and of "
                       "its distance from half the sample rate).")},
        {range_empty, "range-empty", impossible,
         VYBEG_MESSAGE("Message",
                       "%1: nothing lies between %2 s and %3 s; the recording is %4 s long.")},
        {carrier_above_half_rate, "carrier-above-half-rate", impossible,
         VYBEG_MESSAGE("Message",
                       "%1: the carrier of %2 Hz is not below half the sample rate, %3 Hz. Check "
                       "the carrier and the rate.")},
        {carrier_not_found, "carrier-not-found", impossible,
         VYBEG_MESSAGE("Message",
                       "%1: no carrier stands out of the spectrum. Give it with --f0, or the band "
                       "to look in with --band."),
         VYBEG_MESSAGE("Message",
                       "%1: no carrier stands out of the spectrum. Give its frequency, or the band "
                       "to look in.")},
        {carrier_not_near, "carrier-not-near", impossible,
         VYBEG_MESSAGE("Message",
                       "%1: no line stands out of the spectrum within %3 Hz of the carrier given, "
                       "%2 Hz. Give a nearer one, or leave it out so that it is looked for.")},
        {band_invalid, "band-invalid", impossible,
         VYBEG_MESSAGE("Message",
                       "%1: the band from %2 Hz to %3 Hz is impossible; it must rise and lie "
                       "between 0 and half the sample rate, %4 Hz.")},
        {filter_too_long, "filter-too-long", impossible,
         VYBEG_MESSAGE("Message",
                       "%1: the filter needs %2 samples at each end, and the recording has only "
                       "%3. Choose a wider band or a longer recording.")},
        {no_valid_samples, "no-valid-samples", impossible,
         VYBEG_MESSAGE("Message", "%1: every sample of the range is missing (NaN).")},
        {every_window_clipped, "every-window-clipped", impossible,
         VYBEG_MESSAGE(
             "Message",
             "%1: every window holds clipped samples (channel %2). Record with a lower gain, begin "
             "the range where the wave is weaker (--from), or shorten the window."),
         VYBEG_MESSAGE("Message",
                       "%1: every window holds clipped samples (channel %2). Record with a lower "
                       "gain, begin the range where the wave is weaker, or shorten the window.")},
        {simulation_impossible, "simulation-impossible", impossible,
         VYBEG_MESSAGE("Message", "This decay cannot be simulated: %2.")},
        {fit_window_too_short, "fit-window-too-short", impossible,
         VYBEG_MESSAGE("Message",
                       "%1: the window of %2 samples is too short for the resonator's fit; at this "
                       "carrier it needs at least %3 (16 samples and two periods).")},
        {fit_window_turns, "fit-window-turns", impossible,
         VYBEG_MESSAGE("Message",
                       "%1: the window of %2 samples is too long for the beat between the lines at "
                       "%3 Hz and %4 Hz. Use at most %5 samples, or leave the window out.")},
        {fit_beat_too_fast, "fit-beat-too-fast", impossible,
         VYBEG_MESSAGE("Message",
                       "%1: the lines at %2 Hz and %3 Hz beat too fast for windows of %4 samples, "
                       "the shortest at this carrier. Keep one pair of modes with --filter."),
         VYBEG_MESSAGE("Message",
                       "%1: the lines at %2 Hz and %3 Hz beat too fast for windows of %4 samples, "
                       "the shortest at this carrier. Keep one pair of modes with the band-pass.")},
        {fit_too_few_windows, "fit-too-few-windows", impossible,
         VYBEG_MESSAGE("Message",
                       "%1: the resonator needs %3 windows without faults, and there are %2. Use a "
                       "longer recording or shorter windows.")},
        {fit_failed, "fit-failed", impossible,
         VYBEG_MESSAGE("Message", "The resonator cannot be fitted to %1: %2.")},
        {phasors_fold, "phasors-fold", impossible,
         VYBEG_MESSAGE("Message",
                       "%1: %2 of phasors is less than four times the split of %3, so that the "
                       "motion may be folded. Log them at a higher rate.")},
        {conditions_differ, "conditions-differ", impossible,
         VYBEG_MESSAGE("Message",
                       "%1: the recordings differ in %2 (%3 and %4), and the fit has one value for "
                       "all. Put them into different sets.")},
        {turn_too_short, "turn-too-short", impossible,
         VYBEG_MESSAGE(
             "Message",
             "%1: the wave turns by %2 degrees, too little to tell the second and the fourth "
             "harmonic of the drift from the turn itself. Let it turn by 180 degrees or more.")},
        {powers_disagree, "powers-disagree", impossible,
         VYBEG_MESSAGE(
             "Message",
             "%1: R^2 + S^2 + Q^2 is %2 % of E^2, and has to be all of it. One of the columns is "
             "in another unit, or is something else: E is |c|^2 + |d|^2, R is |c|^2 - |d|^2, S and "
             "Q are twice the real and the imaginary part of c d*.")},
        {angle_unit_wrong, "angle-unit-wrong", impossible,
         VYBEG_MESSAGE("Message",
                       "%1: each time the angle reaches an end, it comes back by %2 degrees. A "
                       "wave's angle comes back by 90, 180 or 360 degrees, so its unit is another "
                       "one. Give it with --angle-unit: deg, rad or cyc."),
         VYBEG_MESSAGE("Message",
                       "%1: each time the angle reaches an end, it comes back by %2 degrees. A "
                       "wave's angle comes back by 90, 180 or 360 degrees, so its unit is another "
                       "one. Choose degrees, radians or turns.")},
        {turn_too_fast, "turn-too-fast", impossible,
         VYBEG_MESSAGE(
             "Message",
             "%1: the wave turns by 45 degrees or more from row to row, and its angle is wrapped: "
             "how far it turned is unknown. Log it faster, or write down the whole angle.")},
        {same_recording, "same-recording", impossible,
         VYBEG_MESSAGE("Message",
                       "%1 and %2 hold the same samples (SHA-256): a recording that is counted "
                       "twice is no new evidence. Name each recording once.")},
        {band_too_narrow, "band-too-narrow", impossible,
         VYBEG_MESSAGE(
             "Message",
             "%1: the band from %2 Hz to %3 Hz is too narrow for the search for the carrier; at "
             "this length it needs at least %4 Hz. Give the carrier with --f0, or a wider band."),
         VYBEG_MESSAGE("Message",
                       "%1: the band from %2 Hz to %3 Hz is too narrow for the search for the "
                       "carrier; at this length it needs at least %4 Hz. Give the frequency of the "
                       "carrier, or a wider band.")},
        {channel_without_samples, "channel-without-samples", impossible,
         VYBEG_MESSAGE("Message",
                       "%1: channel %2 has no samples in the range: every one is missing (NaN). "
                       "Choose other channels or another range.")},
        {out_of_memory, "out-of-memory", impossible,
         VYBEG_MESSAGE(
             "Message",
             "There is not enough memory. Choose a shorter range, or end other programs.")},
        {out_of_threads, "out-of-threads", impossible,
         VYBEG_MESSAGE("Message",
                       "The system starts no more threads. Raise the limit of processes, or give a "
                       "smaller number with --threads."),
         VYBEG_MESSAGE("Message",
                       "The system starts no more threads. Raise the limit of processes.")},
        {program_fault, "program-fault", impossible,
         VYBEG_MESSAGE("Message",
                       "A fault of Vybeg stopped this work (%2). Please report it, with the "
                       "recording and the settings; all else goes on.")},
        {output_failed, "output-failed", no_output,
         VYBEG_MESSAGE("Message", "%1 cannot be written: %2. Nothing was changed there.")},
        {output_format_unknown, "output-format-unknown", no_output,
         VYBEG_MESSAGE("Message",
                       "%1: the ending \"%2\" is none of those that can be written here: %3.")},
        {output_is_recording, "output-is-recording", no_output,
         VYBEG_MESSAGE("Message",
                       "%1 is one of the open files, and stays as it is. Choose another name.")},
        {output_incomplete, "output-incomplete", no_output,
         VYBEG_MESSAGE("Message",
                       "%1 cannot be written: %2. What has gone out there is incomplete.")},
        {interrupted_midway, "interrupted-midway", stopped,
         VYBEG_MESSAGE("Message", "Interrupted; %2 of %3 sets are done. Continue with --resume."),
         VYBEG_MESSAGE("Message", "Interrupted; %2 of %3 sets are done.")},
        {interrupted_partly, "interrupted-partly", stopped,
         VYBEG_MESSAGE("Message", "Interrupted; what has gone out to %1 is incomplete.")},
        {interrupted, "interrupted", stopped,
         VYBEG_MESSAGE("Message", "Interrupted; nothing was written.")},
    });
    return row_of(rows, code);
}

std::string code_name(ErrorCode code) {
    return message_row(code).name;
}

int exit_status(ErrorCode code) {
    return message_row(code).grade;
}

std::vector<MessageArg> message_args(const Error& error) {
    std::vector<MessageArg> args{error.where};
    args.insert(args.end(), error.args.begin(), error.args.end());
    return args;
}

std::string english(const Error& error) {
    return english(message_row(error.code).sentence, message_args(error));
}

Error error_of(const std::exception_ptr& exception) {
    try {
        std::rethrow_exception(exception);
    } catch (const std::bad_alloc&) {
        return {ErrorCode::out_of_memory, {}, {}};
    } catch (const std::length_error&) {
        return {ErrorCode::out_of_memory, {}, {}};  // more than the address space holds
    } catch (const std::system_error& error) {
        if (error.code() == std::errc::resource_unavailable_try_again) {
            return {ErrorCode::out_of_threads, {}, {}};
        }
        return program_fault(error);
    } catch (const std::runtime_error& error) {
        if (typeid(error) == typeid(std::runtime_error)) {
            return {ErrorCode::out_of_threads, {}, {}};  // oneTBB's, of pthread_create
        }
        return program_fault(error);
    } catch (const std::exception& error) {
        return program_fault(error);
    } catch (...) {
        return {ErrorCode::program_fault, {}, {"an exception without a text"}};
    }
}

}  // namespace vybeg
