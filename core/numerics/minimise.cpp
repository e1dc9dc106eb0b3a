#include "core/numerics/minimise.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace vybeg {
namespace {

struct Point {
    double at = 0;
    double value = 0;
};

// Brent, "Algorithms for Minimization without Derivatives" (1973), chapter 5: parabolic
// interpolation, golden section where that does not converge. Precondition: left < middle < right,
// middle lowest.
Point brent(const std::function<double(double)>& f, double left, Point middle, double right,
            double tolerance) {
    constexpr double golden = 0.3819660112501051;
    Point best = middle;
    Point second = middle;
    Point third = middle;
    double move = 0;
    double move_before = 0;
    constexpr int most_steps = 100;
    for (int step = 0; step < most_steps; ++step) {
        const double centre = 0.5 * (left + right);
        if (std::abs(best.at - centre) <= 2 * tolerance - 0.5 * (right - left)) {
            break;
        }
        bool parabolic = false;
        if (std::abs(move_before) > tolerance) {
            const double r = (best.at - second.at) * (best.value - third.value);
            double q = (best.at - third.at) * (best.value - second.value);
            double p = (best.at - third.at) * q - (best.at - second.at) * r;
            q = 2 * (q - r);
            p = q > 0 ? -p : p;
            q = std::abs(q);
            const double limit = std::exchange(move_before, move);
            if (std::abs(p) < std::abs(0.5 * q * limit) && p > q * (left - best.at) &&
                p < q * (right - best.at)) {
                move = p / q;
                parabolic = true;
                const double at = best.at + move;
                if (at - left < 2 * tolerance || right - at < 2 * tolerance) {
                    move = best.at < centre ? tolerance : -tolerance;
                }
            }
        }
        if (!parabolic) {
            move_before = (best.at < centre ? right : left) - best.at;
            move = golden * move_before;
        }
        const double at =
            best.at + (std::abs(move) >= tolerance ? move : std::copysign(tolerance, move));
        const Point trial{at, f(at)};
        if (trial.value <= best.value) {
            (at < best.at ? right : left) = best.at;
            third = std::exchange(second, std::exchange(best, trial));
        } else {
            (at < best.at ? left : right) = at;
            if (trial.value <= second.value || second.at == best.at) {
                third = std::exchange(second, trial);
            } else if (trial.value <= third.value || third.at == best.at || third.at == second.at) {
                third = trial;
            }
        }
    }
    return best;
}

}  // namespace

Minimum minimise(const std::function<double(double)>& f, double low, double start, double high,
                 double step, double tolerance) {
    const auto point = [&f](double at) { return Point{at, f(at)}; };
    Point before = point(start);
    Point here = point(std::min(start + step, high));
    double direction = 1;
    if (here.value > before.value || here.at == before.at) {
        std::swap(before, here);
        direction = -1;
    }
    // Downhill in growing steps until the function rises again.
    double stride = step;
    while (true) {
        const Point ahead = point(std::clamp(here.at + direction * stride, low, high));
        if (ahead.at == here.at) {
            return {here.at, here.value, true};
        }
        if (ahead.value > here.value) {
            if (here.at == before.at) {
                return {here.at, here.value, true};  // began at a bound, and rises from there
            }
            const double left = std::min(before.at, ahead.at);
            const double right = std::max(before.at, ahead.at);
            const Point best = brent(f, left, here, right, tolerance);
            return {best.at, best.value, false};
        }
        before = std::exchange(here, ahead);
        stride *= 2;
    }
}

}  // namespace vybeg
