#include "core/estimators/batch/profile.h"

#include "core/estimators/wave/jet.h"

#include <algorithm>
#include <numbers>

namespace vybeg {
namespace {

// Newton's steps over w with the sums of the samples.
NewtonEnd<double> climb(const Window& window, const FrequencyBracket& bracket, double w) {
    const auto power_at = [&](double at) {
        return profile_power(
            jets_of(window_moments(window, at), window_kernel(window.length(), at)));
    };
    // After a move of 1e-6 of a lobe, 1e-12 of it remain.
    return newton(w, power_at(w), {true, 1e-6 / static_cast<double>(window.length()), 29}, power_at,
                  [&](double at) { return bracket.contains(at); });
}

// Best point of a grid over the bracket, fine enough to hit the main lobe.
double grid_search(const Window& window, const FrequencyBracket& bracket, bool& at_edge) {
    constexpr int points = 33;
    double best_w = bracket.centre;
    double best = -1;
    for (int k = 0; k < points; ++k) {
        const double w = bracket.low + (bracket.high - bracket.low) * k / (points - 1);
        const WindowJets<double> jets =
            jets_of(window_projections(window, w), window_kernel(window.length(), w));
        const double power = profile_power(jets).value;
        if (power > best) {
            best = power;
            best_w = w;
            at_edge = k == 0 || k == points - 1;
        }
    }
    return best_w;
}

}  // namespace

ProfileMaximum maximise_profile(const Window& window, const FrequencyBracket& bracket) {
    ProfileMaximum maximum;
    NewtonEnd<double> end = climb(window, bracket, bracket.centre);
    maximum.w = end.x + end.move;
    if (!end.arrived) {
        bool at_edge = false;
        const double start = grid_search(window, bracket, at_edge);
        end = climb(window, bracket, start);
        maximum.w = end.arrived ? end.x + end.move : start;
        if (!end.arrived) {
            maximum.flags = at_edge ? Flag::not_converged | Flag::at_bound
                                    : static_cast<Flags>(Flag::not_converged);
        }
    }
    const Phasors sum = window_projections(window, maximum.w);
    const WindowKernel kernel = window_kernel(window.length(), maximum.w);
    const auto phasor = [&kernel](std::complex<double> z) {
        return std::complex<double>{z.real() / kernel.gram_cos, z.imag() / kernel.gram_sin};
    };
    maximum.phasors = {phasor(sum.c), phasor(sum.d)};
    return maximum;
}

VYBEG_DISPATCHED
void maximise_batch(const ProjectionBatch& batch, const TaylorFrame& frame, BatchMaximum& maximum) {
    const NewtonEnd<Vec8> end = newton(
        Vec8{}, profile_power(jets_at_reference(batch, frame)), {true, 1e-6, 6},
        [&](Vec8 x) VYBEG_INLINED { return profile_power(jets_at(batch, frame, x)); },
        [](Vec8 x) VYBEG_INLINED { return less(absolute(x), taylor_reach); });
    store(end.x + end.move, maximum.x);
    store(end.value(), maximum.power);
    store(select(end.arrived, Vec8{} + 1, Vec8{}), maximum.arrived);
}

FrequencyBracket main_lobe(double f0_hz, double rate_hz, std::int64_t n) {
    constexpr double pi = std::numbers::pi;
    const double w0 = 2 * pi * f0_hz / rate_hz;
    const double lobe = 2 * pi / static_cast<double>(n);
    // Within half a lobe of 0 or of half the rate cos and sin are nearly equal in the window, and
    // the fit is singular. A carrier in this range keeps half of its distance to the edge.
    const double edge = lobe / 2;
    return {std::max(w0 - lobe, std::min(edge, w0 / 2)), w0,
            std::min(w0 + lobe, std::max(pi - edge, (w0 + pi) / 2))};
}

}  // namespace vybeg
