#include "core/estimators/wave/profile.h"

#include <array>
#include <cmath>

namespace vybeg {
namespace {

// p^2 / g for one component of one channel, with its derivatives by w.
void add_component(ProfilePower& power, double p, double p1, double p2, double g, double g1,
                   double g2) {
    const double ratio = p / g;
    const double ratio1 = (p1 - ratio * g1) / g;
    power.value += p * ratio;
    power.slope += 2 * ratio * p1 - ratio * ratio * g1;
    power.bend += 2 * ratio1 * p1 + 2 * ratio * p2 - 2 * ratio * ratio1 * g1 - ratio * ratio * g2;
}

void add_channel(ProfilePower& power, const ChannelMoments& z, const WindowKernel& kernel) {
    // z[0] = p - i q with p = sum s cos wu, q = sum s sin wu; d/dw multiplies by -i u.
    add_component(power, z[0].real(), z[1].imag(), -z[2].real(), kernel.gram_cos, kernel.slope,
                  kernel.bend);
    add_component(power, -z[0].imag(), z[1].real(), z[2].imag(), kernel.gram_sin, -kernel.slope,
                  -kernel.bend);
}

struct Ascent {
    double w = 0;
    bool arrived = false;
};

// Newton's method on the slope; false where it would leave the bracket or the power is not concave.
Ascent newton(const Window& window, const FrequencyBracket& bracket, double w) {
    const auto n = static_cast<double>(window.length());
    constexpr int most_steps = 30;
    for (int step = 0; step < most_steps; ++step) {
        const ProfilePower power =
            profile_power(window_moments(window, w), window_kernel(window.length(), w));
        if (!(power.bend < 0)) {
            return {w, false};
        }
        const double move = -power.slope / power.bend;
        w += move;
        if (!bracket.contains(w)) {
            return {w, false};
        }
        // Convergence is quadratic: after a move of 1e-6 of a lobe what remains is 1e-12 of it.
        if (std::abs(move) * n < 1e-6) {
            return {w, true};
        }
    }
    return {w, false};
}

// The best of a grid over the bracket, fine enough not to miss the main lobe.
double grid_search(const Window& window, const FrequencyBracket& bracket, bool& at_edge) {
    constexpr int points = 33;
    double best_w = bracket.centre;
    double best = -1;
    for (int k = 0; k < points; ++k) {
        const double w = bracket.low + (bracket.high - bracket.low) * k / (points - 1);
        const double power =
            profile_power(window_projections(window, w), window_kernel(window.length(), w));
        if (power > best) {
            best = power;
            best_w = w;
            at_edge = k == 0 || k == points - 1;
        }
    }
    return best_w;
}

}  // namespace

ProfilePower profile_power(const Moments& moments, const WindowKernel& kernel) {
    ProfilePower power;
    add_channel(power, moments.c, kernel);
    add_channel(power, moments.d, kernel);
    return power;
}

double profile_power(const Projections& projections, const WindowKernel& kernel) {
    const auto channel = [&kernel](std::complex<double> z) {
        return z.real() * z.real() / kernel.gram_cos + z.imag() * z.imag() / kernel.gram_sin;
    };
    return channel(projections.c) + channel(projections.d);
}

Phasors best_phasors(const Projections& projections, const WindowKernel& kernel) {
    const auto phasor = [&kernel](std::complex<double> z) {
        return std::complex<double>{z.real() / kernel.gram_cos, z.imag() / kernel.gram_sin};
    };
    return {phasor(projections.c), phasor(projections.d)};
}

ProfileMaximum maximise_profile(const Window& window, const FrequencyBracket& bracket) {
    ProfileMaximum maximum;
    Ascent ascent = newton(window, bracket, bracket.centre);
    if (!ascent.arrived) {
        const double start = grid_search(window, bracket, maximum.at_bound);
        ascent = newton(window, bracket, start);
        if (!ascent.arrived) {
            ascent.w = start;
        } else {
            maximum.at_bound = false;
        }
    }
    maximum.w = ascent.w;
    maximum.converged = ascent.arrived;
    maximum.phasors = best_phasors(window_projections(window, ascent.w),
                                   window_kernel(window.length(), ascent.w));
    return maximum;
}

}  // namespace vybeg
