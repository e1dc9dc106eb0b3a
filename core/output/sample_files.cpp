#include "core/output/sample_files.h"

#include "core/base/number_text.h"
#include "core/output/array_files.h"

#include <sndfile.h>

#include <algorithm>
#include <cmath>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

namespace vybeg {
namespace {

constexpr std::size_t frames_per_block = 1 << 14;

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

Status write_csv(OutputFile& file, const SampleStream& stream) {
    TRY(file.write("t_s,C,D\n"));
    std::string text;
    std::int64_t frame = 0;
    return stream.run([&](std::span<const double> c, std::span<const double> d) {
        text.clear();
        for (std::size_t k = 0; k < c.size(); ++k) {
            append_round_trip(text, static_cast<double>(frame++) / stream.rate_hz);
            text += ',';
            append_round_trip(text, c[k]);
            text += ',';
            append_round_trip(text, d[k]);
            text += '\n';
        }
        return file.write(text);
    });
}

Status write_npy(OutputFile& file, const SampleStream& stream) {
    const std::string head = npy_head("<f8", integer_text(stream.frames) + ", 2");
    TRY(file.write(head));
    std::string bytes;
    return stream.run([&](std::span<const double> c, std::span<const double> d) {
        bytes.clear();
        for (std::size_t k = 0; k < c.size(); ++k) {
            append_bytes(bytes, c[k], d[k]);
        }
        return file.write(bytes);
    });
}

Status write_mat(OutputFile& file, const SampleStream& stream) {
    if (stream.frames > most_mat_rows) {
        return file.failure("a MAT file of level 5 has room for " + integer_text(most_mat_rows) +
                            " samples a channel; WAV, CSV and NPY for any number");
    }
    TRY(file.write(mat_file_head()));
    for (const bool is_c : {true, false}) {
        TRY(file.write(mat_column_head(is_c ? "S_C" : "S_D", stream.frames)));
        TRY(stream.run([&](std::span<const double> c, std::span<const double> d) {
            return file.write(bytes_of(is_c ? c : d));
        }));
    }
    std::string rate = mat_column_head("fs", 1);
    append_bytes(rate, stream.rate_hz);
    return file.write(rate);
}

}  // namespace

Result<SampleFormat> sample_format(const std::filesystem::path& target) {
    TRY(check_ending(target, {".wav", ".csv", ".npy", ".mat"}));
    const std::string ending = file_ending(target);
    return ending == ".wav"   ? SampleFormat::wav
           : ending == ".csv" ? SampleFormat::csv
           : ending == ".npy" ? SampleFormat::npy
                              : SampleFormat::mat;
}

Status write_samples(OutputFile& file, SampleFormat format, const SampleStream& stream) {
    switch (format) {
        case SampleFormat::wav: return write_wav(file, stream);
        case SampleFormat::csv: return write_csv(file, stream);
        case SampleFormat::npy: return write_npy(file, stream);
        case SampleFormat::mat: return write_mat(file, stream);
    }
    return {};
}

SampleStream in_memory(std::span<const double> c, std::span<const double> d, double rate_hz,
                       const JobControl& job) {
    const auto run = [=](const SampleSink& sink) -> Status {
        for (std::size_t at = 0; at < c.size(); at += frames_per_block) {
            TRY(job.go_on());
            const std::size_t count = std::min(frames_per_block, c.size() - at);
            TRY(sink(c.subspan(at, count), d.subspan(at, count)));
            job.report(static_cast<double>(at + count) / static_cast<double>(c.size()));
        }
        return {};
    };
    return {static_cast<std::int64_t>(c.size()), rate_hz, 0, 0, run};
}

}  // namespace vybeg
