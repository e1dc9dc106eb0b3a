#include "core/output/wav_writer.h"

#include <sndfile.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

namespace vybeg {
namespace {

// Largest size of a WAV file less its chunks; RF64 has 64 bits.
constexpr std::int64_t wav_bytes = (std::int64_t{1} << 32) - 4096;

struct Closer {
    void operator()(SNDFILE* file) const { sf_close(file); }
};

// libsndfile's words for what went wrong, without its frame around those of the system: "System
// error : File too large."
std::string reason(const char* told) {
    std::string text = told;
    if (constexpr std::string_view frame = "System error : "; text.starts_with(frame)) {
        text.erase(0, frame.size());
        text.erase(text.find_last_not_of(". ") + 1);
    }
    return text;
}

int subtype(int bits) {
    if (bits == 0) {
        return SF_FORMAT_DOUBLE;
    }
    if (bits <= 8) {
        return SF_FORMAT_PCM_U8;
    }
    if (bits <= 16) {
        return SF_FORMAT_PCM_16;
    }
    return bits <= 24 ? SF_FORMAT_PCM_24 : SF_FORMAT_PCM_32;
}

// Code of the quantiser in the upper bits of 32, the WAV layout of other widths.
int pcm(double sample, const SampleStream& stream) {
    const double code = std::round(sample / stream.full_scale * std::ldexp(1.0, stream.bits - 1));
    const double most = std::ldexp(1.0, stream.bits - 1);
    return static_cast<int>(std::ldexp(std::clamp(code, -most, most - 1), 32 - stream.bits));
}

template <class Number, class Convert, class Write>
Status write_frames(OutputFile& file, SNDFILE* wav, const SampleStream& stream, Convert convert,
                    Write write) {
    std::vector<Number> interleaved;
    return stream.run([&](std::span<const double> c, std::span<const double> d) -> Status {
        interleaved.clear();
        for (std::size_t k = 0; k < c.size(); ++k) {
            interleaved.push_back(convert(c[k]));
            interleaved.push_back(convert(d[k]));
        }
        const auto frames = static_cast<sf_count_t>(c.size());
        if (write(wav, interleaved.data(), frames) != frames) {
            return file.failure(reason(sf_strerror(wav)));
        }
        return {};
    });
}

}  // namespace

Status write_wav(OutputFile& file, const SampleStream& stream) {
    if (!file.seekable()) {
        return file.failure("a WAV file cannot go to a pipe or a device");
    }
    if (stream.rate_hz != std::round(stream.rate_hz) || stream.rate_hz > INT32_MAX) {
        return file.failure("WAV keeps whole sample rates only; CSV and MAT keep any");
    }
    SF_INFO format{};
    const bool large = stream.frames > wav_bytes / std::int64_t{2 * sizeof(double)};
    format.format = (large ? SF_FORMAT_RF64 : SF_FORMAT_WAV) | subtype(stream.bits);
    format.channels = 2;
    format.samplerate = static_cast<int>(stream.rate_hz);
    std::unique_ptr<SNDFILE, Closer> wav(
        sf_open_fd(file.descriptor(), SFM_WRITE, &format, SF_FALSE));
    if (!wav) {
        return file.failure(reason(sf_strerror(nullptr)));
    }
    // The peak chunk contains the time of day, so that equal simulations would yield different
    // files.
    sf_command(wav.get(), SFC_SET_ADD_PEAK_CHUNK, nullptr, SF_FALSE);
    const Status written =
        stream.bits == 0
            ? write_frames<double>(
                  file, wav.get(), stream, [](double sample) { return sample; }, sf_writef_double)
            : write_frames<int>(
                  file, wav.get(), stream, [&](double sample) { return pcm(sample, stream); },
                  sf_writef_int);
    // Closing completes the header.
    if (const int error = sf_close(wav.release()); written && error != 0) {
        return file.failure(reason(sf_error_number(error)));
    }
    return written;
}

}  // namespace vybeg
