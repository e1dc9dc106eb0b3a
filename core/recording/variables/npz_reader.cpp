#include "core/recording/variables/npz_reader.h"

#include "core/recording/arrays/npy_reader.h"
#include "core/recording/bytes/zip_directory.h"
#include "core/recording/variables/array_variables.h"

#include <string_view>
#include <utility>
#include <vector>

namespace vybeg {
namespace {

constexpr std::string_view ending = ".npy";

// An array, or why it cannot be read.
Result<StoredArray> array_in(const std::shared_ptr<const FileBytes>& file, const ZipMember& zip) {
    StoredArray stored;
    stored.variable.name = zip.name.substr(0, zip.name.size() - ending.size());
    stored.content = [file, zip] { return zip_content(file, zip); };
    const auto content = stored.content();
    const auto array =
        content ? read_npy_header(*file, **content, "NPZ") : Result<NpyArray>(content.error());
    if (!array && array.error().code != ErrorCode::format_unsupported) {
        return array.error();
    }
    if (!array) {
        stored.variable.unsupported = array.error().args[1];
    } else {
        stored.array = *array;
        stored.variable.frames = array->frames();
        stored.variable.channels = array->channels();
        stored.variable.type = name_of(array->type);
        const std::int64_t channels = array->channels();
        if (channels > 0 && npy_column(*array, *content, channels - 1).frames() < array->frames()) {
            return file->damaged(
                "NPZ", VYBEG_MESSAGE("Words", "%1 is shorter than its header says"), {zip.name});
        }
    }
    return stored;
}

}  // namespace

Result<Recording> open_npz(std::shared_ptr<const FileBytes> file, const OpenOptions& options,
                           const JobControl& job) {
    const auto members = TRY(zip_members(*file));
    std::vector<StoredArray> arrays;
    for (const ZipMember& member : members) {
        TRY(job.go_on());
        if (member.name.ends_with(ending)) {
            auto array = TRY(array_in(file, member));
            arrays.push_back(std::move(array));
        }
    }
    if (arrays.empty()) {
        return file->unsupported("ZIP",
                                 VYBEG_MESSAGE("Words", "members other than NumPy arrays (.npy)"));
    }
    return open_arrays(std::move(file), "NPZ", std::move(arrays), options, job);
}

}  // namespace vybeg
