#include "core/numerics/lock_in.h"

#include <cmath>
#include <cstddef>
#include <numbers>

namespace vybeg {
namespace {

using Complex = std::complex<double>;

// Sums over the second differences of the image of h = 1 and of the phasors.
struct ImageSums {
    double image = 0;         // |second difference of the image|^2
    double image_itself = 0;  // |image|^2
    Complex product = 0;
    double rows = 0;  // |second difference of the phasors|^2
    std::size_t count = 0;
};

}  // namespace

double LockIn::tau_s() const {
    // |1 / (1 + i w tau)^p|^2 is a half at the bandwidth.
    return order == 0
               ? 0
               : std::sqrt(std::pow(2.0, 1.0 / order) - 1) / (2 * std::numbers::pi * bandwidth_hz);
}

double LockIn::delay_s() const {
    return order * tau_s();
}

std::complex<double> LockIn::response(double offset_hz) const {
    const double w = 2 * std::numbers::pi * offset_hz;
    return std::polar(1.0, w * delay_s()) / std::pow(std::complex<double>(1, w * tau_s()), order);
}

double LockIn::correlation(double t_s) const {
    if (order == 0) {
        return t_s == 0 ? 1 : 0;
    }
    const double x = std::abs(t_s) / tau_s();
    double binomial = 1;
    double sum = 0;
    for (int j = 0; j < order; ++j) {
        sum += binomial * std::pow(x, order - 1 - j) * std::tgamma(order + j) /
               std::pow(2.0, order + j);
        binomial *= static_cast<double>(order - 1 - j) / (j + 1);
    }
    const double whole = std::tgamma(2 * order - 1) / std::pow(2.0, 2 * order - 1);
    return std::exp(-x) * sum / whole;
}

void remove_image(double f_ref_hz, std::span<const double> time_s, std::span<Complex> c,
                  std::span<Complex> d) {
    constexpr double even = 0.01;
    constexpr double most_image = 0.2;    // of a filter that lets no more than that through
    constexpr double least_moves = 1e-4;  // an image that folds near zero is motion
    constexpr double above_noise = 25;
    const auto image_of = [&](std::span<const Complex> z, std::size_t k) {
        const double turns = std::fmod(2 * f_ref_hz * time_s[k], 1.0);
        return std::conj(z[k]) * std::polar(1.0, -2 * std::numbers::pi * turns);
    };
    ImageSums sums;
    for (std::size_t k = 1; k + 1 < time_s.size(); ++k) {
        const double before = time_s[k] - time_s[k - 1];
        const double behind = time_s[k + 1] - time_s[k];
        if (std::abs(behind - before) > even * before) {
            continue;
        }
        for (const std::span<Complex> z : {c, d}) {
            const Complex image = image_of(z, k);
            const Complex bent = image_of(z, k - 1) - 2.0 * image + image_of(z, k + 1);
            const Complex rows = z[k - 1] - 2.0 * z[k] + z[k + 1];
            sums.image += std::norm(bent);
            sums.image_itself += std::norm(image);
            sums.product += std::conj(bent) * rows;
            sums.rows += std::norm(rows);
            ++sums.count;
        }
    }
    if (!(sums.image > least_moves * sums.image_itself)) {
        return;
    }
    const Complex h = sums.product / sums.image;
    const double explained = std::norm(h) * sums.image;
    const double noise = (sums.rows - explained) / static_cast<double>(sums.count);
    if (std::abs(h) > most_image || !(explained > above_noise * noise)) {
        return;
    }
    for (const std::span<Complex> z : {c, d}) {
        for (std::size_t k = 0; k < z.size(); ++k) {
            z[k] = (z[k] - h * image_of(z, k)) / (1 - std::norm(h));
        }
    }
}

}  // namespace vybeg
