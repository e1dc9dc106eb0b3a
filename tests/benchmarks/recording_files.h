#pragma once

#include "core/recording/samples/open_options.h"

#include <filesystem>
#include <string>

namespace vybeg::benchmarks {

// A recording on the disk, and how it is opened.
struct RecordingFile {
    std::filesystem::path path;
    OpenOptions open;
};

// The same simulated decay in several formats, in a folder that goes with the object: 2^23 frames,
// four minutes; as text the first 2^21 of them. Ends the program where the disk does not take it.
class RecordingFiles {
public:
    RecordingFiles();
    RecordingFiles(const RecordingFiles&) = delete;
    RecordingFiles& operator=(const RecordingFiles&) = delete;
    ~RecordingFiles();

    RecordingFile raw;
    RecordingFile npy;
    RecordingFile wav_f64;
    RecordingFile wav_f32;
    RecordingFile wav_i32;
    RecordingFile wav_i24;
    RecordingFile wav_i16;
    RecordingFile csv;

private:
    std::filesystem::path folder_;
};

}  // namespace vybeg::benchmarks
