#pragma once

#include "core/recording/samples/open_options.h"

#include <cstdint>
#include <string>
#include <string_view>

// One file of any content, given to one reader.
namespace vybeg::fuzz {

enum class Outcome {
    refused,     // the file did not open
    unreadable,  // it opened, and a read further in failed
    read         // it opened, and all that was asked for could be read
};

struct Verdict {
    Outcome outcome = Outcome::refused;
    std::string fault;  // what no file may bring about; empty where all is well
};

using TryFile = Verdict (*)(std::string_view bytes);

// Plain WAV, RF64 and W64 (others are refused: vybeg-reader reads them), text, NPY, NPZ, MAT of
// level 4 and 5, UFF, TDMS, raw. A raw file's first 24 bytes choose its layout.
Verdict try_wav(std::string_view bytes);
Verdict try_text(std::string_view bytes);
Verdict try_npy(std::string_view bytes);
Verdict try_npz(std::string_view bytes);
Verdict try_mat(std::string_view bytes);
Verdict try_uff(std::string_view bytes);
Verdict try_tdms(std::string_view bytes);
Verdict try_raw(std::string_view bytes);
// Whatever format the content is recognised as.
Verdict try_any(std::string_view bytes);

// MAT 7.3, HDF5 and audio as vybeg-reader reads them, but in this process: where the library falls,
// so does the caller. Audio that is also read in place has the same samples there.
Verdict try_mat73(std::string_view bytes);
Verdict try_hdf5(std::string_view bytes);
Verdict try_audio(std::string_view bytes);

}  // namespace vybeg::fuzz
