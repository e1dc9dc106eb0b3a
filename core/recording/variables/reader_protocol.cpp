#include "core/recording/variables/reader_protocol.h"

#include <algorithm>
#include <cerrno>
#include <cstring>
#include <limits>
#include <sys/socket.h>

namespace vybeg {
namespace {

constexpr double slowest_bytes_per_second = 2e7;  // a twelfth of what decoding reaches
constexpr double most_seconds = 3600;

template <class Number>
void put(std::string& bytes, Number number) {
    bytes.append(reinterpret_cast<const char*>(&number), sizeof number);
}

void put(std::string& bytes, const std::string& text) {
    put(bytes, static_cast<std::uint64_t>(text.size()));
    bytes += text;
}

void put(std::string& bytes, const MessageArg& arg) {
    put(bytes, static_cast<std::uint8_t>(arg.kind));
    put(bytes, arg.text);
    put(bytes, arg.unit);
    put(bytes, static_cast<std::uint64_t>(arg.args.size()));
    for (const MessageArg& inner : arg.args) {
        put(bytes, inner);
    }
}

// NaN stands for "no number": the fields that use it are never NaN otherwise.
void put(std::string& bytes, const std::optional<double>& number) {
    put(bytes, number.value_or(std::numeric_limits<double>::quiet_NaN()));
}

// Takes values off the front; once something was not there, ok() stays false.
class Unpacking {
public:
    explicit Unpacking(std::string_view bytes) : rest_(bytes) {}

    bool ok() const { return ok_; }
    bool at_end() const { return rest_.empty(); }

    template <class Number>
    Number number() {
        Number value{};
        const std::string_view bytes = take(sizeof value);
        if (ok_) {
            std::memcpy(&value, bytes.data(), sizeof value);
        }
        return value;
    }

    std::string text() {
        const auto size = number<std::uint64_t>();
        return std::string(take(size));
    }

    // Words within words go no deeper than `depth`.
    MessageArg message_arg(int depth = 2) {
        MessageArg arg;
        const auto kind = number<std::uint8_t>();
        ok_ = ok_ && kind <= static_cast<std::uint8_t>(MessageArg::Kind::words);
        arg.kind = static_cast<MessageArg::Kind>(kind);
        arg.text = text();
        arg.unit = text();
        const auto count = number<std::uint64_t>();
        ok_ = ok_ && (count == 0 || depth > 0);
        for (std::uint64_t k = 0; ok_ && k < count; ++k) {
            arg.args.push_back(message_arg(depth - 1));
        }
        return arg;
    }

    std::optional<double> optional_number() {
        const auto value = number<double>();
        return ok_ && value == value ? std::optional(value) : std::nullopt;
    }

private:
    std::string_view take(std::uint64_t size) {
        ok_ = ok_ && size <= rest_.size();
        if (!ok_) {
            return {};
        }
        const std::string_view taken = rest_.substr(0, size);
        rest_.remove_prefix(size);
        return taken;
    }

    std::string_view rest_;
    bool ok_ = true;
};

}  // namespace

std::string number_type_text(int bits, bool is_float) {
    return std::to_string(bits) + " bit " + (is_float ? "float" : "integer");
}

MessageArg dimensions_text(std::int64_t dimensions) {
    return words(VYBEG_MESSAGE("Words", "an array of %1 dimensions"), {count_arg(dimensions)});
}

bool fits(const SampleRequest& request, const Catalogue& catalogue) {
    if (request.variable < 0 ||
        request.variable >= static_cast<std::int64_t>(catalogue.variables.size())) {
        return false;
    }
    const FileVariable& variable = catalogue.variables[static_cast<std::size_t>(request.variable)];
    return variable.unsupported.text.empty() && request.channel >= 0 &&
           request.channel < variable.channels && request.first >= 0 && request.count >= 0 &&
           request.first <= variable.frames && request.count <= variable.frames - request.first;
}

int seconds_allowed(const SampleRequest& request) {
    const double before = 8 * static_cast<double>(request.channel + 1) *
                          (static_cast<double>(request.first) + static_cast<double>(request.count));
    return 2 + static_cast<int>(std::min(before / slowest_bytes_per_second, most_seconds));
}

std::string encode(const Catalogue& catalogue) {
    std::string bytes;
    put(bytes, catalogue.format);
    put(bytes, catalogue.start);
    put(bytes, static_cast<std::uint8_t>(catalogue.not_closed));
    for (const FileVariable& variable : catalogue.variables) {
        put(bytes, variable.name);
        put(bytes, variable.frames);
        put(bytes, variable.channels);
        put(bytes, variable.type);
        put(bytes, variable.unsupported);
        put(bytes, variable.unit);
        put(bytes, variable.value);
        put(bytes, variable.rate_hz);
    }
    return bytes;
}

std::optional<Catalogue> decode_catalogue(std::string_view bytes) {
    Unpacking unpacking(bytes);
    Catalogue catalogue;
    catalogue.format = unpacking.text();
    catalogue.start = unpacking.text();
    catalogue.not_closed = unpacking.number<std::uint8_t>() != 0;
    while (unpacking.ok() && !unpacking.at_end()) {
        FileVariable variable;
        variable.name = unpacking.text();
        variable.frames = unpacking.number<std::int64_t>();
        variable.channels = unpacking.number<std::int64_t>();
        variable.type = unpacking.text();
        variable.unsupported = unpacking.message_arg();
        variable.unit = unpacking.text();
        variable.value = unpacking.optional_number();
        variable.rate_hz = unpacking.optional_number();
        if (variable.frames < 0 || variable.channels < 0) {
            return {};
        }
        catalogue.variables.push_back(std::move(variable));
    }
    return unpacking.ok() ? std::optional(std::move(catalogue)) : std::nullopt;
}

std::string encode(const Error& error) {
    std::string bytes;
    put(bytes, static_cast<std::int64_t>(error.code));
    for (const MessageArg& arg : error.args) {
        put(bytes, arg);
    }
    return bytes;
}

std::optional<Error> decode_error(std::string_view bytes) {
    Unpacking unpacking(bytes);
    Error error;
    const auto code = unpacking.number<std::int64_t>();
    while (unpacking.ok() && !unpacking.at_end()) {
        error.args.push_back(unpacking.message_arg());
    }
    for (const auto& [known, args] : {std::pair(ErrorCode::format_damaged, 2u),
                                      {ErrorCode::format_unsupported, 2u},
                                      {ErrorCode::format_limit, 3u}}) {
        if (unpacking.ok() && code == static_cast<std::int64_t>(known) &&
            error.args.size() == args) {
            error.code = known;
            return error;
        }
    }
    return {};
}

bool send_bytes(int socket, std::span<const char> bytes) {
    while (!bytes.empty()) {
        const ssize_t sent = ::send(socket, bytes.data(), bytes.size(), MSG_NOSIGNAL);
        if (sent < 0 && errno != EINTR) {
            return false;
        }
        bytes = bytes.subspan(static_cast<std::size_t>(std::max<ssize_t>(sent, 0)));
    }
    return true;
}

bool receive_bytes(int socket, std::span<char> bytes) {
    while (!bytes.empty()) {
        const ssize_t got = ::recv(socket, bytes.data(), bytes.size(), 0);
        if (got == 0) {
            errno = 0;
            return false;
        }
        if (got < 0 && errno != EINTR) {
            return false;
        }
        bytes = bytes.subspan(static_cast<std::size_t>(std::max<ssize_t>(got, 0)));
    }
    return true;
}

}  // namespace vybeg
