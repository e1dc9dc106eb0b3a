#pragma once

#include "core/base/diagnostic.h"
#include "core/recording/bytes/file_bytes.h"
#include "core/recording/samples/recording_format.h"
#include "core/recording/samples/sample_source.h"

#include <cstdint>
#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace vybeg {

enum class RateOrigin { file, time_column, option };

// "file", "time column" or "option", as in `info --json`.
std::string rate_origin_name(RateOrigin origin);

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

    std::int64_t frames() const { return source->frames(); }
    double seconds() const { return static_cast<double>(frames()) / rate_hz; }
};

}  // namespace vybeg
