#include "core/recording/times/uniform_times.h"

#include "core/numerics/statistics.h"

#include <algorithm>
#include <iterator>
#include <limits>
#include <utility>

namespace vybeg {
namespace {

constexpr double even_tolerance = 1e-3;     // of a sample period
constexpr double most_frames_per_row = 20;  // a grid beyond this and the next is no recording

constexpr double gap_steps = 1.5;  // a longer step has lost samples
// Longest step that counts for one, and shortest that counts for more, of about that length;
// between them all times together decide.
constexpr double longest_single_step = 1.4;
constexpr double shortest_gap = 1.6;
constexpr double doubt = 0.2;  // the same for steps that rounding makes longer than that
constexpr std::size_t most_segments = std::size_t{1} << 16;

constexpr double rows_left_out = 16;  // at most, after a point of a hull

constexpr std::size_t most_bounds = 1000;   // on each side, for the interval of the slope
constexpr double arithmetic_error = 1e-15;  // of a time, relative to the largest

// The longest step from one time to the next that rounding may make of the given step, s.
double longest_rounded_step(double step_s, const TimeResolution& resolution, double time_s) {
    // Each of the two times is rounded by up to half of its last digit.
    return step_s + 1.25 * resolution.at(time_s);
}

// How far a time may lie from a grid of the given step and still be even, s: a thousandth of a step
// plus what its digits leave open.
double allowed_deviation(double step_s, const TimeResolution& resolution, double time_s) {
    // Half of the last digit from rounding, and half of that again for its effect on the line.
    return even_tolerance * step_s + 0.75 * resolution.at(time_s);
}

double median_step(std::span<const double> times_s) {
    std::vector<double> steps(times_s.size() - 1);
    for (std::size_t i = 0; i < steps.size(); ++i) {
        steps[i] = times_s[i + 1] - times_s[i];
    }
    return median(std::move(steps));
}

// Sum of the squares of n whole numbers round their mean.
double spread(double n) {
    return n * (n * n - 1) / 12;
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

bool is_plausible_grid(double frames, double rows, double always) {
    return frames < most_frames_per_row * rows + always;
}

double typical_step(std::span<const double> times_s, const TimeResolution& resolution) {
    const UniformTimeDetector judge(times_s, median_step(times_s), resolution);
    double products = 0;
    double squares = 0;
    for (const std::int64_t rows : judge.rows_between_gaps()) {
        const double centre = 0.5 * static_cast<double>(rows - 1);
        const auto times = times_s.first(static_cast<std::size_t>(rows));
        times_s = times_s.subspan(times.size());
        for (std::size_t i = 0; i < times.size(); ++i) {
            const double k = static_cast<double>(i) - centre;
            products += k * (times[i] - times[0]);
            squares += k * k;
        }
    }
    return products / squares;
}

std::int64_t EvenTimes::frame_of(std::int64_t row) const {
    const auto behind = std::ranges::upper_bound(segments, row, {}, &RowSegment::first_row);
    const RowSegment& segment = *std::prev(behind);
    return segment.first_frame + row - segment.first_row;
}

std::vector<FrameRange> EvenTimes::gaps() const {
    std::vector<FrameRange> gaps;
    for (std::size_t s = 1; s < segments.size(); ++s) {
        const std::int64_t end = segments[s - 1].first_frame + segments[s - 1].rows;
        if (segments[s].first_frame > end) {
            gaps.push_back({end, segments[s].first_frame - end});
        }
    }
    return gaps;
}

UniformTimeDetector::UniformTimeDetector(std::span<const double> times_s, double step_s,
                                         const TimeResolution& resolution)
    : step_s_(step_s), expected_(resolution), has_all_(true) {
    for (const double time_s : times_s) {
        add(time_s);
    }
}

void UniformTimeDetector::Chain::add(const Point& point) {
    const auto bends_inwards = [&] {
        const Point& a = points[points.size() - 2];
        const Point& b = points.back();
        return side * ((b.late_s - a.late_s) * (point.row - a.row) -
                       (point.late_s - a.late_s) * (b.row - a.row)) >=
               0;
    };
    while (points.size() > 1 && bends_inwards()) {
        points.pop_back();
    }
    points.push_back(point);
}

void UniformTimeDetector::Chain::add_row(const Point& row) {
    const bool covered = !points.empty() && row.row - points.back().row <= rows_left_out &&
                         side * (row.late_s - points.back().late_s) >= 0;
    if (!covered) {
        add(row);
    }
}

UniformTimeDetector::Hull& UniformTimeDetector::Segment::hull(double time_s) {
    if (hulls.empty() || hulls.back().time_s != time_s) {
        hulls.push_back({.time_s = time_s});
    }
    return hulls.back();
}

// Appends a segment without a gap before it.
void UniformTimeDetector::Segment::join(const Segment& next, double step_s) {
    const auto before = static_cast<double>(rows);
    const auto more = static_cast<double>(next.rows);
    const double shift = next.first_s - first_s - step_s * before;
    late_row_sum +=
        next.late_row_sum + before * next.late_sum + shift * more * (before + (more - 1) / 2);
    late_sum += next.late_sum + more * shift;
    rows += next.rows;
    last_s = next.last_s;
    for (const Hull& part : next.hulls) {
        Hull& whole = hull(part.time_s);
        for (std::size_t i = 0; i < part.sides.size(); ++i) {
            for (const Point& point : part.sides.at(i).points) {
                whole.sides.at(i).add({before + point.row, point.late_s + shift});
            }
        }
    }
}

// The middle of the times with the resolution of this one; 0 of the time 0.
double UniformTimeDetector::decade_of(double time_s) {
    const double magnitude = std::abs(time_s);
    if (magnitude == 0) {
        return 0;
    }
    if (magnitude < decade_.from || magnitude >= decade_.to) {
        enter_decade(time_s);
    }
    return decade_.inside;
}

void UniformTimeDetector::enter_decade(double time_s) {
    const double magnitude = std::abs(time_s);
    const int exponent = static_cast<int>(std::floor(std::log10(magnitude)));
    decade_.from = std::pow(10.0, exponent);
    decade_.to = std::pow(10.0, exponent + 1);
    if (const double unit_s = expected_.single_unit_s; unit_s > 0) {
        const int octave = std::ilogb(magnitude / unit_s);
        decade_.from = std::max(decade_.from, std::ldexp(unit_s, octave));
        decade_.to = std::min(decade_.to, std::ldexp(unit_s, octave + 1));
    }
    decade_.inside = 0.5 * (decade_.from + decade_.to);
    // Of the coarser decade, where the times pass from one to the other.
    decade_.rounding =
        std::max(decade_.rounding, longest_rounded_step(step_s_, expected_, time_s) / step_s_);
}

// Whether the time follows the last one without a gap. Its decade has been entered.
bool UniformTimeDetector::continues(double time_s) {
    if (segments_.empty()) {
        return false;
    }
    const double last_s = segments_.back().last_s;
    if (has_all_) {
        // Not in steps: more than half of the times may be the one before again.
        const double coarser_s = std::max(std::abs(time_s), std::abs(last_s));
        return !(time_s - last_s > std::max(gap_steps * step_s_,
                                            longest_rounded_step(step_s_, expected_, coarser_s)));
    }
    const double steps = (time_s - last_s) / step_s_;
    const double longest = std::max(longest_single_step, decade_.rounding);
    const double shortest = std::max(shortest_gap, decade_.rounding + doubt);
    doubtful_ = doubtful_ || !(steps <= longest || steps >= shortest);
    return steps < shortest;
}

void UniformTimeDetector::add(double time_s) {
    const double decade = decade_of(time_s);
    if (!continues(time_s)) {
        segments_.emplace_back().first_s = time_s;
        doubtful_ = doubtful_ || (!has_all_ && segments_.size() > most_segments);
    }
    if (doubtful_) {
        return;
    }
    Segment& segment = segments_.back();
    const auto row = static_cast<double>(segment.rows);
    const double late = time_s - segment.first_s - step_s_ * row;
    segment.rows += 1;
    segment.last_s = time_s;
    segment.late_sum += late;
    segment.late_row_sum += row * late;
    for (Chain& side : segment.hull(decade).sides) {
        side.add_row({row, late});
    }
}

void UniformTimeDetector::append(const UniformTimeDetector& next) {
    auto from = next.segments_.begin();
    if (from != next.segments_.end()) {
        decade_of(from->first_s);
    }
    const bool joins = from != next.segments_.end() && continues(from->first_s);
    doubtful_ =
        doubtful_ || next.doubtful_ || segments_.size() + next.segments_.size() > most_segments;
    if (doubtful_) {
        return;
    }
    if (joins) {
        segments_.back().join(*from, step_s_);
        ++from;
    }
    segments_.insert(segments_.end(), from, next.segments_.end());
}

// One slope of least squares for all segments, each with its own offset.
std::optional<double> UniformTimeDetector::fitted_step() const {
    double products = 0;
    double squares = 0;
    for (const Segment& segment : segments_) {
        const auto rows = static_cast<double>(segment.rows);
        products += segment.late_row_sum - 0.5 * (rows - 1) * segment.late_sum;
        squares += spread(rows);
    }
    return squares > 0 ? std::optional(step_s_ + products / squares) : std::nullopt;
}

std::vector<RowSegment> UniformTimeDetector::number_rows(double step_s) const {
    std::vector<RowSegment> numbered;
    for (const Segment& segment : segments_) {
        RowSegment next{0, 0, segment.rows};
        if (!numbered.empty()) {
            const RowSegment& before = numbered.back();
            const double last_s = segments_[numbered.size() - 1].last_s;
            const double steps = std::round((segment.first_s - last_s) / step_s);
            next.first_row = before.first_row + before.rows;
            next.first_frame = before.first_frame + before.rows - 1 +
                               std::max<std::int64_t>(static_cast<std::int64_t>(steps), 1);
        }
        numbered.push_back(next);
    }
    return numbered;
}

// The line of least squares through all rows, numbered by steps of that length.
TimeLine UniformTimeDetector::fit_line(double step_s) const {
    TimeLine line{.segments = number_rows(step_s)};
    double rows = 0;
    for (std::size_t s = 0; s < segments_.size(); ++s) {
        const auto n = static_cast<double>(segments_[s].rows);
        const auto frame = static_cast<double>(line.segments[s].first_frame);
        line.offsets.push_back(segments_[s].first_s - segments_[0].first_s - step_s_ * frame);
        line.mean_frame += n * (frame + 0.5 * (n - 1));
        line.mean_late_s += n * line.offsets[s] + segments_[s].late_sum;
        rows += n;
    }
    line.mean_frame /= rows;
    line.mean_late_s /= rows;
    double products = 0;
    for (std::size_t s = 0; s < segments_.size(); ++s) {
        const Segment& segment = segments_[s];
        const auto n = static_cast<double>(segment.rows);
        const double centre =
            static_cast<double>(line.segments[s].first_frame) + 0.5 * (n - 1) - line.mean_frame;
        products += centre * (n * (line.offsets[s] - line.mean_late_s) + segment.late_sum) +
                    segment.late_row_sum - 0.5 * (n - 1) * segment.late_sum;
        line.squares += n * centre * centre + spread(n);
    }
    line.slope = products / line.squares;
    line.start_s = segments_[0].first_s + line.mean_late_s - line.slope * line.mean_frame;
    line.step_s = step_s_ + line.slope;
    return line;
}

// The bounds that rounding by half of the last digit sets to a straight line.
UniformTimeDetector::Bounds UniformTimeDetector::bounds(const TimeResolution& resolution,
                                                        const TimeLine& line) const {
    Bounds result;
    const double reach_s =
        std::max(std::abs(segments_.front().first_s), std::abs(segments_.back().last_s));
    for (std::size_t s = 0; s < segments_.size(); ++s) {
        const Segment& segment = segments_[s];
        const auto first = static_cast<double>(line.segments[s].first_frame);
        const auto half_of = [&](double time_s) {
            return 0.5 * resolution.at(time_s) + arithmetic_error * reach_s;
        };
        for (const Hull& hull : segment.hulls) {
            const double half_s = half_of(hull.time_s);
            for (std::size_t i = 0; i < result.size(); ++i) {
                const Chain& chain = hull.sides.at(i);
                for (const Point& point : chain.points) {
                    result.at(i).push_back(
                        {first + point.row, line.offsets[s] + point.late_s + chain.side * half_s});
                }
            }
        }
        // The last row, which the hulls may leave out, has the longest lever.
        const auto last = static_cast<double>(segment.rows - 1);
        const double late_s = line.offsets[s] + segment.last_s - segment.first_s - step_s_ * last;
        const double half_s = half_of(segment.last_s);
        result[0].push_back({first + last, late_s + half_s});
        result[1].push_back({first + last, late_s - half_s});
    }
    return result;
}

// Rounded times leave an interval of slopes open: those of the lines that pass each time within
// half of its last digit. Takes the slope from there; returns the standard deviation of one that
// may lie anywhere in it. Returns nothing and leaves the line where no line passes all of them.
std::optional<double> UniformTimeDetector::pass_all(const Bounds& bounds, TimeLine& line) {
    const auto& [all_most, all_least] = bounds;
    double lowest = -std::numeric_limits<double>::infinity();
    double highest = std::numeric_limits<double>::infinity();
    // Some of many bounds leave a wider interval open than all of them.
    const auto stride = [](const std::vector<Bound>& all) {
        return std::max<std::size_t>(all.size() / most_bounds, 1);
    };
    for (std::size_t i = 0; i < all_most.size(); i += stride(all_most)) {
        for (std::size_t j = 0; j < all_least.size(); j += stride(all_least)) {
            const Bound& most = all_most[i];
            const Bound& least = all_least[j];
            const double frames = most.frame - least.frame;
            const double slope = (most.late_s - least.late_s) / frames;
            lowest = frames < 0 ? std::max(lowest, slope) : lowest;
            highest = frames > 0 ? std::min(highest, slope) : highest;
        }
    }
    if (!(lowest <= highest) || !std::isfinite(lowest) || !std::isfinite(highest)) {
        return std::nullopt;
    }
    const double middle = 0.5 * (lowest + highest);
    const double middle_sd = (highest - lowest) / std::sqrt(12.0);
    const double off_middle = line.slope - middle;
    // Few steps of rounding pull the slope of least squares; many leave it right to the last digit.
    const bool pulled = std::abs(off_middle) > middle_sd;
    const double slope = pulled ? middle : line.slope;
    double earliest = -std::numeric_limits<double>::infinity();  // late_s at the frame 0
    double latest = std::numeric_limits<double>::infinity();
    for (const Bound& bound : all_least) {
        earliest = std::max(earliest, bound.late_s - slope * bound.frame);
    }
    for (const Bound& bound : all_most) {
        latest = std::min(latest, bound.late_s - slope * bound.frame);
    }
    // The rows that the hulls leave out lie as much further outside as the line rises over them.
    if (earliest > latest + 2 * rows_left_out * std::abs(slope)) {
        return std::nullopt;
    }
    line.slope = slope;
    return pulled ? middle_sd : std::hypot(middle_sd, off_middle);
}

// The standard deviation of the slope where no time lies further from the line than
// allowed_deviation(), by the largest deviation in place of that of each time; else nothing.
std::optional<double> UniformTimeDetector::pass_nearly(const TimeResolution& resolution,
                                                       const TimeLine& line) const {
    double largest_s = 0;
    for (std::size_t s = 0; s < segments_.size(); ++s) {
        for (const Hull& hull : segments_[s].hulls) {
            const double allowed = allowed_deviation(line.step_s, resolution, hull.time_s) -
                                   rows_left_out * std::abs(line.slope);
            for (const Chain& chain : hull.sides) {
                for (const Point& point : chain.points) {
                    const double frame =
                        static_cast<double>(line.segments[s].first_frame) + point.row;
                    const double expected =
                        line.mean_late_s + line.slope * (frame - line.mean_frame);
                    const double deviation_s = std::abs(line.offsets[s] + point.late_s - expected);
                    if (!(deviation_s <= allowed)) {
                        return std::nullopt;
                    }
                    largest_s = std::max(largest_s, deviation_s);
                }
            }
        }
    }
    return largest_s / std::sqrt(line.squares);
}

std::vector<std::int64_t> UniformTimeDetector::rows_between_gaps() const {
    std::vector<std::int64_t> rows;
    std::ranges::transform(segments_, std::back_inserter(rows), &Segment::rows);
    return rows;
}

std::optional<EvenTimes> UniformTimeDetector::judge(const TimeResolution& resolution) const {
    const auto step_s = doubtful_ ? std::nullopt : fitted_step();
    if (!step_s) {
        return std::nullopt;
    }
    double rows = 0;
    for (const Segment& segment : segments_) {
        rows += static_cast<double>(segment.rows);
    }
    const double reach_s = segments_.back().last_s - segments_.front().first_s;
    if (!is_plausible_grid(reach_s / *step_s, rows)) {
        return std::nullopt;
    }
    TimeLine line = fit_line(*step_s);
    const auto passed = pass_all(bounds(resolution, line), line);
    const auto slope_sd = passed ? passed : pass_nearly(resolution, line);
    if (!slope_sd) {
        return std::nullopt;
    }
    const double rate_hz = 1 / (step_s_ + line.slope);
    return EvenTimes{rate_hz, *slope_sd * rate_hz, std::move(line.segments)};
}

Result<TimeSteps> judge_column(std::vector<double> block, std::int64_t rows, double unit_s,
                               bool ticks,
                               const std::function<Status(std::int64_t, std::span<double>)>& read,
                               const JobControl& job) {
    TimeSteps steps;
    double before = block.front() * unit_s;
    double last = 0;
    TRY(read(rows - 1, std::span(&last, 1)));
    const double mean_step_s = (last * unit_s - before) / static_cast<double>(rows - 1);
    if (!(mean_step_s > 0 && mean_step_s < longest_step_s)) {
        return steps;
    }
    // What the times may have been rounded to before they were stored.
    bool whole = ticks;
    bool single = true;
    const auto in_seconds = [&](std::span<double> times) {
        for (double& time : times) {
            // But for the rounding of the unit.
            whole = whole && std::abs(time - std::round(time)) <= 1e-15 * std::abs(time);
            single = single && is_single(time, 0);
            time *= unit_s;
        }
        steps.resolution = {.absolute_s = whole ? unit_s : 0, .single_unit_s = single ? unit_s : 0};
    };
    in_seconds(block);
    // Of the first rows, where rounding does not make their times equal.
    const double first_step_s = typical_step(block, steps.resolution);
    UniformTimeDetector detector(first_step_s > 0 ? first_step_s : mean_step_s, steps.resolution);
    bool repeated = false;
    const auto at_once = static_cast<std::int64_t>(block.size());
    for (std::int64_t at = 0; at < rows; at += at_once) {
        TRY(job.go_on());
        const auto times =
            std::span(block).first(static_cast<std::size_t>(std::min(at_once, rows - at)));
        TRY(read(at, times));
        in_seconds(times);
        for (std::size_t i = 0; i < times.size(); ++i) {
            if (!(times[i] >= before)) {
                return steps;
            }
            repeated = repeated || (times[i] == before && at + static_cast<std::int64_t>(i) > 0);
            detector.add(times[i]);
            before = times[i];
        }
        job.report(static_cast<double>(at) / static_cast<double>(rows));
    }
    steps.even = detector.judge({});
    if (!steps.even) {
        steps.even = detector.judge(steps.resolution);
    }
    steps.is_time = steps.even || !repeated;
    return steps;
}

}  // namespace vybeg
