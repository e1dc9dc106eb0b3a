#pragma once

#include "core/estimators/wave/lanes.h"
#include "core/estimators/wave/window_moments.h"

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

}  // namespace vybeg
