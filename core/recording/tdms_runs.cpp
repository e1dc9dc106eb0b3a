#include "core/recording/tdms_runs.h"

#include "core/recording/tdms_values.h"

#include <algorithm>

namespace vybeg {
namespace {

// How a chunk is made, and where in it the channel stands.
struct Chunk {
    std::int64_t size = 0;    // bytes
    std::int64_t offset = 0;  // of the channel's first value
    std::int64_t stride = 0;  // from value to value
    std::int64_t width = 0;   // of a value
    std::int64_t count = 0;   // of the channel's values; 0: it is not there
};

Chunk chunk_for(std::size_t object, const std::vector<TdmsRawIndex>& indices, bool interleaved) {
    Chunk chunk;
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

// Values of the channel in the first `bytes` bytes of a chunk.
std::int64_t values_in(const Chunk& chunk, std::int64_t bytes) {
    const std::int64_t room = bytes - chunk.offset - chunk.width;
    return room < 0 ? 0 : std::min(chunk.count, room / chunk.stride + 1);
}

}  // namespace

std::optional<std::string> TdmsRuns::take(const TdmsSegment& segment,
                                          const std::vector<TdmsRawIndex>& indices) {
    if (segment.interleaved &&
        std::any_of(indices.begin(), indices.end(), [&](const TdmsRawIndex& index) {
            return index.count != indices.front().count || !tdms_bytes(index.type);
        })) {
        return "channels of different lengths are interleaved";
    }
    const Chunk chunk = chunk_for(object_, indices, segment.interleaved);
    if (chunk.size == 0) {
        return std::nullopt;
    }
    const std::int64_t rest = segment.size % chunk.size;
    if (rest != 0 && !segment.last) {
        return "a segment ends within a chunk of its raw data";
    }
    if (chunk.count == 0) {
        return std::nullopt;
    }
    // A segment that was never closed promises as many whole chunks as it began.
    const std::int64_t bytes = segment.promised.value_or(segment.size);
    promised_ += (bytes / chunk.size + (bytes % chunk.size != 0 ? 1 : 0)) * chunk.count;

    SampleRun run;
    run.count = segment.size / chunk.size * chunk.count + values_in(chunk, rest);
    run.per_chunk = chunk.count;
    run.offset = segment.offset + chunk.offset;
    run.stride = chunk.stride;
    run.chunk_stride = chunk.size;
    run.big_endian = segment.big_endian;
    if (run.count > 0) {
        append(run);
    }
    return std::nullopt;
}

void TdmsRuns::append(SampleRun run) {
    run.first = runs_.empty() ? 0 : runs_.back().end();
    if (!runs_.empty()) {
        SampleRun& before = runs_.back();
        const std::int64_t chunks = before.count / before.per_chunk;
        const std::int64_t step = run.offset - before.offset - (chunks - 1) * before.chunk_stride;
        const bool alike = before.per_chunk == run.per_chunk && before.stride == run.stride &&
                           before.big_endian == run.big_endian &&
                           before.count % before.per_chunk == 0;
        if (alike && (chunks == 1 || before.chunk_stride == step) &&
            (run.count <= run.per_chunk || run.chunk_stride == step)) {
            before.chunk_stride = step;
            before.count += run.count;
            return;
        }
    }
    runs_.push_back(run);
}

}  // namespace vybeg
