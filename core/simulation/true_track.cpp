#include "core/simulation/true_track.h"

#include "core/base/number_text.h"
#include "core/numerics/phase.h"
#include "core/simulation/decay_motion.h"
#include "core/windows/window_plan.h"

#include <Eigen/LU>
#include <Eigen/SVD>

#include <cmath>
#include <limits>
#include <numbers>
#include <optional>

namespace vybeg {
namespace {

using std::numbers::pi;

constexpr std::int64_t most_rows = std::int64_t{1} << 26;  // 9 GB of track
constexpr double nan = std::numeric_limits<double>::quiet_NaN();
// Relative to the amplitude: four digits above the rounding of the compared values.
constexpr double vanishing = 1e-12;

// Ellipse of (C, D) = ellipse (cos wt, sin wt): rotation, two signed half-axes and a phase.
struct Axes {
    double long_axis = 0;   // a_A
    double short_axis = 0;  // a_B, its sign is the sense of rotation
    double angle = 0;       // 2theta_A
    double phase = 0;       // alpha, chosen together with the angle
};

Axes axes_of(const Eigen::Matrix2d& ellipse) {
    const Eigen::JacobiSVD<Eigen::Matrix2d> svd(ellipse, Eigen::ComputeFullU | Eigen::ComputeFullV);
    Axes axes;
    axes.long_axis = svd.singularValues()(0);
    axes.short_axis = std::copysign(svd.singularValues()(1), ellipse.determinant());
    axes.angle = std::atan2(svd.matrixU()(1, 0), svd.matrixU()(0, 0));
    axes.phase = std::atan2(svd.matrixV()(1, 0), svd.matrixV()(0, 0));
    return axes;
}

double phase_lead(const Eigen::Vector2cd& phasors) {
    const double least = vanishing * phasors.norm();
    if (std::abs(phasors(0)) <= least || std::abs(phasors(1)) <= least) {
        return nan;
    }
    return wrap(std::arg(phasors(1)) - std::arg(phasors(0)));
}

// The angle unwrapped modulo pi from the row before it, the first into (-pi/2, pi/2].
double unwrapped(double angle, const std::optional<double>& previous) {
    if (previous) {
        return nearest_branch(angle, *previous, pi);
    }
    const double nearest = nearest_branch(angle, 0, pi);
    return nearest <= -pi / 2 ? nearest + pi : nearest;
}

}  // namespace

Result<Track> true_track(const FreeDecay& decay, std::int64_t window) {
    TRY(check(decay));
    const std::int64_t frames = motion_frame_count(decay);
    if (window < 1 || window > frames) {
        return impossible("its truth needs a window of 1 to " + integer_text(frames) + " samples");
    }
    const WindowPlan plan = plan_windows(0, frames, window, window);
    if (plan.count > most_rows) {
        return impossible("its truth would have " + integer_text(plan.count) +
                          " windows; the most is " + integer_text(most_rows));
    }
    DecayMotion motion(decay);
    Track track(static_cast<std::size_t>(plan.count));
    std::optional<double> previous;
    for (std::size_t row = 0; row < track.rows(); ++row) {
        const auto start = static_cast<double>(plan.start(static_cast<std::int64_t>(row)));
        const double centre = start + 0.5 * static_cast<double>(window - 1);
        const Eigen::Vector2cd phasors = motion.at_frame(centre);
        Eigen::Matrix2d ellipse;
        ellipse << phasors.real(), -phasors.imag();
        const Axes axes = axes_of(ellipse);
        const auto put = [&track, row](SlowVariable variable, double value) {
            track.put(row, variable, value, 0);
        };
        track.time_s()[row] = plan.centre_s(static_cast<std::int64_t>(row), decay.rate_hz);
        put(SlowVariable::a_A, axes.long_axis);
        put(SlowVariable::a_B, axes.short_axis);
        put(SlowVariable::f, motion.frequency_hz(centre, phasors));
        put(SlowVariable::delta_phi_CD, phase_lead(phasors));
        put(SlowVariable::rms, std::numbers::sqrt2 * decay.noise);
        put(SlowVariable::orthogonality, 0);
        if (axes.long_axis - std::abs(axes.short_axis) <= vanishing * axes.long_axis) {
            set(track.flags()[row], Flag::circular);
            continue;  // the track was made with NaN in the angles
        }
        const double angle = unwrapped(axes.angle, previous);
        const bool odd = std::abs(std::remainder(angle - axes.angle, 2 * pi)) > pi / 2;
        put(SlowVariable::two_theta_A, angle);
        put(SlowVariable::alpha, wrap(odd ? axes.phase + pi : axes.phase));
        previous = angle;
    }
    return track;
}

}  // namespace vybeg
