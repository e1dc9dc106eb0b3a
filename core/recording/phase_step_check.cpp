#include "core/recording/phase_step_check.h"

#include "core/numerics/phase.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numbers>

namespace vybeg {
namespace {

using Complex = std::complex<double>;

constexpr std::size_t block_frames = 32;
// Blocks over which the scatter of the phase is taken: half a second at 33333 Hz.
constexpr std::size_t segment_blocks = 512;
// Blocks of a segment that the next one sees again: a step in the last of them has its whole
// neighbourhood there.
constexpr std::size_t overlap_blocks = 6;
constexpr double least_step = 0.25;  // rad
// Of the power around a step, what noise and decay may leave unexplained.
constexpr double most_unexplained = 0.1;

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

// Re(z exp(-i w j)), least squares over x[from..to): the wave of one channel, j from the start of
// x.
Complex fit_wave(std::span<const double> x, std::size_t from, std::size_t to, double w) {
    double cc = 0;
    double cs = 0;
    double ss = 0;
    double xc = 0;
    double xs = 0;
    for (std::size_t j = from; j < to; ++j) {
        const double cosine = std::cos(w * static_cast<double>(j));
        const double sine = std::sin(w * static_cast<double>(j));
        cc += cosine * cosine;
        cs += cosine * sine;
        ss += sine * sine;
        xc += x[j] * cosine;
        xs += x[j] * sine;
    }
    const double determinant = cc * ss - cs * cs;
    return {(xc * ss - xs * cs) / determinant, (xs * cc - xc * cs) / determinant};
}

double wave_at(Complex wave, double w, std::size_t j) {
    const double turn = w * static_cast<double>(j);
    return wave.real() * std::cos(turn) + wave.imag() * std::sin(turn);
}

}  // namespace

PhaseStepCheck::PhaseStepCheck(double f0_hz, double rate_hz)
    : w_(2 * std::numbers::pi * f0_hz / rate_hz) {
    for (std::size_t j = 0; j < block_frames; ++j) {
        basis_.push_back(std::polar(1.0, -w_ * static_cast<double>(j)));
    }
}

void PhaseStepCheck::add(std::int64_t first_frame, std::span<const double> c,
                         std::span<const double> d) {
    if (first_frame != first_frame_ + static_cast<std::int64_t>(c_.size())) {
        evaluate();
        forget_all();
        first_frame_ = first_frame;
    }
    constexpr std::size_t most = (segment_blocks + overlap_blocks) * block_frames;
    for (std::size_t at = 0; at < c.size();) {
        const std::size_t count = std::min(most - c_.size(), c.size() - at);
        const auto copy = [at, count](std::span<const double> from, std::vector<double>& to) {
            const auto begin = from.begin() + static_cast<std::ptrdiff_t>(at);
            to.insert(to.end(), begin, begin + static_cast<std::ptrdiff_t>(count));
        };
        copy(c, c_);
        copy(d, d_);
        at += count;
        while ((blocks_.size() + 1) * block_frames <= c_.size()) {
            close_block();
        }
        if (c_.size() == most) {
            evaluate();
            const auto keep = [](auto& values, std::size_t last) {
                values.erase(values.begin(), values.end() - static_cast<std::ptrdiff_t>(last));
            };
            constexpr std::size_t kept = overlap_blocks * block_frames;
            first_frame_ += static_cast<std::int64_t>(most - kept);
            keep(c_, kept);
            keep(d_, kept);
            keep(blocks_, overlap_blocks);
        }
    }
}

void PhaseStepCheck::close_block() {
    Block block;
    const std::size_t begin = blocks_.size() * block_frames;
    double c_cos = 0;
    double c_sin = 0;
    double d_cos = 0;
    double d_sin = 0;
    for (std::size_t j = 0; j < block_frames; ++j) {
        c_cos += c_[begin + j] * basis_[j].real();
        c_sin += c_[begin + j] * basis_[j].imag();
        d_cos += d_[begin + j] * basis_[j].real();
        d_sin += d_[begin + j] * basis_[j].imag();
    }
    // Whole turns are taken off first, so that the phase keeps its digits through hours.
    const double turns = w_ / (2 * std::numbers::pi) *
                         static_cast<double>(first_frame_ + static_cast<std::int64_t>(begin));
    const Complex start = std::polar(1.0, -2 * std::numbers::pi * std::remainder(turns, 1.0));
    block.c = start * Complex(c_cos, c_sin);
    block.d = start * Complex(d_cos, d_sin);
    // A missing sample makes its whole sum one.
    block.missing = !std::isfinite(c_cos) || !std::isfinite(d_cos);
    blocks_.push_back(block);
}

// The phase's move from the block before to the block after each block between the first and the
// last.
void PhaseStepCheck::evaluate() {
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
    const double threshold = std::max(least_step, 8 * sd_of_median_deviation * median(deviations));
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
        const std::optional<PhaseStep> step = placed(places[largest]);
        if (!step) {
            continue;
        }
        const bool seen_before = !found_.empty() && step->frame - found_.back().frame <=
                                                        static_cast<std::int64_t>(2 * block_frames);
        if (!seen_before) {
            found_.push_back(*step);
        } else if (std::abs(step->angle) > std::abs(found_.back().angle)) {
            found_.back() = *step;  // one step on the border of two segments
        }
    }
}

// The frame of a step in or beside a block: the waves of the two blocks before its neighbours and
// of the two after change over where that leaves the least squares.
std::optional<PhaseStep> PhaseStepCheck::placed(std::size_t block) const {
    const std::size_t low = (block - 1) * block_frames;
    const std::size_t high = (block + 2) * block_frames;
    const std::size_t begin = low - std::min(low, 2 * block_frames);
    const std::size_t end = std::min(high + 2 * block_frames, c_.size());
    const auto part = [begin, end](const std::vector<double>& x) {
        return std::span(x).subspan(begin, end - begin);
    };
    const auto is_missing = [](double x) { return !std::isfinite(x); };
    if (low - begin < block_frames || end - high < block_frames ||
        std::ranges::any_of(part(c_), is_missing) || std::ranges::any_of(part(d_), is_missing)) {
        return std::nullopt;
    }
    const std::size_t from = low - begin;
    const std::size_t to = high - begin;
    const std::array<std::span<const double>, 2> channels{part(c_), part(d_)};
    std::array<Complex, 2> before;
    std::array<Complex, 2> after;
    Complex turn = 0;
    double power = 0;
    for (std::size_t i = 0; i < 2; ++i) {
        before[i] = fit_wave(channels[i], 0, from, w_);
        after[i] = fit_wave(channels[i], to, end - begin, w_);
        // z is conjugate to the analytic signal's phase: a wave that runs ahead has its arg fall.
        turn += std::conj(after[i]) * before[i];
    }
    double squares = 0;  // of the change over at each frame, from `from` on
    for (std::size_t i = 0; i < 2; ++i) {
        for (std::size_t j = from; j < to; ++j) {
            const double off = channels[i][j] - wave_at(after[i], w_, j);
            squares += off * off;
            power += channels[i][j] * channels[i][j];
        }
    }
    double least = squares;
    std::size_t best = from;
    for (std::size_t j = from; j < to; ++j) {
        for (std::size_t i = 0; i < 2; ++i) {
            const double off_before = channels[i][j] - wave_at(before[i], w_, j);
            const double off_after = channels[i][j] - wave_at(after[i], w_, j);
            squares += off_before * off_before - off_after * off_after;
        }
        if (squares < least) {
            least = squares;
            best = j + 1;
        }
    }
    const double angle = std::arg(turn);
    if (least > most_unexplained * power || std::abs(angle) < least_step) {
        return std::nullopt;
    }
    return PhaseStep{first_frame_ + static_cast<std::int64_t>(begin + best), angle,
                     samples_lost(angle, w_)};
}

void PhaseStepCheck::forget_all() {
    c_.clear();
    d_.clear();
    blocks_.clear();
}

std::vector<PhaseStep> PhaseStepCheck::finish() {
    evaluate();
    forget_all();
    return std::move(found_);
}

}  // namespace vybeg
