#pragma once

#include "core/base/job_control.h"
#include "core/base/result.h"
#include "core/recording/arrays/tdms_metadata.h"
#include "core/recording/bytes/file_bytes.h"
#include "core/recording/samples/column_source.h"

#include <cstdint>
#include <functional>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace vybeg {

// Raw data of one segment: consecutive chunks of equal layout.
struct TdmsSegment {
    std::int64_t offset = 0;               // of its first chunk, in the file
    std::int64_t size = 0;                 // bytes present
    std::optional<std::int64_t> promised;  // bytes by its lead-in; empty if it was never closed
    bool interleaved = false;              // one value of each object in turn
    bool big_endian = false;
    bool last = false;  // last segment; its last chunk may be incomplete
};

// Reads a TDMS file (version 2.0) segment by segment.
class TdmsFile {
public:
    using Visitor =
        std::function<Status(const TdmsSegment& segment, const std::vector<TdmsRawIndex>& chunk)>;

    TdmsFile(std::shared_ptr<const FileBytes> file, const JobControl& job);

    // Calls `visit` for each segment with raw data; `chunk` lists the contents of one of its
    // chunks, in order. Errors: those of `visit`; file_read_failed; format_damaged;
    // format_limit for more than 10,000 objects and more than 50,000 properties of scales;
    // interrupted.
    Status walk(const Visitor& visit);

    const std::vector<TdmsObject>& objects() const { return objects_; }  // read so far
    // Whether the last segment was never closed or the file is truncated within the head of a
    // segment; the intended length is then unknown.
    bool open_ended() const { return open_ended_; }

private:
    Status take_metadata(std::int64_t offset, std::int64_t size, bool big_endian, bool new_list);
    Status take_object(TdmsMetadata& metadata);
    Status list_raw_index(TdmsMetadata& metadata, std::size_t object);
    Status take_properties(TdmsMetadata& metadata, TdmsObject& object);
    Result<std::size_t> object_named(const std::string& path);

    std::shared_ptr<const FileBytes> file_;
    const JobControl& job_;
    bool open_ended_ = false;
    std::size_t kept_ = 0;                                    // properties
    std::map<std::string, std::size_t, std::less<>> places_;  // of the objects, by their path
    std::vector<TdmsObject> objects_;
    std::vector<std::optional<TdmsRawIndex>> known_;  // the last raw index of each object
    std::vector<TdmsRawIndex> chunk_;                 // of the current segment
};

// Collects the positions of the values of one channel, segment by segment. Contiguous ranges are
// merged, so that a file written in many pieces has a short table.
class TdmsRanges {
public:
    // `scaler`: id of the chosen numbers of a DAQmx channel.
    explicit TdmsRanges(std::size_t object, std::uint32_t scaler = 0)
        : object_(object), scaler_(scaler) {}

    // Adds the chunks of one segment. A last chunk that is shorter by its segment is divided in
    // proportion among consecutive channels; in a truncated file the present bytes count. Returns
    // the fault of the chunks, if any.
    std::optional<const char*> take(const TdmsSegment& segment,
                                    const std::vector<TdmsRawIndex>& chunk);

    const std::vector<StridedRange>& ranges() const { return ranges_; }
    std::vector<StridedRange> take_ranges() { return std::move(ranges_); }
    // Number of values by the lead-ins of the segments; of an unclosed segment, whole chunks.
    std::int64_t promised() const { return promised_; }

private:
    void append(StridedRange range);

    std::size_t object_;
    std::uint32_t scaler_;
    std::int64_t promised_ = 0;
    std::vector<StridedRange> ranges_;
};

}  // namespace vybeg
