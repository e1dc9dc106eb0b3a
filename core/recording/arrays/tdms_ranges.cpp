#include "core/recording/arrays/tdms_ranges.h"

#include "core/recording/arrays/tdms_values.h"

#include <algorithm>
#include <limits>

namespace vybeg {
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
