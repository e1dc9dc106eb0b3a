#include "core/recording/times/time_grid.h"

#include "core/base/number_text.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

namespace vybeg {
namespace {

constexpr double missing = std::numeric_limits<double>::quiet_NaN();
constexpr std::size_t most_gaps_listed = 20;
constexpr double frames_always_held = 1.5e6;  // in memory
constexpr double grid_slack = 1e-3;           // a frame this near to a row is where the row is

// Value at x of the polynomial through all of the points.
double lagrange(std::span<const double> nodes, std::span<const double> values, double x) {
    double sum = 0;
    for (std::size_t i = 0; i < nodes.size(); ++i) {
        double product = values[i];
        for (std::size_t j = 0; j < nodes.size(); ++j) {
            product *= i == j ? 1.0 : (x - nodes[j]) / (nodes[i] - nodes[j]);
        }
        sum += product;
    }
    return sum;
}

UniformSamples place(const TimedSamples& samples, const EvenTimes& even) {
    UniformSamples grid;
    const auto frames = static_cast<std::size_t>(even.frames());
    grid.c.assign(frames, missing);
    grid.d.assign(frames, missing);
    for (const RowSegment& segment : even.segments) {
        for (const auto& [from, to] : {std::pair(&samples.c, &grid.c), {&samples.d, &grid.d}}) {
            std::copy_n(from->begin() + segment.first_row, segment.rows,
                        to->begin() + segment.first_frame);
        }
    }
    grid.rate_hz = even.rate_hz;
    grid.rate_relative_sd = even.rate_relative_sd;
    report_gaps(even.gaps(), grid.rate_hz, grid.diagnostics);
    return grid;
}

// Fills in how far the times lie from their line, with the diagnostic time_uneven.
void note_unevenness(std::span<const double> time, const TimeLine& line, double step,
                     UniformSamples& grid) {
    double largest_s = 0;  // magnitude
    std::size_t largest_row = 0;
    double scatter = 0;
    for (const RowSegment& segment : line.segments) {
        for (std::int64_t i = 0; i < segment.rows; ++i) {
            const auto row = static_cast<std::size_t>(segment.first_row + i);
            const auto frame = static_cast<double>(segment.first_frame + i);
            const double late_s = time[row] - line.start_s - line.step_s * frame;
            scatter += late_s * late_s;
            largest_row = std::abs(late_s) > largest_s ? row : largest_row;
            largest_s = std::max(largest_s, std::abs(late_s));
        }
    }
    const double freedom = std::max(static_cast<double>(time.size()) - 2, 1.0);
    grid.rate_relative_sd = std::sqrt(scatter / freedom / line.squares) / line.step_s;
    grid.diagnostics.push_back({DiagnosticKind::time_uneven,
                                {number_arg(largest_s, 3), number_arg(largest_s / step, 3)},
                                static_cast<std::int64_t>((time[largest_row] - time[0]) / step),
                                1});
}

UniformSamples interpolate(const TimedSamples& samples, const TimeLine& line, double step) {
    const std::span<const double> time = samples.time_s;
    const auto frames =
        static_cast<std::size_t>(std::floor((time.back() - time[0]) / step + grid_slack)) + 1;
    UniformSamples grid;
    grid.c.assign(frames, missing);
    grid.d.assign(frames, missing);
    std::vector<FrameRange> gaps;
    for (const RowSegment& segment : line.segments) {
        const auto first_row = static_cast<std::size_t>(segment.first_row);
        const auto rows = static_cast<std::size_t>(segment.rows);
        const auto nodes = time.subspan(first_row, rows);
        const double from = std::ceil((nodes.front() - time[0]) / step - grid_slack);
        if (segment.first_row > 0) {
            const double end = std::floor((time[first_row - 1] - time[0]) / step + grid_slack) + 1;
            if (from > end) {
                gaps.push_back(
                    {static_cast<std::int64_t>(end), static_cast<std::int64_t>(from - end)});
            }
        }
        const double to = std::floor((nodes.back() - time[0]) / step + grid_slack);
        if (to < from) {
            continue;  // a few rows between two frames of the grid
        }
        const auto first = static_cast<std::size_t>(from);
        const auto count = static_cast<std::size_t>(to) - first + 1;
        const double start = time[0] + step * from;
        interpolate_cubic(nodes, std::span(samples.c).subspan(first_row, rows), start, step,
                          std::span(grid.c).subspan(first, count));
        interpolate_cubic(nodes, std::span(samples.d).subspan(first_row, rows), start, step,
                          std::span(grid.d).subspan(first, count));
    }
    // Samples near the end of the range may have none between them.
    for (std::vector<double>* values : {&grid.c, &grid.d}) {
        std::replace_if(
            values->begin(), values->end(), [](double x) { return std::isinf(x); }, missing);
    }
    grid.rate_hz = 1 / step;
    note_unevenness(time, line, step, grid);
    report_gaps(gaps, grid.rate_hz, grid.diagnostics);
    return grid;
}

Diagnostic gap_diagnostic(const FrameRange& gap, double rate_hz) {
    return {DiagnosticKind::time_gap,
            {count_arg(gap.count), number_arg(static_cast<double>(gap.first) / rate_hz, 9)},
            gap.first,
            gap.count};
}

}  // namespace

void interpolate_cubic(std::span<const double> nodes, std::span<const double> values, double start,
                       double step, std::span<double> out) {
    const std::size_t count = std::min<std::size_t>(4, nodes.size());
    std::size_t right = 0;  // first node that is not before the point
    for (std::size_t i = 0; i < out.size(); ++i) {
        const double at = start + step * static_cast<double>(i);
        while (right < nodes.size() - 1 && nodes[right] < at) {
            ++right;
        }
        const std::size_t first = std::clamp<std::size_t>(right, 2, nodes.size() - count + 2) - 2;
        out[i] = lagrange(nodes.subspan(first, count), values.subspan(first, count), at);
    }
}

void report_gaps(std::span<const FrameRange> gaps, double rate_hz,
                 std::vector<Diagnostic>& diagnostics) {
    FrameRange rest;
    std::size_t listed = 0;
    for (const FrameRange& gap : gaps) {
        if (++listed < most_gaps_listed || gaps.size() == most_gaps_listed) {
            diagnostics.push_back(gap_diagnostic(gap, rate_hz));
        } else {
            rest = {rest.count == 0 ? gap.first : rest.first, rest.count + gap.count};
        }
    }
    if (rest.count > 0) {
        diagnostics.push_back(gap_diagnostic(rest, rate_hz));
    }
}

Result<UniformSamples> to_uniform_grid(const TimedSamples& samples, const std::string& where) {
    const std::span<const double> time = samples.time_s;
    const double step = typical_step(time, samples.resolution);
    const double frames = (time.back() - time[0]) / step;
    const auto rows = static_cast<double>(time.size());
    if (!is_plausible_grid(frames, rows, frames_always_held)) {
        return Error{ErrorCode::format_limit,
                     where,
                     {"text",
                      Phrase::tr("its %1 times reach over %2 sample periods",
                                 {count_arg(std::ssize(time)), number_arg(frames)}),
                      Phrase::tr("Cut the recording where its clock jumps")}};
    }
    const UniformTimeDetector judge(time, step, samples.resolution);
    const auto even = judge.judge(samples.resolution);
    return even ? place(samples, *even) : interpolate(samples, judge.line(), step);
}

}  // namespace vybeg
