#pragma once

#include "tests/core/recording/recording_files.h"

#include <sndfile.h>

namespace vybeg::test {

// Writes two (or more: silent) channels of doubles with libsndfile.
inline void write_audio(const std::filesystem::path& path, const Samples& samples, int format,
                        int rate = 33333, int channels = 2, const char* date = nullptr) {
    SF_INFO info{};
    info.samplerate = rate;
    info.channels = channels;
    info.format = format;
    SNDFILE* file = sf_open(path.c_str(), SFM_WRITE, &info);
    if (!file) {
        qFatal("%s", sf_strerror(nullptr));
    }
    if (date) {
        sf_set_string(file, SF_STR_DATE, date);
    }
    const auto width = static_cast<std::size_t>(channels);
    std::vector<double> interleaved(samples.c.size() * width, 0.0);
    for (std::size_t i = 0; i < samples.c.size(); ++i) {
        interleaved[i * width] = samples.c[i];
        if (width > 1) {
            interleaved[i * width + 1] = samples.d[i];
        }
    }
    const auto frames = static_cast<sf_count_t>(samples.c.size());
    if (sf_writef_double(file, interleaved.data(), frames) != frames) {
        qFatal("%s", sf_strerror(file));
    }
    sf_close(file);
}

}  // namespace vybeg::test
