#pragma once

#include "core/base/error.h"

#include <utility>
#include <variant>

namespace vybeg {

// A value, or the reason why there is none. GCC 12 has no std::expected; this is the part of it we
// use.
template <class T>
class [[nodiscard]] Result {
public:
    Result(T value) : content_(std::in_place_index<0>, std::move(value)) {}
    Result(Error error) : content_(std::in_place_index<1>, std::move(error)) {}

    explicit operator bool() const { return content_.index() == 0; }

    // Precondition of the next three: the result holds a value.
    T& operator*() { return std::get<0>(content_); }
    const T& operator*() const { return std::get<0>(content_); }
    T* operator->() { return &std::get<0>(content_); }
    const T* operator->() const { return &std::get<0>(content_); }

    // Precondition: the result holds an error.
    const Error& error() const { return std::get<1>(content_); }

private:
    std::variant<T, Error> content_;
};

// For what either succeeds or fails and returns nothing.
class [[nodiscard]] Status {
public:
    Status() = default;
    Status(Error error) : error_(std::move(error)), ok_(false) {}

    explicit operator bool() const { return ok_; }
    const Error& error() const { return error_; }

private:
    Error error_;
    bool ok_ = true;
};

template <class T>
T taken(Result<T>&& result) {
    return std::move(*result);
}
inline void taken(Status&&) {}

}  // namespace vybeg

// The value of a result, or nothing of a status; where there is an error, the function returns it.
// A statement, an initialiser or an assignment of its own: GCC keeps temporaries of a larger
// expression alive.
#define TRY(...)                               \
    __extension__({                            \
        auto try_result = (__VA_ARGS__);       \
        if (!try_result) {                     \
            return try_result.error();         \
        }                                      \
        ::vybeg::taken(std::move(try_result)); \
    })
