#include "core/analysis/phasor_findings.h"

#include <array>
#include <cmath>
#include <cstddef>
#include <numbers>

namespace vybeg {
namespace {

using Complex = std::complex<double>;

// Both channels hold the same two modes: only with a sign of Y of their own, or with the reference
// just between modes each of which is in one channel, do they turn against each other.
void look_for_mirror(double step_s, std::span<const Complex> c, std::span<const Complex> d,
                     std::vector<Diagnostic>& found) {
    constexpr double alike = 0.25;
    constexpr double certain = 10;
    std::array<double, 2> rates{};
    for (const std::size_t channel : {0, 1}) {
        const std::span<const Complex> z = channel == 0 ? c : d;
        Complex sum = 0;
        for (std::size_t k = 1; k < z.size(); ++k) {
            sum += z[k] * std::conj(z[k - 1]);
        }
        double across = 0;
        for (std::size_t k = 1; k < z.size(); ++k) {
            const double off = (z[k] * std::conj(z[k - 1]) * std::conj(sum)).imag();
            across += off * off;
        }
        const double angle = std::arg(sum);
        if (std::abs(angle) < certain * std::sqrt(across) / std::norm(sum)) {
            return;
        }
        rates[channel] = angle / (2 * std::numbers::pi * step_s);
    }
    if (std::abs(rates[0] + rates[1]) < alike * std::abs(rates[0] - rates[1])) {
        found.push_back({DiagnosticKind::phasors_mirrored,
                         {number_arg(rates[0], 3, "Hz"), number_arg(rates[1], 3, "Hz")}});
    }
}

// A reference that follows C leaves its phase less scatter than the noise has, which the amplitude
// shows: the frequency, and all that is relative to it, is gone from the phasors.
void look_for_lock(std::span<const Complex> c, std::vector<Diagnostic>& found) {
    constexpr std::size_t blocks = 40;
    constexpr double least_share = 0.1;
    const std::size_t count = c.size() / blocks;
    if (count == 0) {
        return;
    }
    std::vector<Complex> means(blocks);
    Complex direction = 0;
    for (std::size_t k = 0; k < blocks * count; ++k) {
        means[k / count] += c[k] / static_cast<double>(count);
        direction += c[k];
    }
    direction /= std::abs(direction);
    double across = 0;
    double along = 0;
    for (std::size_t k = 0; k < blocks; ++k) {
        across += std::pow((means[k] * std::conj(direction)).imag(), 2) / blocks;
        if (k >= 4) {
            // Fourth differences of the logarithm leave nothing of a decay, and 70 times the
            // variance of the noise.
            const auto log_at = [&means, k](std::size_t back) {
                return std::log(std::abs(means[k - back]));
            };
            const double rest =
                std::abs(means[k - 2]) *
                (log_at(0) - 4 * log_at(1) + 6 * log_at(2) - 4 * log_at(3) + log_at(4));
            along += rest * rest / (70.0 * (blocks - 4));
        }
    }
    if (across < least_share * along) {
        found.push_back({DiagnosticKind::phasors_locked, {}});
    }
}

}  // namespace

std::vector<Diagnostic> phasor_findings(double step_s, std::span<const Complex> c,
                                        std::span<const Complex> d) {
    std::vector<Diagnostic> found;
    look_for_mirror(step_s, c, d, found);
    look_for_lock(c, found);
    return found;
}

}  // namespace vybeg
