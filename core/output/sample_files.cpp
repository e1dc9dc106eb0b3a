#include "core/output/sample_files.h"

#include "core/base/number_text.h"
#include "core/output/wav_writer.h"
#include "core/recording/variables/mat_format.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cstdint>
#include <string>

namespace vybeg {
namespace {

static_assert(std::endian::native == std::endian::little, "NPY and MAT are written as they lie");

constexpr std::size_t frames_per_block = 1 << 14;

template <class Number>
void append_bytes(std::string& bytes, Number number) {
    const auto raw = std::bit_cast<std::array<char, sizeof(Number)>>(number);
    bytes.append(raw.data(), raw.size());
}

Status write_csv(OutputFile& file, const SampleStream& stream) {
    if (const Status written = file.write("t_s,C,D\n"); !written) {
        return written;
    }
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
    std::string dictionary = "{'descr': '<f8', 'fortran_order': False, 'shape': (" +
                             integer_text(stream.frames) + ", 2), }";
    // Magic (6), version (2), length (2), dictionary and line feed fill a multiple of 64 bytes.
    dictionary.append(63 - (10 + dictionary.size()) % 64, ' ');
    dictionary += '\n';
    std::string head = "\x93NUMPY";
    head += std::string_view("\x01\x00", 2);
    append_bytes(head, static_cast<std::uint16_t>(dictionary.size()));
    if (const Status written = file.write(head + dictionary); !written) {
        return written;
    }
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

// The lengths of MAT level 5, 32 bit counts of bytes, include the head of the column.
constexpr std::int64_t most_mat_rows = (std::int64_t{1} << 29) - 16;

void append_tag(std::string& bytes, mat5::ElementType type, std::size_t size) {
    append_bytes(bytes, static_cast<std::uint32_t>(type));
    append_bytes(bytes, static_cast<std::uint32_t>(size));
}

// The head of a column of doubles, up to its first byte of data. libmatio would write a column in
// one piece and ignore the stop token and a full disk.
std::string mat_column_head(const std::string& name, std::int64_t rows) {
    const std::size_t padded = (name.size() + 7) / 8 * 8;
    const std::size_t bytes = static_cast<std::size_t>(rows) * sizeof(double);
    std::string head;
    append_tag(head, mat5::matrix, 16 + 16 + 8 + padded + 8 + bytes);
    append_tag(head, mat5::uint32, 8);
    append_bytes(head, static_cast<std::uint32_t>(mat5::double_class));
    append_bytes(head, std::uint32_t{0});
    append_tag(head, mat5::int32, 8);
    append_bytes(head, static_cast<std::int32_t>(rows));
    append_bytes(head, std::int32_t{1});
    append_tag(head, mat5::int8, name.size());
    head += name + std::string(padded - name.size(), '\0');
    append_tag(head, mat5::float64, bytes);
    return head;
}

Status write_mat(OutputFile& file, const SampleStream& stream) {
    if (stream.frames > most_mat_rows) {
        return file.failure("a MAT file of level 5 has room for " + integer_text(most_mat_rows) +
                            " samples a channel; WAV, CSV and NPY for any number");
    }
    std::string head = "MATLAB 5.0 MAT-file, vybeg";
    head.resize(124, ' ');
    append_bytes(head, std::uint16_t{0x0100});
    head += "IM";
    Status written = file.write(head);
    for (const bool is_c : {true, false}) {
        written =
            written ? file.write(mat_column_head(is_c ? "S_C" : "S_D", stream.frames)) : written;
        const auto column = [&](std::span<const double> c, std::span<const double> d) {
            const auto bytes = std::as_bytes(is_c ? c : d);
            return file.write({reinterpret_cast<const char*>(bytes.data()), bytes.size()});
        };
        written = written ? stream.run(column) : written;
    }
    std::string rate = mat_column_head("fs", 1);
    append_bytes(rate, stream.rate_hz);
    return written ? file.write(rate) : written;
}

}  // namespace

Result<SampleFormat> sample_format(const std::filesystem::path& target) {
    std::string ending = target.extension().string();
    std::ranges::transform(ending, ending.begin(), [](char letter) {
        return letter >= 'A' && letter <= 'Z' ? static_cast<char>(letter - 'A' + 'a') : letter;
    });
    if (ending == ".wav") {
        return SampleFormat::wav;
    }
    if (ending == ".csv") {
        return SampleFormat::csv;
    }
    if (ending == ".npy") {
        return SampleFormat::npy;
    }
    if (ending == ".mat") {
        return SampleFormat::mat;
    }
    return Error{ErrorCode::output_format_unknown, target.string(), {target.extension().string()}};
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
            if (job.cancelled()) {
                return Error{ErrorCode::interrupted, {}, {}};
            }
            const std::size_t count = std::min(frames_per_block, samples.c.size() - at);
            if (const Status taken =
                    sink(samples.c.subspan(at, count), samples.d.subspan(at, count));
                !taken) {
                return taken;
            }
            job.report(static_cast<double>(at + count) / static_cast<double>(samples.c.size()));
        }
        return {};
    };
    return write_stream(file, format,
                        {static_cast<std::int64_t>(samples.c.size()), samples.rate_hz, samples.bits,
                         samples.full_scale, run});
}

}  // namespace vybeg
