#include "core/recording/variables/reader_protocol.h"

#include <algorithm>
#include <cerrno>
#include <cstring>
#include <limits>
#include <sys/socket.h>
#include <utility>

namespace vybeg {
namespace {

constexpr double slowest_bytes_per_second = 2e7;  // a twelfth of what decoding reaches
constexpr double most_seconds = 3600;

// A message, which fields are appended to or, where it was received, taken from. Once one was not
// there, ok() stays false.
class Message {
public:
    Message() = default;
    explicit Message(std::string_view received) : bytes_(received), reading_(true) {}

    // Of a received message: taken to its end.
    bool ok() const { return ok_ && (!reading_ || at_ == bytes_.size()); }
    const std::string& bytes() const { return bytes_; }

    template <class... Fields>
    void operator()(Fields&... fields) {
        (take(fields), ...);
    }

private:
    static constexpr int deepest = 4;  // of words within words

    void take_bytes(void* data, std::size_t size) {
        if (!reading_) {
            bytes_.append(static_cast<const char*>(data), size);
            return;
        }
        ok_ = ok_ && size <= bytes_.size() - at_;
        if (ok_) {
            std::memcpy(data, bytes_.data() + at_, size);
            at_ += size;
        }
    }

    template <class Number>
    void take(Number& number) {
        take_bytes(&number, sizeof number);
    }

    void take(std::string& text) {
        std::uint64_t size = text.size();
        take(size);
        if (reading_) {
            ok_ = ok_ && size <= bytes_.size() - at_;
            text.resize(ok_ ? size : 0);
        }
        take_bytes(text.data(), text.size());
    }

    void take(bool& flag) {
        std::uint8_t byte = flag ? 1 : 0;
        take(byte);
        flag = byte != 0;
    }

    // NaN means "no number": the fields that use it are never NaN otherwise.
    void take(std::optional<double>& number) {
        double value = number.value_or(std::numeric_limits<double>::quiet_NaN());
        take(value);
        number = value == value ? std::optional(value) : std::nullopt;
    }

    void take(MessageArg& arg) {
        ++depth_;
        take(arg.kind);
        ok_ = ok_ && arg.kind <= MessageArg::Kind::words && depth_ <= deepest;
        (*this)(arg.text, arg.unit, arg.args);
        --depth_;
    }

    void take(FileVariable& of) {
        (*this)(of.name, of.frames, of.channels, of.type, of.unsupported, of.unit, of.value,
                of.rate_hz);
    }

    void take(Catalogue& of) { (*this)(of.format, of.start, of.not_closed, of.variables); }

    // `where` is not sent.
    void take(Error& of) { (*this)(of.code, of.args); }

    template <class T>
    void take(std::vector<T>& list) {
        std::uint64_t count = list.size();
        take(count);
        for (std::size_t k = 0; ok_ && k < count; ++k) {
            if (reading_) {
                list.emplace_back();
            }
            take(list[k]);
        }
    }

    std::string bytes_;
    bool reading_ = false;
    std::size_t at_ = 0;
    int depth_ = 0;
    bool ok_ = true;
};

}  // namespace

std::string number_type_text(int bits, bool is_float) {
    return std::to_string(bits) + " bit " + (is_float ? "float" : "integer");
}

MessageArg dimensions_text(std::int64_t dimensions) {
    return Phrase::tr("an array of %1 dimensions", {count_arg(dimensions)});
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

std::string encode(Catalogue catalogue) {
    Message message;
    message(catalogue);
    return message.bytes();
}

std::optional<Catalogue> decode_catalogue(std::string_view bytes) {
    Message message(bytes);
    Catalogue catalogue;
    message(catalogue);
    const bool possible = std::ranges::all_of(catalogue.variables, [](const FileVariable& each) {
        return each.frames >= 0 && each.channels >= 0;
    });
    return message.ok() && possible ? std::optional(std::move(catalogue)) : std::nullopt;
}

std::string encode(Error error) {
    Message message;
    message(error);
    return message.bytes();
}

std::optional<Error> decode_error(std::string_view bytes) {
    Message message(bytes);
    Error error;
    message(error);
    for (const auto& [known, args] : {std::pair(ErrorCode::format_damaged, 2u),
                                      {ErrorCode::format_unsupported, 2u},
                                      {ErrorCode::format_limit, 3u}}) {
        if (message.ok() && error.code == known && error.args.size() == args) {
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

}  // namespace vybeg
