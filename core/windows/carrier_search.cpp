#include "core/windows/carrier_search.h"

#include "core/numerics/fft.h"
#include "core/numerics/statistics.h"
#include "core/windows/carrier_zoom.h"

#include <algorithm>
#include <cmath>
#include <complex>
#include <numbers>
#include <vector>

namespace vybeg {
namespace {

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
    constexpr std::size_t least_length = 256;
    constexpr double least_ratio = 40;
    if (c.size() >= least_length && power[peak] < least_ratio * median_of(power)) {
        return Error{ErrorCode::carrier_not_found, "", {}};
    }
    const double shift = peak_shift(power[peak - 1], power[peak], power[peak + 1]);
    return (static_cast<double>(peak) + shift) * bin_hz;
}

}  // namespace vybeg
