#pragma once

#include "core/base/job_control.h"
#include "core/base/result.h"
#include "core/recording/samples/open_options.h"
#include "core/recording/samples/recording.h"

#include <filesystem>
#include <functional>

namespace vybeg {

// Opens one file under options without further files.
using OpenFile =
    std::function<Result<Recording>(const std::filesystem::path& path, const OpenOptions& options)>;

// A recording with a file for each channel (options.channel_d_file). Errors: those of both files
// and of pair_channels().
Result<Recording> open_pair(const std::filesystem::path& path, const OpenOptions& options,
                            const OpenFile& open);

// A recording in pieces (options.join): each where its times, or its start, put it; gaps between
// them are missing samples (time_gap). Pieces that tell neither follow each other
// (pieces_untimed). Errors: those of every file; parts_differ for unlike sample rates, units
// and numbers of channels, and for a piece that begins before the end of the one above it;
// format_limit for gaps that are absurdly long.
Result<Recording> open_pieces(const std::filesystem::path& path, const OpenOptions& options,
                              const OpenFile& open);

}  // namespace vybeg
