#include "core/recording/arrays/tdms_segments.h"

#include "core/recording/bytes/number_type.h"

#include <algorithm>
#include <array>
#include <limits>
#include <utility>

namespace vybeg {
namespace {

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

constexpr std::size_t most_kept = 50000;

// Whether a property describes samples.
bool is_kept(std::string_view name) {
    constexpr std::array<std::string_view, 6> names{"wf_increment",  "wf_xunit_string",
                                                    "wf_start_time", "wf_start_offset",
                                                    "unit_string",   "NI_Number_Of_Scales"};
    return name.starts_with("NI_Scal") ||
           std::find(names.begin(), names.end(), name) != names.end();
}

struct LeadIn {
    std::uint32_t contents = 0;
    std::uint64_t next = 0;  // of the next segment and of the raw data, from the lead-in's end
    std::uint64_t raw = 0;

    bool has(std::uint32_t bit) const { return (contents & bit) != 0; }
};

LeadIn parse_lead_in(const char* bytes) {
    LeadIn lead_in;
    lead_in.contents = load<std::uint32_t>(bytes + 4, false);  // little endian in all files
    const bool big_endian = lead_in.has(is_big_endian);
    lead_in.next = load<std::uint64_t>(bytes + 12, big_endian);
    lead_in.raw = load<std::uint64_t>(bytes + 20, big_endian);
    return lead_in;
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
        const LeadIn lead_in = parse_lead_in(bytes.data());
        const auto room = static_cast<std::uint64_t>(file_size - at - lead_in_bytes);
        const bool closed = lead_in.next != never_closed;
        if (lead_in.raw > room) {
            open_ended_ = true;  // within its metadata
            break;
        }
        if (closed && lead_in.next < lead_in.raw) {
            return file_->damaged("TDMS",
                                  VYBEG_MESSAGE("Words", "a segment ends before its raw data"));
        }
        const std::int64_t metadata_at = at + lead_in_bytes;
        const auto metadata_size = static_cast<std::int64_t>(lead_in.raw);
        const bool big_endian = lead_in.has(is_big_endian);
        if (lead_in.has(has_metadata)) {
            TRY(take_metadata(metadata_at, metadata_size, big_endian, lead_in.has(has_new_list)));
        }
        const auto daqmx = std::count_if(chunk_.begin(), chunk_.end(),
                                         [](const TdmsRawIndex& index) { return index.is_daqmx; });
        const bool all = daqmx == static_cast<std::ptrdiff_t>(chunk_.size());
        if (lead_in.has(has_raw_data) && !(all || (daqmx == 0 && !lead_in.has(has_daqmx_data)))) {
            return file_->unsupported(
                "TDMS", VYBEG_MESSAGE("Words", "raw data of DAQmx that not all channels describe"));
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
        open_ended_ = open_ended_ || !closed;
        if (lead_in.has(has_raw_data)) {
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
    for (std::uint32_t i = 0; i < objects; ++i) {
        TRY(take_object(metadata));
    }
    return metadata.ended()
               ? file_->damaged("TDMS", VYBEG_MESSAGE("Words", "its metadata end too early"))
               : Status{};
}

Status TdmsFile::take_object(TdmsMetadata& metadata) {
    const auto object = object_named(metadata.string());
    if (metadata.ended()) {
        return file_->damaged("TDMS", VYBEG_MESSAGE("Words", "its metadata end too early"));
    }
    if (!object) {
        return object.error();
    }
    TRY(list_raw_index(metadata, *object));
    return take_properties(metadata, objects_[*object]);
}

Result<std::size_t> TdmsFile::object_named(const std::string& path) {
    const auto known = places_.find(path);
    if (known != places_.end()) {
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
    const auto listed =
        std::find_if(chunk_.begin(), chunk_.end(),
                     [object](const TdmsRawIndex& index) { return index.object == object; });
    if (length == tdms_no_raw_data) {
        if (listed != chunk_.end()) {
            chunk_.erase(listed);
        }
        return {};
    }
    std::optional<TdmsRawIndex>& known = known_[object];
    if (length != tdms_same_as_before) {
        TdmsRawIndex index;
        index.object = object;
        if (const Status taken = take_raw_index(metadata, length, index); !taken) {
            return file_->error(taken.error().code, taken.error().args);
        }
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

// Layout of a chunk, and position of the channel in it.
struct Chunk {
    std::int64_t size = 0;    // bytes
    std::int64_t offset = 0;  // of the channel's first value
    std::int64_t stride = 0;  // from value to value
    std::int64_t width = 0;   // of a value
    std::int64_t count = 0;   // of the channel's values; 0: the channel is absent
    bool by_rows = false;     // a value of each channel in turn
};

Chunk chunk_for(std::size_t object, const std::vector<TdmsRawIndex>& indices, bool interleaved) {
    Chunk chunk;
    chunk.by_rows = interleaved;
    std::int64_t row = 0;
    for (const TdmsRawIndex& index : indices) {
        const std::int64_t width = tdms_bytes(index.type).value_or(0);
        if (index.object == object) {
            chunk.offset = interleaved ? row : chunk.size;
            chunk.width = width;
            chunk.count = index.count;
        }
        row += width;
        chunk.size += index.bytes;
    }
    chunk.stride = interleaved ? row : chunk.width;
    return chunk;
}

// The same for DAQmx: consecutive buffers, each with as many rows as its longest channel has
// values. Empty if the channels contradict each other about the buffers.
std::optional<Chunk> daqmx_chunk_for(std::size_t object, std::uint32_t scaler_id,
                                     const std::vector<TdmsRawIndex>& indices) {
    const std::vector<std::int64_t>& widths = indices.front().widths;
    std::vector<std::int64_t> rows(widths.size());
    for (const TdmsRawIndex& index : indices) {
        if (index.widths != widths) {
            return std::nullopt;
        }
        for (const TdmsScaler& scaler : index.scalers) {
            std::int64_t& most = rows[static_cast<std::size_t>(scaler.buffer)];
            most = std::max(most, index.count);
        }
    }
    std::vector<std::int64_t> starts;
    Chunk chunk;
    chunk.by_rows = true;
    for (std::size_t i = 0; i < widths.size(); ++i) {
        starts.push_back(chunk.size);
        chunk.size += rows[i] * widths[i];
    }
    for (const TdmsRawIndex& index : indices) {
        for (const TdmsScaler& scaler : index.scalers) {
            if (index.object == object && scaler.id == scaler_id && scaler.type) {
                const auto buffer = static_cast<std::size_t>(scaler.buffer);
                chunk.offset = starts[buffer] + scaler.offset;
                chunk.stride = widths[buffer];
                chunk.width = bytes_of(*scaler.type);
                chunk.count = index.count;
            }
        }
    }
    return chunk;
}

// Values of the channel in the first `bytes` bytes of a chunk.
std::int64_t values_in(const Chunk& chunk, std::int64_t bytes) {
    const std::int64_t room = bytes - chunk.offset - chunk.width;
    return room < 0 || chunk.count == 0 ? 0 : std::min(chunk.count, room / chunk.stride + 1);
}

// A last chunk of `bytes` bytes, divided in proportion among the channels. Empty if a product would
// exceed any file size.
std::optional<Chunk> shared_out(Chunk chunk, std::size_t object, std::int64_t bytes,
                                const std::vector<TdmsRawIndex>& indices) {
    constexpr std::int64_t most = std::numeric_limits<std::int64_t>::max();
    std::int64_t at = 0;
    for (const TdmsRawIndex& index : indices) {
        if (index.count > 0 && bytes > most / index.count) {
            return std::nullopt;
        }
        const std::int64_t values = index.count * bytes / chunk.size;
        if (index.object == object) {
            chunk.offset = at;
            chunk.count = values;
        }
        at += values * tdms_bytes(index.type).value_or(0);
    }
    return chunk;
}

bool has_texts(const std::vector<TdmsRawIndex>& indices) {
    return std::any_of(indices.begin(), indices.end(), [](const TdmsRawIndex& index) {
        return index.count > 0 && !tdms_bytes(index.type);
    });
}

}  // namespace

std::optional<const char*> TdmsRanges::take(const TdmsSegment& segment,
                                            const std::vector<TdmsRawIndex>& indices) {
    const bool is_daqmx = !indices.empty() && indices.front().is_daqmx;
    if (segment.interleaved && !is_daqmx &&
        std::any_of(indices.begin(), indices.end(), [&](const TdmsRawIndex& index) {
            return index.count != indices.front().count || !tdms_bytes(index.type);
        })) {
        return VYBEG_MESSAGE("Words", "channels of different lengths are interleaved");
    }
    const auto made = is_daqmx ? daqmx_chunk_for(object_, scaler_, indices)
                               : std::optional(chunk_for(object_, indices, segment.interleaved));
    if (!made) {
        return VYBEG_MESSAGE("Words", "its channels do not agree on the width of a row");
    }
    const Chunk& chunk = *made;
    if (chunk.size == 0) {
        return std::nullopt;
    }
    const std::int64_t whole = segment.size / chunk.size;
    const std::int64_t rest = segment.size % chunk.size;
    if (rest != 0 && !segment.last) {
        return VYBEG_MESSAGE("Words", "a segment ends within a chunk of its raw data");
    }
    if (chunk.count == 0) {
        return std::nullopt;
    }
    StridedRange range;
    range.count = whole * chunk.count;
    range.per_chunk = chunk.count;
    range.offset = segment.offset + chunk.offset;
    range.stride = chunk.stride;
    range.chunk_stride = chunk.size;
    range.big_endian = segment.big_endian;

    // The number of values of an unclosed segment is that of its whole chunks.
    const std::int64_t bytes = segment.promised.value_or(segment.size);
    const std::int64_t last = bytes % chunk.size;
    promised_ += bytes / chunk.size * chunk.count;
    if (!segment.promised || last == 0 || chunk.by_rows) {
        promised_ += last == 0 ? 0 : segment.promised ? values_in(chunk, last) : chunk.count;
        range.count += values_in(chunk, rest);
        append(range);
        return std::nullopt;
    }
    const auto share = shared_out(chunk, object_, last, indices);
    if (!share) {
        return VYBEG_MESSAGE("Words", "it promises more samples than any file can hold");
    }
    promised_ += share->count;
    if (whole < bytes / chunk.size) {  // cut before its last chunk
        range.count += values_in(chunk, rest);
        append(range);
        return std::nullopt;
    }
    append(range);
    // The number of text bytes in a shorter chunk is unknown.
    StridedRange end = range;
    end.count = has_texts(indices) ? 0 : values_in(*share, rest);
    end.per_chunk = std::max<std::int64_t>(share->count, 1);
    end.offset = segment.offset + whole * chunk.size + share->offset;
    end.chunk_stride = end.per_chunk * end.stride;
    append(end);
    return std::nullopt;
}

void TdmsRanges::append(StridedRange range) {
    if (range.count == 0) {
        return;
    }
    range.first = ranges_.empty() ? 0 : ranges_.back().end();
    if (!ranges_.empty()) {
        StridedRange& before = ranges_.back();
        const std::int64_t chunks = before.count / before.per_chunk;
        const std::int64_t step = range.offset - before.offset - (chunks - 1) * before.chunk_stride;
        const bool alike = before.per_chunk == range.per_chunk && before.stride == range.stride &&
                           before.big_endian == range.big_endian &&
                           before.count % before.per_chunk == 0;
        if (alike && (chunks == 1 || before.chunk_stride == step) &&
            (range.count <= range.per_chunk || range.chunk_stride == step)) {
            before.chunk_stride = step;
            before.count += range.count;
            return;
        }
    }
    ranges_.push_back(range);
}

}  // namespace vybeg
