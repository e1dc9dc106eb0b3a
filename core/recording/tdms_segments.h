#pragma once

#include "core/base/job_control.h"
#include "core/base/result.h"
#include "core/recording/file_bytes.h"

#include <cstdint>
#include <functional>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace vybeg {

// A property of a TDMS object: a number, a text, or a time as text.
struct TdmsValue {
    std::optional<double> number;
    std::string text;
};

// An object of a TDMS file: the file ("/"), a group or a channel. Of its properties those are kept
// that say something about samples.
struct TdmsObject {
    std::string group;    // empty for the file itself
    std::string channel;  // empty for the file and for groups
    std::map<std::string, TdmsValue, std::less<>> properties;
};

// What one object has in each chunk of a segment's raw data.
struct TdmsRawIndex {
    std::size_t object = 0;  // its place in TdmsFile::objects
    std::uint32_t type = 0;  // of its values, in National Instruments' numbering
    std::int64_t count = 0;  // values
    std::int64_t bytes = 0;  // all of them
};

// The raw data of one segment: chunks of equal make, one after the other.
struct TdmsSegment {
    std::int64_t offset = 0;  // of its first chunk, in the file
    std::int64_t size = 0;    // bytes that are there
    std::optional<std::int64_t>
        promised;              // bytes by its lead-in; nothing where it was never closed
    bool interleaved = false;  // one value of each object in turn
    bool big_endian = false;
    bool last = false;  // nothing follows, and its last chunk may be incomplete
};

// Walks a TDMS file (version 2.0) from segment to segment.
class TdmsFile {
public:
    using Visitor =
        std::function<Status(const TdmsSegment& segment, const std::vector<TdmsRawIndex>& chunk)>;

    TdmsFile(std::shared_ptr<const FileBytes> file, const JobControl& job);

    // Calls `visit` for each segment with raw data; `chunk` is what a chunk of it consists of, in
    // its order. Errors: those of `visit`; file_read_failed; format_damaged; format_unsupported for
    // DAQmx raw data and more than 10000 objects; interrupted.
    Status walk(const Visitor& visit);

    const std::vector<TdmsObject>& objects() const { return objects_; }  // as far as walked
    // Whether the last segment was never closed, or the file was cut.
    bool incomplete() const { return incomplete_; }

private:
    class Metadata;

    Status take_metadata(std::int64_t offset, std::int64_t size, bool big_endian, bool new_list);
    Status take_object(Metadata& metadata);
    Status take_raw_index(Metadata& metadata, std::size_t object);
    Status take_properties(Metadata& metadata, TdmsObject& object);
    Result<std::size_t> object_named(const std::string& path);
    Error damaged(const std::string& reason) const;
    Error unsupported(const std::string& what) const;

    std::shared_ptr<const FileBytes> file_;
    const JobControl& job_;
    bool incomplete_ = false;
    std::map<std::string, std::size_t, std::less<>> places_;  // of the objects, by their path
    std::vector<TdmsObject> objects_;
    std::vector<std::optional<TdmsRawIndex>> known_;  // the last raw index of each object
    std::vector<TdmsRawIndex> chunk_;                 // of the current segment
};

}  // namespace vybeg
