#include "core/recording/arrays/npy_reader.h"

#include "core/recording/arrays/npy_array.h"
#include "core/recording/samples/reader_rules.h"

namespace vybeg {

Result<Recording> open_npy(std::shared_ptr<const FileBytes> file, const OpenOptions& options) {
    const auto bytes = file_part(file, 0, file->size());
    const auto array = read_npy_header(*file, *bytes, "NPY");
    if (!array) {
        return array.error();
    }
    const auto channels = static_cast<int>(array->channels());
    if (const Status status = check_channels(*file, channels, options); !status) {
        return status.error();
    }
    const auto rate = choose_rate(*file, {}, options);
    if (!rate) {
        return rate.error();
    }
    Recording recording;
    recording.path = file->path();
    recording.format = "NPY, " + array->text() + ", " + std::to_string(channels) + " channels";
    recording.rate_hz = rate->hz;
    recording.rate_from = rate->from;
    recording.channels = numbered_channels(channels);
    recording.channel_c = options.channel_c;
    recording.channel_d = options.channel_d;
    recording.source = column_source(npy_column(*array, bytes, options.channel_c - 1),
                                     npy_column(*array, bytes, options.channel_d - 1));
    if (const Status status = check_frames(*file, recording.frames()); !status) {
        return status.error();
    }
    note_early_end(array->frames(), recording);
    return recording;
}

}  // namespace vybeg
