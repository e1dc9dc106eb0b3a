#pragma once

#include "core/base/diagnostic.h"
#include "core/base/job_control.h"
#include "core/base/result.h"
#include "core/recording/bytes/file_bytes.h"
#include "core/recording/samples/sample_source.h"

#include <cstdint>
#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace vybeg {

// One part of what a recording's file is made of.
struct FormatPart {
    // A name ("WAV") reads the same in every language; words ("64 bit float") are translated by the
    // desktop program (context "Format"); channels and columns are counts.
    enum class Kind : std::uint8_t { name, words, channels, columns };

    Kind kind = Kind::name;
    std::string text;        // of a name or words
    std::int64_t count = 0;  // of channels or columns

    static FormatPart name(std::string text) { return {Kind::name, std::move(text), 0}; }
    // E.g. words(VYBEG_MESSAGE("Format", "decimal comma")).
    static FormatPart words(std::string text) { return {Kind::words, std::move(text), 0}; }
    static FormatPart channels(std::int64_t count) { return {Kind::channels, {}, count}; }
    static FormatPart columns(std::int64_t count) { return {Kind::columns, {}, count}; }

    friend bool operator==(const FormatPart&, const FormatPart&) = default;
};

using RecordingFormat = std::vector<FormatPart>;

FormatPart byte_order_part(bool big_endian);

// E.g. "WAV, 64 bit float, 2 channels", "text, 3 columns, comma".
std::string english(const RecordingFormat& format);

enum class RateOrigin { file, time_column, option };

// "file", "time column" or "option", as in `info --json`.
std::string rate_origin_name(RateOrigin origin);

struct SampleRate {
    double hz = 0;  // 0: unknown
    RateOrigin from = RateOrigin::file;
    // What the digits of the file leave open: rounding is uniform, a digit / sqrt(12).
    double relative_sd = 0;

    friend bool operator==(const SampleRate&, const SampleRate&) = default;
};

struct Channel {
    std::string name;  // from the file, otherwise "1", "2", ...
    std::string unit;  // empty if the file has none

    friend bool operator==(const Channel&, const Channel&) = default;
};

// An open recording: properties from its file, and samples on demand. Copies share the samples.
struct Recording {
    std::filesystem::path path;
    RecordingFormat format;
    double rate_hz = 0;
    // Relative standard deviation of rate_hz due to the number of digits in the file; 0 for an
    // exact rate.
    double rate_relative_sd = 0;
    RateOrigin rate_from = RateOrigin::file;
    std::vector<Channel> channels;  // all of the file's, in its order; a time column does not count
    int channel_c = 1;              // numbers of C and D among them, from 1
    int channel_d = 2;
    std::string start;      // date and time of the recording from the file, or empty
    std::string read_with;  // options_text() of the options of opening
    std::vector<Diagnostic> diagnostics;
    std::shared_ptr<const SampleSource> source;
    std::shared_ptr<const FileBytes> file{};  // file of the samples; null: not from a file
    // The others that it is made of: of channel D, of further pieces, of what describes them.
    std::vector<std::shared_ptr<const FileBytes>> more_files{};
    std::optional<double> first_time_s{};  // of the first sample, by the file's own times

    const Channel& channel(int number) const {
        return channels[static_cast<std::size_t>(number - 1)];
    }
    std::int64_t frames() const { return source->frames(); }
    double seconds() const { return static_cast<double>(frames()) / rate_hz; }
};

// SHA-256 of the open file of a recording, independent of its path; of several files, of their
// bytes one after the other, as `cat C D | sha256sum`. Errors: those of files_sha256();
// file_changed.
Result<std::string> recording_sha256(const Recording& recording, const JobControl& job);

// Checks that sizes and modification times are those at the time of opening. Call it after reading
// the samples. Errors: file_changed, file_read_failed.
Status unchanged(const Recording& recording);

}  // namespace vybeg
