#include "core/recording/audio/audio_reader.h"

#include "core/base/number_text.h"
#include "core/recording/bytes/number_type.h"
#include "core/recording/samples/reader_rules.h"
#include "core/recording/variables/library_variables.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <utility>

namespace vybeg {
namespace {

using namespace std::string_view_literals;

// The 16 byte names of W64 chunks begin with the four letters of the WAV chunk.
constexpr std::string_view w64_riff = "riff\x2E\x91\xCF\x11\xA5\xD6\x28\xDB\x04\xC1\x00\x00"sv;
constexpr int most_chunks = 1000;
constexpr std::size_t payload_head = 40;  // more than any field used

enum class Container { wav, rf64, w64, aiff, caf };

struct Chunk {
    std::string_view id;  // four letters
    std::int64_t size;    // of the payload, as written; -1 or all ones: not filled in
    std::int64_t payload_at;
    const char* payload;  // its first payload_head bytes, zeros after the end of the file
};

// Layout of the chunk heads of a container, in the order of Container; of WAV and RF64 that of
// little endian ones.
struct Layout {
    const char* name;
    std::int64_t first_chunk;
    std::int64_t id_bytes;
    std::int64_t size_bytes;
    std::int64_t alignment;
    bool big_endian;
    bool size_counts_head;
};
constexpr std::array<Layout, 5> layouts{{{"WAV", 12, 4, 4, 2, false, false},
                                         {"RF64", 12, 4, 4, 2, false, false},
                                         {"W64", 40, 16, 8, 8, false, true},
                                         {"AIFF", 12, 4, 4, 2, true, false},
                                         {"CAF", 8, 4, 8, 1, true, false}}};

const Layout& layout_of(Container container) {
    return layouts.at(static_cast<std::size_t>(container));
}

// Passes each chunk between `at` and `end` to `visit`, a Result<bool>, until that is false; returns
// where the next one would begin.
template <class Visit>
Result<std::int64_t> walk_chunks(const FileBytes& file, const Layout& layout, std::int64_t at,
                                 std::int64_t end, Visit visit) {
    const std::int64_t head_bytes = layout.id_bytes + layout.size_bytes;
    for (int i = 0; i < most_chunks && end - at >= head_bytes; ++i) {
        std::array<char, 24 + payload_head> bytes{};
        TRY(file.read(at, bytes));
        const char* const size_at = bytes.data() + layout.id_bytes;
        std::int64_t size = layout.size_bytes == 8
                                ? load<std::int64_t>(size_at, layout.big_endian)
                                : load<std::uint32_t>(size_at, layout.big_endian);
        if (layout.size_counts_head) {
            constexpr std::int64_t least = std::numeric_limits<std::int64_t>::min();
            size = size < least + head_bytes ? size : size - head_bytes;
        }
        const auto goes_on =
            TRY(visit(Chunk{{bytes.data(), 4}, size, at + head_bytes, bytes.data() + head_bytes}));
        if (!goes_on) {
            break;
        }
        at += (head_bytes + size + layout.alignment - 1) / layout.alignment * layout.alignment;
    }
    return at;
}

// Whether the chunks in a LIST chunk lie inside it.
Result<bool> is_sound_list(const FileBytes& file, const Layout& layout, const Chunk& list) {
    const std::int64_t end = list.payload_at + list.size;
    if (end > file.size()) {
        return false;
    }
    const auto behind = TRY(walk_chunks(file, layout, list.payload_at + 4, end,
                                        [](const Chunk&) -> Result<bool> { return true; }));
    return behind <= end + 1;  // the last one need not be padded
}

// Whether the decoder gets a chunk of a WAV or RF64 file: samples, their description, date.
Result<bool> is_wanted(const FileBytes& file, const Layout& layout, const Chunk& chunk) {
    constexpr std::array<std::string_view, 5> wanted{"fmt ", "fact", "data", "ds64", "bext"};
    if (chunk.id == "LIST") {
        return is_sound_list(file, layout, chunk);
    }
    return std::find(wanted.begin(), wanted.end(), chunk.id) != wanted.end();
}

// A text that may end before its field does.
std::string text_of(std::string_view field) {
    return std::string(field.substr(0, field.find('\0')));
}

// Date and time of a broadcast extension (chunk "bext"). Errors: file_read_failed.
Result<std::string> broadcast_start(const FileBytes& file, const Chunk& chunk) {
    constexpr std::int64_t least_bytes = 602, most_bytes = 10240, at = 320;
    constexpr std::size_t date_bytes = 10, time_bytes = 8;
    if (chunk.size < least_bytes || chunk.size > most_bytes) {
        return std::string();
    }
    std::array<char, date_bytes + time_bytes> fields{};
    TRY(file.read(chunk.payload_at + at, fields));
    const std::string date = text_of({fields.data(), date_bytes});
    const std::string time = text_of({fields.data() + date_bytes, time_bytes});
    return date.empty() || time.empty() ? date : date + " " + time;
}

// The date (ICRD) of a sound list of informations. Errors: file_read_failed.
Result<std::string> listed_date(const FileBytes& file, const Layout& layout, const Chunk& list) {
    constexpr std::int64_t most_text = 2046;
    if (std::string_view(list.payload, 4) != "INFO") {
        return std::string();
    }
    std::int64_t size = 0;  // of the date
    std::int64_t at = 0;
    TRY(walk_chunks(file, layout, list.payload_at + 4, list.payload_at + list.size,
                    [&](const Chunk& chunk) -> Result<bool> {
                        const bool is_date = chunk.id == "ICRD";
                        size = is_date ? chunk.size : 0;
                        at = chunk.payload_at;
                        return !is_date;
                    }));
    const auto text = TRY(file.text(at, size > most_text ? 0 : size));
    return text_of(text);
}

// Whether the bytes from `at` to the end of a WAV file are chunks, the last one complete; this is
// the case after a data chunk that is really empty.
Result<bool> are_chunks(const FileBytes& file, const Layout& layout, std::int64_t at) {
    bool named = true;
    const auto behind =
        TRY(walk_chunks(file, layout, at, file.size(), [&](const Chunk& chunk) -> Result<bool> {
            named = std::ranges::all_of(chunk.id, [](char c) { return c >= ' ' && c <= '~'; });
            return named;
        }));
    return named && (behind == file.size() || behind == file.size() + 1);
}

// An 80-bit number of AIFF, whose first bit is the whole number 1.
double extended(const char* bytes) {
    constexpr int bias = 16383, fraction_bits = 63;
    const int exponent = load<std::uint16_t>(bytes, true) & 0x7FFF;
    const auto mantissa = static_cast<double>(load<std::uint64_t>(bytes + 2, true));
    return std::ldexp(mantissa, exponent - bias - fraction_bits);
}

// Reads the chunks of one file up to the samples.
class ExtentReader {
public:
    ExtentReader(Container container, bool big_endian, std::int64_t file_size)
        : container_(container), big_endian_(big_endian), file_size_(file_size) {}

    // False if no relevant chunk can follow.
    bool take(const Chunk& chunk) {
        // Names of other containers mean nothing here.
        const bool is_aiff = container_ == Container::aiff;
        const bool is_caf = container_ == Container::caf;
        if (chunk.id == "fmt " && !is_aiff && !is_caf) {
            take_wav_format(chunk);
        } else if (chunk.id == "ds64" && container_ == Container::rf64) {
            long_data_size_ = load<std::int64_t>(chunk.payload + 8, false);
        } else if (chunk.id == "COMM" && is_aiff) {
            extent_.promised_frames = load<std::uint32_t>(chunk.payload + 2, true);
            extent_.rate_hz = extended(chunk.payload + 8);
            constexpr std::int64_t with_encoding = 22;  // of AIFF-C, perhaps of floats
            extent_.bits =
                chunk.size < with_encoding ? load<std::uint16_t>(chunk.payload + 6, true) : 0;
        } else if (chunk.id == "desc" && is_caf) {
            const auto bytes = load<std::uint32_t>(chunk.payload + 16, true);
            const auto frames = load<std::uint32_t>(chunk.payload + 20, true);
            frame_bytes_ = frames == 1 ? bytes : 0;
            extent_.rate_hz = load<double>(chunk.payload, true);
        } else if (chunk.id == "data") {
            take_data(chunk);
            return false;
        }
        return true;
    }

    // Samples of a file without a final length, because the recorder stopped.
    void take_unfinished(const Chunk& chunk) {
        constexpr std::int64_t most = std::numeric_limits<std::uint32_t>::max() - 1;
        const std::int64_t frame = std::max<std::int64_t>(frame_bytes_, 1);
        const std::int64_t present = file_size_ - chunk.payload_at;
        const auto size = static_cast<std::uint32_t>(std::min(present, most) / frame * frame);
        extent_.patches.push_back({chunk.payload_at - 4, store(size, big_endian_)});
        extent_.samples_at = chunk.payload_at;
        extent_.promised_frames =
            frame_bytes_ > 0 ? std::optional(present / frame_bytes_) : std::nullopt;
        extent_.never_closed = true;
        take_plain(present);
    }

    // Of a broadcast extension or a list; the extension counts first.
    void take_start(const std::string& start, bool of_broadcast) {
        if (!start.empty() && (extent_.start.empty() || (of_broadcast && !broadcast_))) {
            extent_.start = start;
            broadcast_ = of_broadcast;
        }
    }

    void hide(const Chunk& chunk) { extent_.patches.push_back({chunk.payload_at - 8, "JUNK"}); }

    AudioExtent extent() const { return extent_; }

private:
    // Of a format chunk of a usual length that the number of bytes in a frame agrees with.
    std::optional<PlainSamples> plain_format(const Chunk& chunk, std::uint16_t tag) const {
        constexpr std::string_view guid_tail = "\0\0\0\0\x10\0\x80\0\0\xAA\0\x38\x9B\x71"sv;
        constexpr std::uint16_t pcm = 1, ieee = 3, extensible = 0xFFFE;
        constexpr int most_channels = 1024;
        const auto number = [&](int at) {
            return load<std::uint16_t>(chunk.payload + at, big_endian_);
        };
        const int bits = number(14);
        const bool is_extensible = tag == extensible;
        if (is_extensible) {
            tag = number(24);
            if (chunk.size != 40 || number(18) != bits ||
                std::string_view(chunk.payload + 26, guid_tail.size()) != guid_tail) {
                return {};
            }
        } else if (chunk.size != 16 && chunk.size != 18) {
            return {};
        }
        PlainSamples plain;
        if (tag == pcm && (bits == 8 || bits == 16 || bits == 24 || bits == 32 || bits == 64)) {
            constexpr std::array by_bytes{NumberType::u8, NumberType::i16, NumberType::i24,
                                          NumberType::i32};
            plain.type =
                bits == 64 ? NumberType::i64 : by_bytes.at(static_cast<std::size_t>(bits) / 8 - 1);
            plain.type_name =
                (bits == 8 ? "Unsigned " : "Signed ") + integer_text(bits) + " bit PCM";
            plain.scale = {std::ldexp(1.0, 1 - bits), bits == 8 ? -1.0 : 0.0};
        } else if (tag == ieee && (bits == 32 || bits == 64)) {
            plain.type = bits == 32 ? NumberType::f32 : NumberType::f64;
            plain.type_name = integer_text(bits) + " bit float";
        } else {
            return {};
        }
        plain.channels = number(2);
        plain.rate_hz = load<std::uint32_t>(chunk.payload + 4, big_endian_);
        plain.big_endian = big_endian_;
        plain.container = container_ == Container::rf64  ? "RF64"
                          : container_ == Container::w64 ? "W64"
                          : is_extensible                ? "WAVEX"
                                                         : "WAV";
        const bool agrees = plain.channels >= 1 && plain.channels <= most_channels &&
                            plain.rate_hz <= std::numeric_limits<std::int32_t>::max() &&
                            number(12) == plain.channels * bits / 8;
        return agrees ? std::optional(plain) : std::nullopt;
    }

    // Of so many bytes of samples, of which the file may have less.
    void take_plain(std::int64_t bytes) {
        extent_.plain = plain_;
        if (plain_) {
            const std::int64_t present = file_size_ - extent_.samples_at;
            extent_.plain->offset = extent_.samples_at;
            extent_.plain->frames = std::clamp<std::int64_t>(bytes, 0, present) / frame_bytes_;
        }
    }

    void take_wav_format(const Chunk& chunk) {
        constexpr std::array<std::uint16_t, 5> unpacked = {1, 3, 6, 7, 0xFFFE};
        const auto tag = load<std::uint16_t>(chunk.payload, big_endian_);
        const bool known = std::find(unpacked.begin(), unpacked.end(), tag) != unpacked.end();
        extent_.packed_as = known ? 0 : tag;
        frame_bytes_ = known ? load<std::uint16_t>(chunk.payload + 12, big_endian_) : 0;
        constexpr std::uint16_t extensible = 0xFFFE;  // the tag of integers follows later
        const auto kind =
            tag == extensible ? load<std::uint16_t>(chunk.payload + 24, big_endian_) : tag;
        extent_.bits = kind == 1 ? load<std::uint16_t>(chunk.payload + 14, big_endian_) : 0;
        if (load<std::uint32_t>(chunk.payload + 4, big_endian_) == 0) {
            extent_.rate_is_zero = true;
            extent_.patches.push_back({chunk.payload_at + 4, store(std::uint32_t{1}, big_endian_)});
        }
        plain_ = ++formats_ == 1 ? plain_format(chunk, tag) : std::nullopt;
    }

    void take_data(const Chunk& chunk) {
        std::int64_t size = chunk.size;
        extent_.samples_at = container_ == Container::caf ? 0 : chunk.payload_at;
        const std::int64_t present = file_size_ - chunk.payload_at;
        if (container_ == Container::caf && (size > present || size == -1)) {
            extent_.patches.push_back({chunk.payload_at - 8, store(present, true)});
            size = size == -1 ? present : size;  // -1: to the end of the file
        }
        if (container_ == Container::caf && size >= 0) {
            size -= 4;  // an edit count precedes the samples
        }
        const bool not_filled_in = size == std::numeric_limits<std::uint32_t>::max();
        if (container_ == Container::rf64 && not_filled_in) {
            size = long_data_size_;
        } else if (not_filled_in) {
            size = 0;
        }
        if (container_ == Container::wav || (container_ == Container::rf64 && size > 0) ||
            (container_ == Container::w64 && size >= 0)) {
            take_plain(not_filled_in && container_ == Container::wav ? present : size);
        }
        if (size > 0 && frame_bytes_ > 0) {
            extent_.promised_frames = size / frame_bytes_;
        }
    }

    Container container_;
    bool big_endian_;
    std::int64_t file_size_;
    std::int64_t frame_bytes_ = 0;  // 0: packed, or unknown
    std::int64_t long_data_size_ = 0;
    int formats_ = 0;
    std::optional<PlainSamples> plain_;
    bool broadcast_ = false;
    AudioExtent extent_;
};

std::optional<Container> container_of(std::string_view head) {
    const std::string_view id = head.substr(0, 4);
    const std::string_view form = head.size() < 12 ? ""sv : head.substr(8, 4);
    if ((id == "RIFF" || id == "RIFX") && form == "WAVE") {
        return Container::wav;
    }
    if (id == "RF64" && form == "WAVE") {
        return Container::rf64;
    }
    if (head.starts_with(w64_riff)) {
        return Container::w64;
    }
    if (id == "FORM" && (form == "AIFF" || form == "AIFC")) {
        return Container::aiff;
    }
    if (id == "caff" && form == "desc") {
        return Container::caf;
    }
    return std::nullopt;
}

}  // namespace

std::string audio_container(std::string_view head) {
    const auto container = container_of(head);
    if (!container) {
        return head.starts_with("fLaC") ? "FLAC" : head.starts_with(".snd") ? "AU" : "";
    }
    return layout_of(*container).name;
}

std::int64_t tag_before_flac(std::string_view head, const FileBytes& file) {
    constexpr std::size_t tag_head = 10;  // and as many bytes after the tag where it has a footer
    if (head.size() < tag_head || !head.starts_with("ID3")) {
        return 0;
    }
    std::int64_t behind = tag_head + ((head[5] & 0x10) != 0 ? tag_head : 0);
    for (int i = 0; i < 4; ++i) {
        const auto place = static_cast<std::size_t>(i) + 6;
        behind += static_cast<std::int64_t>(head[place] & 0x7F) << (7 * (3 - i));
    }
    std::array<char, 4> name{};
    const bool flac = file.read(behind, name) && std::string_view(name.data(), 4) == "fLaC";
    return flac ? behind : 0;
}

Result<AudioExtent> audio_extent(const FileBytes& file) {
    const auto head = TRY(file.text(0, 16));
    const auto container = container_of(head);
    if (!container) {
        return AudioExtent{};
    }
    const bool is_riff = *container == Container::wav || *container == Container::rf64;
    Layout layout = layout_of(*container);
    layout.big_endian = layout.big_endian || (is_riff && head[3] == 'X');
    ExtentReader reader(*container, layout.big_endian, file.size());
    bool searching = true;
    const auto visit = [&](const Chunk& chunk) -> Result<bool> {
        if (is_riff) {
            const auto wanted = TRY(is_wanted(file, layout, chunk));
            if (!wanted) {
                reader.hide(chunk);
            } else if (chunk.id == "bext" || chunk.id == "LIST") {
                const bool of_broadcast = chunk.id == "bext";
                const auto start = TRY(of_broadcast ? broadcast_start(file, chunk)
                                                    : listed_date(file, layout, chunk));
                reader.take_start(start, of_broadcast);
            }
        }
        if (*container == Container::wav && chunk.id == "data" && chunk.size == 0 && searching) {
            const auto is_empty = TRY(are_chunks(file, layout, chunk.payload_at));
            if (!is_empty) {
                reader.take_unfinished(chunk);
                return false;
            }
        }
        searching = searching && reader.take(chunk);
        return (searching || is_riff) && chunk.size >= 0 && chunk.size <= file.size();
    };
    TRY(walk_chunks(file, layout, layout.first_chunk, file.size(), visit));
    return reader.extent();
}

namespace {

// In place, at the speed of memory and for several threads at once.
Result<Recording> open_plain(const std::shared_ptr<const FileBytes>& file,
                             const AudioExtent& header, const OpenOptions& options) {
    const PlainSamples& plain = *header.plain;
    const auto channels = static_cast<int>(plain.channels);
    TRY(check_channels(*file, channels, options));
    FoundSamples found;
    found.format = {FormatPart::name(plain.container), FormatPart::words(plain.type_name),
                    FormatPart::channels(channels)};
    found.channels = numbered_channels(channels);
    found.own_rate = SampleRate{static_cast<double>(plain.rate_hz), RateOrigin::file};
    found.start = header.start;
    found.present_frames = plain.frames;
    found.promised_frames = std::max(header.promised_frames.value_or(0), plain.frames);
    found.never_closed = header.never_closed;
    found.source = array_source(file, plain, options.channel_c, options.channel_d);
    return complete_recording(*file, std::move(found), options);
}

// Number of frames that can be decoded from the start. If the last frame of the header cannot be
// decoded, only decoding shows the number.
Result<std::int64_t> count_frames(const VariableReader& reader, std::int64_t promised,
                                  const JobControl& job) {
    constexpr std::int64_t large_step = 4096;
    std::array<double, large_step> samples{};
    const std::span all(samples);
    if (promised == 0 || reader.read({}, promised - 1, all.first(1))) {
        return promised;
    }
    std::int64_t frames = 0;
    // In large steps to the damage, then frame by frame up to it.
    for (const std::int64_t step : {large_step, std::int64_t{1}}) {
        while (frames < promised) {
            TRY(job.go_on());
            const std::int64_t count = std::min(step, promised - frames);
            if (!reader.read({}, frames, all.first(static_cast<std::size_t>(count)))) {
                break;
            }
            frames += count;
        }
    }
    return frames;
}

Result<Recording> open_decoded(const std::shared_ptr<const FileBytes>& file,
                               const std::string& container, const AudioExtent& header,
                               const OpenOptions& options, const JobControl& job) {
    const auto library = TRY(open_library(file, "audio", container));
    const Catalogue& catalogue = library->catalogue();
    if (catalogue.variables.size() != 1) {
        return file->damaged(container, VYBEG_MESSAGE("Words", "its library returned nonsense"));
    }
    const FileVariable& samples = catalogue.variables.front();
    const auto channels = static_cast<int>(samples.channels);
    TRY(check_channels(*file, channels, options));
    SampleRate own{header.rate_is_zero ? 0.0 : samples.rate_hz.value_or(0), RateOrigin::file};
    if (header.rate_hz && std::abs(*header.rate_hz - own.hz) < 1) {
        own.hz = *header.rate_hz;
    }
    // Checked before frames are counted.
    TRY(choose_rate(*file, own, options));
    const auto frames = TRY(count_frames(*library, samples.frames, job));
    FoundSamples found;
    found.format = {FormatPart::name(catalogue.format), FormatPart::words(samples.type),
                    FormatPart::channels(channels)};
    found.channels = numbered_channels(channels);
    found.own_rate = own;
    found.start = header.start.empty() ? catalogue.start : header.start;
    found.present_frames = frames;
    // A FLAC stream without its number of frames has the greatest one here.
    const bool is_open = samples.frames == std::numeric_limits<std::int64_t>::max();
    found.promised_frames =
        std::max(header.promised_frames.value_or(0), is_open ? 0 : samples.frames);
    found.never_closed = header.never_closed;
    found.source =
        TRY(library->source({0, options.channel_c - 1}, {0, options.channel_d - 1}, frames));
    return complete_recording(*file, std::move(found), options);
}

}  // namespace

Result<Recording> open_audio(std::shared_ptr<const FileBytes> file, const OpenOptions& options,
                             const JobControl& job) {
    const auto head = TRY(file->text(0, 16));
    const auto header = TRY(audio_extent(*file));
    constexpr int most_bits = 32;
    if (header.bits > most_bits && !header.plain) {
        return file->error(ErrorCode::format_limit,
                           {Phrase::tr("audio"),
                            Phrase::tr("integers of %1 bits; up to %2, and 64 in WAV, are read",
                                       {count_arg(header.bits), count_arg(most_bits)}),
                            Phrase::tr("Save the recording with 32 bits or as floats")});
    }
    const std::string container = audio_container(head);
    return header.plain
               ? open_plain(file, header, options)
               : open_decoded(file, container.empty() ? "FLAC" : container, header, options, job);
}

}  // namespace vybeg
