#include "core/recording/arrays/raw_reader.h"

#include "core/base/plain_text.h"
#include "core/recording/bytes/text_encoding.h"
#include "core/recording/samples/column_source.h"
#include "core/recording/samples/open_table.h"
#include "core/recording/samples/reader_rules.h"
#include "core/recording/samples/text_fields.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <filesystem>
#include <system_error>
#include <utility>

namespace vybeg {

NumberType number_type(RawType type) {
    // In the order of RawType.
    constexpr std::array types{NumberType::i16, NumberType::i32, NumberType::f32, NumberType::f64};
    return types.at(static_cast<std::size_t>(type));
}

Result<Recording> open_raw(std::shared_ptr<const FileBytes> file, const OpenOptions& options) {
    const RawLayout& layout = *options.raw;
    TRY(check_layout(layout));
    TRY(check_channels(*file, layout.channels, options));
    const NumberType type = number_type(layout.type);
    FoundSamples found;
    found.format = {FormatPart::words(VYBEG_MESSAGE("Format", "raw")),
                    FormatPart::words(name_of(type)), byte_order_part(layout.big_endian),
                    FormatPart::channels(layout.channels)};
    found.channels = numbered_channels(layout.channels);
    NumberArray samples{type, {}, layout.big_endian, layout.channels, layout.skip_bytes};
    const std::int64_t frame_bytes = std::int64_t{bytes_of(type)} * layout.channels;
    samples.frames = std::max<std::int64_t>(file->size() - layout.skip_bytes, 0) / frame_bytes;
    found.present_frames = samples.frames;
    found.source = array_source(file, samples, options.channel_c, options.channel_d);
    return complete_recording(*file, std::move(found), options);
}

namespace {

constexpr std::int64_t longest_header = std::int64_t{1} << 20;

// Takes on what one key says; false where its value cannot be.
void take(std::string_view key, std::string_view value, ZetlabHeader& header) {
    const auto number = [value]() -> double {
        const auto parsed = parse_field(value, false);
        const auto with_comma = parsed ? parsed : parse_field(value, true);
        return with_comma && std::isfinite(*with_comma) ? *with_comma : 0;
    };
    const std::string name = lower_text(key);
    if (name == "frq" || name == "frequency") {
        header.rate_hz = number();
    } else if (name == "absvolt" || name == "minlevel") {
        header.scale = number() != 0 ? number() : header.scale;
    } else if (name == "convert" || name == "conversion") {
        header.unit = value;
    } else if (name == "name") {
        header.name = value;
    }
}

// "&quot;" as '"', of the five that XML has by itself.
std::string without_entities(std::string_view text) {
    constexpr std::array<std::pair<std::string_view, char>, 5> entities{
        {{"&quot;", '"'}, {"&apos;", '\''}, {"&lt;", '<'}, {"&gt;", '>'}, {"&amp;", '&'}}};
    std::string plain;
    while (!text.empty()) {
        const auto* const entity = std::ranges::find_if(
            entities, [text](const auto& each) { return text.starts_with(each.first); });
        const bool found = entity != entities.end();
        plain += found ? entity->second : text.front();
        text.remove_prefix(found ? entity->first.size() : 1);
    }
    return plain;
}

// The attributes of the first element Signal.
void take_xml(std::string_view text, ZetlabHeader& header) {
    const std::size_t element = text.find("<Signal");
    if (element == std::string_view::npos) {
        return;
    }
    text = text.substr(element + std::string_view("<Signal").size());
    while (true) {
        const std::size_t equals = text.find('=');
        const std::size_t end = text.find('>');
        if (equals == std::string_view::npos || end < equals) {
            return;
        }
        std::string_view key = text.substr(0, equals);
        key.remove_prefix(std::min(key.find_first_not_of(" \t\r\n"), key.size()));
        key = key.substr(0, key.find_first_of(" \t\r\n"));
        text.remove_prefix(equals + 1);
        const std::size_t open = text.find_first_of("\"'");
        const std::size_t close =
            open == std::string_view::npos ? open : text.find(text[open], open + 1);
        if (close == std::string_view::npos) {
            return;
        }
        take(key, without_entities(text.substr(open + 1, close - open - 1)), header);
        text.remove_prefix(close + 1);
    }
}

// A key and, after blanks, its value in each line.
void take_lines(std::string_view text, ZetlabHeader& header) {
    while (!text.empty()) {
        const std::size_t end = std::min(text.find_first_of("\r\n"), text.size());
        const std::string_view line = trimmed(text.substr(0, end));
        const std::size_t blank = std::min(line.find_first_of(" \t="), line.size());
        std::string_view value = line.substr(blank);
        value.remove_prefix(std::min(value.find_first_not_of(" \t="), value.size()));
        take(line.substr(0, blank), trimmed(value), header);
        text.remove_prefix(std::min(end + 1, text.size()));
    }
}

// The file beside the samples that describes them.
Result<std::pair<std::shared_ptr<const FileBytes>, ZetlabHeader>> find_header(
    const FileBytes& file) {
    for (const char* ending : {".xml", ".anp", ".XML", ".ANP"}) {
        const std::filesystem::path path =
            std::filesystem::path(file.path()).replace_extension(ending);
        std::error_code unknown;
        if (!std::filesystem::exists(path, unknown)) {
            continue;
        }
        auto beside = TRY(FileBytes::open(path));
        const auto text = TRY(beside->text(0, std::min(beside->size(), longest_header)));
        if (auto header = parse_zetlab_header(text)) {
            return std::pair(std::move(beside), std::move(*header));
        }
    }
    return file.error(ErrorCode::header_missing, {file.path().stem().string()});
}

}  // namespace

std::optional<ZetlabHeader> parse_zetlab_header(std::string_view text) {
    const std::string utf8 = to_utf8(text.substr(mark_length(text)));
    ZetlabHeader header;
    if (utf8.find("<Signal") != std::string::npos) {
        take_xml(utf8, header);
    } else {
        take_lines(utf8, header);
    }
    // The scale is in volts.
    header.scale *= header.unit == "mV" || header.unit == "мВ" ? 1e3 : 1;
    const bool possible = header.rate_hz > 0 && std::isfinite(header.scale) && header.scale != 0;
    return possible ? std::optional(header) : std::nullopt;
}

bool is_zetlab(std::string_view /*head*/, const FileBytes& file) {
    return lower_text(file.path().extension().string()) == ".ana";
}

Result<Recording> open_zetlab(std::shared_ptr<const FileBytes> file, const OpenOptions& options,
                              const JobControl& /*job*/) {
    TRY(check_channels(*file, 1, options));
    auto beside = TRY(find_header(*file));
    const auto& [header_file, header] = beside;
    const NumberType type = NumberType::f32;
    const NumberArray samples{type, {header.scale, 0}, false, 1, 0, file->size() / bytes_of(type)};
    FoundSamples found;
    found.format = {FormatPart::name("ZETLAB"), FormatPart::words(name_of(type)),
                    FormatPart::channels(1)};
    found.channels = {{header.name.empty() ? "1" : header.name, header.unit}};
    found.own_rate = SampleRate{header.rate_hz, RateOrigin::file};
    found.present_frames = samples.frames;
    found.source = array_source(file, samples, 1, 1);
    auto recording = complete_recording(*file, std::move(found), options);
    if (recording) {
        recording->more_files.push_back(header_file);
    }
    return recording;
}

}  // namespace vybeg
