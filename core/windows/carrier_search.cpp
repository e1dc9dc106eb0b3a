#include "core/windows/carrier_search.h"

#include "core/numerics/fft.h"
#include "core/numerics/kaiser.h"
#include "core/numerics/lanes.h"
#include "core/numerics/statistics.h"

#include <array>
#include <bit>
#include <complex>
#include <numbers>
#include <numeric>
#include <utility>
#include <vector>

// Vectors are passed between inlined functions only.
#pragma GCC diagnostic ignored "-Wpsabi"

namespace vybeg {
namespace {

// Length with zero padding of at least half the length, so that the parabola through the logarithms
// of a peak is accurate: the next power of two, or three times one.
std::size_t padded_length(std::size_t length) {
    const std::size_t least = std::max<std::size_t>(length + length / 2, 1024);
    const std::size_t power = std::bit_ceil(least);
    return power / 4 * 3 >= least ? power / 4 * 3 : power;
}

double mean_of_finite(std::span<const double> x) {
    double sum = 0;
    double count = 0;
    for (const double value : x) {
        if (std::isfinite(value)) {
            sum += value;
            count += 1;
        }
    }
    return count > 0 ? sum / count : std::nan("");
}

using Complex = std::complex<double>;

constexpr double pi = std::numbers::pi;
// For shorter ranges the whole spectrum takes a few milliseconds.
constexpr std::size_t least_length = std::size_t{1} << 17;
constexpr std::size_t coarse_length = 4096;
constexpr std::size_t coarse_segments = 8;
// Number of blocks after decimation; the filter of a block covers four of them.
constexpr std::size_t blocks_wished = 8192;
constexpr std::size_t overlap = 4;
// The centre of the zoom is a multiple of the rate of blocks divided by this, so that the rotation
// from block to block is periodic.
constexpr std::size_t turns = 64;

// The Hann window over `count` samples.
double hann_at(double place, std::size_t count) {
    return 0.5 - 0.5 * std::cos(2 * pi * place / static_cast<double>(count));
}

// Missing samples count as zero.
void clear_missing(std::span<double> x) {
    double sum = 0;
    for (const double value : x) {
        sum += value;
    }
    if (std::isfinite(sum)) {
        return;
    }
    for (double& value : x) {
        value = std::isfinite(value) ? value : 0;
    }
}

// Approximate frequency of the largest peak, from a few short segments.
Result<std::optional<double>> coarse_peak(const ReadFrames& read, std::size_t count, double rate_hz,
                                          double low_hz, double high_hz) {
    std::vector<double> power(coarse_length / 2);
    std::vector<Complex> data(coarse_length);
    std::vector<double> c(coarse_length);
    std::vector<double> d(coarse_length);
    const Fft transform(coarse_length);
    for (std::size_t s = 0; s < coarse_segments; ++s) {
        const std::size_t first = (count - coarse_length) * s / (coarse_segments - 1);
        TRY(read(static_cast<std::int64_t>(first), c, d));
        clear_missing(c);
        clear_missing(d);
        const Complex mean{std::accumulate(c.begin(), c.end(), 0.0) / coarse_length,
                           std::accumulate(d.begin(), d.end(), 0.0) / coarse_length};
        for (std::size_t j = 0; j < coarse_length; ++j) {
            const double weight = hann_at(static_cast<double>(j) + 0.5, coarse_length);
            data[j] = weight * (Complex{c[j], d[j]} - mean);
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
        return std::optional<double>();
    }
    return std::optional(
        (static_cast<double>(peak - begin) + peak_shift(peak[-1], peak[0], peak[1])) * bin_hz);
}

// A low-pass over four blocks.
std::vector<double> low_pass(std::size_t length) {
    std::vector<double> taps(length);
    double sum = 0;
    for (std::size_t j = 0; j < length; ++j) {
        const double angle = 2 * pi * (static_cast<double>(j) + 0.5) / static_cast<double>(length);
        taps[j] = blackman_harris(angle);
        sum += taps[j];
    }
    for (double& tap : taps) {
        tap /= sum;
    }
    return taps;
}

// Both channels decimated around a frequency, and their sums.
struct Thinned {
    std::vector<Complex> c;
    std::vector<Complex> d;
    double squares = 0;  // of both channels
    // The same in the Hann window, of the samples less their means.
    double weighted_squares = 0;
};

// One block: the samples times e^{-iwj} and the low-pass; for the first `fresh` samples also their
// sums.
VYBEG_DISPATCHED
void thin_block(const double* c, const double* d, const double* cosines, const double* sines,
                std::size_t length, std::size_t fresh, std::array<double, 7>& sums) {
    Vec8 c_cos{};
    Vec8 c_sin{};
    Vec8 d_cos{};
    Vec8 d_sin{};
    for (std::size_t j = 0; j < length; j += lane_count) {
        const Vec8 x = load(c + j);
        const Vec8 y = load(d + j);
        const Vec8 cosine = load(cosines + j);
        const Vec8 sine = load(sines + j);
        c_cos += x * cosine;
        c_sin += x * sine;
        d_cos += y * cosine;
        d_sin += y * sine;
    }
    Vec8 c_sum{};
    Vec8 d_sum{};
    Vec8 squares{};
    for (std::size_t j = 0; j < fresh; j += lane_count) {
        const Vec8 x = load(c + j);
        const Vec8 y = load(d + j);
        c_sum += x;
        d_sum += y;
        squares += x * x + y * y;
    }
    sums = {total(c_cos), total(c_sin), total(d_cos),  total(d_sin),
            total(c_sum), total(d_sum), total(squares)};
}

// Takes the samples in portions, in their order.
class Thinner {
public:
    Thinner(std::size_t count, std::size_t step, std::size_t centre)
        : count_(count), step_(step), centre_(centre), length_(overlap * step) {
        const std::vector<double> taps = low_pass(length_);
        const double w = 2 * pi * static_cast<double>(centre) / static_cast<double>(turns * step);
        for (std::size_t j = 0; j < length_; ++j) {
            cosines_.push_back(taps[j] * std::cos(w * static_cast<double>(j)));
            sines_.push_back(-taps[j] * std::sin(w * static_cast<double>(j)));
            of_constant_ += Complex(cosines_.back(), sines_.back());
        }
    }

    // Precondition: at least the samples of one block, except at the end. Returns how many of them
    // the next portion need not repeat.
    std::size_t take(std::span<const double> c, std::span<const double> d) {
        std::size_t at = 0;
        std::array<double, 7> sums{};
        for (; at + length_ <= c.size(); at += step_) {
            thin_block(c.data() + at, d.data() + at, cosines_.data(), sines_.data(), length_, step_,
                       sums);
            const std::size_t place = thinned_.c.size() * step_ + step_ / 2;
            thinned_.c.emplace_back(sums[0], sums[1]);
            thinned_.d.emplace_back(sums[2], sums[3]);
            add(hann_at(static_cast<double>(place), count_), static_cast<double>(step_), sums[4],
                sums[5], sums[6]);
        }
        return at;
    }

    // Processes the samples after the last block, subtracts the offsets and moves all blocks to one
    // phase.
    Thinned finish(std::span<const double> c, std::span<const double> d) {
        const std::size_t first = count_ - c.size();
        for (std::size_t j = 0; j < c.size(); ++j) {
            add(hann_at(static_cast<double>(first + j), count_), 1, c[j], d[j],
                c[j] * c[j] + d[j] * d[j]);
        }
        const double mean_c = sum_.c / static_cast<double>(count_);
        const double mean_d = sum_.d / static_cast<double>(count_);
        thinned_.squares = sum_.squares;
        thinned_.weighted_squares = weighted_.squares -
                                    mean_c * (2 * weighted_.c - mean_c * weighted_.weights) -
                                    mean_d * (2 * weighted_.d - mean_d * weighted_.weights);
        std::array<Complex, turns> turned;
        for (std::size_t k = 0; k < turns; ++k) {
            turned[k] = std::polar(1.0, -2 * pi * static_cast<double>(k * centre_ % turns) /
                                            static_cast<double>(turns));
        }
        for (std::size_t b = 0; b < thinned_.c.size(); ++b) {
            thinned_.c[b] = turned[b % turns] * (thinned_.c[b] - mean_c * of_constant_);
            thinned_.d[b] = turned[b % turns] * (thinned_.d[b] - mean_d * of_constant_);
        }
        return std::move(thinned_);
    }

private:
    struct Sums {
        double weights = 0;
        double c = 0;
        double d = 0;
        double squares = 0;

        void add(double weight, double samples, double of_c, double of_d, double of_squares) {
            weights += weight * samples;
            c += weight * of_c;
            d += weight * of_d;
            squares += weight * of_squares;
        }
    };

    void add(double hann, double samples, double c, double d, double squares) {
        sum_.add(1, samples, c, d, squares);
        weighted_.add(hann, samples, c, d, squares);
    }

    std::size_t count_;
    std::size_t step_;
    std::size_t centre_;
    std::size_t length_;
    std::vector<double> cosines_;
    std::vector<double> sines_;
    Complex of_constant_ = 0;
    Thinned thinned_;
    Sums sum_;
    Sums weighted_;  // in the Hann window
};

Result<Thinned> thin_out(const ReadFrames& read, std::size_t count, std::size_t step,
                         std::size_t centre, const JobControl& job) {
    constexpr std::size_t portion = std::size_t{1} << 15;
    std::vector<double> c(std::min(portion + overlap * step, count));
    std::vector<double> d(c.size());
    Thinner thinner(count, step, centre);
    std::size_t held = 0;  // samples repeated from the portion before
    for (std::size_t at = 0; at < count && !job.cancelled();) {
        const std::size_t fresh = std::min(c.size() - held, count - at);
        const std::span<double> fresh_c = std::span(c).subspan(held, fresh);
        const std::span<double> fresh_d = std::span(d).subspan(held, fresh);
        TRY(read(static_cast<std::int64_t>(at), fresh_c, fresh_d));
        clear_missing(fresh_c);
        clear_missing(fresh_d);
        at += fresh;
        const std::size_t all = held + fresh;
        const std::size_t done = thinner.take(std::span(c).first(all), std::span(d).first(all));
        held = all - done;
        for (std::vector<double>* channel : {&c, &d}) {
            std::copy_n(channel->begin() + static_cast<std::ptrdiff_t>(done), held,
                        channel->begin());
        }
    }
    return thinner.finish(std::span(c).first(held), std::span(d).first(held));
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

// Peak of a carrier near centre/turns of their rate in the spectrum of the decimated samples.
std::optional<double> peak_of(const Thinned& thinned, std::size_t count, std::size_t step,
                              double centre, double rate_hz, double low_hz, double high_hz) {
    const double blocks_hz = rate_hz / static_cast<double>(step);
    const auto [power, energy] = fine_spectrum(thinned, count, step);
    // Largest peak where the low-pass is flat, and largest power beside it, where the low-pass
    // attenuates by up to 15 dB.
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

    // By Cauchy-Schwarz, samples whose squares add up to E in a Hann window have no peak above E
    // times the sum of the window, half of it for real samples. The power outside the band is
    // compared with this bound, with a factor of two.
    const auto of_block = static_cast<double>(step);
    const double outside = std::max(thinned.weighted_squares - 2 * of_block * energy, 0.0);
    const double elsewhere = 2 * 0.5 * 0.5 * static_cast<double>(count) * outside;
    constexpr double rounding = 1e-12;
    if (!(thinned.weighted_squares > rounding * thinned.squares) ||
        of_block * of_block * highest < elsewhere) {
        return std::nullopt;
    }
    return hz(static_cast<double>(peak) + peak_shift(at(peak - 1), highest, at(peak + 1)));
}

bool none_is_finite(std::span<const double> x) {
    return std::ranges::none_of(x, [](double value) { return std::isfinite(value); });
}

// C + iD, Hann-windowed and padded.
std::vector<std::complex<double>> windowed(std::span<const double> c, std::span<const double> d,
                                           double mean_c, double mean_d, std::size_t size) {
    std::vector<std::complex<double>> data(size);
    const double turn = 2 * std::numbers::pi / static_cast<double>(c.size());
    const std::complex<double> step = std::polar(1.0, turn);
    // The cosine of the window is updated from sample to sample and recomputed at the start of each
    // segment.
    constexpr std::size_t segment = 256;
    for (std::size_t first = 0; first < c.size(); first += segment) {
        std::complex<double> phase = std::polar(1.0, turn * (static_cast<double>(first) + 0.5));
        for (std::size_t j = first; j < std::min(first + segment, c.size()); ++j) {
            const double hann = 0.5 - 0.5 * phase.real();
            const double real = std::isfinite(c[j]) ? c[j] - mean_c : 0;
            const double imag = std::isfinite(d[j]) ? d[j] - mean_d : 0;
            data[j] = {hann * real, hann * imag};
            phase = {phase.real() * step.real() - phase.imag() * step.imag(),
                     phase.real() * step.imag() + phase.imag() * step.real()};
        }
    }
    return data;
}

// |C_k|^2 + |D_k|^2 for k = 0 .. size/2, from the transform of C + iD.
std::vector<double> summed_power(const std::vector<std::complex<double>>& spectrum) {
    const std::size_t size = spectrum.size();
    std::vector<double> power(size / 2 + 1);
    power[0] = std::norm(spectrum[0]);
    for (std::size_t k = 1; k < power.size(); ++k) {
        power[k] = 0.5 * (std::norm(spectrum[k]) + std::norm(spectrum[size - k]));
    }
    return power;
}

// Median; for a long spectrum that of a part of its bins.
double median_of(const std::vector<double>& power) {
    constexpr std::size_t bins = 65536;
    const std::size_t step = 1 + power.size() / bins;
    std::vector<double> part;
    part.reserve(power.size() / step + 1);
    for (std::size_t k = 1; k < power.size(); k += step) {
        part.push_back(power[k]);
    }
    return median(std::move(part));
}

}  // namespace

Result<std::optional<double>> zoom_carrier(const ReadFrames& read, std::size_t count,
                                           double rate_hz, double low_hz, double high_hz,
                                           const JobControl& job) {
    if (count < least_length || !(low_hz < high_hz)) {
        return std::optional<double>();
    }
    const auto coarse = TRY(coarse_peak(read, count, rate_hz, low_hz, high_hz));
    const std::size_t step = std::bit_floor(count / blocks_wished);
    const double blocks_hz = rate_hz / static_cast<double>(step);
    if (!coarse || *coarse < blocks_hz / 2 || *coarse > (rate_hz - blocks_hz) / 2) {
        return std::optional<double>();
    }
    const double centre = std::round(*coarse / blocks_hz * turns);
    const auto thinned = TRY(thin_out(read, count, step, static_cast<std::size_t>(centre), job));
    if (job.cancelled()) {
        return std::optional<double>();
    }
    return peak_of(thinned, count, step, centre, rate_hz, low_hz, high_hz);
}

std::optional<double> zoom_carrier(std::span<const double> c, std::span<const double> d,
                                   double rate_hz, double low_hz, double high_hz,
                                   const JobControl& job) {
    const ReadFrames read = [c, d](std::int64_t first, std::span<double> to_c,
                                   std::span<double> to_d) {
        const auto at = static_cast<std::size_t>(first);
        std::ranges::copy(c.subspan(at, to_c.size()), to_c.begin());
        std::ranges::copy(d.subspan(at, to_d.size()), to_d.begin());
        return Status{};
    };
    return *zoom_carrier(read, c.size(), rate_hz, low_hz, high_hz, job);
}

Result<double> find_carrier(std::span<const double> c, std::span<const double> d, double rate_hz,
                            double low_hz, double high_hz, const JobControl& job) {
    if (none_is_finite(c) || none_is_finite(d)) {
        return Error{ErrorCode::no_valid_samples, "", {}};
    }
    const std::size_t size = padded_length(c.size());
    const double bin_hz = rate_hz / static_cast<double>(size);
    const std::size_t half = size / 2;
    const auto last_bin = static_cast<double>(half - 1);
    const auto low =
        static_cast<std::size_t>(std::clamp(std::ceil(low_hz / bin_hz), 1.0, last_bin));
    const auto high =
        static_cast<std::size_t>(std::clamp(std::floor(high_hz / bin_hz), 1.0, last_bin));
    if (!(low_hz < high_hz) || low_hz >= rate_hz / 2 || high < low) {
        return Error{ErrorCode::band_invalid,
                     "",
                     {number_arg(low_hz), number_arg(high_hz), number_arg(rate_hz / 2)}};
    }

    const auto is_constant = [](std::span<const double> x) {
        return std::ranges::all_of(x, [&x](double value) { return value == x[0]; });
    };
    if (is_constant(c) && is_constant(d)) {
        return Error{ErrorCode::channels_constant, "", {}};
    }
    if (const auto found = zoom_carrier(c, d, rate_hz, low_hz, high_hz, job)) {
        return *found;
    }
    // A million samples take some tenths of a second, so the stop token is checked between the
    // steps.
    std::vector<std::complex<double>> data =
        windowed(c, d, mean_of_finite(c), mean_of_finite(d), size);
    TRY(job.go_on());
    const Fft transform(size);
    TRY(job.go_on());
    transform.forward(data);
    TRY(job.go_on());
    const std::vector<double> power = summed_power(data);
    const auto begin = power.begin();
    const auto peak =
        static_cast<std::size_t>(std::max_element(begin + static_cast<std::ptrdiff_t>(low),
                                                  begin + static_cast<std::ptrdiff_t>(high) + 1) -
                                 begin);
    if (!(power[peak] > 0)) {
        return Error{ErrorCode::carrier_not_found, "", {}};
    }
    // White noise of a million bins has peaks of 10 dB above its median. A few periods fill the
    // whole spectrum, so this limit does not apply to shorter ranges.
    constexpr std::size_t least_judged = 256;
    constexpr double least_ratio = 40;
    if (c.size() >= least_judged && power[peak] < least_ratio * median_of(power)) {
        return Error{ErrorCode::carrier_not_found, "", {}};
    }
    const double shift = peak_shift(power[peak - 1], power[peak], power[peak + 1]);
    return (static_cast<double>(peak) + shift) * bin_hz;
}

}  // namespace vybeg
