#include "core/output/sample_files.h"

#include "core/base/number_text.h"
#include "core/output/array_heads.h"
#include "core/output/output_paths.h"
#include "core/output/raw_bytes.h"
#include "core/output/wav_writer.h"

#include <algorithm>
#include <cstdint>
#include <string>

namespace vybeg {
namespace {

constexpr std::size_t frames_per_block = 1 << 14;

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
            append_bytes(bytes, c[k]);
            append_bytes(bytes, d[k]);
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
