#pragma once

#include "core/estimators/wave/jet.h"
#include "core/estimators/wave/window_moments.h"
#include "core/numerics/lanes.h"

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace vybeg {

// Projections of windows as power series in the frequency (METHOD section 5.6): one product of the
// samples with a basis common to all windows. Projections at frequencies near the reference then
// need no sample.
//
// With v = 2u/n in [-1, 1] and x = (w - w0) n/2, the projections at w are
//     sum s cos wu = sum_k x^k sum_j s_j v^k/k! cos(w0 u + k pi/2)
//     sum s sin wu = sum_k x^k sum_j s_j v^k/k! sin(w0 u + k pi/2).
inline constexpr std::size_t taylor_orders = 8;

// Largest |x| at which the series is used. The truncation error is below x^8/8! of a projection and
// x^7/7! of its slope: 4e-15 and 5e-13.
inline constexpr double taylor_reach = 0.06;

// Largest window projected as a whole. Longer windows are cut into segments of 256 samples, because
// their basis would not stay in cache; the series of the segments are moved to the window's centre
// and added (projection_sums.h).
inline constexpr std::int64_t longest_whole_window = 1024;
inline constexpr std::int64_t segment_length = 256;

// Closed-form quantities of a window length and a reference frequency.
class TaylorFrame {
public:
    // Windows of n samples, reference frequency w0 (rad per sample, 0 < w0 < pi).
    TaylorFrame(std::int64_t n, double w0);

    std::int64_t length() const { return n_; }
    double w0() const { return w0_; }
    double spread() const { return spread_; }  // WindowKernel::spread

    // window_kernel(n, w0 + 2x/n), from its series at w0.
    WindowKernel kernel(double x) const;
    // gram_cos as a series in x.
    static constexpr std::size_t gram_orders = 10;
    const std::array<double, gram_orders>& gram() const { return gram_; }

private:
    std::int64_t n_;
    double w0_;
    std::array<double, gram_orders> gram_;
    double spread_;
};

// Basis functions, the factors of the samples.
class TaylorBasis : public TaylorFrame {
public:
    TaylorBasis(std::int64_t n, double w0);

    // Largest number of samples of a segment. The time of its series counts from the centre of that
    // many samples, also for shorter segments.
    std::int64_t segment() const { return segment_; }
    // Row of sample j of a segment: the basis functions of cos, then those of sin, by order.
    const double* row(std::int64_t j) const { return rows_.data() + 2 * taylor_orders * j; }

private:
    std::int64_t segment_;
    std::vector<double> rows_;
};

// Sums over eight windows, one per lane. cc + dd is not finite for a window with a missing sample.
using TaylorSums = std::array<Lanes, taylor_orders>;
struct ProjectionBatch {
    TaylorSums c_cos;
    TaylorSums c_sin;
    TaylorSums d_cos;
    TaylorSums d_sin;
    Lanes cc;  // sum C^2
    Lanes dd;
    Lanes cd;
    Lanes cq;  // sum C(t) D(t - t3); only with delayed samples
};

// One window's projections at x.
Phasors lane_projections(const ProjectionBatch& batch, std::size_t lane, double x);

// A window's projections at one frequency, with their derivatives. Of signal S: p = sum S cos wu
// and q = sum S sin wu, hence 2<S e^{-iwu}> = 2/n (p - iq). g = sum cos^2 wu and h = sum sin^2 wu.
template <class Real>
struct WindowJets {
    Jet2<Real> pc;
    Jet2<Real> qc;
    Jet2<Real> pd;
    Jet2<Real> qd;
    Jet2<Real> g;
    Jet2<Real> h;
};

// The g of windows at x, with its derivatives by x.
template <class Real>
VYBEG_INLINED inline Jet2<Real> gram_jet(const TaylorFrame& frame, Real x) {
    const auto& gram = frame.gram();
    return polynomial_jet<TaylorFrame::gram_orders>(
        x, [&gram](std::size_t k) VYBEG_INLINED { return gram[k] + Real{}; });
}

// Of eight windows, by x.
template <class Projection>
VYBEG_INLINED inline WindowJets<Vec8> batch_jets(const ProjectionBatch& batch, const Jet2<Vec8>& g,
                                                 double n, Projection at) {
    return {at(batch.c_cos),
            at(batch.c_sin),
            at(batch.d_cos),
            at(batch.d_sin),
            g,
            {n - g.value, -g.slope, -g.bend}};
}

VYBEG_INLINED inline WindowJets<Vec8> jets_at(const ProjectionBatch& batch,
                                              const TaylorFrame& frame, Vec8 x) {
    return batch_jets(batch, gram_jet(frame, x), static_cast<double>(frame.length()),
                      [x](const TaylorSums& sums) VYBEG_INLINED {
                          return polynomial_jet<taylor_orders>(
                              x, [&](std::size_t k) VYBEG_INLINED { return load(sums[k]); });
                      });
}

// At x = 0 the value of a series is its first coefficient.
VYBEG_INLINED inline WindowJets<Vec8> jets_at_reference(const ProjectionBatch& batch,
                                                        const TaylorFrame& frame) {
    const auto& gram = frame.gram();
    return batch_jets(batch, {Vec8{} + gram[0], Vec8{} + gram[1], Vec8{} + 2 * gram[2]},
                      static_cast<double>(frame.length()),
                      [](const TaylorSums& sums) VYBEG_INLINED {
                          return Jet2<Vec8>{load(sums[0]), load(sums[1]), 2 * load(sums[2])};
                      });
}

// Power that a linear change of the four phasor components over a window adds to that of the best
// phasors at one frequency: sum of the squares of the residual's components along u cos wu and u
// sin wu, made orthogonal to cos and sin. At the best frequency it is the power of three
// parameters, the fourth being the frequency itself. `spread`: sum u^2, in the units of the jets.
template <class Real>
VYBEG_INLINED inline Real motion_power(const WindowJets<Real>& s, double spread) {
    // sum u sin wu cos wu is minus half the slope of g.
    const Real by_g = 1 / s.g.value;
    const Real by_h = 1 / s.h.value;
    const Real half = 0.5 * s.g.slope;
    const Real for_cos = half * by_g;
    const Real for_sin = half * by_h;
    const Real c_sin = s.pc.slope - s.pc.value * for_cos;
    const Real d_sin = s.pd.slope - s.pd.value * for_cos;
    const Real c_cos = s.qc.slope + s.qc.value * for_sin;
    const Real d_cos = s.qd.slope + s.qd.value * for_sin;
    const Real with_sin = 0.5 * (spread + 0.5 * s.g.bend) - half * for_cos;
    const Real with_cos = 0.5 * (spread - 0.5 * s.g.bend) - half * for_sin;
    return (c_sin * c_sin + d_sin * d_sin) / with_sin + (c_cos * c_cos + d_cos * d_cos) / with_cos;
}

// sum u^2 in units of x.
inline double spread_by_x(const TaylorFrame& frame) {
    const auto n = static_cast<double>(frame.length());
    return 4 * frame.spread() / (n * n);
}

// Of one window, by w: d/dw multiplies by -iu.
inline WindowJets<double> jets_of(const WindowMoments& z, const WindowKernel& kernel) {
    const auto p = [](const ChannelMoments& of) {
        return Jet2<double>{of[0].real(), of[1].imag(), -of[2].real()};
    };
    const auto q = [](const ChannelMoments& of) {
        return Jet2<double>{-of[0].imag(), of[1].real(), of[2].imag()};
    };
    return {p(z.c),
            q(z.c),
            p(z.d),
            q(z.d),
            {kernel.gram_cos, kernel.slope, kernel.bend},
            {kernel.gram_sin, -kernel.slope, -kernel.bend}};
}

// Values alone.
inline WindowJets<double> jets_of(const Phasors& z, const WindowKernel& kernel) {
    return jets_of(WindowMoments{{z.c, 0, 0}, {z.d, 0, 0}}, kernel);
}

}  // namespace vybeg
