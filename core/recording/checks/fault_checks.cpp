#include "core/recording/checks/fault_checks.h"

#include "core/numerics/dense_solvers.h"
#include "core/numerics/phase.h"
#include "core/numerics/statistics.h"

#include <Eigen/Core>

#include <algorithm>
#include <cmath>
#include <functional>
#include <numbers>
#include <numeric>
#include <utility>

namespace vybeg {
namespace {

// Frames: hundreds of periods of a carrier, a tenth of what carrier and rate usually have in
// common.
constexpr std::int64_t neighbourhood = 4096;
// Frames: occurrences at multiples of more than this are the pattern of a noiseless carrier that
// nearly divides the rate (355 frames in 113 half-periods), not a rail.
constexpr std::int64_t longest_pattern = 64;

}  // namespace

void ClippingCheck::Extreme::add(std::int64_t frame, double value) {
    if (value > level) {
        if (count > 0) {
            add_below({level, count});
        }
        level = value;
        count = 0;
        neighbours = 0;
        common = 0;
        places.clear();
        drawn_together = 0;
    }
    if (value == level) {
        neighbours += count > 0 && frame - last_frame <= neighbourhood ? 1 : 0;
        common = count > 0 ? std::gcd(common, frame - last_frame) : 0;
        last_frame = frame;
        ++count;
        if (!places.empty() && frame - places.back().end() <= drawn_together) {
            places.back().count = frame + 1 - places.back().first;
        } else {
            places.push_back({frame, 1});
        }
        if (places.size() > most_places) {
            draw_together();
        }
    } else {
        add_below({value, 1});
    }
}

void ClippingCheck::Extreme::add_below(const Level& more) {
    const auto place = std::ranges::lower_bound(below, more.value, std::greater{}, &Level::value);
    if (place == below.end()) {
        return;
    }
    if (place->value == more.value) {
        place->count += more.count;
        return;
    }
    std::move_backward(place, below.end() - 1, below.end());
    *place = more;
}

// Merges neighbouring places beyond the limit until half of them remain.
void ClippingCheck::Extreme::draw_together() {
    while (places.size() > most_places / 2) {
        drawn_together = std::max<std::int64_t>(2 * drawn_together, 8);
        std::vector<FrameRange> fewer{places.front()};
        for (const FrameRange& place : places) {
            FrameRange& last = fewer.back();
            if (place.first - last.end() <= drawn_together) {
                last.count = place.end() - last.first;
            } else {
                fewer.push_back(place);
            }
        }
        places = std::move(fewer);
    }
}

bool ClippingCheck::Extreme::is_rail() const {
    // A sinusoid that just reaches its top level stays (sqrt(2) - 1) = 0.41 times as long on the
    // next one; noise only equalises them. Few samples of a fine converter may miss the next level,
    // but not all of the next ones. Continuous samples never repeat the same extreme five
    // times by chance. A noiseless simulation does, once in each common period of carrier and rate,
    // but never in clusters.
    constexpr std::int64_t least_count = 5;
    constexpr std::int64_t many = 40;  // misses the next level with a probability of 1e-6
    constexpr double few = 0.2;        // of what a sinusoid has on the next levels
    double step = std::numeric_limits<double>::infinity();
    double last = level;
    double inward = 0;
    for (const Level& each : below) {
        if (each.count > 0) {
            step = std::min(step, last - each.value);
            last = each.value;
            inward += static_cast<double>(each.count);
        }
    }
    const auto own = static_cast<double>(count);
    const double levels = 1 + (level - last) / step;  // NaN: there is no other level
    const bool missed = count < many && inward > few * own * (std::sqrt(levels) - 1);
    return count >= least_count && count > 5 * below.front().count && 2 * neighbours >= count &&
           common < longest_pattern && !missed;
}

void ClippingCheck::add(std::int64_t first_frame, std::span<const double> x) {
    std::int64_t frame = first_frame;
    for (const double value : x) {
        if (std::isfinite(value)) {
            ++count_;
            // Most samples lie far inside, where two comparisons are enough.
            if (value >= upper_.least()) {
                upper_.add(frame, value);
            }
            if (-value >= lower_.least()) {
                lower_.add(frame, -value);
            }
        }
        ++frame;
    }
}

bool ClippingCheck::are_inside(double lowest, double highest) const {
    return count_ > 0 && highest < upper_.least() && -lowest < lower_.least();
}

int ClippingCheck::levels() const {
    if (count_ == 0 || upper_.level == -lower_.level) {
        return count_ == 0 ? 0 : 1;
    }
    return upper_.count + lower_.count == count_ ? 2 : 3;
}

std::vector<ClippingCheck::Rail> ClippingCheck::rails() const {
    std::vector<Rail> rails;
    if (levels() < 3) {
        return rails;
    }
    if (upper_.is_rail()) {
        rails.push_back({upper_.level, upper_.count, upper_.places});
    }
    if (lower_.is_rail()) {
        rails.push_back({-lower_.level, lower_.count, lower_.places});
    }
    return rails;
}

namespace {

constexpr Eigen::Index order = 16;
// The prediction is fitted to blocks of about so many frames together.
constexpr std::size_t fitted_frames = 2048;

using Samples = Eigen::Map<const Eigen::VectorXd>;

// Adds the normal equations of x[j] = sum over i of a_i x[j - i] for j in [from, from + count).
void add_equations(const Samples& x, Eigen::Index from, Eigen::Index count, Eigen::MatrixXd& normal,
                   Eigen::VectorXd& right) {
    for (Eigen::Index i = 1; i <= order; ++i) {
        const auto past = x.segment(from - i, count);
        right[i - 1] += past.dot(x.segment(from, count));
        for (Eigen::Index k = 1; k <= i; ++k) {
            normal(i - 1, k - 1) += past.dot(x.segment(from - k, count));
        }
    }
}

// Mean squared errors, both channels summed, of a linear prediction from the 16 samples before, for
// each block of `block` frames. One prediction for both channels is fitted to a sample of the
// blocks. A sum of up to eight decaying modes in noise has small errors everywhere except at lost
// samples. NaN for the first block, blocks with missing samples and the blocks after these.
std::vector<double> prediction_errors(std::span<const double> c, std::span<const double> d,
                                      std::size_t block) {
    const std::size_t blocks = c.size() / block;
    std::vector<double> errors(blocks, std::numeric_limits<double>::quiet_NaN());
    const Samples x(c.data(), static_cast<Eigen::Index>(c.size()));
    const Samples y(d.data(), static_cast<Eigen::Index>(d.size()));
    const auto length = static_cast<Eigen::Index>(block);
    std::vector<Eigen::Index> whole;  // starts of blocks that can be predicted
    for (std::size_t b = 1; b < blocks; ++b) {
        const auto from = static_cast<Eigen::Index>(b * block);
        if (length >= order && x.segment(from - order, length + order).allFinite() &&
            y.segment(from - order, length + order).allFinite()) {
            whole.push_back(from);
        }
    }
    if (whole.size() < 8) {
        return errors;
    }
    Eigen::MatrixXd normal = Eigen::MatrixXd::Zero(order, order);
    Eigen::VectorXd right = Eigen::VectorXd::Zero(order);
    const std::size_t stride = std::max<std::size_t>(1, whole.size() * block / fitted_frames);
    for (std::size_t k = 0; k < whole.size(); k += stride) {
        add_equations(x, whole[k], length, normal, right);
        add_equations(y, whole[k], length, normal, right);
    }
    // Noise far below the last digits keeps the equations solvable where there is none.
    normal.diagonal().array() += 1e-12 * normal.trace() / static_cast<double>(order);
    const Eigen::VectorXd a = normal.selfadjointView<Eigen::Lower>().ldlt().solve(right);
    Eigen::VectorXd left(length);
    for (const Eigen::Index from : whole) {
        double squares = 0;
        for (const Samples* channel : {&x, &y}) {
            left = channel->segment(from, length);
            for (Eigen::Index i = 1; i <= order; ++i) {
                left -= a[i - 1] * channel->segment(from - i, length);
            }
            squares += left.squaredNorm();
        }
        errors[static_cast<std::size_t>(from) / block] = squares / static_cast<double>(block);
    }
    return errors;
}

using Complex = std::complex<double>;

// Least number of blocks between two suspicions that are judged separately.
constexpr std::size_t least_between = 4;
// Half a second at 33333 Hz, and at most eight megabytes of a slow carrier.
constexpr std::size_t most_segment_blocks = 512;
constexpr std::size_t most_segment_frames = std::size_t{1} << 19;
// Threshold of the mean prediction error of a block, relative to the median.
constexpr double far_off_prediction = 5;
// Largest number of judged suspicions of a segment, in the order of size; with more, the phase
// cannot be followed.
constexpr std::size_t most_judged = 16;

// Smallest phase step of one to three lost samples.
double smallest_step(double w) {
    return std::min({std::abs(wrap(w)), std::abs(wrap(2 * w)), std::abs(wrap(3 * w))});
}

// Two periods at least. Of lengths up to half as long again, the one nearest to whole half-periods:
// there the image at -w, which hides small steps, affects the sum of a block least.
std::size_t block_of(double w) {
    const double two_periods = 4 * std::numbers::pi / w;
    const auto least = static_cast<std::size_t>(std::clamp(std::ceil(two_periods), 32.0, 4096.0));
    std::size_t best = least;
    for (std::size_t length = least; length <= least + least / 2; ++length) {
        const auto image = [w](std::size_t n) {
            return std::abs(std::sin(w * static_cast<double>(n)));
        };
        if (image(length) < image(best)) {
            best = length;
        }
    }
    return best;
}

// Twelve periods resolve neighbouring modes; eight blocks leave room for a step.
std::size_t reach_of(double w, std::size_t block) {
    const double frames = std::clamp(24 * std::numbers::pi / w, 512.0, 16384.0);
    return std::max<std::size_t>(8, (static_cast<std::size_t>(frames) + block - 1) / block);
}

}  // namespace

PhaseStepCheck::PhaseStepCheck(double f0_hz, double rate_hz)
    : w_(2 * std::numbers::pi * f0_hz / rate_hz),
      block_frames_(block_of(w_)),
      reach_blocks_(reach_of(w_, block_frames_)) {
    const std::size_t blocks = std::clamp<std::size_t>(most_segment_frames / block_frames_,
                                                       4 * reach_blocks_, most_segment_blocks);
    segment_frames_ = (blocks + 2 * reach_blocks_ + 6) * block_frames_;
    for (std::size_t j = 0; j < block_frames_; ++j) {
        basis_.push_back(std::polar(1.0, -w_ * static_cast<double>(j)));
    }
}

void PhaseStepCheck::add(std::int64_t first_frame, std::span<const double> c,
                         std::span<const double> d) {
    if (first_frame != first_frame_ + static_cast<std::int64_t>(c_.size())) {
        evaluate(true);
        c_.clear();
        d_.clear();
        blocks_.clear();
        first_block_ = 0;
        first_frame_ = first_frame;
    }
    for (std::size_t at = 0; at < c.size();) {
        const std::size_t count = std::min(segment_frames_ - c_.size(), c.size() - at);
        const auto copy = [at, count](std::span<const double> from, std::vector<double>& to) {
            const auto begin = from.begin() + static_cast<std::ptrdiff_t>(at);
            to.insert(to.end(), begin, begin + static_cast<std::ptrdiff_t>(count));
        };
        copy(c, c_);
        copy(d, d_);
        at += count;
        while ((blocks_.size() + 1) * block_frames_ <= c_.size()) {
            close_block();
        }
        if (c_.size() == segment_frames_) {
            evaluate(false);
            const auto keep = [](auto& values, std::size_t last) {
                values.erase(values.begin(), values.end() - static_cast<std::ptrdiff_t>(last));
            };
            const std::size_t kept = 2 * reach_blocks_ + 6;
            const std::size_t gone = blocks_.size() - kept;
            first_frame_ += static_cast<std::int64_t>(gone * block_frames_);
            first_block_ -= gone;
            keep(c_, kept * block_frames_);
            keep(d_, kept * block_frames_);
            keep(blocks_, kept);
        }
    }
}

void PhaseStepCheck::close_block() {
    Block block;
    const std::size_t begin = blocks_.size() * block_frames_;
    double c_cos = 0;
    double c_sin = 0;
    double d_cos = 0;
    double d_sin = 0;
    for (std::size_t j = 0; j < block_frames_; ++j) {
        c_cos += c_[begin + j] * basis_[j].real();
        c_sin += c_[begin + j] * basis_[j].imag();
        d_cos += d_[begin + j] * basis_[j].real();
        d_sin += d_[begin + j] * basis_[j].imag();
    }
    // Whole turns are subtracted first, so that the phase keeps its digits over hours.
    const double turns = w_ / (2 * std::numbers::pi) *
                         static_cast<double>(first_frame_ + static_cast<std::int64_t>(begin));
    const Complex start = std::polar(1.0, -2 * std::numbers::pi * std::remainder(turns, 1.0));
    block.c = start * Complex(c_cos, c_sin);
    block.d = start * Complex(d_cos, d_sin);
    // A missing sample makes the whole sum NaN.
    block.missing = !std::isfinite(c_cos) || !std::isfinite(d_cos);
    blocks_.push_back(block);
}

// Blocks across which the phase changes, from the block before to the block after, by more than a
// threshold; sets `threshold`.
std::vector<PhaseStepCheck::Suspect> PhaseStepCheck::moving_phases(double& threshold) const {
    std::vector<double> moves;
    std::vector<std::size_t> places;
    for (std::size_t k = 1; k + 1 < blocks_.size(); ++k) {
        const Block& before = blocks_[k - 1];
        const Block& after = blocks_[k + 1];
        if (before.missing || blocks_[k].missing || after.missing) {
            continue;
        }
        const Complex move = after.c * std::conj(before.c) + after.d * std::conj(before.d);
        if (std::norm(move) > 0) {
            moves.push_back(std::arg(move));
            places.push_back(k);
        }
    }
    std::vector<Suspect> suspects;
    if (moves.size() < 8) {
        return suspects;
    }
    const double usual = median(moves);
    for (double& move : moves) {
        move = std::abs(wrap(move - usual));
    }
    constexpr double sd_of_median_deviation = 1.4826;
    threshold = std::max(least_phase_step, 8 * sd_of_median_deviation * median(moves));
    for (std::size_t k = 0; k < moves.size(); ++k) {
        if (moves[k] > threshold) {
            suspects.push_back({places[k], places[k], moves[k] / threshold});
        }
    }
    return suspects;
}

// Blocks whose samples do not follow from those before (large prediction error).
std::vector<PhaseStepCheck::Suspect> PhaseStepCheck::unforeseen_blocks() const {
    const std::vector<double> errors = prediction_errors(c_, d_, block_frames_);
    std::vector<double> known;
    std::ranges::copy_if(errors, std::back_inserter(known),
                         [](double error) { return std::isfinite(error); });
    std::vector<Suspect> suspects;
    if (known.size() < 8) {
        return suspects;
    }
    const double usual = median(std::move(known));
    for (std::size_t k = 0; k < errors.size(); ++k) {
        if (errors[k] > far_off_prediction * usual) {
            suspects.push_back({k, k, errors[k] / (far_off_prediction * usual)});
        }
    }
    return suspects;
}

// Merges suspicions too close to each other for separate judgement.
void PhaseStepCheck::draw_together(std::vector<Suspect>& suspects) {
    std::ranges::sort(suspects, {}, &Suspect::first);
    std::vector<Suspect> fewer;
    for (const Suspect& suspect : suspects) {
        if (!fewer.empty() && suspect.first <= fewer.back().last + least_between) {
            fewer.back().last = std::max(fewer.back().last, suspect.last);
            fewer.back().size = std::max(fewer.back().size, suspect.size);
        } else {
            fewer.push_back(suspect);
        }
    }
    suspects = std::move(fewer);
}

void PhaseStepCheck::evaluate(bool is_end) {
    double threshold = least_phase_step;
    std::vector<Suspect> suspects = moving_phases(threshold);
    if (threshold > least_phase_step && threshold > 0.7 * smallest_step(w_)) {
        std::ranges::copy(unforeseen_blocks(), std::back_inserter(suspects));
    }
    draw_together(suspects);
    const std::size_t end =
        is_end ? blocks_.size() : blocks_.size() - std::min(blocks_.size(), reach_blocks_ + 3);
    std::vector<double> sizes(suspects.size());
    std::ranges::transform(suspects, sizes.begin(), &Suspect::size);
    std::ranges::sort(sizes, std::greater{});
    const double least = sizes.size() > most_judged ? sizes[most_judged - 1] : 0;
    for (std::size_t k = 0; k < suspects.size(); ++k) {
        if (suspects[k].first >= first_block_ && suspects[k].first < end &&
            suspects[k].size >= least) {
            judge(suspects, k);
        }
    }
    first_block_ = end;
}

// Judges the range around a suspicion, limited by its reach, other suspicions and missing samples.
void PhaseStepCheck::judge(const std::vector<Suspect>& suspects, std::size_t suspect) {
    // A step affects adjacent blocks, too.
    const std::size_t first =
        suspects[suspect].first - std::min<std::size_t>(1, suspects[suspect].first);
    const std::size_t end = std::min(suspects[suspect].last + 2, blocks_.size());
    const std::size_t after_last = suspect == 0 ? 0 : suspects[suspect - 1].last + 2;
    const std::size_t before_next =
        suspect + 1 == suspects.size() ? blocks_.size() : suspects[suspect + 1].first - 1;
    if (std::ranges::any_of(blocks_.begin() + static_cast<std::ptrdiff_t>(first),
                            blocks_.begin() + static_cast<std::ptrdiff_t>(end), &Block::missing)) {
        return;
    }
    std::size_t from = first;
    while (from > 0 && first - from < reach_blocks_ && !blocks_[from - 1].missing) {
        --from;
    }
    std::size_t to = end;
    while (to < blocks_.size() && to - end < reach_blocks_ && !blocks_[to].missing) {
        ++to;
    }
    const Suspicion where{from * block_frames_,
                          std::min(first, std::max(from, after_last)) * block_frames_,
                          first * block_frames_,
                          end * block_frames_,
                          std::max(end, std::min(to, before_next)) * block_frames_,
                          to * block_frames_};
    std::optional<PhaseStep> step = judge_step({c_, d_}, where, w_);
    if (!step) {
        return;
    }
    step->frame += first_frame_;
    const bool seen_before = !found_.empty() && step->frame - found_.back().frame <=
                                                    static_cast<std::int64_t>(2 * block_frames_);
    if (!seen_before) {
        found_.push_back(*std::move(step));
    }
}

std::vector<PhaseStep> PhaseStepCheck::finish() {
    evaluate(true);
    return std::move(found_);
}

std::int64_t least_still_frames(double f0_hz, double rate_hz) {
    constexpr std::int64_t least = 16;
    return std::max(least, static_cast<std::int64_t>(std::ceil(rate_hz / f0_hz)) + 1);
}

bool stand_still(std::span<const double> c, std::span<const double> d, std::int64_t frames) {
    std::int64_t unmoved = 1;
    for (std::size_t j = 1; j < c.size(); ++j) {
        unmoved = c[j] == c[j - 1] && d[j] == d[j - 1] ? unmoved + 1 : 1;
        if (unmoved >= frames) {
            return true;
        }
    }
    return false;
}

FillCheck::FillCheck(double f0_hz, double rate_hz)
    : least_still_(least_still_frames(f0_hz, rate_hz)),
      cos_w_(std::cos(2 * std::numbers::pi * f0_hz / rate_hz)) {}

// Counts equal neighbours first: most portions have none.
void FillCheck::add(std::int64_t first_frame, std::span<const double> c,
                    std::span<const double> d) {
    opening_ = opening_ < 0 ? first_frame : opening_;
    std::int64_t alike = c[0] == last_[0] && d[0] == last_[1] ? 1 : 0;
    std::int64_t zeros = 0;
    for (std::size_t j = 1; j < c.size(); ++j) {
        alike += static_cast<std::int64_t>((c[j] == c[j - 1]) & (d[j] == d[j - 1]));
        zeros += static_cast<std::int64_t>((c[j] == 0) & (d[j] == 0));
    }
    if (alike + zeros > 0) {
        const auto [low_c, high_c] = std::ranges::minmax(c);
        const auto [low_d, high_d] = std::ranges::minmax(d);
        if (high_c - low_c > high_d - low_d) {
            add_short(first_frame, c, d, low_c, high_c);
        } else {
            add_short(first_frame, d, c, low_d, high_d);
        }
    }
    const std::size_t from = alike > 0 ? 0 : c.size() - 1;
    for (std::size_t j = from; j < c.size(); ++j) {
        if (alike > 0 && c[j] == last_[0] && d[j] == last_[1]) {
            ++unmoved_.count;
            continue;
        }
        close();
        unmoved_ = {first_frame + static_cast<std::int64_t>(j), 1};
        last_ = {c[j], d[j]};
    }
}

// Of a sinusoid about its middle, x(j-1) + x(j+1) = 2 cos(w) x(j). The last frame of a fill counts.
void FillCheck::add_short(std::int64_t first_frame, std::span<const double> x,
                          std::span<const double> y, double low, double high) {
    const double bound = 0.15 * (high - low);
    const double of_middle = (1 - cos_w_) * (low + high);
    const auto is_off = [&](std::size_t j) {
        return std::abs(x[j - 1] + x[j + 1] - 2 * cos_w_ * x[j] - of_middle) > bound;
    };
    const auto repeats = [&](std::size_t j) { return x[j] == x[j - 1] && y[j] == y[j - 1]; };
    const auto is_empty = [&](std::size_t j) { return x[j] == 0 && y[j] == 0; };
    for (std::size_t j = 2; j + 2 < x.size(); ++j) {
        const bool filled = (repeats(j) && !repeats(j + 1)) || (is_empty(j) && !is_empty(j + 1));
        const bool at_rail = x[j] == low || x[j] == high;
        if (filled && !at_rail && (is_off(j - 1) || is_off(j) || is_off(j + 1))) {
            ++short_fills_;
            const std::int64_t frame = first_frame + static_cast<std::int64_t>(j);
            first_short_ = first_short_ < 0 ? frame : first_short_;
        }
    }
}

void FillCheck::close() {
    if (unmoved_.count < least_still_) {
        return;
    }
    for (std::size_t k = 0; k < held_.size(); ++k) {
        const auto count = static_cast<double>(unmoved_.count);
        held_[k].sum += count * last_[k];
        held_[k].squares += count * last_[k] * last_[k];
        held_[k].count += unmoved_.count;
    }
    if (unmoved_.first == opening_) {
        return;
    }
    still_frames_ += unmoved_.count;
    if (++still_places_ <= static_cast<std::int64_t>(ClippingCheck::most_places)) {
        still_.push_back(unmoved_);
    }
}

std::vector<FrameRange> FillCheck::finish() {
    close();
    unmoved_ = {};
    return std::move(still_);
}

}  // namespace vybeg
