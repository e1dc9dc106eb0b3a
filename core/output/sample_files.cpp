#include "core/output/sample_files.h"

#include "core/base/number_text.h"
#include "core/output/array_files.h"
#include "core/output/output_file.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

namespace vybeg {
namespace {

constexpr std::size_t frames_per_block = 1 << 14;

// Largest size of a WAV file less its chunks; RF64 has 64 bits.
constexpr std::int64_t wav_bytes = (std::int64_t{1} << 32) - 4096;

// Code of the quantiser in the upper bits of 32, the WAV layout of other widths.
int pcm(double sample, const SampleStream& stream) {
    const double code = std::round(sample / stream.full_scale * std::ldexp(1.0, stream.bits - 1));
    const double most = std::ldexp(1.0, stream.bits - 1);
    return static_cast<int>(std::ldexp(std::clamp(code, -most, most - 1), 32 - stream.bits));
}

// Both signals in turn: float64, or codes of `width` bytes with an offset where they are unsigned.
Status write_interleaved(OutputFile& file, const SampleStream& stream, std::size_t width) {
    std::string bytes;
    const auto append = [&](double sample) {
        if (stream.bits == 0) {
            append_bytes(bytes, sample);
            return;
        }
        std::string code;
        append_bytes(code, pcm(sample, stream));
        bytes.append(code, code.size() - width);
        if (width == 1) {
            bytes.back() = static_cast<char>(bytes.back() ^ '\x80');
        }
    };
    return stream.run([&](std::span<const double> c, std::span<const double> d) {
        bytes.clear();
        for (std::size_t k = 0; k < c.size(); ++k) {
            append(c[k]);
            append(d[k]);
        }
        return file.write(bytes);
    });
}

// What stands before the samples of a WAV file or, where 32 bits do not suffice, of an RF64 file,
// as libsndfile writes it.
std::string wav_head(const SampleStream& stream, std::size_t width) {
    using namespace std::string_view_literals;
    constexpr std::uint32_t in_ds64 = 0xFFFFFFFF;
    constexpr std::uint32_t both_fronts = 3;
    const auto frame_bytes = static_cast<std::uint16_t>(2 * width);
    const auto bits = static_cast<std::uint16_t>(8 * width);
    const auto rate = static_cast<std::uint32_t>(stream.rate_hz);
    const auto frames = static_cast<std::uint64_t>(stream.frames);
    const std::uint64_t data = frames * frame_bytes;
    const std::uint16_t kind = stream.bits == 0 ? 3 : 1;  // floats, integers
    const bool large = stream.frames > wav_bytes / std::int64_t{2 * sizeof(double)};
    std::string format;
    append_bytes(format, large ? std::uint16_t{0xFFFE} : kind, std::uint16_t{2}, rate,
                 rate * frame_bytes, frame_bytes, bits);
    if (large) {
        append_bytes(format, std::uint16_t{22}, bits, both_fronts, kind);
        format += "\0\0\0\0\x10\0\x80\0\0\xAA\0\x38\x9B\x71"sv;
    }
    std::string chunks = "fmt ";
    append_bytes(chunks, static_cast<std::uint32_t>(format.size()));
    chunks += format;
    if (stream.bits == 0 && !large) {
        chunks += "fact";
        append_bytes(chunks, std::uint32_t{4}, static_cast<std::uint32_t>(frames));
    }
    chunks += "data";
    append_bytes(chunks, large ? in_ds64 : static_cast<std::uint32_t>(data));
    constexpr std::uint32_t ds64_bytes = 32;
    std::string head = large ? "RF64" : "RIFF";
    if (large) {
        append_bytes(head, in_ds64);
        head += "WAVEds64";
        const std::uint64_t whole = 12 + 8 + ds64_bytes + chunks.size() + data;
        append_bytes(head, ds64_bytes, whole, data, frames, std::uint64_t{0});
    } else {
        append_bytes(head, static_cast<std::uint32_t>(4 + chunks.size() + data));
        head += "WAVE";
    }
    return head + chunks;
}

Status write_wav(OutputFile& file, const SampleStream& stream) {
    if (!file.seekable()) {
        return file.failure("a WAV file cannot go to a pipe or a device");
    }
    if (stream.rate_hz != std::round(stream.rate_hz) || stream.rate_hz > INT32_MAX) {
        return file.failure("WAV keeps whole sample rates only; CSV and MAT keep any");
    }
    const std::size_t width =
        stream.bits == 0 ? sizeof(double) : static_cast<std::size_t>((stream.bits + 7) / 8);
    TRY(file.write(wav_head(stream, width)));
    return write_interleaved(file, stream, width);
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
    TRY(file.write(npy_head("<f8", integer_text(stream.frames) + ", 2")));
    SampleStream numbers = stream;
    numbers.bits = 0;
    return write_interleaved(file, numbers, sizeof(double));
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

Status write_stream(OutputFile& file, SampleFormat format, const SampleStream& stream) {
    switch (format) {
        case SampleFormat::wav: return write_wav(file, stream);
        case SampleFormat::csv: return write_csv(file, stream);
        case SampleFormat::npy: return write_npy(file, stream);
        case SampleFormat::mat: return write_mat(file, stream);
    }
    return {};
}

Status write_samples(OutputFile& file, SampleFormat format, const Samples& samples,
                     const JobControl& job) {
    const auto run = [&](const SampleSink& sink) -> Status {
        for (std::size_t at = 0; at < samples.c.size(); at += frames_per_block) {
            TRY(job.go_on());
            const std::size_t count = std::min(frames_per_block, samples.c.size() - at);
            TRY(sink(samples.c.subspan(at, count), samples.d.subspan(at, count)));
            job.report(static_cast<double>(at + count) / static_cast<double>(samples.c.size()));
        }
        return {};
    };
    return write_stream(file, format,
                        {static_cast<std::int64_t>(samples.c.size()), samples.rate_hz, samples.bits,
                         samples.full_scale, run});
}

}  // namespace vybeg
