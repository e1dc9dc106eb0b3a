#include "core/recording/samples/column_source.h"

#include "core/recording/times/uniform_times.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <span>
#include <utility>

namespace vybeg {
namespace {

// Bytes per read: large for the disk, small for the processor's cache.
constexpr std::int64_t block_bytes = std::int64_t{1} << 18;

// Memory for the bytes of a block, not initialised.
class Scratch {
public:
    std::span<char> room(std::size_t size) {
        if (size > size_) {
            bytes_ = std::make_unique_for_overwrite<char[]>(size);
            size_ = size;
        }
        return {bytes_.get(), size};
    }
    const char* data() const { return bytes_.get(); }

private:
    std::unique_ptr<char[]> bytes_;
    std::size_t size_ = 0;
};

// The bytes [begin, end) of a source.
struct ByteRange {
    std::int64_t begin = 0;
    std::int64_t end = 0;
    std::int64_t size() const { return end - begin; }
};

// Precondition: the column has the frame.
const StridedRange& range_at(const SampleColumn& column, std::int64_t frame) {
    const auto behind =
        std::upper_bound(column.ranges.begin(), column.ranges.end(), frame,
                         [](std::int64_t f, const StridedRange& range) { return f < range.first; });
    return *std::prev(behind);
}

std::int64_t place(const StridedRange& range, std::int64_t frame) {
    const std::int64_t at = frame - range.first;
    return range.offset + at / range.per_chunk * range.chunk_stride +
           at % range.per_chunk * range.stride;
}

// Number of samples from the frame on within one range and, except the first, within a block.
std::int64_t samples_in_block(const SampleColumn& column, std::int64_t frame) {
    const StridedRange& range = range_at(column, frame);
    const std::int64_t left = range.end() - frame;
    const std::int64_t in_chunk = range.per_chunk - (frame - range.first) % range.per_chunk;
    if (in_chunk > block_bytes / range.stride) {
        return std::min(left, std::max<std::int64_t>(block_bytes / range.stride, 1));
    }
    const std::int64_t rest = block_bytes - in_chunk * range.stride;
    return std::min(left, in_chunk + rest / range.chunk_stride * range.per_chunk);
}

// The bytes of `count` samples of one range.
ByteRange range_of(const SampleColumn& column, std::int64_t frame, std::int64_t count) {
    const StridedRange& range = range_at(column, frame);
    return {place(range, frame), place(range, frame + count - 1) + bytes_of(column.type)};
}

// Decodes samples of one range from bytes that begin at `begin` in the source.
void decode_block(const SampleColumn& column, std::int64_t frame, const char* bytes,
                  std::int64_t begin, std::span<double> out) {
    const StridedRange& range = range_at(column, frame);
    const auto length = static_cast<std::int64_t>(out.size());
    for (std::int64_t done = 0; done < length;) {
        const std::int64_t at = frame + done;
        const std::int64_t in_chunk = range.per_chunk - (at - range.first) % range.per_chunk;
        const std::int64_t count = std::min(length - done, in_chunk);
        decode(column.type, range.big_endian, bytes + (place(range, at) - begin), range.stride,
               column.scale,
               out.subspan(static_cast<std::size_t>(done), static_cast<std::size_t>(count)));
        done += count;
    }
}

// Whether the samples of `left` and `right` from a frame on are interleaved without gaps.
bool are_pairs(const SampleColumn& left, const SampleColumn& right, std::int64_t frame,
               std::int64_t count) {
    const StridedRange& range = range_at(left, frame);
    const StridedRange& next = range_at(right, frame);
    const std::int64_t width = bytes_of(left.type);
    const auto last = frame + count - 1;
    return left.type == right.type && left.scale == right.scale &&
           range.big_endian == next.big_endian && range.stride == 2 * width &&
           next.stride == 2 * width &&
           place(range, last) - place(range, frame) == (count - 1) * range.stride &&
           place(next, frame) == place(range, frame) + width &&
           place(next, last) == place(range, last) + width;
}

Status fetch(const ByteSource& source, ByteRange range, Scratch& bytes) {
    return source.read(range.begin, bytes.room(static_cast<std::size_t>(range.size())));
}

// Precondition: the samples lie within one range.
Status fetch_block(const SampleColumn& column, std::int64_t at, std::span<double> out,
                   Scratch& bytes) {
    const ByteRange range = range_of(column, at, static_cast<std::int64_t>(out.size()));
    TRY(fetch(*column.bytes, range, bytes));
    decode_block(column, at, bytes.data(), range.begin, out);
    return {};
}

// Precondition: the samples of each column lie within one range.
Status read_block(const SampleColumn& column_c, const SampleColumn& column_d, std::int64_t at,
                  std::span<double> c, std::span<double> d, Scratch& bytes) {
    const auto count = static_cast<std::int64_t>(c.size());
    const ByteRange range_c = range_of(column_c, at, count);
    const ByteRange range_d = range_of(column_d, at, count);
    const ByteRange both{std::min(range_c.begin, range_d.begin),
                         std::max(range_c.end, range_d.end)};
    if (column_c.bytes != column_d.bytes || both.size() > range_c.size() + range_d.size()) {
        TRY(fetch_block(column_c, at, c, bytes));
        return fetch_block(column_d, at, d, bytes);
    }
    TRY(fetch(*column_c.bytes, both, bytes));
    const bool big_endian = range_at(column_c, at).big_endian;
    if (are_pairs(column_c, column_d, at, count)) {
        decode_pairs(column_c.type, big_endian, bytes.data(), column_c.scale, c, d);
    } else if (are_pairs(column_d, column_c, at, count)) {
        decode_pairs(column_c.type, big_endian, bytes.data(), column_c.scale, d, c);
    } else {
        decode_block(column_c, at, bytes.data(), both.begin, c);
        decode_block(column_d, at, bytes.data(), both.begin, d);
    }
    return {};
}

// Calls `read(at, part)` for blocks one after the other, `part` taking a block's share of a span;
// `most(at)`: samples of a block.
template <class Most, class Read>
Status read_blocks(std::int64_t first, std::size_t length, Most most, Read read) {
    for (std::size_t done = 0; done < length;) {
        const std::int64_t at = first + static_cast<std::int64_t>(done);
        const std::size_t count = std::min(length - done, static_cast<std::size_t>(most(at)));
        TRY(read(at, [=](std::span<double> all) { return all.subspan(done, count); }));
        done += count;
    }
    return {};
}

}  // namespace

StridedRange contiguous_range(std::int64_t count, std::int64_t offset, std::int64_t stride,
                              bool big_endian) {
    StridedRange range;
    range.count = count;
    range.per_chunk = std::max<std::int64_t>(count, 1);
    range.offset = offset;
    range.stride = stride;
    range.chunk_stride = range.per_chunk * stride;
    range.big_endian = big_endian;
    return range;
}

Status read_column(const SampleColumn& column, std::int64_t first, std::span<double> out) {
    Scratch bytes;
    return read_blocks(
        first, out.size(), [&](std::int64_t at) { return samples_in_block(column, at); },
        [&](std::int64_t at, auto part) { return fetch_block(column, at, part(out), bytes); });
}

std::shared_ptr<const SampleSource> column_source(SampleColumn c, SampleColumn d) {
    const std::int64_t frames = std::min(c.frames(), d.frames());
    const bool seeks = c.bytes->seeks() && d.bytes->seeks();
    return source_of(frames, seeks,
                     [c = std::move(c), d = std::move(d)](
                         std::int64_t first, std::span<double> out_c, std::span<double> out_d) {
                         Scratch bytes;
                         return read_blocks(
                             first, out_c.size(),
                             [&](std::int64_t at) {
                                 return std::min(samples_in_block(c, at), samples_in_block(d, at));
                             },
                             [&](std::int64_t at, auto part) {
                                 return read_block(c, d, at, part(out_c), part(out_d), bytes);
                             });
                     });
}

SampleColumn array_column(const NumberArray& array, std::shared_ptr<const ByteSource> bytes,
                          std::int64_t channel) {
    const std::int64_t size = bytes_of(array.type);
    const std::int64_t stride = array.interleaved ? array.channels * size : size;
    const std::int64_t offset =
        array.offset + channel * (array.interleaved ? size : array.frames * size);
    const std::int64_t room = bytes->size() - offset - size;
    const std::int64_t count =
        room < 0 || array.channels == 0 ? 0 : std::min(array.frames, room / stride + 1);
    return {std::move(bytes),
            array.type,
            {contiguous_range(count, offset, stride, array.big_endian)},
            array.scale};
}

std::shared_ptr<const SampleSource> array_source(const std::shared_ptr<const FileBytes>& file,
                                                 const NumberArray& array, int c, int d) {
    const auto bytes = file_part(file, 0, file->size());
    return column_source(array_column(array, bytes, c - 1), array_column(array, bytes, d - 1));
}

namespace {

constexpr std::int64_t least_times = 20;  // fewer rise within a period of a vibration, too
constexpr std::int64_t times_at_once = std::int64_t{1} << 16;

}  // namespace

Result<std::optional<SampleRate>> rate_of_times(const SampleColumn& column, double unit_s,
                                                const JobControl& job) {
    const std::optional<SampleRate> none;
    const std::int64_t frames = column.frames();
    if (frames < least_times) {
        return none;
    }
    std::vector<double> block(static_cast<std::size_t>(std::min(frames, times_at_once)));
    TRY(read_column(column, 0, block));
    const auto rises = [](double before, double after) { return before < after; };
    const auto is_whole = [](double time) { return time == std::floor(time); };
    if (std::ranges::adjacent_find(block, std::not_fn(rises)) != block.end() ||
        (unit_s == 1 && std::ranges::all_of(block, is_whole))) {
        return none;
    }
    const auto steps = TRY(judge_column(
        std::move(block), frames, unit_s, false,
        [&](std::int64_t first, std::span<double> times) {
            return read_column(column, first, times);
        },
        job.silent()));
    return steps.is_even() ? std::optional(SampleRate{steps.even->rate_hz, RateOrigin::time_column,
                                                      steps.even->rate_relative_sd})
                           : none;
}

}  // namespace vybeg
