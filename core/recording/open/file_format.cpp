#include "core/recording/open/file_format.h"

#include "core/recording/arrays/npy_reader.h"
#include "core/recording/arrays/raw_reader.h"
#include "core/recording/arrays/tdms_reader.h"
#include "core/recording/audio/audio_extent.h"
#include "core/recording/audio/audio_reader.h"
#include "core/recording/bytes/packed_parts.h"
#include "core/recording/bytes/text_encoding.h"
#include "core/recording/text/text_recording.h"
#include "core/recording/text/uff_reader.h"
#include "core/recording/variables/array_variables.h"
#include "core/recording/variables/library_variables.h"
#include "core/recording/variables/mat_format.h"
#include "core/recording/variables/mat_reader.h"

#include <algorithm>
#include <array>

namespace vybeg {
namespace {

// Basis of the decision between text and binary.
constexpr std::int64_t head_bytes = std::int64_t{1} << 16;

using Group = FileFormat::Group;

// Of a signature that does not depend on the rest of the file.
template <bool (*is)(std::string_view head)>
bool by_head(std::string_view head, const FileBytes& /*file*/) {
    return is(head);
}

bool is_audio(std::string_view head, const FileBytes& file) {
    return !audio_container(head).empty() || tag_before_flac(head, file) > 0;
}

// Level 4 has no signature.
bool is_mat4_file(std::string_view head, const FileBytes& file) {
    return is_mat4(head, file.size());
}

constexpr std::array formats{
    FileFormat{.name = "audio",
               .group = Group::audio,
               .endings = "wav w64 rf64 flac aif aiff caf",
               .is = is_audio,
               .open = open_audio,
               .in_helper = true},
    FileFormat{.name = "npy",
               .group = Group::arrays,
               .endings = "npy",
               .is = by_head<is_npy>,
               .open = open_npy},
    FileFormat{.name = "npz",
               .group = Group::arrays,
               .endings = "npz",
               .is = by_head<is_zip>,
               .open = open_npz,
               .has_variables = true},
    FileFormat{.name = "mat",
               .group = Group::arrays,
               .endings = "mat",
               .is = by_head<is_mat5>,
               .open = open_mat,
               .has_variables = true},
    FileFormat{.name = "tdms",
               .group = Group::arrays,
               .endings = "tdms",
               .is = by_head<is_tdms>,
               .open = open_tdms},
    FileFormat{.name = "zetlab",
               .group = Group::arrays,
               .endings = "ana",
               .is = is_zetlab,
               .open = open_zetlab},
    FileFormat{.name = "hdf5",
               .group = Group::arrays,
               .endings = "h5 hdf5",
               .is = is_hdf5,
               .open = open_hdf5,
               .has_variables = true,
               .in_helper = true},
    FileFormat{.name = "mat",
               .group = Group::arrays,
               .endings = "",
               .is = is_mat4_file,
               .open = open_mat,
               .has_variables = true},
    FileFormat{.name = "uff",
               .group = Group::arrays,
               .endings = "uff unv",
               .is = by_head<is_uff>,
               .open = open_uff},
    FileFormat{.name = "text",
               .group = Group::tables,
               .endings = "csv tsv txt dat",
               .is = by_head<looks_like_text>,
               .open = open_text,
               .is_text = true},
};

}  // namespace

std::span<const FileFormat> file_formats() {
    return formats;
}

Result<std::string> file_head(const FileBytes& file) {
    return file.text(0, head_bytes);
}

const FileFormat* find_format(std::string_view head, const FileBytes& file) {
    const auto* const found = std::ranges::find_if(
        formats, [&](const FileFormat& format) { return format.is(head, file); });
    return found == formats.end() ? nullptr : found;
}

}  // namespace vybeg
