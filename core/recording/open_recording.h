#pragma once

#include "core/base/job_control.h"
#include "core/base/result.h"
#include "core/recording/recording.h"
#include "core/recording/text_choice.h"

#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

namespace vybeg {

enum class RawType { i16, i32, f32, f64 };

// Layout of headerless interleaved samples (--raw and its companions).
struct RawLayout {
    RawType type = RawType::i16;
    bool big_endian = false;
    int channels = 2;
    std::int64_t skip_bytes = 0;
    double scale = 1;  // recording units per count

    friend bool operator==(const RawLayout&, const RawLayout&) = default;
};

struct OpenOptions {
    std::optional<double> rate_hz;  // used where the file has no rate
    int channel_c = 1;              // from 1; a time column does not count
    int channel_d = 2;
    std::optional<RawLayout> raw;  // read the file as raw samples, whatever it looks like
    // Names of the variables that hold C and D and, third, the rate, in a file of several (NPZ,
    // MAT, HDF5). D's is left out, or empty before a rate, where C's holds both channels. None: the
    // reader's own choice.
    std::vector<std::string> variables{};
    std::optional<TextChoice> text{};  // read the file as text, whatever it looks like
    std::string unit{};                // of the samples; empty: the file's

    friend bool operator==(const OpenOptions&, const OpenOptions&) = default;
};

// What `options` say beside the rate and the channels, as on the command line; empty where they say
// nothing.
std::string options_text(const OpenOptions& options);

// Opens a recording by its content, never by its name. What its file says about it is plain_text().
// Text is looked through whole (progress and cancellation through `job`); samples are read on
// demand. Errors: every ErrorCode of the input group, setting_invalid, interrupted.
Result<Recording> open_recording(const std::filesystem::path& path, const OpenOptions& options,
                                 const JobControl& job);

// Lower-case hexadecimal SHA-256 of a file's bytes.
Result<std::string> file_sha256(const std::filesystem::path& path, const JobControl& job);

// The same of what a recording's samples come from, which its path need not name any more. Errors:
// also file_changed.
Result<std::string> recording_sha256(const Recording& recording, const JobControl& job);

// Whether the file still is what was opened, size and time of its last change: to be asked after
// its samples were read. Errors: file_changed, file_read_failed.
Status unchanged(const Recording& recording);

}  // namespace vybeg
