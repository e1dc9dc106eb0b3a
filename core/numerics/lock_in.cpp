#include "core/numerics/lock_in.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace vybeg {

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

void LockIn::take_out(double offset_hz, double step_s, std::span<const double> time_s,
                      std::vector<std::complex<double>>& z) const {
    const std::complex<double> turn(0, 2 * std::numbers::pi * offset_hz * tau_s());
    const std::complex<double> slope_s =
        delay_s() * turn / (1.0 + turn);  // of log response + delay
    const std::complex<double> gain = response(offset_hz);
    const std::vector<std::complex<double>> seen = z;
    // Over less than a time constant of both sides the difference would be that of the noise.
    const auto reach = static_cast<std::size_t>(std::max(std::lround(tau_s() / step_s), 1L));
    const auto goes_on = [&](std::size_t k) { return time_s[k] - time_s[k - 1] <= 1.5 * step_s; };
    for (std::size_t begin = 0, end = 0; begin < z.size(); begin = end) {
        end = begin + 1;
        while (end < z.size() && goes_on(end)) {
            ++end;
        }
        for (std::size_t k = begin; k < end; ++k) {
            const std::size_t from = k - std::min(reach, k - begin);
            const std::size_t to = std::min(k + reach, end - 1);
            const std::complex<double> rate =
                from == to ? 0 : (seen[to] - seen[from]) / (time_s[to] - time_s[from]);
            z[k] = (seen[k] - slope_s * rate) / gain;
        }
    }
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

std::pair<std::vector<double>, double> LockIn::noise_of_means(std::size_t count,
                                                              double step_s) const {
    constexpr std::size_t most_lags = 64;
    constexpr double least = 1e-3;
    std::vector<double> sums;
    const auto n = static_cast<std::ptrdiff_t>(count);
    for (std::size_t lag = 0; lag < most_lags; ++lag) {
        double sum = 0;
        for (std::ptrdiff_t i = 1 - n; i < n; ++i) {
            const auto rows = static_cast<double>(static_cast<std::ptrdiff_t>(lag) * n + i);
            sum += static_cast<double>(n - std::abs(i)) * correlation(rows * step_s);
        }
        if (lag > 0 && std::abs(sum) < least * sums.front()) {
            break;
        }
        sums.push_back(sum);
    }
    const double first = sums.front();
    for (double& sum : sums) {
        sum /= first;
    }
    return {sums, first / static_cast<double>(n * n)};
}

}  // namespace vybeg
