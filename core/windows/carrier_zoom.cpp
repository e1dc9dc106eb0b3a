#include "core/windows/carrier_zoom.h"

#include "core/base/dispatch.h"
#include "core/numerics/fft.h"
#include "core/windows/carrier_peak.h"

#include <array>
#include <complex>
#include <cstdint>
#include <numbers>
#include <vector>

// Vectors are passed between inlined functions only.
#pragma GCC diagnostic ignored "-Wpsabi"

namespace vybeg {
namespace {

using Complex = std::complex<double>;
using Eight = double __attribute__((vector_size(64)));

constexpr double pi = std::numbers::pi;
// Of shorter stretches the whole spectrum takes a few milliseconds.
constexpr std::size_t least_length = std::size_t{1} << 17;
constexpr std::size_t coarse_length = 4096;
constexpr std::size_t coarse_stretches = 8;
// Thinned out so far that about so many blocks are left, whose filter covers four of them.
constexpr std::size_t blocks_wished = 8192;
constexpr std::size_t overlap = 4;
// The zoom's centre is a multiple of the blocks' rate over this: the turn from block to block then
// repeats itself.
constexpr std::size_t turns = 64;

VYBEG_INLINED inline Eight load(const double* from) {
    Eight value;
    __builtin_memcpy(&value, from, sizeof value);
    return value;
}

VYBEG_INLINED inline double total(Eight x) {
    return ((x[0] + x[4]) + (x[2] + x[6])) + ((x[1] + x[5]) + (x[3] + x[7]));
}

double finite(double x) {
    return std::isfinite(x) ? x : 0;
}

// Roughly where the largest peak lies, from a few short stretches.
std::optional<double> coarse_peak(std::span<const double> c, std::span<const double> d,
                                  double rate_hz, double low_hz, double high_hz) {
    std::vector<double> power(coarse_length / 2);
    std::vector<Complex> data(coarse_length);
    const Fft transform(coarse_length);
    const double turn = 2 * pi / static_cast<double>(coarse_length);
    std::vector<double> hann(coarse_length);
    for (std::size_t j = 0; j < coarse_length; ++j) {
        hann[j] = 0.5 - 0.5 * std::cos(turn * (static_cast<double>(j) + 0.5));
    }
    for (std::size_t s = 0; s < coarse_stretches; ++s) {
        const std::size_t first = (c.size() - coarse_length) * s / (coarse_stretches - 1);
        Complex mean = 0;
        for (std::size_t j = 0; j < coarse_length; ++j) {
            data[j] = {finite(c[first + j]), finite(d[first + j])};
            mean += data[j];
        }
        mean /= static_cast<double>(coarse_length);
        for (std::size_t j = 0; j < coarse_length; ++j) {
            data[j] = hann[j] * (data[j] - mean);
        }
        transform.forward(data);
        for (std::size_t k = 1; k < power.size(); ++k) {
            power[k] += std::norm(data[k]) + std::norm(data[coarse_length - k]);
        }
    }
    const double bin_hz = rate_hz / static_cast<double>(coarse_length);
    const auto bin_of = [&](double f_hz) {
        return static_cast<std::size_t>(
            std::clamp(f_hz / bin_hz, 1.0, static_cast<double>(power.size() - 2)));
    };
    const auto begin = power.begin();
    const auto peak = std::max_element(begin + static_cast<std::ptrdiff_t>(bin_of(low_hz)),
                                       begin + static_cast<std::ptrdiff_t>(bin_of(high_hz)) + 1);
    if (!(*peak > 0)) {
        return std::nullopt;
    }
    return (static_cast<double>(peak - begin) + peak_shift(peak[-1], peak[0], peak[1])) * bin_hz;
}

// Four terms, side lobes of -92 dB (F. J. Harris, 1978): a low-pass over four blocks.
std::vector<double> low_pass(std::size_t length) {
    std::vector<double> taps(length);
    double sum = 0;
    for (std::size_t j = 0; j < length; ++j) {
        const double angle = 2 * pi * (static_cast<double>(j) + 0.5) / static_cast<double>(length);
        taps[j] = 0.35875 - 0.48829 * std::cos(angle) + 0.14128 * std::cos(2 * angle) -
                  0.01168 * std::cos(3 * angle);
        sum += taps[j];
    }
    for (double& tap : taps) {
        tap /= sum;
    }
    return taps;
}

// Both channels thinned out around a frequency, and their sums.
struct Thinned {
    std::vector<Complex> c;
    std::vector<Complex> d;
    double c_sum = 0;
    double d_sum = 0;
    double squares = 0;  // of both channels
    // The same in the Hann window, of the samples less their means.
    double weighted_squares = 0;
};

// The Hann window over `count` samples.
double hann_at(double place, std::size_t count) {
    return 0.5 - 0.5 * std::cos(2 * pi * place / static_cast<double>(count));
}

// One block: the samples times e^{-iwj} and the low-pass; of the first `fresh` also their sums.
VYBEG_DISPATCHED
void thin_block(const double* c, const double* d, const double* cosines, const double* sines,
                std::size_t length, std::size_t fresh, std::array<double, 7>& sums) {
    Eight c_cos{};
    Eight c_sin{};
    Eight d_cos{};
    Eight d_sin{};
    for (std::size_t j = 0; j < length; j += 8) {
        const Eight x = load(c + j);
        const Eight y = load(d + j);
        const Eight cosine = load(cosines + j);
        const Eight sine = load(sines + j);
        c_cos += x * cosine;
        c_sin += x * sine;
        d_cos += y * cosine;
        d_sin += y * sine;
    }
    Eight c_sum{};
    Eight d_sum{};
    Eight squares{};
    for (std::size_t j = 0; j < fresh; j += 8) {
        const Eight x = load(c + j);
        const Eight y = load(d + j);
        c_sum += x;
        d_sum += y;
        squares += x * x + y * y;
    }
    sums = {total(c_cos), total(c_sin), total(d_cos),  total(d_sin),
            total(c_sum), total(d_sum), total(squares)};
}

Thinned thin_out(std::span<const double> c, std::span<const double> d, std::size_t step,
                 std::size_t centre) {
    const std::size_t length = overlap * step;
    const std::vector<double> taps = low_pass(length);
    std::vector<double> cosines(length);
    std::vector<double> sines(length);
    const double w = 2 * pi * static_cast<double>(centre) / static_cast<double>(turns * step);
    Complex of_constant = 0;
    for (std::size_t j = 0; j < length; ++j) {
        cosines[j] = taps[j] * std::cos(w * static_cast<double>(j));
        sines[j] = -taps[j] * std::sin(w * static_cast<double>(j));
        of_constant += Complex(cosines[j], sines[j]);
    }
    const std::size_t blocks = (c.size() - length) / step + 1;
    Thinned thinned;
    thinned.c.resize(blocks);
    thinned.d.resize(blocks);
    std::array<double, 7> sums{};
    struct Weighted {
        double weights = 0;
        double c = 0;
        double d = 0;
        double squares = 0;
    } weighted;
    for (std::size_t b = 0; b < blocks; ++b) {
        thin_block(c.data() + b * step, d.data() + b * step, cosines.data(), sines.data(), length,
                   step, sums);
        thinned.c[b] = {sums[0], sums[1]};
        thinned.d[b] = {sums[2], sums[3]};
        thinned.c_sum += sums[4];
        thinned.d_sum += sums[5];
        thinned.squares += sums[6];
        const double weight = hann_at(static_cast<double>(b * step + step / 2), c.size());
        weighted.weights += weight * static_cast<double>(step);
        weighted.c += weight * sums[4];
        weighted.d += weight * sums[5];
        weighted.squares += weight * sums[6];
    }
    for (std::size_t j = blocks * step; j < c.size(); ++j) {
        thinned.c_sum += c[j];
        thinned.d_sum += d[j];
        thinned.squares += c[j] * c[j] + d[j] * d[j];
    }
    // Offsets out, and all blocks to one phase.
    const auto count = static_cast<double>(c.size());
    const double mean_c = thinned.c_sum / count;
    const double mean_d = thinned.d_sum / count;
    thinned.weighted_squares = weighted.squares -
                               mean_c * (2 * weighted.c - mean_c * weighted.weights) -
                               mean_d * (2 * weighted.d - mean_d * weighted.weights);
    const Complex offset_c = mean_c * of_constant;
    const Complex offset_d = mean_d * of_constant;
    std::array<Complex, turns> turned;
    for (std::size_t k = 0; k < turns; ++k) {
        turned[k] = std::polar(
            1.0, -2 * pi * static_cast<double>(k * centre % turns) / static_cast<double>(turns));
    }
    for (std::size_t b = 0; b < blocks; ++b) {
        thinned.c[b] = turned[b % turns] * (thinned.c[b] - offset_c);
        thinned.d[b] = turned[b % turns] * (thinned.d[b] - offset_d);
    }
    return thinned;
}

// Missing samples replaced by the mean of the others, which counts for nothing.
std::vector<double> without_missing(std::span<const double> x) {
    const double mean = mean_of_finite(x);
    std::vector<double> whole(x.begin(), x.end());
    for (double& value : whole) {
        value = std::isfinite(value) ? value : mean;
    }
    return whole;
}

struct FineSpectrum {
    std::vector<double> power;  // of both channels, in the Hann window
    double energy = 0;          // of the blocks, in the Hann window
};

FineSpectrum fine_spectrum(const Thinned& thinned, std::size_t count, std::size_t step) {
    const std::size_t blocks = thinned.c.size();
    const std::size_t size = padded_length(blocks);
    const Fft transform(size);
    FineSpectrum spectrum{std::vector<double>(size)};
    std::vector<Complex> data(size);
    for (const std::vector<Complex>* channel : {&thinned.c, &thinned.d}) {
        std::fill(data.begin(), data.end(), 0.0);
        for (std::size_t b = 0; b < blocks; ++b) {
            const double weight =
                hann_at(static_cast<double>(b * step + overlap * step / 2), count);
            data[b] = weight * (*channel)[b];
            spectrum.energy += weight * std::norm((*channel)[b]);
        }
        transform.forward(data);
        for (std::size_t k = 0; k < size; ++k) {
            spectrum.power[k] += std::norm(data[k]);
        }
    }
    return spectrum;
}

}  // namespace

std::optional<double> zoom_carrier(std::span<const double> c, std::span<const double> d,
                                   double rate_hz, double low_hz, double high_hz,
                                   const JobControl& job) {
    if (c.size() < least_length) {
        return std::nullopt;
    }
    const std::optional<double> coarse = coarse_peak(c, d, rate_hz, low_hz, high_hz);
    const std::size_t step = std::bit_floor(c.size() / blocks_wished);
    const double blocks_hz = rate_hz / static_cast<double>(step);
    if (!coarse || *coarse < blocks_hz / 2 || *coarse > (rate_hz - blocks_hz) / 2 ||
        job.cancelled()) {
        return std::nullopt;
    }
    const double centre = std::round(*coarse / blocks_hz * turns);
    Thinned thinned = thin_out(c, d, step, static_cast<std::size_t>(centre));
    if (!std::isfinite(thinned.squares)) {
        thinned = thin_out(without_missing(c), without_missing(d), step,
                           static_cast<std::size_t>(centre));
    }
    if (job.cancelled()) {
        return std::nullopt;
    }
    const auto [power, energy] = fine_spectrum(thinned, c.size(), step);

    // The largest peak where the low-pass is flat, and what there is beside it: there the low-pass
    // takes up to 15 dB.
    const std::size_t size = power.size();
    const double bin_hz = blocks_hz / static_cast<double>(size);
    const auto flat = static_cast<std::ptrdiff_t>(size / 6);
    const auto at = [&power = power](std::ptrdiff_t k) {
        return power[static_cast<std::size_t>(k < 0 ? k + std::ssize(power) : k)];
    };
    const auto hz = [&](double k) { return centre / turns * blocks_hz + k * bin_hz; };
    std::ptrdiff_t peak = 0;
    double highest = 0;
    double beside = 0;
    for (std::ptrdiff_t k = -std::ssize(power) / 2 + 1; k < std::ssize(power) / 2; ++k) {
        if (std::abs(k) > flat) {
            beside = std::max(beside, at(k));
        } else if (hz(static_cast<double>(k)) >= low_hz && hz(static_cast<double>(k)) <= high_hz &&
                   at(k) > highest) {
            highest = at(k);
            peak = k;
        }
    }
    if (std::abs(peak) == flat || highest < 64 * beside || at(peak - 1) > highest ||
        at(peak + 1) > highest) {
        return std::nullopt;
    }

    // By Cauchy and Schwarz samples whose squares add up to E in a Hann window have no peak above E
    // times the window's sum, half of it where they are real: what lies outside of the band is held
    // against that, twice.
    const auto of_block = static_cast<double>(step);
    const double outside = std::max(thinned.weighted_squares - 2 * of_block * energy, 0.0);
    const double elsewhere = 2 * 0.5 * 0.5 * static_cast<double>(c.size()) * outside;
    constexpr double rounding = 1e-12;
    if (!(thinned.weighted_squares > rounding * thinned.squares) ||
        of_block * of_block * highest < elsewhere) {
        return std::nullopt;
    }
    return hz(static_cast<double>(peak) + peak_shift(at(peak - 1), highest, at(peak + 1)));
}

}  // namespace vybeg
