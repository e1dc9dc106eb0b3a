#include "tests/fuzz/trial.h"

#include "core/base/error.h"
#include "core/recording/arrays/raw_reader.h"
#include "core/recording/audio/audio_reader.h"
#include "core/recording/bytes/number_type.h"
#include "core/recording/open/open_recording.h"
#include "tests/fuzz/memory_file.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

namespace vybeg::fuzz {
namespace {

using File = std::shared_ptr<const FileBytes>;

constexpr std::int64_t piece = 4096;                       // frames of one read
constexpr std::int64_t most_read = std::int64_t{1} << 18;  // frames from the start on

OpenOptions some_rate() {
    OpenOptions options;
    options.rate_hz = 33333;
    return options;
}

bool any_infinite(const std::vector<double>& x) {
    return std::any_of(x.begin(), x.end(), [](double sample) { return std::isinf(sample); });
}

// Forward from the start, then back from the end.
Verdict read_through(const SampleSource& source) {
    std::vector<std::int64_t> places;
    for (std::int64_t at = 0; at < std::min(source.frames(), most_read); at += piece) {
        places.push_back(at);
    }
    for (const std::int64_t at : {source.frames() - piece, source.frames() / 2, std::int64_t{0}}) {
        places.push_back(std::max<std::int64_t>(at, 0));
    }
    for (const std::int64_t at : places) {
        const auto count = static_cast<std::size_t>(std::min(piece, source.frames() - at));
        std::vector<double> c(count), d(count);
        const Status status = source.read(at, c, d);
        if (!status && exit_status(status.error().code) != 3) {
            return {Outcome::unreadable, "a read fails with an error that is none of the input"};
        }
        if (!status) {
            return {Outcome::unreadable, ""};
        }
        if (any_infinite(c) || any_infinite(d)) {
            return {Outcome::read, "an infinite sample"};
        }
    }
    return {Outcome::read, ""};
}

// `most_frames`: that bytes so many can stand for.
Verdict judge(const Result<Recording>& recording, double most_frames) {
    if (!recording) {
        const bool of_input = exit_status(recording.error().code) == 3;
        return {Outcome::refused, of_input ? "" : "an error that is none of the input"};
    }
    if (!(recording->rate_hz > 0) || !std::isfinite(recording->rate_hz)) {
        return {Outcome::read, "a rate that is none"};
    }
    if (recording->frames() < 5 || static_cast<double>(recording->frames()) > most_frames) {
        return {Outcome::read, std::to_string(recording->frames()) + " frames"};
    }
    return read_through(*recording->source);
}

template <class Open>
Verdict try_opening(std::string_view bytes, double most_frames, const Open& open) {
    const MemoryFile memory(bytes);
    const auto file = FileBytes::open(memory.path());
    return file ? judge(open(*file), most_frames) : Verdict{};
}

Verdict try_wav(std::string_view bytes) {
    return try_opening(bytes, static_cast<double>(bytes.size()),
                       [](const File& file) -> Result<Recording> {
                           const auto header = audio_extent(*file);
                           return header && header->plain ? open_audio(file, some_rate(), {})
                                                          : file->error(ErrorCode::format_unknown);
                       });
}

Verdict try_format(const FileFormat& format, std::string_view bytes) {
    // Gaps between times are frames, too: 20 for a row, and 10 million (is_plausible_grid()).
    // Variables may be packed.
    const auto size = static_cast<double>(bytes.size());
    const double most = format.has_variables ? 1e7 + 20 * 1032.0 * size
                        : format.is_text()   ? 1e7 + 20.0 * size
                                             : size;
    return try_opening(bytes, most,
                       [&](const File& file) { return format.open(file, some_rate(), {}); });
}

Verdict try_any(std::string_view bytes) {
    const MemoryFile memory(bytes);
    // FLAC says with a few bytes that 65535 samples are equal: the most of all formats.
    const double most = 1e7 + 65536.0 * static_cast<double>(bytes.size());
    return judge(open_recording(memory.path(), some_rate(), {}), most);
}

// The samples have no bytes that can be wrong: what describes them does.
Verdict try_zetlab(std::string_view bytes) {
    const auto header = parse_zetlab_header(bytes);
    if (!header) {
        return {Outcome::refused, ""};
    }
    const bool possible = header->rate_hz > 0 && std::isfinite(header->rate_hz) &&
                          std::isfinite(header->scale) && header->scale != 0;
    return {Outcome::read, possible ? "" : "a rate or a scale that is none"};
}

Verdict try_raw(std::string_view bytes) {
    constexpr std::size_t choice_bytes = 24;
    std::array<char, choice_bytes> choice{};
    std::copy_n(bytes.begin(), std::min(bytes.size(), choice.size()), choice.begin());
    RawLayout layout;
    layout.type = static_cast<RawType>(choice[0] & 3);
    layout.big_endian = (choice[0] & 4) != 0;
    layout.channels = load<std::int32_t>(choice.data() + 4, false);
    layout.skip_bytes = load<std::int64_t>(choice.data() + 8, false);
    OpenOptions options = some_rate();
    options.scale = load<double>(choice.data() + 16, false);
    options.raw = layout;
    const MemoryFile memory(bytes);
    const auto file = FileBytes::open(memory.path());
    if (!file) {
        return {};
    }
    const auto recording = open_raw(*file, options);
    // The layout is the user's: one that cannot be is a wrong setting, not a wrong file.
    if (!recording && recording.error().code == ErrorCode::setting_invalid) {
        return {};
    }
    return judge(recording, static_cast<double>(bytes.size()));
}

}  // namespace

std::vector<std::string> readers() {
    std::vector<std::string> names{"wav", "raw", "any"};
    for (const FileFormat& format : file_formats()) {
        const std::string name(format.name);
        if (!format.in_helper && std::ranges::find(names, name) == names.end()) {
            names.push_back(name);
        }
    }
    return names;
}

TryFile reader_of(std::string_view format) {
    if (format == "wav") {
        return try_wav;
    }
    if (format == "raw") {
        return try_raw;
    }
    if (format == "zetlab") {
        return try_zetlab;
    }
    if (format == "any") {
        return try_any;
    }
    const auto formats = file_formats();
    const auto found = std::ranges::find_if(formats, [format](const FileFormat& each) {
        return each.name == format && !each.in_helper;
    });
    if (found == formats.end()) {
        return nullptr;
    }
    return [&reader = *found](std::string_view bytes) { return try_format(reader, bytes); };
}

}  // namespace vybeg::fuzz
