#pragma once

#include "core/estimators/wave/lanes.h"
#include "core/estimators/wave/window_moments.h"

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace vybeg {

// Projections of windows as power series in the frequency (METHOD section 5.6): one product of the
// samples with a basis that is the same for every window, after which a frequency near the
// reference is tried without touching a sample.
//
// With v = 2u/n in [-1, 1] and x = (w - w0) n/2, the projections at w are
//     sum s cos wu = sum_k x^k sum_j s_j v^k/k! cos(w0 u + k pi/2)
//     sum s sin wu = sum_k x^k sum_j s_j v^k/k! sin(w0 u + k pi/2).
inline constexpr std::size_t taylor_orders = 8;

// Largest |x| at which the series is used. What is cut off is below x^8/8! of a projection and
// x^7/7! of its slope: 4e-15 and 5e-13.
inline constexpr double taylor_reach = 0.06;

// Windows up to this length are projected as a whole. The basis of longer ones would not stay in
// cache: they are cut into stretches of 256 samples, whose series are brought to the window's
// centre and added (projection_sums.h).
inline constexpr std::int64_t longest_whole_window = 1024;
inline constexpr std::int64_t stretch_length = 256;

// What of the windows' length and the reference frequency is in closed form.
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

// The functions that the samples are multiplied with.
class TaylorBasis : public TaylorFrame {
public:
    TaylorBasis(std::int64_t n, double w0);

    // Samples that one stretch has at most. Its series counts time from the middle of so many
    // samples, also where it has fewer.
    std::int64_t stretch() const { return stretch_; }
    // Of sample j of a stretch: the basis functions of cos, then those of sin, by order.
    const double* row(std::int64_t j) const { return rows_.data() + 2 * taylor_orders * j; }

private:
    std::int64_t stretch_;
    std::vector<double> rows_;
};

// Sums over windows that stand side by side. A window with a missing sample has cc + dd that is not
// finite.
using TaylorSums = std::array<Lanes, taylor_orders>;
struct ProjectionBatch {
    TaylorSums c_cos;
    TaylorSums c_sin;
    TaylorSums d_cos;
    TaylorSums d_sin;
    Lanes cc;  // sum C^2
    Lanes dd;
    Lanes cd;
    Lanes cq;  // sum C(t) D(t - t3), where delayed samples were given
};

// One window's projections at x.
Projections lane_projections(const ProjectionBatch& batch, std::size_t lane, double x);

}  // namespace vybeg
