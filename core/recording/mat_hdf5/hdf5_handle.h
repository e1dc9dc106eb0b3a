#pragma once

#include <hdf5.h>

#include <utility>

namespace vybeg {

// An identifier of HDF5, closed at the end of its scope by H5Idec_ref(), which serves every kind.
class Hdf5Handle {
public:
    Hdf5Handle() = default;
    explicit Hdf5Handle(hid_t id) : id_(id) {}
    Hdf5Handle(Hdf5Handle&& other) noexcept : id_(std::exchange(other.id_, -1)) {}
    Hdf5Handle& operator=(Hdf5Handle&& other) noexcept {
        std::swap(id_, other.id_);
        return *this;
    }
    ~Hdf5Handle() {
        if (id_ >= 0) {
            H5Idec_ref(id_);
        }
    }

    explicit operator bool() const { return id_ >= 0; }
    hid_t get() const { return id_; }

private:
    hid_t id_ = -1;
};

}  // namespace vybeg
