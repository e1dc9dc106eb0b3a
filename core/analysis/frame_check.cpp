#include "core/analysis/frame_check.h"

#include "core/numerics/statistics.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <numbers>

namespace vybeg {
namespace {

using ChannelRows = std::vector<std::complex<double>>;

// How a channel moves, relative to its size.
struct ChannelMotion {
    double beat = 0;      // rms of the amplitude about an exponential
    double turn = 0;      // rms across its mean direction
    double smooth = 0;    // correlation of that with the next one: noise has none
    double backward = 0;  // share against its mean direction
};

// Rms of log |z| about a straight line, weighted as the phasors' noise has it.
double beat_of(const ChannelRows& z) {
    const auto log_of = [&z](std::size_t k) {
        const double weight = std::norm(z[k]);
        return LinePoint{static_cast<double>(k), std::log(weight) / 2, weight};
    };
    const LineFit line = fit_line(z.size(), log_of);
    if (!(line.weight > 0)) {
        return 0;
    }
    double squares = 0;
    for (std::size_t k = 0; k < z.size(); ++k) {
        if (const LinePoint at = log_of(k); at.weight > 0) {
            squares += at.weight * (at.y - line.mean_y) * (at.y - line.mean_y);
        }
    }
    const double left = squares - (line.spread > 0 ? line.slope * line.slope * line.spread : 0);
    return std::sqrt(std::max(left, 0.0) / line.weight);
}

ChannelMotion motion_of(const ChannelRows& z) {
    std::complex<double> sum = 0;
    for (const auto& each : z) {
        sum += each * std::abs(each);
    }
    const std::complex<double> back = std::polar(1.0, -std::arg(sum));
    double across = 0;
    double along = 0;
    double neighbours = 0;
    double before = 0;
    double backward = 0;
    for (const auto& each : z) {
        const std::complex<double> turned = each * back;
        across += turned.imag() * turned.imag();
        along += turned.real() * turned.real();
        neighbours += before * turned.imag();
        before = turned.imag();
        backward += turned.real() < 0 ? 1 : 0;
    }
    ChannelMotion motion;
    motion.beat = beat_of(z);
    motion.turn = along > 0 ? std::sqrt(across / along) : 0;
    motion.smooth = across > 0 ? neighbours / across : 0;
    motion.backward = backward / static_cast<double>(z.size());
    return motion;
}

// A loop that follows the phase leaves of it what is faster than the loop; across a null of the
// amplitude it does not come out backward.
bool is_followed(const ChannelMotion& channel, const ChannelMotion& other) {
    constexpr double still = 0.02;  // part of what a beat turns
    constexpr double certain = 0.8;
    constexpr double few = 0.01;
    return channel.turn < still * channel.beat && channel.backward < few &&
           other.smooth > certain && still * other.turn > channel.turn;
}

}  // namespace

std::optional<Diagnostic> mirrored_channel(const ChannelRows& c, const ChannelRows& d,
                                           double step_s) {
    constexpr double alike = 0.25;
    constexpr double certain = 10;
    std::array<double, 2> rates{};
    for (const std::size_t channel : {0, 1}) {
        const ChannelRows& z = channel == 0 ? c : d;
        std::complex<double> sum = 0;
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
            return std::nullopt;
        }
        rates[channel] = angle / (2 * std::numbers::pi * step_s);
    }
    if (std::abs(rates[0] + rates[1]) < alike * std::abs(rates[0] - rates[1])) {
        return Diagnostic{DiagnosticKind::phasors_mirrored,
                          {number_arg(rates[0], 3, "Hz"), number_arg(rates[1], 3, "Hz")}};
    }
    return std::nullopt;
}

std::optional<Diagnostic> followed_channel(const ChannelRows& c, const ChannelRows& d) {
    constexpr std::size_t few = 50;
    if (c.size() < few) {
        return std::nullopt;
    }
    const ChannelMotion of_c = motion_of(c);
    const ChannelMotion of_d = motion_of(d);
    if (is_followed(of_c, of_d)) {
        return Diagnostic{DiagnosticKind::reference_follows, {"C", "D"}};
    }
    if (is_followed(of_d, of_c)) {
        return Diagnostic{DiagnosticKind::reference_follows, {"D", "C"}};
    }
    return std::nullopt;
}

}  // namespace vybeg
