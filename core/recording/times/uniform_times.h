#pragma once

#include "core/base/job_control.h"
#include "core/base/result.h"

#include <array>
#include <cmath>
#include <cstdint>
#include <functional>
#include <optional>
#include <span>
#include <vector>

namespace vybeg {

// How finely a column of times is written: no time is known better than to the coarser of decimals
// and digits. Times that were 32 bit floats before have been rounded twice.
struct TimeResolution {
    double absolute_s = 0;        // one unit of the last decimal that any of them has
    int significant_digits = 17;  // the most that any of them has
    double single_unit_s = 0;     // unit (s) in which all of them were 32 bit floats; 0: in none

    double at(double time_s) const;  // seconds
};

// Whether a 32 bit float lies within `half_digit` of the number, which is a float's where the digit
// is 0.
inline bool is_single(double number, double half_digit) {
    constexpr double ties = 1 + 1e-6;  // a float halfway between two texts, and its parsing
    constexpr double parsing = 1.2e-16;
    const double apart = std::abs(number - static_cast<double>(static_cast<float>(number)));
    return apart <= half_digit * ties + parsing * std::abs(number);
}

// False where the gaps between so many rows are so long that a grid of so many frames would be
// absurdly larger than the file. `always`: frames that it may have in any case.
bool is_plausible_grid(double frames, double rows, double always = 1e7);

// The slope of least squares of times (s), the same between all gaps, s per row. Precondition: two
// times or more.
double typical_step(std::span<const double> times_s, const TimeResolution& resolution);

// Rows whose frames on the grid follow each other.
struct RowSegment {
    std::int64_t first_row = 0;
    std::int64_t first_frame = 0;
    std::int64_t rows = 0;
};

// Frames [first, first + count).
struct FrameRange {
    std::int64_t first = 0;
    std::int64_t count = 0;

    std::int64_t end() const { return first + count; }

    friend bool operator==(const FrameRange&, const FrameRange&) = default;
};

// Times that lie on a uniform grid.
struct EvenTimes {
    double rate_hz = 0;
    double rate_relative_sd = 0;       // what the digits of the times leave open of rate_hz
    std::vector<RowSegment> segments;  // one after the other, gaps between them

    std::int64_t frames() const { return segments.back().first_frame + segments.back().rows; }
    std::int64_t frame_of(std::int64_t row) const;
    std::vector<FrameRange> gaps() const;  // ranges missing between them
};

// A straight line through times against their frames, even or not. `late_s` is against the first
// time and multiples of a given step: mean_late_s + slope (frame - mean_frame).
struct TimeLine {
    std::vector<RowSegment> segments{};
    double start_s = 0;  // at the frame 0
    double step_s = 0;
    double mean_frame = 0;
    double mean_late_s = 0;
    double slope = 0;
    double squares = 0;             // sum of (frame - mean_frame)^2
    std::vector<double> offsets{};  // late_s of the first row of each segment
};

// Judges a column of times, the only judge of whether they are even: while it is read, piece by
// piece, without keeping it. Memory grows with the gaps alone.
class UniformTimeDetector {
public:
    // `step_s`: about the time from row to row, typical_step() of some of them; `resolution`: about
    // how finely they are written.
    explicit UniformTimeDetector(double step_s, const TimeResolution& resolution = {})
        : step_s_(step_s), expected_(resolution) {}

    // All times of a column, with the step and resolution of all of them: no step is doubtful.
    UniformTimeDetector(std::span<const double> times_s, double step_s,
                        const TimeResolution& resolution);

    // The next time (s), not below the one before.
    void add(double time_s);

    // Takes on the times of the rows that follow. Precondition: the same step.
    void append(const UniformTimeDetector& next);

    // The grid, where no time lies further from it than a thousandth of a step and what its digits
    // leave open. Nothing where the times are uneven, where that is not certain (steps halfway
    // between one and two), and where there are more gaps than are kept.
    std::optional<EvenTimes> judge(const TimeResolution& resolution) const;

    std::vector<std::int64_t> rows_between_gaps() const;

    // That of least squares. Precondition: all times of a column, two or more, over a plausible
    // number of steps.
    TimeLine line() const { return fit_line(step_s_); }

private:
    // A row by its number and by how late it is against multiples of step_s_, both from the start
    // of its segment.
    struct Point {
        double row;
        double late_s;
    };

    // One side of the convex hull of points of rising rows.
    struct Chain {
        double side = 1;  // 1: the earliest points, -1: the latest
        std::vector<Point> points;

        void add(const Point& point);
        // Leaves a row out that lies just after the last point and further inside.
        void add_row(const Point& row);
    };

    // The hull of the rows for whose times the same deviation is allowed, because they have equally
    // many digits before the decimal point, of 32 bit floats before the binary one, too: no
    // straight line is further from any row than from one of its points, but for what the line
    // rises over the rows left out after it.
    struct Hull {
        double time_s = 0;  // well inside of theirs
        std::array<Chain, 2> sides{Chain{1, {}}, Chain{-1, {}}};
    };

    struct Segment {
        std::int64_t rows = 0;
        double first_s = 0;
        double last_s = 0;
        double late_sum = 0;      // of late_s
        double late_row_sum = 0;  // of row late_s
        std::vector<Hull> hulls;

        Hull& hull(double time_s);
        void join(const Segment& next, double step_s);
    };

    // Times of one resolution.
    struct Decade {
        double inside = 0;  // the time in their middle
        double from = 0;
        double to = 0;
        double rounding = 0;  // longest step that rounding makes of one, in steps
    };

    // A row's frame and how late it may at least or at most be against step_s_.
    struct Bound {
        double frame;
        double late_s;
    };

    using Bounds = std::array<std::vector<Bound>, 2>;  // at most, at least

    bool continues(double time_s);
    void enter_decade(double time_s);
    double decade_of(double time_s);
    std::optional<double> fitted_step() const;
    std::vector<RowSegment> number_rows(double step_s) const;
    TimeLine fit_line(double step_s) const;
    Bounds bounds(const TimeResolution& resolution, const TimeLine& line) const;
    static std::optional<double> pass_all(const Bounds& bounds, TimeLine& line);
    std::optional<double> pass_nearly(const TimeResolution& resolution, const TimeLine& line) const;

    double step_s_;
    TimeResolution expected_;
    bool has_all_ = false;
    bool doubtful_ = false;
    std::vector<Segment> segments_;
    Decade decade_;
};

// Times in longer steps count something.
inline constexpr double longest_step_s = 1;

// How a stored column of times runs.
struct TimeSteps {
    bool is_time = false;  // rises, in steps below a second
    TimeResolution resolution;
    std::optional<EvenTimes> even;
    bool is_even() const { return is_time && even && even->segments.size() == 1; }
};

// Reads all `rows` of a column that counts in `unit_s` seconds once, block by block, holding none.
// `block`: the first of them, as many as are read at once; `read` fills a span with those from a
// row on. `ticks`: whole numbers may have been rounded to units. Errors: those of `read`,
// interrupted.
Result<TimeSteps> judge_column(std::vector<double> block, std::int64_t rows, double unit_s,
                               bool ticks,
                               const std::function<Status(std::int64_t, std::span<double>)>& read,
                               const JobControl& job);

}  // namespace vybeg
