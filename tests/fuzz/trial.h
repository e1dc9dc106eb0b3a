#pragma once

#include <functional>
#include <string>
#include <string_view>
#include <vector>

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

using TryFile = std::function<Verdict(std::string_view bytes)>;

// The reader of a format of file_formats() that is read in this process, whether the file is
// recognised or not; "wav", plain WAV, RF64 and W64 (others are refused: vybeg-reader reads them);
// "raw", whose first 24 bytes choose its layout; "any", whatever format the content is recognised
// as.
TryFile reader_of(std::string_view format);
std::vector<std::string> readers();

// "mat73", "hdf5" and "audio" as vybeg-reader reads them, but in this process: where the library
// falls, so does the caller. Audio that is also read in place has the same samples there.
TryFile library_of(std::string_view format);

}  // namespace vybeg::fuzz
