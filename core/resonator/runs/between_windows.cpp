#include "core/resonator/runs/between_windows.h"

#include "core/numerics/dense_solvers.h"

#include <array>
#include <cmath>
#include <numbers>

namespace vybeg {
namespace {

using Complex = std::complex<double>;
using Eigen::Index;
using std::numbers::pi;

constexpr double band = 0.25;  // cycles per window
constexpr Index frequencies = 64;
// Weight of the noise gain, so small that it costs 1e-6 of the signal.
constexpr double regularisation = 1e-6;

}  // namespace

BetweenWindows::BetweenWindows() {
    constexpr auto taps = static_cast<Index>(2 * reach);
    Eigen::MatrixXd passed = Eigen::MatrixXd::Zero(2 * frequencies + taps, taps);
    Eigen::MatrixXd wanted = Eigen::MatrixXd::Zero(passed.rows(), parts + 1);
    for (Index k = 0; k < frequencies; ++k) {
        const double turn = 2 * pi * band * (static_cast<double>(k) + 0.5) /
                            static_cast<double>(frequencies);  // per window
        const double mean = std::sin(turn / 2) / (turn / 2);
        for (Index tap = 0; tap < taps; ++tap) {
            const double off = static_cast<double>(tap) - (static_cast<double>(reach) - 1);
            passed(2 * k, tap) = mean * std::cos(turn * off);
            passed(2 * k + 1, tap) = mean * std::sin(turn * off);
        }
        for (Index part = 0; part <= static_cast<Index>(parts); ++part) {
            const double off = static_cast<double>(part) / static_cast<double>(parts);
            wanted(2 * k, part) = std::cos(turn * off);
            wanted(2 * k + 1, part) = std::sin(turn * off);
        }
    }
    passed.bottomRows(taps).diagonal().setConstant(regularisation *
                                                   std::sqrt(static_cast<double>(frequencies)));
    weights_ = passed.colPivHouseholderQr().solve(wanted).transpose();
}

Complex BetweenWindows::at(std::size_t part, std::span<const Complex> means) const {
    Complex sum = 0;
    for (std::size_t tap = 0; tap < 2 * reach; ++tap) {
        sum += weights_(static_cast<Index>(part), static_cast<Index>(tap)) * means[tap];
    }
    return sum;
}

double BetweenWindows::phase(std::span<const Complex> c, std::span<const Complex> d) const {
    std::array<Complex, parts + 1> by_c;
    std::array<Complex, parts + 1> by_d;
    for (std::size_t part = 0; part <= parts; ++part) {
        by_c[part] = at(part, c);
        by_d[part] = at(part, d);
    }
    const auto sum = [&](std::size_t step) {
        double phase = 0;
        for (std::size_t part = 0; part < parts; part += step) {
            phase += std::arg(std::conj(by_c[part]) * by_c[part + step] +
                              std::conj(by_d[part]) * by_d[part + step]);
        }
        return phase;
    };
    // A step weights unequal modes by their power, with an error of third order.
    return (4 * sum(1) - sum(2)) / 3;
}

}  // namespace vybeg
