#include "core/recording/phase_step_check.h"

#include "core/numerics/phase.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

namespace vybeg {
namespace {

using Complex = std::complex<double>;

// Blocks over which the scatter of the phase is taken: half a second at 33333 Hz.
constexpr std::size_t segment_blocks = 512;

double median(std::vector<double> values) {
    const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
    std::nth_element(values.begin(), middle, values.end());
    return *middle;
}

// The number of lost samples whose phase comes nearest to the angle; the fewest of those that fit.
int samples_lost(double angle, double w) {
    constexpr int most = 8;
    int best = 1;
    double least = std::numeric_limits<double>::max();
    for (int size = 1; size <= most; ++size) {
        for (const int lost : {size, -size}) {
            // A carrier at a simple fraction of the rate repeats its phases: the smaller number
            // stands.
            const double off = std::abs(wrap(angle - lost * w));
            if (off < least - 0.1) {
                least = off;
                best = lost;
            }
        }
    }
    return best;
}

}  // namespace

PhaseStepCheck::PhaseStepCheck(double f0_hz, double rate_hz)
    : w_(2 * std::numbers::pi * f0_hz / rate_hz), step_(std::polar(1.0, -w_)) {}

void PhaseStepCheck::add(std::int64_t first_frame, std::span<const double> c,
                         std::span<const double> d) {
    for (std::size_t j = 0; j < c.size(); ++j) {
        if (!open_) {
            const std::int64_t frame = first_frame + static_cast<std::int64_t>(j);
            open_ = Block{frame, {}, {}, false};
            in_block_ = 0;
            // Whole turns first, so that the phase keeps its digits through hours.
            const double turns = w_ / (2 * std::numbers::pi) * static_cast<double>(frame);
            rotation_ = std::polar(1.0, -2 * std::numbers::pi * std::remainder(turns, 1.0));
        }
        if (std::isfinite(c[j]) && std::isfinite(d[j])) {
            open_->c += c[j] * rotation_;
            open_->d += d[j] * rotation_;
        } else {
            open_->missing = true;
        }
        rotation_ *= step_;
        if (++in_block_ == phase_step_block) {
            close_block();
        }
    }
}

void PhaseStepCheck::close_block() {
    blocks_.push_back(*open_);
    open_.reset();
    if (blocks_.size() == segment_blocks + 2) {
        evaluate(blocks_.size());
        blocks_.erase(blocks_.begin(), blocks_.end() - 2);
    }
}

// The phase's move from the block before to the block after each block between the first and the
// last.
void PhaseStepCheck::evaluate(std::size_t blocks) {
    std::vector<double> moves;
    std::vector<std::size_t> places;
    for (std::size_t k = 1; k + 1 < blocks; ++k) {
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
    if (moves.size() < 8) {
        return;
    }
    const double usual = median(moves);
    std::vector<double> deviations;
    for (double& move : moves) {
        move = wrap(move - usual);
        deviations.push_back(std::abs(move));
    }
    constexpr double sd_of_median_deviation = 1.4826;
    const double threshold = std::max(0.25, 8 * sd_of_median_deviation * median(deviations));
    for (std::size_t k = 0; k < moves.size(); ++k) {
        if (std::abs(moves[k]) <= threshold) {
            continue;
        }
        // One step shows in up to three neighbouring blocks: the largest move is the whole of it.
        std::size_t largest = k;
        while (k + 1 < moves.size() && places[k + 1] == places[k] + 1 &&
               std::abs(moves[k + 1]) > threshold) {
            ++k;
            largest = std::abs(moves[k]) > std::abs(moves[largest]) ? k : largest;
        }
        const std::int64_t frame = blocks_[places[largest]].first_frame + phase_step_block / 2;
        const PhaseStep step{frame, moves[largest], samples_lost(moves[largest], w_)};
        if (found_.empty() || frame - found_.back().frame > 2 * phase_step_block) {
            found_.push_back(step);
        } else if (std::abs(step.angle) > std::abs(found_.back().angle)) {
            found_.back() = step;  // one step on the border of two segments
        }
    }
}

std::vector<PhaseStep> PhaseStepCheck::finish() {
    evaluate(blocks_.size());
    blocks_.clear();
    return std::move(found_);
}

}  // namespace vybeg
