#pragma once

#include "core/base/result.h"
#include "core/output/output_file.h"

#include <cstdint>
#include <filesystem>
#include <functional>
#include <span>

namespace vybeg {

// Receives frames of both channels in order.
using SampleSink = std::function<Status(std::span<const double> c, std::span<const double> d)>;

// Two signals computed while they are written.
struct SampleStream {
    std::int64_t frames = 0;
    double rate_hz = 0;
    int bits = 0;           // 0: double precision; otherwise those of the quantiser
    double full_scale = 0;  // of that quantiser
    // Passes all frames to a sink, from the first on, the same in each call. Errors: its own and
    // those of the sink.
    std::function<Status(const SampleSink&)> run;
};

// Two signals of equal length in memory, which must outlive the stream.
SampleStream in_memory(std::span<const double> c, std::span<const double> d, double rate_hz,
                       const JobControl& job);

enum class SampleFormat { wav, csv, npy, mat };

// Format by the ending of the name (.wav, .csv, .npy, .mat; upper case too). Errors:
// output_format_unknown.
Result<SampleFormat> sample_format(const std::filesystem::path& target);

// wav: 64-bit float; with bits, PCM of the next larger of 8, 16, 24, 32 bits, full scale 1 (the
//      samples' values are then fractions of full_scale); RF64 above 4 GiB.
// csv: t_s,C,D, numbers that round-trip.   npy: float64, shape (n, 2).
// mat: MATLAB level 5, vectors S_C, S_D (n x 1) and the scalar fs; computes the signals twice,
//      limit of 4 GiB each.
// Errors: output_failed, interrupted, those of the stream. The caller calls commit().
Status write_samples(OutputFile& file, SampleFormat format, const SampleStream& stream);

}  // namespace vybeg
