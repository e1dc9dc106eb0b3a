#pragma once

#include "core/base/job_control.h"
#include "core/base/result.h"
#include "core/recording/bytes/file_bytes.h"
#include "core/recording/bytes/number_type.h"
#include "core/recording/samples/recording.h"
#include "core/recording/samples/sample_source.h"

#include <cstdint>
#include <memory>
#include <optional>
#include <vector>

namespace vybeg {

// Range of samples of one channel: chunks of equal numbers of samples; distances in bytes.
struct StridedRange {
    std::int64_t first = 0;         // frame of its first sample
    std::int64_t count = 0;         // total samples; the last chunk may be shorter
    std::int64_t per_chunk = 0;     // samples in a chunk
    std::int64_t offset = 0;        // of the first sample
    std::int64_t stride = 0;        // from sample to sample within a chunk
    std::int64_t chunk_stride = 0;  // from chunk to chunk
    bool big_endian = false;

    std::int64_t end() const { return first + count; }
};

// Samples at equal distances, all in one chunk.
StridedRange contiguous_range(std::int64_t count, std::int64_t offset, std::int64_t stride,
                              bool big_endian);

// Positions of the samples of one channel in a binary file.
struct SampleColumn {
    std::shared_ptr<const ByteSource> bytes;
    NumberType type = NumberType::f64;
    std::vector<StridedRange> ranges;  // consecutive, without gaps between their frames
    Scale scale{};

    std::int64_t frames() const { return ranges.empty() ? 0 : ranges.back().end(); }
};

// Samples of several channels, all of one type: frame after frame or channel after channel.
struct NumberArray {
    NumberType type = NumberType::f64;
    Scale scale{};
    bool big_endian = false;
    std::int64_t channels = 1;
    std::int64_t offset = 0;  // of the first sample, bytes
    std::int64_t frames = 0;
    bool interleaved = true;  // frame after frame
};

// Positions of the samples of a channel (from 0) within the bytes, possibly fewer than the array's
// frames.
SampleColumn array_column(const NumberArray& array, std::shared_ptr<const ByteSource> bytes,
                          std::int64_t channel);

// Fills `out` with the samples of a column from the frame `first` on. Precondition: as below.
Status read_column(const SampleColumn& column, std::int64_t first, std::span<double> out);

// Source of two channels, read on demand, with as many frames as the shorter one. Adjacent columns
// with the same `bytes` are read together. Precondition: every sample lies inside the bytes, with
// ascending offsets within a range.
std::shared_ptr<const SampleSource> column_source(SampleColumn c, SampleColumn d);

// The same of two channels, from 1, of an array in a file.
std::shared_ptr<const SampleSource> array_source(const std::shared_ptr<const FileBytes>& file,
                                                 const NumberArray& array, int c, int d);

// The rate by a column of times that count in `unit_s` seconds: it rises by even steps below a
// second, and does not count the rows. Nothing for any other column. Errors: those of reading;
// interrupted.
Result<std::optional<SampleRate>> rate_of_times(const SampleColumn& column, double unit_s,
                                                const JobControl& job);

}  // namespace vybeg
