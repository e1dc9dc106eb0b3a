#include "core/recording/times/time_grid.h"

#include "core/base/number_text.h"
#include "core/numerics/median.h"
#include "core/recording/times/local_cubic.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <span>

namespace vybeg {
namespace {

constexpr double missing = std::numeric_limits<double>::quiet_NaN();
constexpr double gap_steps = 1.5;        // a longer step has lost samples
constexpr double even_tolerance = 1e-3;  // of a sample period
constexpr std::size_t most_gaps_listed = 20;
constexpr double most_frames_per_row = 20;  // a grid beyond this and the next is no recording
constexpr double frames_always_allowed = 1e7;
constexpr double frames_always_held = 1.5e6;   // where the grid is held in memory
constexpr double grid_slack = even_tolerance;  // a frame this near to a row is where the row is

double median_step(std::span<const double> time) {
    std::vector<double> steps(time.size() - 1);
    for (std::size_t i = 0; i < steps.size(); ++i) {
        steps[i] = time[i + 1] - time[i];
    }
    return median(std::move(steps));
}

// Rows without a gap between them: [first, end).
struct Segment {
    std::size_t first;
    std::size_t end;
};

std::vector<Segment> find_segments(const TimedSamples& samples, double step) {
    const std::span<const double> time = samples.time_s;
    std::vector<Segment> segments;
    std::size_t first = 0;
    for (std::size_t i = 1; i < time.size(); ++i) {
        const double coarser = std::max(std::abs(time[i]), std::abs(time[i - 1]));
        const double longest =
            std::max(gap_steps * step, longest_rounded_step(step, samples.resolution, coarser));
        if (time[i] - time[i - 1] > longest) {
            segments.push_back({first, i});
            first = i;
        }
    }
    segments.push_back({first, time.size()});
    return segments;
}

// Seconds per sample: one slope of least squares for all segments, each with its own offset.
double fit_step(std::span<const double> time, std::span<const Segment> segments) {
    double products = 0;
    double squares = 0;
    for (const Segment& segment : segments) {
        const double centre = 0.5 * static_cast<double>(segment.end - segment.first - 1);
        for (std::size_t i = segment.first; i < segment.end; ++i) {
            const double k = static_cast<double>(i - segment.first) - centre;
            products += k * (time[i] - time[segment.first]);
            squares += k * k;
        }
    }
    return products / squares;
}

// The grid's number for each row: one more than the row before; behind a gap, the whole number of
// steps more.
std::vector<std::int64_t> number_rows(std::span<const double> time,
                                      std::span<const Segment> segments, double step) {
    std::vector<std::int64_t> numbers(time.size(), 0);
    for (const Segment& segment : segments) {
        for (std::size_t i = std::max<std::size_t>(segment.first, 1); i < segment.end; ++i) {
            const double steps =
                i == segment.first ? std::round((time[i] - time[i - 1]) / step) : 1.0;
            numbers[i] =
                numbers[i - 1] + std::max<std::int64_t>(static_cast<std::int64_t>(steps), 1);
        }
    }
    return numbers;
}

struct Line {
    double start_s = 0;
    double step_s = 0;
    double step_relative_sd = 0;  // by the scatter of the times
};

// The straight line of least squares through the times against their numbers.
Line fit_line(std::span<const double> time, std::span<const std::int64_t> numbers) {
    const auto n = static_cast<double>(time.size());
    double mean_k = 0;
    double mean_t = 0;
    for (std::size_t i = 0; i < time.size(); ++i) {
        mean_k += static_cast<double>(numbers[i]) / n;
        mean_t += (time[i] - time[0]) / n;
    }
    double products = 0;
    double squares = 0;
    for (std::size_t i = 0; i < time.size(); ++i) {
        const double k = static_cast<double>(numbers[i]) - mean_k;
        products += k * (time[i] - time[0] - mean_t);
        squares += k * k;
    }
    const double step = products / squares;
    double scatter = 0;
    for (std::size_t i = 0; i < time.size(); ++i) {
        const double expected = mean_t + step * (static_cast<double>(numbers[i]) - mean_k);
        scatter += std::pow(time[i] - time[0] - expected, 2);
    }
    const double sd = std::sqrt(scatter / std::max(n - 2, 1.0) / squares);
    return {time[0] + mean_t - step * mean_k, step, sd / step};
}

struct Unevenness {
    double largest_s = 0;  // deviation from the line, magnitude
    std::size_t row = 0;
    bool explained = true;  // by the tolerance and the digits of the times
};

Unevenness compare(const TimedSamples& samples, std::span<const std::int64_t> numbers,
                   const Line& line) {
    Unevenness result;
    for (std::size_t i = 0; i < numbers.size(); ++i) {
        const double time = samples.time_s[i];
        const double deviation =
            std::abs(time - line.start_s - line.step_s * static_cast<double>(numbers[i]));
        const double allowed = allowed_deviation(line.step_s, samples.resolution, time);
        result.explained = result.explained && deviation <= allowed;
        if (deviation > result.largest_s) {
            result.largest_s = deviation;
            result.row = i;
        }
    }
    return result;
}

UniformSamples place(const TimedSamples& samples, std::span<const std::int64_t> numbers) {
    UniformSamples grid;
    const auto frames = static_cast<std::size_t>(numbers.back() + 1);
    grid.c.assign(frames, missing);
    grid.d.assign(frames, missing);
    for (std::size_t i = 0; i < numbers.size(); ++i) {
        grid.c[static_cast<std::size_t>(numbers[i])] = samples.c[i];
        grid.d[static_cast<std::size_t>(numbers[i])] = samples.d[i];
    }
    return grid;
}

UniformSamples interpolate(const TimedSamples& samples, std::span<const Segment> segments,
                           double step) {
    const std::span<const double> time = samples.time_s;
    const auto frames =
        static_cast<std::size_t>(std::floor((time.back() - time[0]) / step + grid_slack)) + 1;
    UniformSamples grid;
    grid.c.assign(frames, missing);
    grid.d.assign(frames, missing);
    for (const Segment& segment : segments) {
        const std::size_t rows = segment.end - segment.first;
        const auto nodes = time.subspan(segment.first, rows);
        const double from = std::ceil((nodes.front() - time[0]) / step - grid_slack);
        const double to = std::floor((nodes.back() - time[0]) / step + grid_slack);
        if (to < from) {
            continue;  // a few rows between two frames of the grid
        }
        const auto first = static_cast<std::size_t>(from);
        const auto count = static_cast<std::size_t>(to) - first + 1;
        const double start = time[0] + step * from;
        interpolate_cubic(nodes, std::span(samples.c).subspan(segment.first, rows), start, step,
                          std::span(grid.c).subspan(first, count));
        interpolate_cubic(nodes, std::span(samples.d).subspan(segment.first, rows), start, step,
                          std::span(grid.d).subspan(first, count));
    }
    // Samples near the end of the range may have none between them.
    for (std::vector<double>* values : {&grid.c, &grid.d}) {
        std::replace_if(
            values->begin(), values->end(), [](double x) { return std::isinf(x); }, missing);
    }
    return grid;
}

Diagnostic gap_diagnostic(std::int64_t first, std::int64_t count, double rate_hz) {
    return {DiagnosticKind::time_gap,
            {count_arg(count), number_arg(static_cast<double>(first) / rate_hz, 9)},
            first,
            count};
}

}  // namespace

double TimeResolution::at(double time_s) const {
    const double magnitude = std::abs(time_s);
    const double relative =
        magnitude > 0 ? std::pow(10.0, std::floor(std::log10(magnitude)) + 1 - significant_digits)
                      : 0;
    const double single =
        magnitude > 0 && single_unit_s > 0
            ? std::ldexp(single_unit_s, std::ilogb(magnitude / single_unit_s) + 1 -
                                            std::numeric_limits<float>::digits)
            : 0;
    return std::max(absolute_s, relative) + single;
}

double longest_rounded_step(double step_s, const TimeResolution& resolution, double time_s) {
    // Each of the two times is rounded by up to half of its last digit.
    return step_s + 1.25 * resolution.at(time_s);
}

double allowed_deviation(double step_s, const TimeResolution& resolution, double time_s) {
    // Half of the last digit from rounding, and half of that again for what it does to the line.
    return even_tolerance * step_s + 0.75 * resolution.at(time_s);
}

bool is_plausible_grid(double frames, double rows) {
    return frames < most_frames_per_row * rows + frames_always_allowed;
}

double typical_step(const TimedSamples& samples) {
    const std::span<const double> time = samples.time_s;
    return fit_step(time, find_segments(samples, median_step(time)));
}

void report_gaps(std::span<const TimeGap> gaps, double rate_hz,
                 std::vector<Diagnostic>& diagnostics) {
    std::int64_t rest = 0;
    std::int64_t rest_first = 0;
    std::size_t listed = 0;
    for (const TimeGap& gap : gaps) {
        const std::int64_t count = gap.after - gap.before - 1;
        if (++listed < most_gaps_listed || gaps.size() == most_gaps_listed) {
            diagnostics.push_back(gap_diagnostic(gap.before + 1, count, rate_hz));
        } else {
            rest_first = rest == 0 ? gap.before + 1 : rest_first;
            rest += count;
        }
    }
    if (rest > 0) {
        diagnostics.push_back(gap_diagnostic(rest_first, rest, rate_hz));
    }
}

Result<UniformSamples> to_uniform_grid(const TimedSamples& samples, const std::string& where) {
    const std::span<const double> time = samples.time_s;
    const std::vector<Segment> segments = find_segments(samples, median_step(time));
    const double step = fit_step(time, segments);
    const double frames = (time.back() - time[0]) / step;
    const auto rows = static_cast<double>(time.size());
    if (!is_plausible_grid(frames, rows) ||
        frames > most_frames_per_row * rows + frames_always_held) {
        return Error{ErrorCode::format_limit,
                     where,
                     {"text",
                      words(VYBEG_MESSAGE("Words", "its %1 times reach over %2 sample periods"),
                            {count_arg(std::ssize(time)), number_arg(frames)}),
                      words(VYBEG_MESSAGE("Words", "Cut the recording where its clock jumps"))}};
    }
    const std::vector<std::int64_t> numbers = number_rows(time, segments, step);
    const Line line = fit_line(time, numbers);
    const Unevenness uneven = compare(samples, numbers, line);
    std::vector<TimeGap> gaps;
    UniformSamples grid;
    if (uneven.explained) {
        grid = place(samples, numbers);
        grid.rate_hz = 1 / line.step_s;
        for (std::size_t i = 1; i < numbers.size(); ++i) {
            if (numbers[i] > numbers[i - 1] + 1) {
                gaps.push_back({numbers[i - 1], numbers[i]});
            }
        }
    } else {
        grid = interpolate(samples, segments, step);
        grid.rate_hz = 1 / step;
        grid.diagnostics.push_back(
            {DiagnosticKind::time_uneven,
             {number_arg(uneven.largest_s, 3), number_arg(uneven.largest_s / step, 3)},
             static_cast<std::int64_t>((time[uneven.row] - time[0]) / step),
             1});
        for (std::size_t s = 1; s < segments.size(); ++s) {
            const auto frame_of = [&](std::size_t row) { return (time[row] - time[0]) / step; };
            const TimeGap gap{
                static_cast<std::int64_t>(
                    std::floor(frame_of(segments[s - 1].end - 1) + grid_slack)),
                static_cast<std::int64_t>(std::ceil(frame_of(segments[s].first) - grid_slack))};
            if (gap.after > gap.before + 1) {
                gaps.push_back(gap);
            }
        }
    }
    grid.rate_relative_sd = line.step_relative_sd;
    report_gaps(gaps, grid.rate_hz, grid.diagnostics);
    return grid;
}

}  // namespace vybeg
