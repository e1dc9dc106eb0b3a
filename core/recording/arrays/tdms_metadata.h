#pragma once

#include "core/base/result.h"
#include "core/recording/bytes/number_type.h"

#include <cstddef>
#include <cstdint>
#include <functional>
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace vybeg {

inline constexpr std::uint32_t tdms_string = 0x20;
inline constexpr std::uint32_t tdms_time = 0x44;

// Number type of a TDMS type, if samples can have it.
std::optional<NumberType> tdms_number(std::uint32_t type);

// Bytes of one value of a TDMS type; empty for strings and unknown types.
std::optional<int> tdms_bytes(std::uint32_t type);

// Value in place of the length of an object's raw index: no raw data.
inline constexpr std::uint32_t tdms_no_raw_data = 0xFFFFFFFF;
inline constexpr std::uint32_t tdms_same_as_before = 0;

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

// The object of a path: /'group'/'channel', a quote within a name written twice; "/" is the file
// itself. Empty for other texts.
std::optional<TdmsObject> tdms_object(const std::string& path);

// Position of one of a channel's raw numbers in DAQmx data: buffer of a chunk, and place in each
// row of it.
struct TdmsScaler {
    std::optional<NumberType> type;  // empty for digital lines and times
    std::int64_t buffer = 0;
    std::int64_t offset = 0;  // bytes from the start of a row
    std::uint32_t id = 0;     // the scale that takes it as its input

    friend bool operator==(const TdmsScaler&, const TdmsScaler&) = default;
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

// Reader of a segment's metadata, value by value. After the end it returns empty values, and
// ended() is true.
class TdmsMetadata {
public:
    TdmsMetadata(std::string bytes, bool big_endian)
        : bytes_(std::move(bytes)), rest_(bytes_), big_endian_(big_endian) {}
    TdmsMetadata(const TdmsMetadata&) = delete;
    TdmsMetadata& operator=(const TdmsMetadata&) = delete;

    template <class Number>
    Number number() {
        const std::string_view taken = bytes(sizeof(Number));
        return ended_ ? Number{} : load<Number>(taken.data(), big_endian_);
    }

    std::string_view bytes(std::size_t size);
    std::string string() { return std::string(bytes(number<std::uint32_t>())); }
    // A property's value; empty for an unknown type.
    std::optional<TdmsValue> value(std::uint32_t type);
    bool ended() const { return ended_; }

private:
    std::string bytes_;
    std::string_view rest_;
    bool big_endian_;
    bool ended_ = false;
};

// Reads an object's raw index, whose first number was `length`. Errors, without a place:
// format_damaged, format_unsupported.
Status take_raw_index(TdmsMetadata& metadata, std::uint32_t length, TdmsRawIndex& index);

}  // namespace vybeg
