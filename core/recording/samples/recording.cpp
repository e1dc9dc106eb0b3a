#include "core/recording/samples/recording.h"

#include "core/base/error.h"
#include "core/base/plain_text.h"
#include "core/recording/bytes/sha256.h"

#include <array>

namespace vybeg {
namespace {

std::string english(const FormatPart& part) {
    switch (part.kind) {
        case FormatPart::Kind::name:
        case FormatPart::Kind::words: return part.text;
        case FormatPart::Kind::channels: return std::to_string(part.count) + " channels";
        case FormatPart::Kind::columns: return std::to_string(part.count) + " columns";
    }
    return {};
}

}  // namespace

FormatPart byte_order_part(bool big_endian) {
    return FormatPart::words(big_endian ? VYBEG_MESSAGE("Format", "big endian")
                                        : VYBEG_MESSAGE("Format", "little endian"));
}

std::string english(const RecordingFormat& format) {
    return joined(format, ", ", [](const FormatPart& part) { return english(part); });
}

std::string rate_origin_name(RateOrigin origin) {
    constexpr std::array names{"file", "time column", "option"};  // in the order of RateOrigin
    return names.at(static_cast<std::size_t>(origin));
}

Result<std::string> recording_sha256(const Recording& recording, const JobControl& job) {
    if (!recording.file) {
        return file_sha256(recording.path, job);
    }
    std::vector<const FileBytes*> files{recording.file.get()};
    for (const auto& more : recording.more_files) {
        files.push_back(more.get());
    }
    Result<std::string> hash = files_sha256(files, job);
    const Status still = unchanged(recording);
    return still ? hash : still.error();
}

Status unchanged(const Recording& recording) {
    if (recording.file) {
        TRY(recording.file->unchanged());
    }
    for (const auto& more : recording.more_files) {
        TRY(more->unchanged());
    }
    return {};
}

}  // namespace vybeg
