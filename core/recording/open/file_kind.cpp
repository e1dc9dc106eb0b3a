#include "core/recording/open/file_kind.h"

#include "core/recording/arrays/npy_array.h"
#include "core/recording/arrays/tdms_reader.h"
#include "core/recording/audio/audio_extent.h"
#include "core/recording/bytes/text_encoding.h"
#include "core/recording/bytes/zip_directory.h"
#include "core/recording/text/uff_reader.h"
#include "core/recording/variables/helper_reader.h"

namespace vybeg {
namespace {

// Basis of the decision between text and binary.
constexpr std::size_t head_bytes = std::size_t{1} << 16;

}  // namespace

Result<std::string> file_head(const FileBytes& file) {
    std::string head(head_bytes, '\0');
    const auto got = TRY(file.read(0, head));
    head.resize(static_cast<std::size_t>(got));
    return head;
}

FileKind file_kind(std::string_view head, const FileBytes& file) {
    if (!audio_container(head).empty() || tag_before_flac(head, file) > 0) {
        return FileKind::audio;
    }
    if (is_npy(head)) {
        return FileKind::npy;
    }
    if (is_zip(head)) {
        return FileKind::npz;
    }
    if (is_tdms(head)) {
        return FileKind::tdms;
    }
    if (library_format(head, file)) {
        return FileKind::mat_or_hdf5;
    }
    if (is_uff(head)) {
        return FileKind::uff;
    }
    return looks_like_text(head) ? FileKind::text : FileKind::unknown;
}

}  // namespace vybeg
