#pragma once

#include "core/base/message_arg.h"
#include "core/recording/mat_hdf5/hdf5_handle.h"

#include <cstddef>

namespace vybeg {

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
