// A row for each error: code, exit status, sentence (MessageRow), with %1 for `where` and %2, %3
// for the arguments. Included where ROW is defined (error.h, error.cpp).

// The call itself is wrong: exit status 2.
ROW(setting_invalid, wrong_call, Sentence::tr("%2 cannot be \"%3\": %4."))
// %2: the option that chooses.
ROW(set_not_chosen, wrong_call, Sentence::tr("The list has several sets. Choose one by %2: %3."))

// The input cannot be read: exit status 3.
ROW(file_missing, bad_input,
    Sentence::tr("%1: there is no such file. Check the name and the folder."))
ROW(folder_empty, bad_input,
    Sentence::tr("%1: the folder holds no recording. Choose one that does, or a measurement list."))
ROW(file_permission, bad_input,
    Sentence::tr("%1: no permission to read it. Change its permissions or copy it."))
ROW(file_is_directory, bad_input,
    Sentence::tr("%1 is a folder, not a file. Name one file inside it."))
ROW(file_empty, bad_input, Sentence::tr("%1: the file is empty (0 bytes). Save or copy it again."))
ROW(file_read_failed, bad_input,
    Sentence::tr("%1: reading failed: %2. Check the disk and copy the file again."))
// %2: program; %3: why.
ROW(reader_not_started, bad_input,
    Sentence::tr("%1: the program %2, which reads such files, cannot be started: %3. Install Vybeg "
                 "again, with all of its programs."))
ROW(file_not_regular, bad_input,
    Sentence::tr("%1 is a pipe or a device, which cannot be read more than once. Save it to a file "
                 "first, as in cat %1 > FILE, and name that file."))
ROW(format_unknown, bad_input,
    Sentence::tr("%1: neither an audio file nor a table of numbers. Save the recording as WAV or "
                 "CSV, or give the layout of raw samples {with --raw|under Import}."))
ROW(format_damaged, bad_input, Sentence::tr("%1: the %2 file is damaged: %3. Copy it again."))
ROW(format_unsupported, bad_input,
    Sentence::tr(
        "%1: this %2 file holds %3, which is not read here. Export the recording as WAV or CSV."))
// %3: the quantity and its limit; %4: advice.
ROW(format_limit, bad_input,
    Sentence::tr("%1: this %2 file is beyond a limit of this program: %3. %4."))
ROW(text_not_a_number, bad_input,
    Sentence::tr("%1, line %2, column %3: \"%4\" is not a number. Correct it; a missing sample, "
                 "but no time, may be written as nan."))
ROW(text_no_data, bad_input,
    Sentence::tr(
        "%1: no line with two or more numbers. The file needs one column for each pick-off."))
ROW(text_time_backwards, bad_input,
    Sentence::tr("%1, line %2: the time %3 does not follow %4. The time column must rise."))
ROW(rates_differ, bad_input,
    Sentence::tr("%1 states a sample rate of %2 Hz, and its times give %3 Hz. {Say which holds: "
                 "--time-unit for the unit of the times, or --rate with one of both|Choose the "
                 "unit of the times, or give the one that holds as the sample rate}."))
ROW(text_decimal_commas, bad_input,
    Sentence::tr("%1: commas separate both columns and decimals, as in \"%2\". Export the table "
                 "with semicolons or tabs between its columns, or with decimal points."))
ROW(text_thousands, bad_input,
    Sentence::tr("%1: separators of thousands seem to stand within the numbers, as in \"%2\". "
                 "Export the table without them."))
// %2: a line of the file.
ROW(text_segments, bad_input,
    Sentence::tr("%1: the file has several segments: its header begins again in line %2. Save each "
                 "segment as a file of its own."))
// %2: options; %3 and %4: the first line that is no row.
ROW(text_no_table, bad_input,
    Sentence::tr("%1: read as text with %2, no line from %3 on has two or more numbers; that line "
                 "reads \"%4\". Choose another delimiter, decimal sign or first line."))
ROW(text_lines_missing, bad_input,
    Sentence::tr("%1: %2 lines are to be skipped, and the file has only %3."))
ROW(column_out_of_range, bad_input,
    Sentence::tr("%1: there is no column %2 to be the time; the file has %3."))
ROW(no_channels, bad_input,
    Sentence::tr("%1 holds no channel: it has no column or variable of several numbers that is no "
                 "time. A recording holds the two pick-offs C and D."))
// %4: a file that may hold the other channel.
ROW(too_few_channels, bad_input,
    Sentence::tr("%1 has %2 channel(s), and %3 are needed: the two pick-offs C and D. Where D has "
                 "a file of its own, {name it: --channel-d %4|drop both files into the window "
                 "together, or choose %4 as D under Import}."))
// %2: name without ending of the file that describes the samples.
ROW(header_missing, bad_input,
    Sentence::tr("%1 holds samples alone, and neither %2.anp nor %2.xml beside it tells their "
                 "sample rate. Copy that file, too, or {give --raw f32 --raw-channels 1 --rate "
                 "HZ|read it as raw samples under Import}."))
ROW(parts_differ, bad_input,
    Sentence::tr("%1 and %2 are no parts of one recording: the %3 do not fit (%4 and %5). Choose "
                 "files that were recorded together."))
ROW(channel_out_of_range, bad_input,
    Sentence::tr(
        "%1: there is no channel %2; the file has %3. Choose other channels{ with --channels}."))
ROW(channel_is_time, bad_input,
    Sentence::tr("%1: channel %2 rises by equal steps: it holds times or numbers of rows, no "
                 "signal. Choose other channels{ with --channels}."))
ROW(too_few_frames, bad_input, Sentence::tr("%1 holds %2 sample(s), and at least %3 are needed."))
ROW(rate_unknown, bad_input,
    Sentence::tr("%1: the file does not tell its sample rate. Give it{ with --rate}, in Hz."))
ROW(passport_damaged, bad_input, Sentence::tr("%1 is not a passport that can be read: %2."))
ROW(passport_schema, bad_input,
    Sentence::tr("%1: a passport of schema %2; this program knows schemas up to %3. Use the "
                 "program that wrote it, or a newer one."))
ROW(variable_missing, bad_input,
    Sentence::tr("%1: there is no variable \"%2\" to read; the file has %3. Choose others{ with "
                 "--variables}."))
ROW(variables_ambiguous, bad_input,
    Sentence::tr(
        "%1: several variables may be the recording: %2. Choose among them{ with --variables}."))
ROW(column_missing, bad_input,
    Sentence::tr("%1: there is no column \"%2\"; the file has %3. Name {the columns with "
                 "--columns|others}."))
ROW(angle_unit_unknown, bad_input,
    Sentence::tr("%1: column \"%2\" does not tell the unit of its angles. {Give it with "
                 "--angle-unit: deg, rad or cyc|Choose degrees, radians or turns}."))
// %2: its content in place of samples; %3: options to read it with.
ROW(holds_log, bad_input,
    Sentence::tr(
        "%1 is a log, no recording: it holds %2. {Read it with %3, options of identify, compare, "
        "analyze and batch and columns of a measurement list|Open it with File, Open logs, or say "
        "in the measurement list what it is (%3)}; a set has logs or recordings, not both. If the "
        "columns are samples all the same, give them other names."))
ROW(holds_angle, bad_input,
    Sentence::tr("%1 is a whole-angle log, no recording: it holds the angle of a standing wave "
                 "over time. The {command drift reads|page Drift opens} it."))
ROW(no_log, bad_input,
    Sentence::tr(
        "%1 is no log: logs are tables as text, NPY, NPZ, MAT or HDF5. {analyze and identify read "
        "recordings|Recordings have a set of their own}, without logs beside them."))
ROW(file_changed, bad_input,
    Sentence::tr("%1 changed while it was read: its size or the time of its last change is "
                 "another. Wait until it is complete, and open it again."))
// Of a measurement list or a table of limits.
ROW(list_invalid, bad_input, Sentence::tr("%1, line %2, column \"%3\": %4."))

// The analysis is impossible: exit status 4.
ROW(window_too_long, impossible,
    Sentence::tr("%1: the window of %2 samples is longer than the %3 samples to analyse. Choose a "
                 "shorter window or a longer range."))
ROW(window_too_short, impossible,
    Sentence::tr("%1: the window of %2 samples is too short; at this carrier it needs at least %3 "
                 "(5 samples, and three quarters of a period of the carrier and of its distance "
                 "from half the sample rate)."))
ROW(range_empty, impossible,
    Sentence::tr("%1: nothing lies between %2 s and %3 s; the recording is %4 s long."))
ROW(carrier_above_half_rate, impossible,
    Sentence::tr("%1: the carrier of %2 Hz is not below half the sample rate, %3 Hz. Check the "
                 "carrier and the rate."))
ROW(channels_constant, impossible,
    Sentence::tr("%1: both channels are constant: they hold no signal. Choose other channels{ "
                 "(--channels)} or another range{ (--from, --to)}."))
ROW(carrier_not_found, impossible,
    Sentence::tr("%1: no carrier stands out of the spectrum. Give {it with --f0, or the band to "
                 "look in with --band|its frequency, or the band to look in}."))
ROW(carrier_not_near, impossible,
    Sentence::tr("%1: no line stands out of the spectrum within %3 Hz of the carrier given, %2 Hz. "
                 "Give a nearer one, or leave it out so that it is looked for."))
ROW(band_invalid, impossible,
    Sentence::tr("%1: the band from %2 Hz to %3 Hz is impossible; it must rise and lie between 0 "
                 "and half the sample rate, %4 Hz."))
ROW(filter_too_long, impossible,
    Sentence::tr("%1: the filter needs %2 samples at each end, and the recording has only %3. "
                 "Choose a wider band or a longer recording."))
ROW(no_valid_samples, impossible, Sentence::tr("%1: every sample of the range is missing (NaN)."))
ROW(every_window_clipped, impossible,
    Sentence::tr("%1: every window holds clipped samples (channel %2). Record with a lower gain, "
                 "begin the range where the wave is weaker{ (--from)}, or shorten the window."))
ROW(simulation_impossible, impossible, Sentence::tr("This decay cannot be simulated: %2."))
ROW(fit_window_too_short, impossible,
    Sentence::tr("%1: the window of %2 samples is too short for the resonator's fit; at this "
                 "carrier it needs at least %3 (16 samples and two periods)."))
ROW(fit_window_turns, impossible,
    Sentence::tr("%1: the window of %2 samples is too long for the beat between the lines at %3 Hz "
                 "and %4 Hz. Use at most %5 samples, or leave the window out."))
ROW(fit_beat_too_fast, impossible,
    Sentence::tr("%1: the lines at %2 Hz and %3 Hz beat too fast for windows of %4 samples, the "
                 "shortest at this carrier. Keep one pair of modes with {--filter|the band-pass}."))
ROW(fit_too_few_windows, impossible,
    Sentence::tr("%1: the resonator needs %3 windows without faults, and there are %2. Use a "
                 "longer recording or shorter windows."))
ROW(fit_failed, impossible, Sentence::tr("The resonator cannot be fitted to %1: %2."))
ROW(phasors_fold, impossible,
    Sentence::tr("%1: %2 of phasors is less than four times the split of %3, so that the motion "
                 "may be folded. Log them at a higher rate."))
ROW(conditions_differ, impossible,
    Sentence::tr("%1: the recordings differ in %2 (%3 and %4), and the fit has one value for all. "
                 "Put them into different sets."))
ROW(turn_too_short, impossible,
    Sentence::tr("%1: the wave turns by %2 degrees, too little to tell the second and the fourth "
                 "harmonic of the drift from the turn itself. Let it turn by 180 degrees or more."))
ROW(powers_disagree, impossible,
    Sentence::tr("%1: R^2 + S^2 + Q^2 is %2 % of E^2, and has to be all of it. One of the columns "
                 "is in another unit, or is something else: E is |c|^2 + |d|^2, R is |c|^2 - "
                 "|d|^2, S and Q are twice the real and the imaginary part of c d*."))
ROW(angle_unit_wrong, impossible,
    Sentence::tr("%1: each time the angle reaches an end, it comes back by %2 degrees. A wave's "
                 "angle comes back by 90, 180 or 360 degrees, so its unit is another one. {Give it "
                 "with --angle-unit: deg, rad or cyc|Choose degrees, radians or turns}."))
ROW(turn_too_fast, impossible,
    Sentence::tr(
        "%1: the wave turns by 45 degrees or more from row to row, and its angle is wrapped: how "
        "far it turned is unknown. Log it faster, or write down the whole angle."))
ROW(same_recording, impossible,
    Sentence::tr("%1 and %2 hold the same samples (SHA-256): a recording that is counted twice is "
                 "no new evidence. Name each recording once."))
ROW(band_too_narrow, impossible,
    Sentence::tr("%1: the band from %2 Hz to %3 Hz is too narrow for the search for the carrier; "
                 "at this length it needs at least %4 Hz. Give the {carrier with --f0|frequency of "
                 "the carrier}, or a wider band."))
ROW(channel_without_samples, impossible,
    Sentence::tr("%1: channel %2 has no samples in the range: every one is missing (NaN). Choose "
                 "other channels or another range."))
ROW(out_of_memory, impossible,
    Sentence::tr("There is not enough memory. Choose a shorter range, or end other programs."))
ROW(out_of_threads, impossible,
    Sentence::tr("The system starts no more threads. Raise the limit of processes{, or give a "
                 "smaller number with --threads}."))
// %2: what the exception says.
ROW(program_fault, impossible,
    Sentence::tr("A fault of Vybeg stopped this work (%2). Please report it, with the recording "
                 "and the settings; all else goes on."))

// The output cannot be written: exit status 5.
ROW(output_failed, no_output, Sentence::tr("%1 cannot be written: %2. Nothing was changed there."))
ROW(output_format_unknown, no_output,
    Sentence::tr("%1: the ending \"%2\" is none of those that can be written here: %3."))
ROW(output_is_recording, no_output,
    Sentence::tr("%1 is one of the open files, and stays as it is. Choose another name."))
// A part has gone out to a device or a pipe.
ROW(output_incomplete, no_output,
    Sentence::tr("%1 cannot be written: %2. What has gone out there is incomplete."))

// Ctrl-C, SIGTERM or Cancel: exit status 130.
ROW(interrupted_midway, stopped,
    Sentence::tr("Interrupted; %2 of %3 sets are done.{ Continue with --resume.}"))
ROW(interrupted_partly, stopped,
    Sentence::tr("Interrupted; what has gone out to %1 is incomplete."))
ROW(interrupted, stopped, Sentence::tr("Interrupted; nothing was written."))
