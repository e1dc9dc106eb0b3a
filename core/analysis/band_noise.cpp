#include "core/analysis/band_noise.h"

#include "core/numerics/fft.h"
#include "core/numerics/statistics.h"
#include "core/track/track_summary.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <complex>
#include <limits>
#include <numbers>
#include <vector>

namespace vybeg {
namespace {

constexpr double pi = std::numbers::pi;
constexpr std::int64_t most_frames = std::int64_t{1} << 18;
constexpr std::int64_t read_frames = std::int64_t{1} << 16;

using Analytic = std::vector<std::complex<double>>;

// The longest run of frames without a missing sample, as C + iD, up to most_frames; looked for in
// no more than four times as many from `first` on.
Result<Analytic> whole_segment(const SampleSource& source, std::int64_t first, std::int64_t end,
                               const JobControl& job) {
    Analytic longest;
    Analytic run;
    std::vector<double> c(static_cast<std::size_t>(read_frames));
    std::vector<double> d(c);
    const std::int64_t last = std::min(end, first + 4 * most_frames);
    for (std::int64_t at = first; at < last && std::ssize(run) < most_frames; at += read_frames) {
        TRY(job.go_on());
        const auto count = static_cast<std::size_t>(std::min(read_frames, last - at));
        TRY(source.read(at, std::span(c).first(count), std::span(d).first(count)));
        for (std::size_t j = 0; j < count; ++j) {
            if (std::isfinite(c[j]) && std::isfinite(d[j])) {
                run.emplace_back(c[j], d[j]);
            } else if (!run.empty()) {
                if (run.size() > longest.size()) {
                    longest.swap(run);
                }
                run.clear();
            }
        }
    }
    return run.size() > longest.size() ? run : longest;
}

// Four terms, side lobes of -92 dB (F. J. Harris, 1978).
double blackman_harris(double turns) {
    const double angle = 2 * pi * turns;
    return 0.35875 - 0.48829 * std::cos(angle) + 0.14128 * std::cos(2 * angle) -
           0.01168 * std::cos(3 * angle);
}

// Power response of the band-pass: flat, with edges of a raised cosine, whose energy is that of the
// filter's within a hundredth of the band.
double power_gain(double f_hz, const Band& band, double rate_hz) {
    const double transition =
        std::min({(band.high_hz - band.low_hz) / 2, band.low_hz, rate_hz / 2 - band.high_hz});
    const double beyond = std::max({band.low_hz - f_hz, f_hz - band.high_hz, 0.0}) / transition;
    const double gain = beyond < 1 ? 0.5 + 0.5 * std::cos(pi * beyond) : 0;
    return gain * gain;
}

// sum u sin phi u over n samples, at an offset from the carrier, cycles per sample.
double moment_at(double offset, double n) {
    const double half = pi * offset;
    const double sine = std::sin(half);
    const double turns = n * half;
    return std::abs(turns) < 1e-3
               ? half * n * (n * n - 1) / 6
               : (0.5 * std::sin(turns) * std::cos(half) - 0.5 * n * std::cos(turns) * sine) /
                     (sine * sine);
}

// Its square by sum u^2.
double frequency_response(double offset, double n) {
    const double moment = moment_at(offset, n);
    return 12 * moment * moment / (n * (n * n - 1));
}

}  // namespace

Result<double> noise_in_band(const SampleSource& source, std::int64_t first, std::int64_t end,
                             const Band& band, double rate_hz, const JobControl& job) {
    auto segment = TRY(whole_segment(source, first, end, job));
    const std::size_t size = std::bit_floor(segment.size());
    if (size < 16) {
        return std::numeric_limits<double>::quiet_NaN();
    }
    segment.resize(size);
    double squares = 0;
    for (std::size_t j = 0; j < size; ++j) {
        const double weight =
            blackman_harris((static_cast<double>(j) + 0.5) / static_cast<double>(size));
        segment[j] *= weight;
        squares += weight * weight;
    }
    Fft fft(size);
    fft.forward(segment);
    const double bins_per_hz = static_cast<double>(size) / rate_hz;
    const auto low = static_cast<std::size_t>(std::ceil(band.low_hz * bins_per_hz));
    const auto high = std::max(low, static_cast<std::size_t>(band.high_hz * bins_per_hz));
    std::vector<double> powers;
    for (std::size_t bin = low; bin <= high && bin < size / 2; ++bin) {
        // Both channels: the density of C + iD is the sum of theirs.
        powers.push_back(std::norm(segment[bin]));
        powers.push_back(std::norm(segment[size - bin]));
    }
    // The median of an exponential distribution is ln 2 of its mean.
    return std::sqrt(median(std::move(powers)) / (std::numbers::ln2 * 2 * squares));
}

EquivalentNoise equivalent_noise(double noise, const Band& band, double f0_hz, std::int64_t n,
                                 double rate_hz) {
    // |sum e^{-i phi u}|^2 / n and |sum u e^{-i phi u}|^2 / sum u^2, integrated over the offset
    // from the carrier, have the integral 1 over all frequencies. Beyond 64 / n cycles per sample
    // lies less than a hundredth of either.
    constexpr int points = 16384;
    const auto count = static_cast<double>(n);
    const double reach = std::min(0.5, 64 / count);  // cycles per sample
    const double step = 2 * reach / points;
    double phasors = 0;
    double frequency = 0;
    double all_phasors = 0;
    double all_frequency = 0;
    for (int k = 0; k < points; ++k) {
        const double offset = (k + 0.5) * step - reach;
        const double half = pi * offset;
        const double sine = std::sin(half);
        const double turns = count * half;
        const double sum = std::sin(turns) / sine;
        const double own = sum * sum / count;
        const double by_time = frequency_response(offset, count);
        const double gain = power_gain(f0_hz + offset * rate_hz, band, rate_hz);
        phasors += gain * own;
        frequency += gain * by_time;
        all_phasors += own;
        all_frequency += by_time;
    }
    return {noise * std::sqrt(phasors / all_phasors), noise * std::sqrt(frequency / all_frequency)};
}

std::vector<double> frequency_correlation(const Band& band, double f0_hz, std::int64_t n,
                                          std::int64_t hop, double rate_hz) {
    // The noise of the band forgets within some inverse bandwidths.
    constexpr double memory = 16;
    constexpr double most_points = std::int64_t{1} << 20;
    const double reach = static_cast<double>(n) + memory * rate_hz / (band.high_hz - band.low_hz);
    if (4 * reach > most_points) {  // such windows are long for every band
        return overlap_correlation(
            std::min(1.0, static_cast<double>(hop) / static_cast<double>(n)));
    }
    const std::size_t size = std::bit_ceil(static_cast<std::size_t>(4 * reach));
    std::vector<std::complex<double>> density(size);
    for (std::size_t k = 0; k < size; ++k) {
        const double offset =
            (static_cast<double>(k) + (k < size / 2 ? 0.0 : -static_cast<double>(size))) /
            static_cast<double>(size);
        const auto count = static_cast<double>(n);
        double moment = moment_at(offset, count);
        // Noise about -f0 enters, too, twice the carrier away, as far as it is no steady wave.
        const double image = 2 * f0_hz / rate_hz;
        const double from_image = std::remainder(offset + image, 1.0);
        if (std::abs(from_image) < std::abs(offset)) {
            const double half = pi * from_image;
            const double mean =
                std::abs(half) < 1e-9 ? 1 : std::sin(count * half) / (count * std::sin(half));
            moment -= moment_at(std::remainder(-image, 1.0), count) * mean;
        }
        const double f_hz = std::abs(std::remainder(f0_hz + offset * rate_hz, rate_hz));
        density[k] = power_gain(f_hz, band, rate_hz) * moment * moment;
    }
    Fft(size).forward(density);
    std::vector<double> correlation;
    for (std::size_t lag = 0; lag <= static_cast<std::size_t>(reach);
         lag += static_cast<std::size_t>(hop)) {
        correlation.push_back(density[lag].real() / density[0].real());
    }
    return correlation;
}

}  // namespace vybeg
