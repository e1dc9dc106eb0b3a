#pragma once

#include "core/track/track.h"

#include <cstdint>
#include <deque>
#include <optional>
#include <span>
#include <vector>

namespace vybeg {

// Marks the windows of a track in which the wave moves too much for the model of a window, constant
// slow variables (Flag::moving). The track arrives in pieces, angles unwrapped.
//
// Inside a window: a variable x linear in time has its mean at the centre; curvature shifts the
// mean by x'' T^2/24. x'' follows from the windows one window length before and after. A window is
// marked where the shift exceeds 0.6 of the standard deviation of a_A, a_B, 2theta_A or f and five
// and a half of its own, or where 2theta_A turns by more than pi/4 within a window length. Adjacent
// windows are marked, too, among them those between two bends, whose own x'' passes zero.
//
// Where windows lie apart, the curvature between them may be aliased, and the residual decides: a
// wave that changes by d over the window leaves d/sqrt(12) and an error of about d^2/24 of its
// amplitude. Such a window is marked where that error exceeds the deviation of a_A, provided that
// its neighbours are no more alike than a moving wave leaves them.
//
// Between windows: 2theta_A is known modulo pi. A step of more than pi/4, half of the resolvable
// step, leaves its branch uncertain. So does a discontinuous phase: (2theta_A, alpha) and (2theta_A
// + pi, alpha + pi) are one wave, so that alpha, predicted by the frequencies of both windows,
// reveals a missed branch. Both windows of such a step are marked.
class MotionMarker {
public:
    // `f_correlation`: of errors of f, by hops.
    MotionMarker(std::int64_t length, std::int64_t hop, double rate_hz, double f0_hz,
                 std::span<const double> f_correlation);

    // `no_wave`, a flag a row: whether its window is known to hold no steady wave. `excess`: by
    // which the variances of the rows are known to be too small, at least 1.
    void take(const Track& next_rows, std::span<const char> no_wave, double excess);
    // Marked rows in ascending order; ranges do not overlap.
    std::vector<FlaggedRows> finish();

    // Values of a row that enter the test; variances are squared standard deviations, times
    // `excess`.
    struct Row {
        double a_A, a_B, two_theta_A, alpha, f_hz, noise;
        double var_a_A, var_a_B, var_two_theta_A, var_alpha, var_f;
    };
    static Row row_of(const Track& track, std::size_t k, double excess = 1);
    // Whether the wave bends inside `window`, or turns by more than pi/4, by the rows of the equal
    // parts that it is cut into: for windows without neighbours one window length before and after.
    static bool bends_inside(const Row& window, const Track& parts);
    // Phase of `to` less that which the frequencies of both rows and the step of 2theta_A foretell,
    // rad; beyond pi/2 the step is of another branch. Nothing where they foretell no phase.
    static std::optional<double> phase_off(const Row& from, const Row& to, double seconds);

private:
    void judge_next();
    bool bends(const Row& before, const Row& at, const Row& after) const;
    bool loses_branch(const Row& from, const Row& to, double hops) const;
    void step_to(const Row& row);

    std::size_t apart_;     // rows between a window and the adjacent one
    double lengths_apart_;  // window lengths between their centres
    double hop_s_;
    // Error of a phasor component by the change of the other one over a window, because u sin wu is
    // not orthogonal to cos wu in a window of some periods.
    double slope_share_;
    // Variance of a second difference by that of a value: 6 for independent ones.
    double second_variance_ = 6;
    std::deque<Row> held_;        // the last rows
    std::size_t first_held_ = 0;  // index of the first of them
    std::size_t rows_ = 0;
    std::size_t judged_ = 0;
    Row last_valid_{};  // with an angle
    std::size_t last_valid_row_ = 0;
    bool any_valid_ = false;
    std::vector<FlaggedRows> inside_;
    std::vector<FlaggedRows> between_;
    std::vector<FlaggedRows> no_wave_;
};

}  // namespace vybeg
