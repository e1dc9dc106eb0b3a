#pragma once

#include "core/recording/times/time_grid.h"

#include <cstdint>
#include <optional>
#include <vector>

namespace vybeg {

// Rows whose frames on the grid follow each other.
struct RowSegment {
    std::int64_t first_row = 0;
    std::int64_t first_frame = 0;
    std::int64_t rows = 0;
};

// Times that lie on a uniform grid.
struct EvenTimes {
    double rate_hz = 0;
    double rate_relative_sd = 0;       // what the digits of the times leave open of rate_hz
    std::vector<RowSegment> segments;  // one after the other, gaps between them

    std::int64_t frames() const { return segments.back().first_frame + segments.back().rows; }
};

// Judges a column of times while it is read, piece by piece, without keeping it: finds what
// to_uniform_grid() finds of times that are even. Memory grows with the gaps alone.
class UniformTimeDetector {
public:
    // `step_s`: about the time from row to row, typical_step() of some of them; `resolution`: about
    // how finely they are written.
    explicit UniformTimeDetector(double step_s, const TimeResolution& resolution = {})
        : step_s_(step_s), expected_(resolution) {}

    // The next time (s), not below the one before.
    void add(double time_s);

    // Takes on the times of the rows that follow. Precondition: the same step.
    void append(const UniformTimeDetector& next);

    // The grid, where no time lies further from it than to_uniform_grid() allows. Nothing where the
    // times are uneven, where that is not certain (steps halfway between one and two), and where
    // there are more gaps than are kept.
    std::optional<EvenTimes> judge(const TimeResolution& resolution) const;

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
        // Leaves a row out that lies just behind the last point and further inside.
        void add_row(const Point& row);
    };

    // The hull of the rows for whose times the same deviation is allowed, because they have equally
    // many digits before the decimal point, of 32 bit floats before the binary one, too: no
    // straight line is further from any row than from one of its points, but for what the line
    // rises over the rows left out behind it.
    struct Hull {
        double time_s = 0;  // well inside of theirs
        Chain early{1, {}};
        Chain late{-1, {}};
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

    struct Bounds {
        std::vector<Bound> most;
        std::vector<Bound> least;
    };

    struct Line;  // of least squares through all rows

    bool continues(double time_s);
    void enter_decade(double time_s);
    double decade_of(double time_s);
    std::optional<double> fitted_step() const;
    std::vector<RowSegment> number_rows(double step_s) const;
    Line fit_line(const std::vector<RowSegment>& segments) const;
    Bounds bounds(const std::vector<RowSegment>& segments, const TimeResolution& resolution,
                  const Line& line) const;
    bool pass_all(const Bounds& bounds, Line& line) const;
    bool pass_nearly(const std::vector<RowSegment>& segments, const TimeResolution& resolution,
                     Line& line) const;

    double step_s_;
    TimeResolution expected_;
    bool doubtful_ = false;
    std::vector<Segment> segments_;
    Decade decade_;
};

}  // namespace vybeg
