#pragma once

#include "core/base/job_control.h"
#include "core/base/result.h"
#include "core/recording/bytes/file_bytes.h"
#include "core/recording/bytes/number_type.h"

#include <cstddef>
#include <cstdint>
#include <functional>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace vybeg {

// Number type of a TDMS type, if samples can have it.
std::optional<NumberType> tdms_number(std::uint32_t type);

// Bytes of one value of a TDMS type; empty for strings and unknown types.
std::optional<int> tdms_bytes(std::uint32_t type);

// A property of a TDMS object: a number, a text, or a time as text.
struct TdmsValue {
    std::optional<double> number;
    std::string text;
};

// An object of a TDMS file: the file ("/"), a group or a channel. It stores only properties that
// describe samples.
struct TdmsObject {
    std::string group;    // empty for the file itself
    std::string channel;  // empty for the file and for groups
    std::map<std::string, TdmsValue, std::less<>> properties{};

    // Of a property; nothing where it is not there, or of the other kind.
    std::optional<double> number(std::string_view property) const;
    std::string text(std::string_view property) const;
};

// Position of one of a channel's raw numbers in DAQmx data: buffer of a chunk, and place in each
// row of it.
struct TdmsScaler {
    std::optional<NumberType> type;  // empty for digital lines and times
    std::int64_t buffer = 0;
    std::int64_t offset = 0;  // bytes from the start of a row
    std::uint32_t id = 0;     // the scale that takes it as its input
};

// Data of one object in each chunk of a segment's raw data.
struct TdmsRawIndex {
    std::size_t object = 0;  // its place in TdmsFile::objects
    std::uint32_t type = 0;  // of its values, in National Instruments' numbering
    std::int64_t count = 0;  // values
    std::int64_t bytes = 0;  // all of them; 0 for DAQmx, whose objects share their buffers
    bool is_daqmx = false;
    std::vector<TdmsScaler> scalers;   // DAQmx alone
    std::vector<std::int64_t> widths;  // bytes of a row in each buffer; DAQmx alone
};

// Raw data of one segment: consecutive chunks of equal layout.
struct TdmsSegment {
    std::int64_t offset = 0;               // of its first chunk, in the file
    std::int64_t size = 0;                 // bytes present
    std::optional<std::int64_t> promised;  // bytes by its lead-in; empty if it was never closed
    bool interleaved = false;              // one value of each object in turn
    bool big_endian = false;
    bool last = false;  // last segment; its last chunk may be incomplete
};

class TdmsMetadata;

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
    Status list_raw_index(TdmsMetadata& metadata, std::size_t object);
    Result<TdmsRawIndex> raw_index(TdmsMetadata& metadata, std::uint32_t length) const;
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

// Coefficients of a polynomial, from the constant on.
using Polynomial = std::vector<double>;

// Conversion of a channel's raw numbers to its unit: the linear scale of the decoder, then the
// steps.
struct TdmsScaling {
    std::optional<std::uint32_t>
        scaler;  // id of the number of a DAQmx channel; empty: its only one
    Scale linear;
    std::vector<Polynomial> steps;
};

// Scaling by the NI_Scale properties of the channel, otherwise of its group, otherwise of the file
// (in this order): from the last scale back through its input sources to the raw numbers.
// None if NI_Scaling_Status marks the samples as scaled. Errors: format_unsupported, with the name
// of the scale, for scales of sensors and others that are no function of one number;
// format_damaged.
Result<TdmsScaling> tdms_scaling(const FileBytes& file,
                                 const std::vector<const TdmsObject*>& nearest_first);

}  // namespace vybeg
