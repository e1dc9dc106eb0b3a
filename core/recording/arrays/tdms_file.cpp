#include "core/recording/arrays/tdms_file.h"

#include "core/recording/bytes/text_encoding.h"

#include <algorithm>
#include <array>
#include <chrono>
#include <cmath>
#include <limits>
#include <numeric>
#include <utility>

namespace vybeg {
namespace {

constexpr std::uint32_t tdms_string = 0x20;
constexpr std::uint32_t tdms_time = 0x44;

// Value in place of the length of an object's raw index: no raw data.
constexpr std::uint32_t tdms_no_raw_data = 0xFFFFFFFF;
constexpr std::uint32_t tdms_same_as_before = 0;

std::string padded(std::int64_t number, std::size_t digits) {
    std::string text = std::to_string(number);
    return text.size() < digits ? std::string(digits - text.size(), '0') + text : text;
}

// A TDMS time stamp as "2020-03-01T12:34:56.789Z". It counts seconds from 1904 on, and fractions of
// 2^-64 s. Empty outside the years 1 to 9999.
std::string time_text(std::int64_t seconds, std::uint64_t fraction) {
    using namespace std::chrono;
    constexpr std::int64_t farthest = 400'000'000'000;  // beyond the years 1 to 9999
    if (seconds < -farthest || seconds > farthest) {
        return {};
    }
    const sys_seconds time = sys_days(year(1904) / January / 1) + std::chrono::seconds(seconds);
    const sys_days day = floor<days>(time);
    const year_month_day date(day);
    const int in_year = static_cast<int>(date.year());
    if (in_year < 1 || in_year > 9999) {
        return {};
    }
    const hh_mm_ss clock(time - day);
    // Rounded to the nearest, because the fraction of .789 s lies just below it.
    const std::uint64_t milliseconds =
        std::min<std::uint64_t>(((fraction >> 32) * 1000 + (1u << 31)) >> 32, 999);
    return padded(in_year, 4) + "-" + padded(static_cast<unsigned>(date.month()), 2) + "-" +
           padded(static_cast<unsigned>(date.day()), 2) + "T" + padded(clock.hours().count(), 2) +
           ":" + padded(clock.minutes().count(), 2) + ":" + padded(clock.seconds().count(), 2) +
           "." + padded(static_cast<std::int64_t>(milliseconds), 3) + "Z";
}

}  // namespace

std::optional<NumberType> tdms_number(std::uint32_t type) {
    // From 1 on; 0x19 and 0x1A are floats with a unit.
    constexpr std::array types{NumberType::i8,  NumberType::i16, NumberType::i32, NumberType::i64,
                               NumberType::u8,  NumberType::u16, NumberType::u32, NumberType::u64,
                               NumberType::f32, NumberType::f64};
    const std::uint32_t place = (type == 0x19 || type == 0x1A ? type - 0x10 : type) - 1;
    return place < types.size() ? std::optional(types[place]) : std::nullopt;
}

std::optional<int> tdms_bytes(std::uint32_t type) {
    if (const auto number = tdms_number(type)) {
        return bytes_of(*number);
    }
    switch (type) {
        case 0x00: return 1;  // void
        case 0x21: return 1;  // boolean
        case 0x0B:
        case 0x1B: return 16;  // extended float
        case tdms_time: return 16;
        case 0x08000C: return 8;   // complex, two 32 bit floats
        case 0x10000D: return 16;  // complex, two 64 bit floats
        default: return std::nullopt;
    }
}

std::optional<double> TdmsObject::number(std::string_view property) const {
    const auto found = properties.find(property);
    return found == properties.end() ? std::nullopt : found->second.number;
}

std::string TdmsObject::text(std::string_view property) const {
    const auto found = properties.find(property);
    return found == properties.end() ? "" : found->second.text;
}

// Reader of a segment's metadata, value by value. After the end it returns empty values, and
// ended() is true.
class TdmsMetadata {
public:
    TdmsMetadata(std::string bytes, bool big_endian)
        : bytes_(std::move(bytes)), rest_(bytes_), big_endian_(big_endian) {}
    TdmsMetadata(const TdmsMetadata&) = delete;
    TdmsMetadata& operator=(const TdmsMetadata&) = delete;

    template <class Number>
    Number number() {
        const std::string_view taken = bytes(sizeof(Number));
        return ended_ ? Number{} : load<Number>(taken.data(), big_endian_);
    }

    std::string_view bytes(std::size_t size) {
        if (rest_.size() < size) {
            rest_ = {};
            ended_ = true;
            return {};
        }
        const std::string_view taken = rest_.substr(0, size);
        rest_.remove_prefix(size);
        return taken;
    }

    std::string string() { return std::string(bytes(number<std::uint32_t>())); }

    // A property's value; empty for an unknown type.
    std::optional<TdmsValue> value(std::uint32_t type) {
        if (type == tdms_string) {
            return TdmsValue{std::nullopt, to_utf8(string())};
        }
        if (type == tdms_time) {
            const bool seconds_first = big_endian_;
            const auto first = number<std::uint64_t>();
            const auto second = number<std::uint64_t>();
            const auto seconds = static_cast<std::int64_t>(seconds_first ? first : second);
            return TdmsValue{std::nullopt, time_text(seconds, seconds_first ? second : first)};
        }
        const auto size = tdms_bytes(type);
        if (!size) {
            return std::nullopt;
        }
        const std::string_view content = bytes(static_cast<std::size_t>(*size));
        TdmsValue value;
        if (const auto number_type = tdms_number(type); number_type && !ended_) {
            double number = 0;
            decode(*number_type, big_endian_, content.data(), *size, {}, {&number, 1});
            value.number = number;
        }
        return value;
    }

    bool ended() const { return ended_; }

private:
    std::string bytes_;
    std::string_view rest_;
    bool big_endian_;
    bool ended_ = false;
};

namespace {

// The object of a path: /'group'/'channel', a quote within a name written twice; "/" is the file
// itself. Empty for other texts.
std::optional<TdmsObject> tdms_object(const std::string& path) {
    if (path == "/") {
        return TdmsObject{};
    }
    std::vector<std::string> names;
    std::string_view rest = path;
    while (rest.starts_with("/'")) {
        rest.remove_prefix(2);
        std::string name;
        for (bool open = true; open;) {
            const std::size_t quote = rest.find('\'');
            if (quote == rest.npos) {
                return std::nullopt;
            }
            name += rest.substr(0, quote);
            rest.remove_prefix(quote + 1);
            open = rest.starts_with('\'');
            if (open) {
                name += '\'';
                rest.remove_prefix(1);
            }
        }
        names.push_back(name);
    }
    if (!rest.empty() || names.empty() || names.size() > 2) {
        return std::nullopt;
    }
    return TdmsObject{to_utf8(names[0]), names.size() == 2 ? to_utf8(names[1]) : ""};
}

constexpr std::uint64_t most_values = std::uint64_t{1} << 40;  // of an object in a chunk
constexpr std::int64_t widest_row = std::int64_t{1} << 20;     // bytes of all buffers' rows

// Raw indices of DAQmx. The published layout numbers digital lines 0x1369, the driver 0x126A.
constexpr std::uint32_t format_changing = 0x1269;
constexpr std::uint32_t digital_lines = 0x126A;
constexpr std::uint32_t digital_lines_as_published = 0x1369;

// Type of a scaler, which has a separate numbering; empty for times and unknown types.
std::optional<NumberType> scaler_type(std::uint32_t code) {
    constexpr std::array types{NumberType::u8,  NumberType::i8,  NumberType::u16, NumberType::i16,
                               NumberType::u32, NumberType::i32, NumberType::u64, NumberType::i64,
                               NumberType::f32, NumberType::f64};
    return code < types.size() ? std::optional(types[code]) : std::nullopt;
}

TdmsScaler take_scaler(TdmsMetadata& metadata, bool is_digital) {
    TdmsScaler scaler;
    const auto type = metadata.number<std::uint32_t>();
    scaler.buffer = metadata.number<std::uint32_t>();
    scaler.offset = metadata.number<std::uint32_t>();
    if (is_digital) {
        scaler.offset /= 8;  // in bits
        metadata.bytes(1);   // the bitmap of the sample's format
    } else {
        scaler.type = scaler_type(type);
        metadata.bytes(4);
    }
    scaler.id = metadata.number<std::uint32_t>();
    return scaler;
}

// Whether each scaler lies inside a row of its buffer.
bool fits(const TdmsRawIndex& index) {
    const auto buffers = static_cast<std::int64_t>(index.widths.size());
    return std::accumulate(index.widths.begin(), index.widths.end(), std::int64_t{0}) <=
               widest_row &&
           std::ranges::all_of(index.scalers, [&](const TdmsScaler& scaler) {
               return scaler.buffer < buffers &&
                      scaler.offset + (scaler.type ? bytes_of(*scaler.type) : 1) <=
                          index.widths[static_cast<std::size_t>(scaler.buffer)];
           });
}

constexpr std::int64_t lead_in_bytes = 28;
constexpr std::string_view tag = "TDSm";
constexpr std::size_t most_objects = 10000;

// The table of contents: bits in a segment's lead-in.
constexpr std::uint32_t has_metadata = 1u << 1;
constexpr std::uint32_t has_new_list = 1u << 2;
constexpr std::uint32_t has_raw_data = 1u << 3;
constexpr std::uint32_t is_interleaved = 1u << 5;
constexpr std::uint32_t is_big_endian = 1u << 6;
constexpr std::uint32_t has_daqmx_data = 1u << 7;

constexpr std::uint64_t never_closed = std::numeric_limits<std::uint64_t>::max();
constexpr std::size_t most_kept = 50000;  // properties

// Whether a property describes samples.
bool is_kept(std::string_view name) {
    constexpr std::array<std::string_view, 6> names{"wf_increment",  "wf_xunit_string",
                                                    "wf_start_time", "wf_start_offset",
                                                    "unit_string",   "NI_Number_Of_Scales"};
    return name.starts_with("NI_Scal") || std::ranges::find(names, name) != names.end();
}

}  // namespace

TdmsFile::TdmsFile(std::shared_ptr<const FileBytes> file, const JobControl& job)
    : file_(std::move(file)), job_(job) {}

Status TdmsFile::walk(const Visitor& visit) {
    const std::int64_t file_size = file_->size();
    for (std::int64_t at = 0; at < file_size;) {
        TRY(job_.go_on());
        std::array<char, lead_in_bytes> bytes{};
        const auto got = TRY(file_->read(at, bytes));
        if (got < lead_in_bytes) {
            open_ended_ = true;
            break;
        }
        if (!std::string_view(bytes.data(), bytes.size()).starts_with(tag)) {
            return file_->damaged(
                "TDMS", VYBEG_MESSAGE("Words", "there is no segment where one should begin"));
        }
        const auto contents = load<std::uint32_t>(bytes.data() + 4, false);  // in all files
        const auto has = [contents](std::uint32_t bit) { return (contents & bit) != 0; };
        const bool big_endian = has(is_big_endian);
        // Where the next segment and the raw data begin, from the end of the lead-in.
        const auto next = load<std::uint64_t>(bytes.data() + 12, big_endian);
        const auto raw = load<std::uint64_t>(bytes.data() + 20, big_endian);
        const auto room = static_cast<std::uint64_t>(file_size - at - lead_in_bytes);
        const bool closed = next != never_closed;
        if (raw > room) {
            open_ended_ = true;  // within its metadata
            break;
        }
        if (closed && next < raw) {
            return file_->damaged("TDMS",
                                  VYBEG_MESSAGE("Words", "a segment ends before its raw data"));
        }
        const std::int64_t metadata_at = at + lead_in_bytes;
        const auto metadata_size = static_cast<std::int64_t>(raw);
        if (has(has_metadata)) {
            TRY(take_metadata(metadata_at, metadata_size, big_endian, has(has_new_list)));
        }
        const auto daqmx = std::ranges::count_if(chunk_, &TdmsRawIndex::is_daqmx);
        const bool all = daqmx == static_cast<std::ptrdiff_t>(chunk_.size());
        if (has(has_raw_data) && !(all || (daqmx == 0 && !has(has_daqmx_data)))) {
            return file_->unsupported(
                "TDMS", VYBEG_MESSAGE("Words", "raw data of DAQmx that not all channels describe"));
        }
        TdmsSegment segment;
        segment.offset = metadata_at + metadata_size;
        segment.interleaved = has(is_interleaved);
        segment.big_endian = big_endian;
        segment.last = !closed || next >= room;
        segment.size = static_cast<std::int64_t>(std::min(next, room) - raw);
        if (closed) {
            constexpr auto most =
                static_cast<std::uint64_t>(std::numeric_limits<std::int64_t>::max());
            segment.promised = static_cast<std::int64_t>(std::min(next, most)) - metadata_size;
        }
        open_ended_ = open_ended_ || !closed;
        if (has(has_raw_data)) {
            TRY(visit(segment, chunk_));
        }
        at = segment.last ? file_size : segment.offset + segment.size;
    }
    return {};
}

Status TdmsFile::take_metadata(std::int64_t offset, std::int64_t size, bool big_endian,
                               bool new_list) {
    std::string bytes(static_cast<std::size_t>(size), '\0');
    TRY(file_->read(offset, bytes));
    TdmsMetadata metadata(std::move(bytes), big_endian);
    if (new_list) {
        chunk_.clear();
    }
    const auto objects = metadata.number<std::uint32_t>();
    for (std::uint32_t i = 0; i < objects && !metadata.ended(); ++i) {
        const std::string path = metadata.string();
        if (!metadata.ended()) {
            const auto object = TRY(object_named(path));
            TRY(list_raw_index(metadata, object));
            TRY(take_properties(metadata, objects_[object]));
        }
    }
    return metadata.ended()
               ? file_->damaged("TDMS", VYBEG_MESSAGE("Words", "its metadata end too early"))
               : Status{};
}

Result<std::size_t> TdmsFile::object_named(const std::string& path) {
    if (const auto known = places_.find(path); known != places_.end()) {
        return known->second;
    }
    auto object = tdms_object(path);
    if (!object) {
        return file_->damaged("TDMS",
                              VYBEG_MESSAGE("Words", "the name of an object cannot be understood"));
    }
    if (objects_.size() == most_objects) {
        return too_many_parts(file_->path().string(), "TDMS",
                              VYBEG_MESSAGE("Words", "it has more than %1 objects"), most_objects);
    }
    const std::size_t place = objects_.size();
    places_.emplace(path, place);
    objects_.push_back(std::move(*object));
    known_.emplace_back();
    return place;
}

Status TdmsFile::list_raw_index(TdmsMetadata& metadata, std::size_t object) {
    const auto length = metadata.number<std::uint32_t>();
    const auto listed = std::ranges::find(chunk_, object, &TdmsRawIndex::object);
    if (length == tdms_no_raw_data) {
        if (listed != chunk_.end()) {
            chunk_.erase(listed);
        }
        return {};
    }
    std::optional<TdmsRawIndex>& known = known_[object];
    if (length != tdms_same_as_before) {
        auto index = TRY(raw_index(metadata, length));
        index.object = object;
        known = std::move(index);
    }
    if (!known) {
        return file_->damaged(
            "TDMS", VYBEG_MESSAGE("Words",
                                  "a channel's raw data are as before, and there are none before"));
    }
    if (listed != chunk_.end()) {
        *listed = *known;
    } else {
        chunk_.push_back(*known);
    }
    return {};
}

// An object's raw index, whose first number was `length`.
Result<TdmsRawIndex> TdmsFile::raw_index(TdmsMetadata& metadata, std::uint32_t length) const {
    TdmsRawIndex index;
    const bool is_digital = length == digital_lines || length == digital_lines_as_published;
    index.is_daqmx = is_digital || length == format_changing;
    index.type = metadata.number<std::uint32_t>();
    const auto dimensions = metadata.number<std::uint32_t>();
    const auto count = metadata.number<std::uint64_t>();
    std::uint64_t bytes = 0;
    if (index.is_daqmx) {
        const auto scalers = metadata.number<std::uint32_t>();
        for (std::uint32_t i = 0; i < scalers && !metadata.ended(); ++i) {
            index.scalers.push_back(take_scaler(metadata, is_digital));
        }
        const auto buffers = metadata.number<std::uint32_t>();
        for (std::uint32_t i = 0; i < buffers && !metadata.ended(); ++i) {
            index.widths.push_back(metadata.number<std::uint32_t>());
        }
    } else {
        bytes = index.type == tdms_string
                    ? metadata.number<std::uint64_t>()
                    : count * static_cast<std::uint64_t>(tdms_bytes(index.type).value_or(0));
    }
    if (metadata.ended() || dimensions != 1 || count > most_values || bytes > 16 * most_values ||
        !fits(index)) {
        return file_->damaged(
            "TDMS",
            VYBEG_MESSAGE("Words", "the raw data of a channel cannot be as its index says"));
    }
    if (!index.is_daqmx && index.type != tdms_string && !tdms_bytes(index.type)) {
        return file_->unsupported("TDMS", VYBEG_MESSAGE("Words", "values of the type %1"),
                                  {count_arg(index.type)});
    }
    index.count = static_cast<std::int64_t>(count);
    index.bytes = static_cast<std::int64_t>(bytes);
    return index;
}

Status TdmsFile::take_properties(TdmsMetadata& metadata, TdmsObject& object) {
    const auto properties = metadata.number<std::uint32_t>();
    for (std::uint32_t i = 0; i < properties && !metadata.ended(); ++i) {
        const std::string name = metadata.string();
        const auto type = metadata.number<std::uint32_t>();
        auto value = metadata.value(type);
        if (metadata.ended()) {
            break;
        }
        if (!value) {
            return file_->unsupported("TDMS", VYBEG_MESSAGE("Words", "a property of the type %1"),
                                      {count_arg(type)});
        }
        if (is_kept(name)) {
            kept_ += object.properties.insert_or_assign(name, std::move(*value)).second ? 1 : 0;
            if (kept_ > most_kept) {
                return too_many_parts(
                    file_->path().string(), "TDMS",
                    VYBEG_MESSAGE("Words", "it has more than %1 properties of scales"), most_kept);
            }
        }
    }
    return {};
}

namespace {

constexpr double raw_numbers = 0xFFFFFFFF;  // as the input source of a scale
constexpr double most_scales = 1000;

std::string scale_name(int index, const std::string& rest) {
    return "NI_Scale[" + std::to_string(index) + "]_" + rest;
}

// The scales of one object.
class Scales {
public:
    Scales(const FileBytes& file, const TdmsObject& channel, const TdmsObject& owner)
        : file_(file), channel_(channel), owner_(owner) {}

    // Number of scales by the file, otherwise of those described.
    double count() const {
        if (const auto told = owner_.number("NI_Number_Of_Scales")) {
            return *told;
        }
        int found = 0;
        while (found < most_scales && !type_of(found).empty()) {
            ++found;
        }
        return found;
    }

    Result<TdmsScaling> read() const {
        const double scales = count();
        if (!(scales <= most_scales)) {
            return damaged(
                VYBEG_MESSAGE("Words", "the channel %1 has an impossible number of scales"));
        }
        TdmsScaling scaling;
        // From the last scale back to the raw numbers; the step found first is applied last.
        auto index = static_cast<int>(scales) - 1;
        for (int seen = 0;; ++seen) {
            const std::string type = type_of(index);
            if (type.empty()) {  // raw number of DAQmx with this id
                scaling.scaler = static_cast<std::uint32_t>(index);
                break;
            }
            if (seen > scales) {
                return damaged(VYBEG_MESSAGE(
                    "Words", "the channel %1 has scales that are each other's input"));
            }
            TRY(take(type, index, scaling));
            const double input = number(index, type + "_Input_Source").value_or(raw_numbers);
            if (input == raw_numbers || input == -1) {
                break;
            }
            if (!(input >= 0 && input < scales)) {
                return damaged(VYBEG_MESSAGE(
                    "Words", "the channel %1 has a scale whose input does not exist"));
            }
            index = static_cast<int>(input);
        }
        std::reverse(scaling.steps.begin(), scaling.steps.end());
        fold(scaling);
        return scaling;
    }

private:
    std::string type_of(int index) const { return owner_.text(scale_name(index, "Scale_Type")); }
    std::optional<double> number(int index, const std::string& rest) const {
        return owner_.number(scale_name(index, rest));
    }

    Status take(const std::string& type, int index, TdmsScaling& scaling) const {
        if (type == "Linear") {
            const auto slope = number(index, "Linear_Slope");
            const auto intercept = number(index, "Linear_Y_Intercept");
            if (!slope || !intercept) {
                return damaged(VYBEG_MESSAGE(
                    "Words", "the channel %1 has a linear scale without slope or intercept"));
            }
            scaling.steps.push_back({*intercept, *slope});
        } else if (type == "Polynomial") {
            constexpr double usual = 4;
            const double size = number(index, "Polynomial_Coefficients_Size").value_or(usual);
            Polynomial coefficients;
            for (int i = 0; i < size; ++i) {
                const auto value =
                    number(index, "Polynomial_Coefficients[" + std::to_string(i) + "]");
                if (!value || !std::isfinite(*value)) {
                    return damaged(VYBEG_MESSAGE(
                        "Words",
                        "the channel %1 has a polynomial scale without all of its coefficients"));
                }
                coefficients.push_back(*value);
            }
            scaling.steps.push_back(std::move(coefficients));
        } else {
            return file_.unsupported(
                "TDMS", VYBEG_MESSAGE("Words", "a scale of the kind \"%1\" (channel %2)"),
                {type, channel_.channel});
        }
        return {};
    }

    // Moves linear steps at the beginning into the scale of the decoder.
    static void fold(TdmsScaling& scaling) {
        auto& steps = scaling.steps;
        while (!steps.empty() && steps.front().size() == 2) {
            const double offset = steps.front()[0];
            const double slope = steps.front()[1];
            scaling.linear.gain *= slope;
            scaling.linear.offset = scaling.linear.offset * slope + offset;
            steps.erase(steps.begin());
        }
    }

    // %1 is the channel.
    Error damaged(const char* text) const {
        return file_.damaged("TDMS", text, {channel_.channel});
    }

    const FileBytes& file_;
    const TdmsObject& channel_;
    const TdmsObject& owner_;
};

}  // namespace

Result<TdmsScaling> tdms_scaling(const FileBytes& file,
                                 const std::vector<const TdmsObject*>& nearest_first) {
    for (const TdmsObject* owner : nearest_first) {
        const Scales scales(file, *nearest_first.front(), *owner);
        if (owner->text("NI_Scaling_Status") == "scaled") {
            break;
        }
        if (scales.count() >= 1) {
            return scales.read();
        }
    }
    return TdmsScaling{};
}

}  // namespace vybeg
