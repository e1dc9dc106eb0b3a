#include "core/estimators/functional.h"

#include <cmath>

namespace vybeg {
namespace {

using Complex = std::complex<double>;
constexpr Complex i{0, 1};

enum Parameter { a_A, a_B, angle, phase, frequency };

// One channel's phasor x with its derivatives by the four wave parameters.
struct ChannelPhasor {
    Complex value;
    std::array<Complex, 4> first;
    std::array<std::array<Complex, 4>, 4> second;
};

// Derivatives of both phasors. The wave angle turns (c, d) like a vector, the phase like a complex
// number.
std::array<ChannelPhasor, 2> differentiate(const WaveState& state) {
    const Complex turn = std::polar(1.0, -state.alpha);
    const Complex cosine = turn * std::cos(state.two_theta_A);
    const Complex sine = turn * std::sin(state.two_theta_A);
    std::array<ChannelPhasor, 2> x{};
    x[0].first[a_A] = cosine;
    x[0].first[a_B] = i * sine;
    x[1].first[a_A] = sine;
    x[1].first[a_B] = -i * cosine;
    for (ChannelPhasor& channel : x) {
        channel.value = state.a_A * channel.first[a_A] + state.a_B * channel.first[a_B];
    }
    const auto turned = [&x](std::size_t channel, auto member) {
        return channel == 0 ? -member(x[1]) : member(x[0]);
    };
    for (std::size_t channel = 0; channel < 2; ++channel) {
        ChannelPhasor& own = x[channel];
        own.first[angle] = turned(channel, [](const ChannelPhasor& p) { return p.value; });
        own.first[phase] = -i * own.value;
        for (const Parameter amplitude : {a_A, a_B}) {
            own.second[amplitude][angle] = own.second[angle][amplitude] =
                turned(channel, [amplitude](const ChannelPhasor& p) { return p.first[amplitude]; });
            own.second[amplitude][phase] = own.second[phase][amplitude] = -i * own.first[amplitude];
        }
        own.second[angle][angle] = own.second[phase][phase] = -own.value;
        own.second[angle][phase] = own.second[phase][angle] = -i * own.first[angle];
    }
    return x;
}

void add_channel(Functional& f, const ChannelPhasor& x, const ChannelMoments& z,
                 const WindowKernel& kernel) {
    // By the phasor's components: value = -2 (Re x p + Im x q) + Re x^2 gram_cos + Im x^2 gram_sin
    // with p = Re z0, q = Im z0 (the sample is Re x cos - Im x sin, and Im z0 = -sum s sin).
    const double re = x.value.real();
    const double im = x.value.imag();
    const double p = z[0].real();
    const double q = z[0].imag();
    const double p1 = z[1].imag();
    const double q1 = -z[1].real();
    const double p2 = -z[2].real();
    const double q2 = -z[2].imag();
    f.value += re * (re * kernel.gram_cos - 2 * p) + im * (im * kernel.gram_sin - 2 * q);

    const double by_re = 2 * (re * kernel.gram_cos - p);
    const double by_im = 2 * (im * kernel.gram_sin - q);
    const double by_re_w = 2 * (re * kernel.slope - p1);
    const double by_im_w = -2 * (im * kernel.slope + q1);
    for (int a = 0; a < 4; ++a) {
        const Complex xa = x.first[static_cast<std::size_t>(a)];
        f.gradient[a] += by_re * xa.real() + by_im * xa.imag();
        f.hessian(a, frequency) += by_re_w * xa.real() + by_im_w * xa.imag();
        for (int b = 0; b < 4; ++b) {
            const Complex xb = x.first[static_cast<std::size_t>(b)];
            const Complex xab = x.second[static_cast<std::size_t>(a)][static_cast<std::size_t>(b)];
            f.hessian(a, b) += 2 * kernel.gram_cos * xa.real() * xb.real() +
                               2 * kernel.gram_sin * xa.imag() * xb.imag() + by_re * xab.real() +
                               by_im * xab.imag();
        }
    }
    f.gradient[frequency] += (re * re - im * im) * kernel.slope - 2 * (re * p1 + im * q1);
    f.hessian(frequency, frequency) += (re * re - im * im) * kernel.bend - 2 * (re * p2 + im * q2);
}

}  // namespace

Functional evaluate_functional(const WaveParameters& parameters, const Moments& moments,
                               const WindowKernel& kernel) {
    Functional f{0, Vector5::Zero(), Matrix5::Zero()};
    const std::array<ChannelPhasor, 2> x = differentiate(parameters.state);
    add_channel(f, x[0], moments.c, kernel);
    add_channel(f, x[1], moments.d, kernel);
    for (int a = 0; a < 4; ++a) {
        f.hessian(frequency, a) = f.hessian(a, frequency);
    }
    return f;
}

}  // namespace vybeg
