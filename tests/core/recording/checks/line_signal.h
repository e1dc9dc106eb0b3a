#pragma once

#include "core/recording/checks/fault_checks.h"

#include <QString>

#include <algorithm>
#include <cmath>
#include <complex>
#include <cstdint>
#include <numbers>
#include <random>
#include <span>
#include <vector>

namespace vybeg::test {

// One mode as both channels see it: Re(c e^{(2 pi i f - 1/tau) t}), from t = start_s on.
struct Line {
    double f_hz = 5300;
    double tau_s = 30;
    std::complex<double> c = 1;
    std::complex<double> d = 0;
    double start_s = 0;
};

struct Signal {
    std::vector<double> c;
    std::vector<double> d;
};

// Lines and white noise of sd `noise` in each channel.
inline Signal signal_of(const std::vector<Line>& lines, double rate_hz, double seconds,
                        double noise, std::uint64_t seed) {
    const auto frames = static_cast<std::size_t>(seconds * rate_hz);
    std::mt19937_64 random(seed);
    std::normal_distribution<double> gauss(0, 1);
    Signal signal;
    for (std::size_t j = 0; j < frames; ++j) {
        signal.c.push_back(noise * gauss(random));
        signal.d.push_back(noise * gauss(random));
    }
    for (const Line& line : lines) {
        const std::complex<double> turn =
            std::exp(std::complex(-1 / line.tau_s, 2 * std::numbers::pi * line.f_hz) / rate_hz);
        std::complex<double> wave = 1;
        for (auto j = static_cast<std::size_t>(line.start_s * rate_hz); j < frames; ++j) {
            signal.c[j] += (line.c * wave).real();
            signal.d[j] += (line.d * wave).real();
            wave *= turn;
        }
    }
    return signal;
}

// A complex number of this modulus and any phase.
inline std::complex<double> any_phase(double modulus, std::mt19937_64& random) {
    return std::polar(modulus, std::uniform_real_distribution(0.0, 2 * std::numbers::pi)(random));
}

// A mode of this amplitude with any direction, any phase and 20 % of quadrature.
inline Line any_line(double f_hz, double tau_s, double amplitude, std::mt19937_64& random) {
    const double angle = std::uniform_real_distribution(0.0, 2 * std::numbers::pi)(random);
    const std::complex<double> phase = any_phase(amplitude, random);
    const std::complex<double> quadrature(0, 0.2);
    return {f_hz, tau_s, phase * (std::cos(angle) - quadrature * std::sin(angle)),
            phase * (std::sin(angle) + quadrature * std::cos(angle))};
}

// `count` samples from `frame` on are lost in both channels.
inline void lose(Signal& signal, std::int64_t frame, std::int64_t count) {
    signal.c.erase(signal.c.begin() + frame, signal.c.begin() + frame + count);
    signal.d.erase(signal.d.begin() + frame, signal.d.begin() + frame + count);
}

// The `count` samples from `frame` on come twice.
inline void repeat(Signal& signal, std::int64_t frame, std::int64_t count) {
    for (std::vector<double>* x : {&signal.c, &signal.d}) {
        const std::vector<double> again(x->begin() + frame, x->begin() + frame + count);
        x->insert(x->begin() + frame + count, again.begin(), again.end());
    }
}

// In uneven portions, as a reader gives them.
inline std::vector<PhaseStep> steps_of(const Signal& signal, double f0_hz, double rate_hz) {
    PhaseStepCheck check(f0_hz, rate_hz);
    for (std::size_t at = 0; at < signal.c.size();) {
        const std::size_t count = std::min<std::size_t>(10007, signal.c.size() - at);
        check.add(static_cast<std::int64_t>(at), std::span(signal.c).subspan(at, count),
                  std::span(signal.d).subspan(at, count));
        at += count;
    }
    return check.finish();
}

}  // namespace vybeg::test
