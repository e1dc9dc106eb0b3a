#pragma once

#include "core/base/error.h"
#include "core/recording/open/file_kind.h"
#include "core/recording/samples/open_options.h"
#include "core/recording/samples/recording.h"
#include "core/recording/text/text_format.h"

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

namespace vybeg {

// A line of a text file, or a frame of any other.
struct PreviewLine {
    std::int64_t number = 0;         // line of the file, from 1; frame, from 0
    bool is_row = true;              // else a line that is skipped or that is no row of the table
    std::vector<std::string> cells;  // of a row; else the whole line as one
};

// How a recording begins when it is opened with certain options, and what its file suggests.
struct RecordingPreview {
    FileKind kind = FileKind::unknown;   // by content, whatever the options say
    std::optional<TextFormat> guessed;   // of text, by content alone
    std::optional<RawLayout> raw_guess;  // of a file that is no other kind
    std::optional<TextFormat> used;      // of what is read as text
    std::string format;                  // as Recording::format
    std::vector<Channel> channels;       // as Recording::channels
    std::vector<Channel> columns;        // of the cells
    int time_column = -1;                // among them, from 0; -1: none
    int c_column = -1;
    int d_column = -1;
    std::vector<PreviewLine> lines;
    std::vector<double> time_s;  // of the frames; empty where there is no time column
    std::vector<double> c;       // first frames, recording units
    std::vector<double> d;
    std::optional<double> rate_hz;  // of a time column: as far as the first rows tell
    // Why the recording cannot be opened like this, as far as its beginning tells.
    std::optional<Error> problem;
};

inline constexpr std::size_t preview_frames = 2048;
inline constexpr std::size_t preview_lines = 40;

}  // namespace vybeg
