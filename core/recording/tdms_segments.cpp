#include "core/recording/tdms_segments.h"

#include "core/recording/byte_order.h"
#include "core/recording/tdms_values.h"
#include "core/recording/text_encoding.h"

#include <algorithm>
#include <array>
#include <limits>
#include <utility>

namespace vybeg {
namespace {

constexpr std::int64_t lead_in_bytes = 28;
constexpr std::string_view tag = "TDSm";
constexpr std::size_t most_objects = 10000;
constexpr std::uint64_t most_values = std::uint64_t{1} << 40;  // of an object in a chunk

// The table of contents: bits in a segment's lead-in.
constexpr std::uint32_t has_metadata = 1u << 1;
constexpr std::uint32_t has_new_list = 1u << 2;
constexpr std::uint32_t has_raw_data = 1u << 3;
constexpr std::uint32_t is_interleaved = 1u << 5;
constexpr std::uint32_t is_big_endian = 1u << 6;
constexpr std::uint32_t has_daqmx_data = 1u << 7;

// Instead of the length of an object's raw index.
constexpr std::uint32_t no_raw_data = 0xFFFFFFFF;
constexpr std::uint32_t same_as_before = 0;
constexpr std::array<std::uint32_t, 3> daqmx_indices{0x1269, 0x126A, 0x1369};

constexpr std::uint64_t never_closed = std::numeric_limits<std::uint64_t>::max();

constexpr std::array<std::string_view, 8> kept_properties{"wf_increment",
                                                          "wf_start_time",
                                                          "unit_string",
                                                          "NI_Scaling_Status",
                                                          "NI_Number_Of_Scales",
                                                          "NI_Scale[0]_Scale_Type",
                                                          "NI_Scale[0]_Linear_Slope",
                                                          "NI_Scale[0]_Linear_Y_Intercept"};

struct LeadIn {
    std::uint32_t contents = 0;
    std::uint64_t next = 0;  // of the next segment and of the raw data, from the lead-in's end
    std::uint64_t raw = 0;

    bool has(std::uint32_t bit) const { return (contents & bit) != 0; }
};

LeadIn parse_lead_in(const char* bytes) {
    LeadIn lead_in;
    lead_in.contents = load<std::uint32_t>(bytes + 4, false);  // in this order in all files
    const bool big_endian = lead_in.has(is_big_endian);
    lead_in.next = load<std::uint64_t>(bytes + 12, big_endian);
    lead_in.raw = load<std::uint64_t>(bytes + 20, big_endian);
    return lead_in;
}

}  // namespace

// The bytes of a segment's metadata, taken one value after the other. What lies behind their end
// reads as nothing, and ended() tells.
class TdmsFile::Metadata {
public:
    Metadata(std::string bytes, bool big_endian)
        : bytes_(std::move(bytes)), rest_(bytes_), big_endian_(big_endian) {}
    Metadata(const Metadata&) = delete;
    Metadata& operator=(const Metadata&) = delete;

    template <class Number>
    Number number() {
        if (rest_.size() < sizeof(Number)) {
            rest_ = {};
            ended_ = true;
            return {};
        }
        const auto value = load<Number>(rest_.data(), big_endian_);
        rest_.remove_prefix(sizeof(Number));
        return value;
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

    // A property's value; nothing where its type is not known.
    std::optional<TdmsValue> value(std::uint32_t type) {
        if (type == tdms_string) {
            return TdmsValue{std::nullopt, to_utf8(string())};
        }
        if (type == tdms_time) {
            const bool seconds_first = big_endian_;
            const auto first = number<std::uint64_t>();
            const auto second = number<std::uint64_t>();
            const auto seconds = static_cast<std::int64_t>(seconds_first ? first : second);
            return TdmsValue{std::nullopt, tdms_time_text(seconds, seconds_first ? second : first)};
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

TdmsFile::TdmsFile(std::shared_ptr<const FileBytes> file, const JobControl& job)
    : file_(std::move(file)), job_(job) {}

Error TdmsFile::damaged(const std::string& reason) const {
    return file_->error(ErrorCode::format_damaged, {"TDMS", reason});
}

Error TdmsFile::unsupported(const std::string& what) const {
    return file_->error(ErrorCode::format_unsupported, {"TDMS", what});
}

Status TdmsFile::walk(const Visitor& visit) {
    const std::int64_t file_size = file_->size();
    for (std::int64_t at = 0; at < file_size;) {
        if (job_.cancelled()) {
            return file_->error(ErrorCode::interrupted);
        }
        std::array<char, lead_in_bytes> bytes{};
        const auto got = file_->read(at, bytes);
        if (!got) {
            return got.error();
        }
        if (*got < lead_in_bytes) {
            incomplete_ = true;
            break;
        }
        if (!std::string_view(bytes.data(), bytes.size()).starts_with(tag)) {
            return damaged("there is no segment where one should begin");
        }
        const LeadIn lead_in = parse_lead_in(bytes.data());
        const auto room = static_cast<std::uint64_t>(file_size - at - lead_in_bytes);
        const bool closed = lead_in.next != never_closed;
        if (lead_in.raw > room) {
            incomplete_ = true;  // within its metadata
            break;
        }
        if (closed && lead_in.next < lead_in.raw) {
            return damaged("a segment ends before its raw data");
        }
        const std::int64_t metadata_at = at + lead_in_bytes;
        const auto metadata_size = static_cast<std::int64_t>(lead_in.raw);
        const bool big_endian = lead_in.has(is_big_endian);
        if (lead_in.has(has_metadata)) {
            const Status status =
                take_metadata(metadata_at, metadata_size, big_endian, lead_in.has(has_new_list));
            if (!status) {
                return status;
            }
        }
        if (lead_in.has(has_daqmx_data)) {
            return unsupported("raw data of DAQmx");
        }
        TdmsSegment segment;
        segment.offset = metadata_at + metadata_size;
        segment.interleaved = lead_in.has(is_interleaved);
        segment.big_endian = big_endian;
        segment.last = !closed || lead_in.next >= room;
        segment.size = static_cast<std::int64_t>(std::min(lead_in.next, room) - lead_in.raw);
        if (closed) {
            constexpr auto most =
                static_cast<std::uint64_t>(std::numeric_limits<std::int64_t>::max());
            segment.promised =
                static_cast<std::int64_t>(std::min(lead_in.next, most)) - metadata_size;
        }
        incomplete_ = incomplete_ || !closed || lead_in.next > room;
        if (lead_in.has(has_raw_data)) {
            if (const Status status = visit(segment, chunk_); !status) {
                return status;
            }
        }
        at = segment.last ? file_size : segment.offset + segment.size;
    }
    return {};
}

Status TdmsFile::take_metadata(std::int64_t offset, std::int64_t size, bool big_endian,
                               bool new_list) {
    std::string bytes(static_cast<std::size_t>(size), '\0');
    const auto got = file_->read(offset, bytes);
    if (!got) {
        return got.error();
    }
    Metadata metadata(std::move(bytes), big_endian);
    if (new_list) {
        chunk_.clear();
    }
    const auto objects = metadata.number<std::uint32_t>();
    for (std::uint32_t i = 0; i < objects; ++i) {
        if (const Status status = take_object(metadata); !status) {
            return status;
        }
    }
    return metadata.ended() ? damaged("its metadata end too early") : Status{};
}

Status TdmsFile::take_object(Metadata& metadata) {
    const auto object = object_named(metadata.string());
    if (metadata.ended()) {
        return damaged("its metadata end too early");
    }
    if (!object) {
        return object.error();
    }
    if (const Status status = take_raw_index(metadata, *object); !status) {
        return status;
    }
    return take_properties(metadata, objects_[*object]);
}

Result<std::size_t> TdmsFile::object_named(const std::string& path) {
    const auto known = places_.find(path);
    if (known != places_.end()) {
        return known->second;
    }
    const auto names = tdms_path(path);
    if (!names) {
        return damaged("the name of an object cannot be understood");
    }
    if (objects_.size() == most_objects) {
        return unsupported("more than " + std::to_string(most_objects) + " objects");
    }
    const std::size_t place = objects_.size();
    places_.emplace(path, place);
    objects_.push_back({to_utf8(names->group), to_utf8(names->channel), {}});
    known_.emplace_back();
    return place;
}

Status TdmsFile::take_raw_index(Metadata& metadata, std::size_t object) {
    const auto length = metadata.number<std::uint32_t>();
    const auto listed =
        std::find_if(chunk_.begin(), chunk_.end(),
                     [object](const TdmsRawIndex& index) { return index.object == object; });
    if (length == no_raw_data) {
        if (listed != chunk_.end()) {
            chunk_.erase(listed);
        }
        return {};
    }
    if (std::find(daqmx_indices.begin(), daqmx_indices.end(), length) != daqmx_indices.end()) {
        return unsupported("raw data of DAQmx");
    }
    std::optional<TdmsRawIndex>& known = known_[object];
    if (length != same_as_before) {
        TdmsRawIndex index;
        index.object = object;
        index.type = metadata.number<std::uint32_t>();
        const auto dimensions = metadata.number<std::uint32_t>();
        const auto count = metadata.number<std::uint64_t>();
        const auto size = index.type == tdms_string ? std::optional(1) : tdms_bytes(index.type);
        const std::uint64_t bytes = index.type == tdms_string
                                        ? metadata.number<std::uint64_t>()
                                        : count * static_cast<std::uint64_t>(size.value_or(0));
        if (metadata.ended() || dimensions != 1 || count > most_values ||
            bytes > 16 * most_values) {
            return damaged("the raw data of a channel cannot be as its index says");
        }
        if (!size) {
            return unsupported("values of the type " + std::to_string(index.type));
        }
        index.count = static_cast<std::int64_t>(count);
        index.bytes = static_cast<std::int64_t>(bytes);
        known = index;
    }
    if (!known) {
        return damaged("a channel's raw data are as before, and there are none before");
    }
    if (listed != chunk_.end()) {
        *listed = *known;
    } else {
        chunk_.push_back(*known);
    }
    return {};
}

Status TdmsFile::take_properties(Metadata& metadata, TdmsObject& object) {
    const auto properties = metadata.number<std::uint32_t>();
    for (std::uint32_t i = 0; i < properties && !metadata.ended(); ++i) {
        const std::string name = metadata.string();
        const auto type = metadata.number<std::uint32_t>();
        auto value = metadata.value(type);
        if (metadata.ended()) {
            break;
        }
        if (!value) {
            return unsupported("a property of the type " + std::to_string(type));
        }
        if (std::find(kept_properties.begin(), kept_properties.end(), name) !=
            kept_properties.end()) {
            object.properties[name] = std::move(*value);
        }
    }
    return metadata.ended() ? damaged("its metadata end too early") : Status{};
}

}  // namespace vybeg
