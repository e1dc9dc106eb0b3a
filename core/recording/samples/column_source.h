#pragma once

#include "core/recording/bytes/byte_source.h"
#include "core/recording/bytes/number_type.h"
#include "core/recording/samples/sample_source.h"

#include <cstdint>
#include <memory>
#include <vector>

namespace vybeg {

// A stretch of one channel: chunks of equally many samples, all distances in bytes.
struct SampleRun {
    std::int64_t first = 0;         // frame of its first sample
    std::int64_t count = 0;         // samples in all; the last chunk may be shorter
    std::int64_t per_chunk = 0;     // samples in a chunk
    std::int64_t offset = 0;        // of the first sample
    std::int64_t stride = 0;        // from sample to sample within a chunk
    std::int64_t chunk_stride = 0;  // from chunk to chunk
    bool big_endian = false;

    std::int64_t end() const { return first + count; }
};

// Samples at equal distances, all in one chunk.
SampleRun even_run(std::int64_t count, std::int64_t offset, std::int64_t stride, bool big_endian);

// Where the samples of one channel stand in a binary file.
struct SampleColumn {
    std::shared_ptr<const ByteSource> bytes;
    NumberType type = NumberType::f64;
    std::vector<SampleRun> runs;  // one after the other, without gaps between their frames
    Scale scale{};

    std::int64_t frames() const { return runs.empty() ? 0 : runs.back().end(); }
};

// Two channels read on demand; as many frames as the shorter one has. Columns with the same `bytes`
// that lie side by side are read together. Precondition: every sample of the runs lies inside of
// the bytes, and offsets rise within a run.
std::shared_ptr<const SampleSource> column_source(SampleColumn c, SampleColumn d);

}  // namespace vybeg
