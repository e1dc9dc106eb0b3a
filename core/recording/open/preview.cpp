#include "core/recording/open/preview.h"

#include "core/base/number_text.h"
#include "core/recording/arrays/raw_guess.h"
#include "core/recording/arrays/raw_reader.h"
#include "core/recording/bytes/file_bytes.h"
#include "core/recording/bytes/number_decoding.h"
#include "core/recording/open/open_recording.h"
#include "core/recording/open/text_preview.h"
#include "core/recording/samples/open_options.h"
#include "core/recording/samples/open_table.h"

#include <algorithm>
#include <utility>

namespace vybeg {
namespace {

constexpr int most_columns = 64;  // of a raw file, in the table
constexpr int cell_digits = 9;

// Reads the first frames of an open recording.
Status take_samples(const Recording& recording, RecordingPreview& preview) {
    const auto frames = std::min(static_cast<std::size_t>(recording.frames()), preview_frames);
    preview.c.resize(frames);
    preview.d.resize(frames);
    return recording.source->read(0, preview.c, preview.d);
}

// Fills the table with every channel, from the bytes.
Status take_raw_cells(const FileBytes& file, const OpenOptions& options,
                      RecordingPreview& preview) {
    const RawLayout& layout = *options.raw;
    const NumberType type = number_type(layout.type);
    const auto width = static_cast<std::size_t>(bytes_of(type));
    const auto channels = static_cast<std::size_t>(layout.channels);
    std::string bytes(preview_lines * channels * width, '\0');
    const auto got = TRY(file.read(layout.skip_bytes, bytes));
    const std::size_t frames = static_cast<std::size_t>(got) / (channels * width);
    std::vector<double> values(frames * channels);
    if (!values.empty()) {
        decode(type, layout.big_endian, bytes.data(), static_cast<std::int64_t>(width),
               {options.scale, 0}, values);
    }
    preview.columns.resize(std::min<std::size_t>(channels, most_columns));
    for (std::size_t frame = 0; frame < frames; ++frame) {
        PreviewLine line{static_cast<std::int64_t>(frame), true, {}};
        for (std::size_t k = 0; k < preview.columns.size(); ++k) {
            line.cells.push_back(short_text(values[frame * channels + k], cell_digits));
        }
        preview.lines.push_back(std::move(line));
    }
    return {};
}

// Fills the table with C and D only.
void take_cells(RecordingPreview& preview) {
    preview.c_column = 0;
    preview.d_column = 1;
    for (std::size_t i = 0; i < std::min(preview.c.size(), preview_lines); ++i) {
        preview.lines.push_back(
            {static_cast<std::int64_t>(i),
             true,
             {short_text(preview.c[i], cell_digits), short_text(preview.d[i], cell_digits)}});
    }
}

// Preview of other files, through their reader. A file without rate is opened with an arbitrary
// one, so that its samples are visible.
Status preview_opened(const FileBytes& file, const OpenOptions& options, const JobControl& job,
                      RecordingPreview& preview) {
    OpenOptions rated = options;
    rated.rate_hz = options.rate_hz.value_or(1);
    const auto recording = open_recording(file.path(), rated, job);
    if (!recording) {
        if (recording.error().code == ErrorCode::interrupted) {
            return recording.error();
        }
        preview.problem = recording.error();
        return {};
    }
    preview.format = recording->format;
    preview.channels = recording->channels;
    if (recording->rate_from != RateOrigin::option || options.rate_hz) {
        preview.rate_hz = recording->rate_hz;
    } else {
        preview.problem = file.error(ErrorCode::rate_unknown);
    }
    TRY(take_samples(*recording, preview));
    const auto channel = [&](int number) {
        return recording->channels[static_cast<std::size_t>(number - 1)];
    };
    if (!options.raw) {
        preview.columns = {channel(recording->channel_c), channel(recording->channel_d)};
        take_cells(preview);
        return {};
    }
    Status status = take_raw_cells(file, options, preview);
    for (std::size_t k = 0; k < preview.columns.size(); ++k) {
        preview.columns[k] = recording->channels[k];
    }
    preview.c_column = recording->channel_c - 1;
    preview.d_column = recording->channel_d - 1;
    return status;
}

}  // namespace

Result<RecordingPreview> preview_recording(const std::filesystem::path& path,
                                           const OpenOptions& options, const JobControl& job) {
    TRY(check_options(options));
    const auto file = TRY(FileBytes::open(path));
    const auto head = TRY(file_head(*file));
    RecordingPreview preview;
    preview.file_format = find_format(head, *file);
    if (!preview.file_format || options.raw) {
        const auto guess = TRY(guess_raw_layout(*file));
        preview.raw_guess = guess;
    }
    const bool text =
        options.text || (!options.raw && preview.file_format && preview.file_format->is_text);
    const Status status = text ? preview_text(file, options, job, preview)
                               : preview_opened(*file, options, job, preview);
    if (!status) {
        return status.error();
    }
    if (!options.unit.empty()) {
        for (auto* const named : {&preview.channels, &preview.columns}) {
            for (Channel& channel : *named) {
                channel.unit = options.unit;
            }
        }
    }
    return preview;
}

}  // namespace vybeg
