#pragma once

#include "core/recording/open_recording.h"

#include <filesystem>
#include <string>

namespace vybeg::benchmarks {

// A recording on the disk, and how it is opened.
struct RecordingFile {
    std::filesystem::path path;
    OpenOptions open;
};

// The same simulated decay of 2^21 frames in several formats, in a folder that goes with the
// object. Ends the program where the disk does not take it.
class RecordingFiles {
public:
    RecordingFiles();
    RecordingFiles(const RecordingFiles&) = delete;
    RecordingFiles& operator=(const RecordingFiles&) = delete;
    ~RecordingFiles();

    RecordingFile raw;
    RecordingFile npy;
    RecordingFile wav;      // 64 bit float
    RecordingFile wav_pcm;  // 16 bit
    RecordingFile csv;

private:
    std::filesystem::path folder_;
};

}  // namespace vybeg::benchmarks
