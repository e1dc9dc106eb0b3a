#pragma once

#include "core/simulation/free_decay.h"

#include <Eigen/Core>

#include <array>
#include <cmath>
#include <complex>
#include <cstdint>
#include <optional>

namespace vybeg {

// Fractional turns of a frequency up to a frame (whole or half), exact to rounding for any length:
// the product is reduced by whole turns, which is exact, with its own rounding error carried.
inline double turns_at(double frame, double f_hz, double rate_hz) {
    const double product = frame * f_hz;
    const double lost = std::fma(frame, f_hz, -product);
    return (std::remainder(product, rate_hz) + lost) / rate_hz;
}

// The slow motion dz/dt = M z of METHOD section 8, z = (c, d) relative to f0, in closed form. M is
// split into its mean m and a traceless N with N^2 = s^2 I, so that
//     exp(M t) = exp(m t) (cosh(s t) I + sinh(s t)/s N)
// for every t at once: no step, no accumulated error.
class SlowMotion {
public:
    // Precondition: check(decay) passes.
    explicit SlowMotion(const FreeDecay& decay);

    // exp(M t), t in seconds.
    Eigen::Matrix2cd propagator(double t) const;

    // e^{i w0 t} at a frame (whole or half), exact to rounding however long the record.
    std::complex<double> carrier(double frame) const;

    // The phasors with their carrier, z e^{i w0 t}, at a frame: the signals are their real parts.
    Eigen::Vector2cd at_frame(double frame) const {
        return propagator(frame / rate_hz_) * start_ * carrier(frame);
    }

    // Mean rate of phase of z, weighted with the power of its components, relative to f0:
    // Im(z^H M z) / (2 pi |z|^2), Hz. NaN where z = 0.
    double frequency_offset_hz(const Eigen::Vector2cd& z) const;

    // M, 1/s, and z at t = 0.
    Eigen::Matrix2cd matrix() const { return mean_ * Eigen::Matrix2cd::Identity() + traceless_; }
    const Eigen::Vector2cd& start() const { return start_; }

private:
    double f0_hz_;
    double rate_hz_;
    std::complex<double> mean_;        // m, 1/s
    Eigen::Matrix2cd traceless_;       // N, 1/s
    std::complex<double> half_split_;  // s, 1/s
    Eigen::Vector2cd start_;
};

// The slow motion where frequency and damping depend on the power |z|^2 (FreeDecay), z = (c, d):
//     dz/dt = M z + i (2 pi b/3) (2|z|^2 z + (z.z) conj z) - k |z|^2 z
// by Taylor series of order 16 from step to step. A step is `fraction` of 1/rate, where rate = |M|
// + 2 (2 pi |b| + |k|) |z|^2 bounds the inverse radius of convergence: at a tenth the truncation
// error is below the rounding of a double.
class PowerMotion {
public:
    PowerMotion(const FreeDecay& decay, const Eigen::Matrix2cd& linear,
                const Eigen::Vector2cd& start, double fraction = 0.1);

    // z at t, seconds, also before 0. Only the last step is stored. Precondition: ascending times,
    // except the first.
    Eigen::Vector2cd at(double t);

    // dz/dt of the motion at z.
    Eigen::Vector2cd slope(const Eigen::Vector2cd& z) const;

private:
    static constexpr std::size_t order = 16;
    using Series = std::array<std::complex<double>, order + 1>;  // in the step's own time, 0 to 1

    void expand(double direction);
    Eigen::Vector2cd sum(double x) const;

    Eigen::Matrix2cd linear_;
    double spring_;   // 2 pi b / 3
    double damping_;  // k
    double fraction_;
    double begin_ = 0;  // of the step, s
    double step_ = 0;   // its length, s; negative: backwards
    Eigen::Vector2cd z_;
    Series c_{};
    Series d_{};
};

// Factor A of the linear motion w = exp(M t) z(0), z = A w, under friction and a drive, which leave
// the shape of the wave as it is:
//     dA/dt = g(t) A - dry/|w| - air A^2 |w|        A = 0 from the instant at which the wave rests
// by Runge and Kutta's fourth order, in steps of 0.5 % of the fastest change, and cubics between
// them: errors below 1e-10.
class AmplitudeFactor {
public:
    AmplitudeFactor(const FreeDecay& decay, const SlowMotion& linear);

    // A at t, seconds; 1 before the start. Ascending times.
    double at(double t);

private:
    double slope(double t, double factor) const;
    double size_of_linear(double t) const;
    double next_switch() const;
    void advance();

    FreeDecay decay_;
    SlowMotion linear_;
    double slowest_;  // rate of change of the linear motion, 1/s
    double least_;    // amplitude of a wave at rest
    struct Node {
        double time_s = 0;
        double factor = 1;
        double slope = 0;
    };
    double time_s_ = 0;  // start of the step
    Node begin_;
    Node end_;
};

// The wave frame by frame: the slow motion, linear or not, with its carrier whose frequency may
// drift and settle.
class DecayMotion {
public:
    // `late_s`: delay of the motion against each frame, s. Precondition: check(decay) passes.
    explicit DecayMotion(const FreeDecay& decay, double late_s = 0);

    // Phasors with their carrier, the signals being their real parts, at frame 0, 1, 2, ...
    Eigen::Vector2cd next();

    // The same at a frame (whole or half); frames in ascending order, not mixed with next().
    Eigen::Vector2cd at_frame(double frame);

    // f(t) plus the mean rate of phase of both phasors at a frame, Hz; `phasors` are those there.
    double frequency_hz(double frame, const Eigen::Vector2cd& phasors) const;

private:
    std::complex<double> turn(double frame) const;

    FreeDecay decay_;
    double late_s_;
    SlowMotion linear_;
    std::optional<PowerMotion> by_power_;
    std::optional<AmplitudeFactor> factor_;
    bool turns_;                    // whether f changes
    std::complex<double> earlier_;  // rotation of the carrier in late_s_
    Eigen::Matrix2cd step_;
    Eigen::Vector2cd z_;
    std::int64_t frame_ = 0;
};

}  // namespace vybeg
