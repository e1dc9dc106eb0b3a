#include "core/recording/open/open_recording.h"

#include "core/base/plain_text.h"
#include "core/recording/arrays/raw_reader.h"
#include "core/recording/bytes/file_bytes.h"
#include "core/recording/open/file_format.h"
#include "core/recording/open/open_parts.h"
#include "core/recording/samples/open_options.h"
#include "core/recording/samples/open_table.h"
#include "core/recording/samples/scaled_source.h"
#include "core/recording/text/text_recording.h"

#include <memory>
#include <utility>

namespace vybeg {
namespace {

Result<Recording> open_by_content(const std::shared_ptr<const FileBytes>& file,
                                  const OpenOptions& options, const JobControl& job) {
    if (options.raw) {
        return open_raw(file, options);
    }
    if (options.text) {
        return open_text(file, options, job);
    }
    const auto head = TRY(file_head(*file));
    const FileFormat* const format = find_format(head, *file);
    return format ? format->open(file, options, job)
                  : Result<Recording>(file->error(ErrorCode::format_unknown));
}

// One file, with everything that the options say of its samples.
Result<Recording> open_file(const std::filesystem::path& path, const OpenOptions& options,
                            const JobControl& job) {
    const auto file = TRY(FileBytes::open(path));
    auto recording = open_by_content(file, options, job);
    if (recording) {
        for (FormatPart& part : recording->format) {
            part.text = plain_text(part.text);
        }
        recording->start = plain_text(recording->start);
        for (Channel& channel : recording->channels) {
            channel = {plain_text(channel.name), plain_text(channel.unit)};
        }
        if (options.scale != 1) {
            recording->source =
                scaled_source(std::move(recording->source), options.scale, options.scale);
            for (Channel& channel : recording->channels) {
                channel.unit.clear();
            }
        }
        recording->file = file;
        if (!options.unit.empty()) {
            for (Channel& channel : recording->channels) {
                channel.unit = options.unit;
            }
        }
    }
    return recording;
}

}  // namespace

Result<Recording> open_recording(const std::filesystem::path& path, const OpenOptions& options,
                                 const JobControl& job) {
    TRY(check_options(options));
    const OpenFile open = [&job](const std::filesystem::path& part, const OpenOptions& of_part) {
        return open_file(part, of_part, job);
    };
    auto recording = !options.channel_d_file.empty() ? open_pair(path, options, open)
                     : !options.join.empty()         ? open_pieces(path, options, open)
                                                     : open(path, options);
    if (recording) {
        recording->read_with = options_text(options);
    }
    return recording;
}

}  // namespace vybeg
