#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

namespace vybeg {

// The Kaiser window, I0(beta sqrt(1 - x^2)) / I0(beta) at x in [-1, 1]; 1 at the middle, 0 outside.
double kaiser_window(double x, double beta);
// At the middles of `size` equal parts of it.
std::vector<double> kaiser_weights(std::size_t size, double beta);

// Four terms of Blackman and Harris (F. J. Harris, 1978), side lobes of -92 dB; the angle runs from
// 0 to 2 pi over the window.
double blackman_harris(double angle);

// sin(pi x) / (pi x).
double sinc(double x);

// Kaiser's empirical design (J. F. Kaiser, 1974): a windowed-sinc low-pass of 2 M + 1 taps keeps
// its ripple below -attenuation_db on both sides of a transition.
struct KaiserDesign {
    double beta = 0;
    std::int64_t half_length = 0;  // M
};

// Transition in cycles per sample, stop edge minus pass edge. Preconditions: attenuation_db > 50,
// transition > 0.
KaiserDesign kaiser_design(double attenuation_db, double transition);

// The half h[0] .. h[M] of a symmetric band-pass of unit gain between the cut-offs low < high
// (cycles per sample, the middles of its transitions).
std::vector<double> band_pass_taps(double low, double high, const KaiserDesign& design);

}  // namespace vybeg
