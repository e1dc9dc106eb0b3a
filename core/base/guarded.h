#pragma once

#include <mutex>
#include <utility>

namespace vybeg {

// A value for one thread at a time, through const owners too: what a source keeps from read to
// read, which several threads may call at once.
template <class Value>
class Guarded {
public:
    // Access, while it lives.
    class Held {
    public:
        Held(std::mutex& mutex, Value& value) : lock_(mutex), value_(value) {}

        Value& operator*() const { return value_; }
        Value* operator->() const { return &value_; }

    private:
        std::lock_guard<std::mutex> lock_;
        Value& value_;
    };

    template <class... Arguments>
    explicit Guarded(Arguments&&... arguments) : value_(std::forward<Arguments>(arguments)...) {}

    Held hold() const { return {mutex_, value_}; }

private:
    mutable std::mutex mutex_;
    mutable Value value_;
};

}  // namespace vybeg
