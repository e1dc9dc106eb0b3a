#pragma once

#include "core/base/error.h"
#include "core/base/result.h"

#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

// What the program and its helper vybeg-reader say to each other over a socket. The helper speaks
// first: a catalogue or an error, or, before it looks at the file, that it may not. Then it answers
// each SampleRequest with samples or an error. Both are of one build on one machine: numbers go as
// they lie in memory. Nothing that comes from the helper is trusted: a damaged file may have
// damaged it, too.
namespace vybeg {

// One array of numbers in a file.
struct FileVariable {
    std::string name;           // "C", "run.C" (MAT), "/run/C" (HDF5)
    std::int64_t frames = 0;    // along the longer axis
    std::int64_t channels = 0;  // along the shorter one; 1 for a vector
    std::string type;           // e.g. "64 bit float"
    MessageArg unsupported;     // why its samples cannot be read, e.g. "complex numbers"; or empty
    std::string unit;
    std::optional<double> value;    // of a single number
    std::optional<double> rate_hz;  // from its attributes or those of the groups around it

    friend bool operator==(const FileVariable&, const FileVariable&) = default;
};

// FileVariable::type: "16 bit integer", "64 bit float".
std::string number_type_text(int bits, bool is_float);

// FileVariable::unsupported of more than two dimensions: "an array of 3 dimensions".
MessageArg dimensions_text(std::int64_t dimensions);

struct Catalogue {
    std::string format;   // e.g. "MAT 5"
    std::string start{};  // date and time from the file, or empty
    std::vector<FileVariable> variables;
    bool not_closed = false;  // still being written, or its writer died

    friend bool operator==(const Catalogue&, const Catalogue&) = default;
};

// The frames [first, first + count) of one channel (from 0) of a variable (its place in the
// catalogue, from 0).
struct SampleRequest {
    std::int64_t variable = 0;
    std::int64_t channel = 0;
    std::int64_t first = 0;
    std::int64_t count = 0;
};

// Whether the request asks for samples that the catalogue promises.
bool fits(const SampleRequest& request, const Catalogue& catalogue);

// Seconds of processor time that the helper may take to answer: 2, and for a long compressed chunk,
// which is decoded from its start, a time that grows with what lies before.
int seconds_allowed(const SampleRequest& request);
inline constexpr int seconds_for_catalogue = 5;  // 10,000 objects take one

// unconfined: the helper cannot forbid itself system calls, and reads nothing.
enum class ReplyKind : std::uint8_t { catalogue, samples, error, unconfined };

struct Reply {
    ReplyKind kind{};
    std::int64_t bytes = 0;  // that follow
};

// Descriptors that the helper finds open.
inline constexpr int reader_socket = 0;
inline constexpr int reader_file = 3;

// The largest piece (unpacked) of a packed dataset, which can be read only whole, and how many
// times its size reading takes: the piece of one channel, and that of the other with its packed
// bytes and the buffers of unpacking.
inline constexpr std::size_t most_packed_bytes = std::size_t{128} << 20;
inline constexpr std::size_t packed_pieces_held = 6;

std::string encode(Catalogue catalogue);
std::optional<Catalogue> decode_catalogue(std::string_view bytes);
// Code and arguments; `where` is the caller's to fill in.
std::string encode(Error error);
std::optional<Error> decode_error(std::string_view bytes);

// The whole of `bytes` to a socket; false at its end and on failure.
bool send_bytes(int socket, std::span<const char> bytes);

// The same for one plain value.
template <class Value>
bool send_value(int socket, const Value& value) {
    return send_bytes(socket, {reinterpret_cast<const char*>(&value), sizeof value});
}

// A file that a library reads, inside vybeg-reader only: a damaged file may crash the library, make
// it hang or take memory up to the process's limit.
//
// Errors of all of it: format_damaged, format_unsupported, format_limit, without a place.
class HelperFile {
public:
    HelperFile() = default;
    HelperFile(const HelperFile&) = delete;
    HelperFile& operator=(const HelperFile&) = delete;
    virtual ~HelperFile() = default;

    virtual const Catalogue& catalogue() const = 0;

    // Bytes of memory that reading takes, beyond those of a file without large packed pieces.
    virtual std::int64_t memory_bytes() const { return 0; }

    // Precondition: fits(request, catalogue()), and `out` has request.count places.
    virtual Status read(const SampleRequest& request, std::span<double> out) = 0;
};

}  // namespace vybeg
