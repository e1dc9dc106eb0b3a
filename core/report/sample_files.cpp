#include "core/report/sample_files.h"

#include "core/base/number_text.h"
#include "core/report/wav_writer.h"

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

// Writes `rows` rows, each appended to a text by append(text, row), in blocks.
template <class Append>
Status write_rows(OutputFile& file, std::size_t rows, const JobControl& job, Append append) {
    std::string text;
    for (std::size_t first = 0; first < rows; first += frames_per_block) {
        const std::size_t end = std::min(first + frames_per_block, rows);
        text.clear();
        for (std::size_t row = first; row < end; ++row) {
            append(text, row);
        }
        if (const Status written = file.write(text); !written) {
            return written;
        }
        job.report(static_cast<double>(end) / static_cast<double>(rows));
    }
    return {};
}

Status write_csv(OutputFile& file, const Samples& samples, const JobControl& job) {
    if (const Status written = file.write("t_s,C,D\n"); !written) {
        return written;
    }
    return write_rows(file, samples.c.size(), job, [&](std::string& text, std::size_t row) {
        append_round_trip(text, static_cast<double>(row) / samples.rate_hz);
        text += ',';
        append_round_trip(text, samples.c[row]);
        text += ',';
        append_round_trip(text, samples.d[row]);
        text += '\n';
    });
}

Status write_npy(OutputFile& file, const Samples& samples, const JobControl& job) {
    std::string dictionary = "{'descr': '<f8', 'fortran_order': False, 'shape': (" +
                             integer_text(static_cast<std::int64_t>(samples.c.size())) + ", 2), }";
    // Magic (6), version (2), length (2), dictionary and line feed fill a multiple of 64 bytes.
    dictionary.append(63 - (10 + dictionary.size()) % 64, ' ');
    dictionary += '\n';
    std::string head = "\x93NUMPY";
    head += std::string_view("\x01\x00", 2);
    append_bytes(head, static_cast<std::uint16_t>(dictionary.size()));
    if (const Status written = file.write(head + dictionary); !written) {
        return written;
    }
    return write_rows(file, samples.c.size(), job, [&](std::string& bytes, std::size_t row) {
        append_bytes(bytes, samples.c[row]);
        append_bytes(bytes, samples.d[row]);
    });
}

// Type numbers of the MAT level 5 format (MathWorks, "MAT-File Format", tables 1-1 and 1-3).
enum MatType : std::uint32_t { int8 = 1, int32 = 5, uint32 = 6, float64 = 9, matrix = 14 };
constexpr std::uint32_t mat_class_double = 6;

void append_tag(std::string& bytes, MatType type, std::size_t size) {
    append_bytes(bytes, static_cast<std::uint32_t>(type));
    append_bytes(bytes, static_cast<std::uint32_t>(size));
}

// A column of doubles. libmatio would write it in one piece, deaf to the stop token and to a full
// disk.
Status write_mat_column(OutputFile& file, const std::string& name, std::span<const double> values,
                        const JobControl& job) {
    const std::size_t padded = (name.size() + 7) / 8 * 8;
    std::string head;
    append_tag(head, matrix, 16 + 16 + 8 + padded + 8 + values.size_bytes());
    append_tag(head, uint32, 8);
    append_bytes(head, mat_class_double);
    append_bytes(head, std::uint32_t{0});
    append_tag(head, int32, 8);
    append_bytes(head, static_cast<std::int32_t>(values.size()));
    append_bytes(head, std::int32_t{1});
    append_tag(head, int8, name.size());
    head += name + std::string(padded - name.size(), '\0');
    append_tag(head, float64, values.size_bytes());
    if (const Status written = file.write(head); !written) {
        return written;
    }
    return write_rows(file, values.size(), job, [&](std::string& bytes, std::size_t row) {
        append_bytes(bytes, values[row]);
    });
}

Status write_mat(OutputFile& file, const Samples& samples, const JobControl& job) {
    std::string head = "MATLAB 5.0 MAT-file, vybeg";
    head.resize(124, ' ');
    append_bytes(head, std::uint16_t{0x0100});
    head += "IM";
    if (const Status written = file.write(head); !written) {
        return written;
    }
    if (const Status written = write_mat_column(file, "S_C", samples.c, job); !written) {
        return written;
    }
    if (const Status written = write_mat_column(file, "S_D", samples.d, job); !written) {
        return written;
    }
    return write_mat_column(file, "fs", {&samples.rate_hz, 1}, job);
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

Status write_samples(OutputFile& file, SampleFormat format, const Samples& samples,
                     const JobControl& job) {
    switch (format) {
        case SampleFormat::wav: return write_wav(file, samples, job);
        case SampleFormat::csv: return write_csv(file, samples, job);
        case SampleFormat::npy: return write_npy(file, samples, job);
        case SampleFormat::mat: return write_mat(file, samples, job);
    }
    return {};
}

}  // namespace vybeg
