#include "core/recording/checks/start_check.h"

#include "core/numerics/fft.h"
#include "core/numerics/statistics.h"

#include <Eigen/Dense>

#include <algorithm>
#include <bit>
#include <cmath>
#include <complex>
#include <numbers>

namespace vybeg {
namespace {

constexpr double least_carrier_hz = 200;
constexpr double skirts_hz = 20;  // of a carrier near a line of the mains above it

double finite(double x) {
    return std::isfinite(x) ? x : 0;
}

double mean_of(std::span<const double> x) {
    double sum = 0;
    for (const double value : x) {
        sum += finite(value);
    }
    return sum / static_cast<double>(x.size());
}

double mean_power(std::span<const double> x) {
    const double offset = mean_of(x);
    double sum = 0;
    for (const double value : x) {
        const double off = finite(value) - offset;
        sum += off * off;
    }
    return sum / static_cast<double>(x.size());
}

// Variance of white noise beside a sinusoid, which x[j-1] + x[j+1] - 2 cos(w) x[j] leaves out.
double noise_power(std::span<const double> x, double twice_cos) {
    const double offset = mean_of(x);
    double sum = 0;
    for (std::size_t j = 1; j + 1 < x.size(); ++j) {
        const double left = finite(x[j - 1]) + finite(x[j + 1]) - twice_cos * finite(x[j]) -
                            (2 - twice_cos) * offset;
        sum += left * left;
    }
    return sum / static_cast<double>(x.size() - 2) / (2 + twice_cos * twice_cos);
}

// Largest distance of equally spaced values from their polynomial of the fourth degree.
double distance_from_smooth(const std::vector<double>& values) {
    const auto count = static_cast<Eigen::Index>(values.size());
    const Eigen::VectorXd places = Eigen::VectorXd::LinSpaced(count, -1, 1);
    Eigen::Matrix<double, Eigen::Dynamic, 5> powers(count, 5);
    powers.col(0).setOnes();
    for (int k = 1; k < 5; ++k) {
        powers.col(k) = powers.col(k - 1).cwiseProduct(places);
    }
    const Eigen::Map<const Eigen::VectorXd> given(values.data(), count);
    const Eigen::VectorXd smooth = powers * powers.householderQr().solve(given);
    return (given - smooth).lpNorm<Eigen::Infinity>();
}

}  // namespace

std::vector<MainsLine> mains_lines(std::span<const double> c, std::span<const double> d,
                                   double rate_hz) {
    const auto wished = static_cast<std::size_t>(4 * rate_hz);
    const std::size_t size = std::bit_floor(std::min(c.size(), wished));
    const double bin_hz = rate_hz / static_cast<double>(size);
    std::vector<MainsLine> lines;
    if (bin_hz > 5) {
        return lines;  // too short to resolve a line at 50 Hz
    }
    std::vector<std::complex<double>> data(size);
    const double turn = 2 * std::numbers::pi / static_cast<double>(size);
    for (std::size_t j = 0; j < size; ++j) {
        const double hann = 0.5 - 0.5 * std::cos(turn * static_cast<double>(j));
        data[j] = {hann * finite(c[j]), hann * finite(d[j])};
    }
    Fft(size).forward(data);
    const auto amplitude = [&](std::size_t k) {
        return std::sqrt(std::norm(data[k]) + std::norm(data[size - k]));
    };
    const auto strongest = [&](double low_hz, double high_hz) {
        std::size_t best = 0;
        for (auto k = static_cast<std::size_t>(std::max(low_hz / bin_hz, 1.0));
             k <= static_cast<std::size_t>(high_hz / bin_hz) && k < size / 2; ++k) {
            best = best == 0 || amplitude(k) > amplitude(best) ? k : best;
        }
        return best;
    };
    const std::size_t carrier_at = strongest(least_carrier_hz, rate_hz / 2);
    const double carrier = carrier_at > 0 ? amplitude(carrier_at) : 0;
    const double carrier_hz = bin_hz * static_cast<double>(carrier_at);
    const auto look_at = [&](double f) {
        // Skirts of a fast decaying carrier.
        if (f >= least_carrier_hz && std::abs(carrier_hz - f) < skirts_hz) {
            return;
        }
        const std::size_t at_line = strongest(f - 1 - bin_hz, f + 1 + bin_hz);
        const double line = at_line > 0 ? amplitude(at_line) : 0;
        std::vector<double> around;
        for (double aside = 4 + 3 * bin_hz; aside < 24 + 20 * bin_hz; aside += bin_hz) {
            for (const double at : {f - aside, f + aside}) {
                const auto k = static_cast<std::size_t>(std::max(at / bin_hz, 1.0));
                around.push_back(amplitude(std::min(k, size / 2 - 1)));
            }
        }
        if (line > 8 * median(around) && line > 1e-3 * carrier) {
            lines.push_back({f, line / carrier});
        }
    };
    for (const double supply : supplies_hz) {
        const int harmonics = supply < least_carrier_hz ? 3 : 2;
        for (int order = 1; order <= harmonics; ++order) {
            look_at(order * supply);
        }
    }
    return lines;
}

double start_transient_s(std::span<const double> c, std::span<const double> d, double f0_hz,
                         double rate_hz) {
    constexpr std::size_t blocks = 64;
    const std::size_t length = c.size() / blocks;
    if (length < 64) {
        return 0;  // too short to have a start
    }
    const double twice_cos = 2 * std::cos(2 * std::numbers::pi * f0_hz / rate_hz);
    std::vector<double> powers;
    std::vector<double> noises;
    for (std::size_t b = 0; b < blocks; ++b) {
        const auto part_c = c.subspan(b * length, length);
        const auto part_d = d.subspan(b * length, length);
        powers.push_back(mean_power(part_c) + mean_power(part_d));
        noises.push_back(noise_power(part_c, twice_cos) + noise_power(part_d, twice_cos));
    }
    const double noise = median(noises);
    std::vector<double> places;
    std::vector<double> logarithms;
    for (std::size_t b = 0; b < blocks; ++b) {
        places.push_back(static_cast<double>(b));
        const double wave = powers[b] - noise;
        logarithms.push_back(wave > 0 ? std::log(wave) : std::nan(""));
    }
    constexpr std::size_t half = blocks / 2;
    if (std::ranges::any_of(logarithms, [](double x) { return std::isnan(x); })) {
        return 0;  // noise only
    }
    const LineFit line =
        fit_line(std::span(places).subspan(half), std::span(logarithms).subspan(half));
    std::vector<double> off;
    for (std::size_t b = 0; b < blocks; ++b) {
        off.push_back(logarithms[b] - line.mean_y - line.slope * (places[b] - line.mean_x));
    }
    std::vector<double> scatter;
    for (std::size_t b = half; b < blocks; ++b) {
        scatter.push_back(std::abs(off[b]));
    }
    // Two per cent of the power: a smaller change of the decay is no transient. A second half
    // without exponential decay (beats, decay down to the noise) is inconclusive.
    const double usual = 8 * median(scatter);
    if (usual > 0.2) {
        return 0;
    }
    // A beat whose power channels of different gain change slowly bends smoothly from one end to
    // the other; a transient has its end, which a polynomial does not follow.
    constexpr double bend = 0.004;
    if (distance_from_smooth(logarithms) < std::max(bend, usual / 2)) {
        return 0;
    }
    const double threshold = std::max(0.02, usual);
    // The transient ends at the first of three consecutive blocks with the usual decay.
    std::size_t end = 0;
    while (end + 3 < half &&
           !(std::abs(off[end]) < threshold && std::abs(off[end + 1]) < threshold &&
             std::abs(off[end + 2]) < threshold)) {
        ++end;
    }
    // If no part of the first half fits, the decay is not exponential and the check inconclusive.
    return end + 3 < half ? static_cast<double>(end * length) / rate_hz : 0;
}

}  // namespace vybeg
