#include "core/recording/open_recording.h"

#include "core/recording/audio_extent.h"
#include "core/recording/audio_reader.h"
#include "core/recording/file_bytes.h"
#include "core/recording/library_reader.h"
#include "core/recording/npy_array.h"
#include "core/recording/npy_reader.h"
#include "core/recording/npz_reader.h"
#include "core/recording/raw_reader.h"
#include "core/recording/selection.h"
#include "core/recording/tdms_reader.h"
#include "core/recording/text_encoding.h"
#include "core/recording/text_recording.h"
#include "core/recording/uff_reader.h"
#include "core/recording/zip_directory.h"

#include <vector>

namespace vybeg {
namespace {

constexpr std::size_t head_bytes = std::size_t{1} << 16;  // what decides between text and binary

}  // namespace

Result<Recording> open_recording(const std::filesystem::path& path, const OpenOptions& options,
                                 const JobControl& job) {
    if (const Status status = check_options(options); !status) {
        return status.error();
    }
    const auto file = FileBytes::open(path);
    if (!file) {
        return file.error();
    }
    if (options.raw) {
        return open_raw(*file, options);
    }
    std::vector<char> bytes(head_bytes);
    const auto got = (*file)->read(0, bytes);
    if (!got) {
        return got.error();
    }
    const std::string_view head(bytes.data(), static_cast<std::size_t>(*got));
    if (is_audio(head)) {
        return open_audio(*file, options, job);
    }
    if (is_npy(head)) {
        return open_npy(*file, options);
    }
    if (is_zip(head)) {
        return open_npz(*file, options, job);
    }
    if (is_tdms(head)) {
        return open_tdms(*file, options, job);
    }
    if (const auto format = library_format(head, **file)) {
        return open_with_library(*file, *format, options, job);
    }
    if (is_uff(head)) {
        return open_uff(*file, options, job);
    }
    if (looks_like_text(head)) {
        return open_text(*file, options, job);
    }
    return (*file)->error(ErrorCode::format_unknown);
}

}  // namespace vybeg
