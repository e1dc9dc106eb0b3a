#pragma once

#include "core/base/message_arg.h"

#include <hdf5.h>

#include <cstddef>
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

struct OpenedHdf5 {
    Hdf5Handle file;          // none where it could not be opened
    bool not_closed = false;  // marked as being written: it is, or its writer died
    bool truncated = false;   // shorter than its header says
};

// Opens the HDF5 file at a descriptor, from its first byte, without plug-ins, locks and any other
// file.
OpenedHdf5 open_hdf5(int descriptor);

// Bytes of the pieces that a packed dataset is unpacked in; 0 of any other.
std::size_t packed_piece_bytes(hid_t dataset);

// How a dataset is opened whose pieces are unpacked once, and not for each block of frames again.
Hdf5Handle access_to_dataset(std::size_t piece_bytes);

// Why the samples of a dataset cannot be read however sound the file is: they lie in other files,
// are packed in larger pieces than most_packed_bytes, or by a filter that this libhdf5 does not
// have. Empty where they can.
MessageArg unsupported_storage(hid_t dataset);

}  // namespace vybeg
