#pragma once

#include "core/base/error.h"
#include "core/base/job_control.h"
#include "core/base/result.h"
#include "core/recording/envelope/envelope.h"
#include "core/recording/open/open_recording.h"
#include "core/recording/samples/open_options.h"
#include "core/recording/samples/recording.h"
#include "core/recording/text/text_format.h"

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace vybeg {

// A line of a text file, or a frame of any other.
struct PreviewLine {
    std::int64_t number = 0;         // line of the file, from 1; frame, from 0
    bool is_row = true;              // otherwise a skipped line or no row of the table
    std::vector<std::string> cells;  // of a row; otherwise the whole line as one cell
};

// Beginning of a recording under given options, and the guessed format of a text.
struct RecordingPreview {
    const FileFormat* file_format = nullptr;  // by content, independent of the options
    std::optional<TextFormat> guessed;        // of text, by content only
    std::optional<TextFormat> used;           // of a file read as text
    RecordingFormat format;                   // as Recording::format
    std::vector<Channel> channels;            // as Recording::channels
    std::vector<Channel> columns;             // of the cells
    int time_column = -1;                     // among them, from 0; -1: none
    int c_column = -1;
    int d_column = -1;
    std::vector<PreviewLine> lines;
    std::vector<double> time_s;  // of the frames; empty without a time column
    std::vector<double> c;       // first frames, recording units
    std::vector<double> d;
    std::optional<double> rate_hz;  // of a time column, from the first rows
    // Error of opening with these options, from the beginning of the file.
    std::optional<Error> problem;
};

inline constexpr std::size_t preview_frames = 2048;
inline constexpr std::size_t preview_lines = 40;

// Reads only the beginning of a text or raw file; opens other files. The samples equal those of
// open_recording(), except that uneven times are not resampled. Errors: those of a file that no
// options can open; setting_invalid, interrupted.
Result<RecordingPreview> preview_recording(const std::filesystem::path& path,
                                           const OpenOptions& options, const JobControl& job);

// Approximate picture of a recording before it is open.
struct QuickOverview {
    double rate_hz = 0;  // about
    std::shared_ptr<const Envelope> envelope;
};

// First look at a long text file, because opening reads all of it. Its length is that of the time
// column, otherwise approximately that of the rows. Empty for files that open fast or cannot be
// opened; open_recording() reports the reason.
std::optional<QuickOverview> quick_overview(const std::filesystem::path& path,
                                            const OpenOptions& options, const JobControl& job);

}  // namespace vybeg
