#include "core/estimators/batch/carrier_sums.h"

#include "core/estimators/batch/window_estimate.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <complex>
#include <iterator>
#include <numbers>

namespace vybeg {
namespace {

using std::numbers::pi;
// Largest |x| of the windows of a block for which the carrier is the reference of all.
constexpr double near = 0.04;
// Step of the grid of references, which blocks share.
constexpr double grid = 0.06;
constexpr std::size_t most_references = 64;
// Long windows with a drifting carrier have a reference almost each.
constexpr std::size_t most_of_long = 6;
// Largest range of x of the windows with one reference: a reference computed for these windows, and
// one of the grid.
constexpr double widest = 0.06;
constexpr double widest_on_grid = 0.03;
// Largest number of windows of a block that move the line without convergence, because the
// frequency of noise follows no line.
constexpr int most_followed = 4;
// Shorter windows are not probed, because their pieces would be shorter than two periods.
constexpr std::int64_t least_probed = 128;
// Windows from this length on are probed by separate pieces of 64 samples, which resolve
// frequencies far outside the main lobe.
constexpr std::int64_t least_sparse = 1024;

// Power at x of the pieces of a window; the phase between pieces changes by `by_x` radians per x.
double power_of_pieces(std::span<const Phasors> pieces, double turn, double by_x, double x) {
    std::complex<double> c = 0;
    std::complex<double> d = 0;
    for (std::size_t k = 0; k < pieces.size(); ++k) {
        const auto back = std::polar(1.0, -(turn + by_x * x) * static_cast<double>(k));
        c += back * pieces[k].c;
        d += back * pieces[k].d;
    }
    return std::norm(c) + std::norm(d);
}

// Position of a separate wave in the main lobe while a stronger wave, at x, lies outside. The
// leakage of the stronger wave into the lobe is below 1/x^2 of its power.
std::optional<double> wave_in_lobe(std::span<const Phasors> pieces, double turn, double by_x,
                                   double x) {
    constexpr int points = 12;
    constexpr double step = 0.25;
    double highest = 0;
    int place = 0;
    for (int k = -points; k <= points; ++k) {
        const double power = power_of_pieces(pieces, turn, by_x, step * k);
        if (power > highest) {
            highest = power;
            place = k;
        }
    }
    const bool is_peak = std::abs(place) < points;
    const double leaks = 4 / (x * x) * power_of_pieces(pieces, turn, by_x, x);
    return is_peak && highest > leaks ? std::optional(step * place) : std::nullopt;
}

}  // namespace

CarrierSums::CarrierSums(std::int64_t n, double w0) : n_(n), w0_(w0) {
    at_ = &reference(0);
}

double CarrierSums::x_at(double window) const {
    return line_.x + line_.slope * (window - line_.from);
}

CarrierSums::Reference& CarrierSums::reference(double x) {
    const std::int64_t place = std::llround(x / grid);
    const std::size_t most = n_ > longest_whole_window ? most_of_long : most_references;
    if (references_.size() >= most && !references_.contains(place)) {
        // The farthest reference is replaced; its memory is already in the caches.
        const bool is_first =
            place - references_.begin()->first > references_.rbegin()->first - place;
        const auto farthest = is_first ? references_.begin() : std::prev(references_.end());
        at_ = at_ == farthest->second.get() ? nullptr : at_;
        references_.erase(farthest);
    }
    std::unique_ptr<Reference>& found = references_[place];
    if (!found) {
        const double w = w0_ + 2 * grid * static_cast<double>(place) / static_cast<double>(n_);
        found = std::make_unique<Reference>(n_, w, tables_);
    }
    return *found;
}

// x from phase differences of short pieces of the window, from neighbours to pieces half a window
// apart; empty where samples are missing.
std::optional<double> CarrierSums::probe(std::size_t window) const {
    const bool sparse = n_ >= least_sparse;
    const std::size_t pieces = sparse ? 16 : 4;
    const std::int64_t length = sparse ? 64 : n_ / 4;
    const std::int64_t apart = (n_ - length) / static_cast<std::int64_t>(pieces - 1);
    const Window all = window_of(block_, window);
    std::array<Phasors, 16> sums;
    for (std::size_t k = 0; k < pieces; ++k) {
        const auto at = static_cast<std::size_t>(apart) * k;
        const auto size = static_cast<std::size_t>(length);
        sums[k] = window_projections({all.c.subspan(at, size), all.d.subspan(at, size)}, w0_);
    }
    double x = 0;
    for (std::size_t lag = 1; lag <= pieces / 2; lag *= 2) {
        std::complex<double> product = 0;
        for (std::size_t k = 0; k + lag < pieces; ++k) {
            product +=
                sums[k + lag].c * std::conj(sums[k].c) + sums[k + lag].d * std::conj(sums[k].d);
        }
        const double samples = static_cast<double>(lag) * static_cast<double>(apart);
        const double by_x = 2 * samples / static_cast<double>(n_);
        const double turned = std::arg(product) - w0_ * samples;
        if (!std::isfinite(turned)) {
            return std::nullopt;
        }
        x += std::remainder(turned - by_x * x, 2 * pi) / by_x;
    }
    if (std::abs(x) > pi) {
        const auto all_pieces = std::span<const Phasors>(sums).first(pieces);
        const double turn = w0_ * static_cast<double>(apart);
        const double by_x = 2 * static_cast<double>(apart) / static_cast<double>(n_);
        x = wave_in_lobe(all_pieces, turn, by_x, x).value_or(x);
    }
    const double farthest = sparse ? 8 * pi : pi;
    // The main lobe of taylor_window.h keeps this distance from 0 and half the rate.
    const double low = 0.5 * (pi - static_cast<double>(n_) * w0_);
    const double high = 0.5 * (static_cast<double>(n_) * (pi - w0_) - pi);
    return std::clamp(std::clamp(x, -farthest, farthest), std::min(low, 0.0), std::max(high, 0.0));
}

// Approximate x of the largest power of a lane, by its series far beyond their reach.
double CarrierSums::rough_maximum(const ProjectionBatch& batch, std::size_t lane) const {
    constexpr int points = 7;
    constexpr double step = 0.25;
    std::array<double, 2 * points + 1> power{};
    for (std::size_t k = 0; k < power.size(); ++k) {
        const double x = step * (static_cast<double>(k) - points);
        power[k] =
            profile_power(jets_of(lane_projections(batch, lane, x), frame().kernel(x))).value;
    }
    const auto peak = std::max_element(power.begin() + 1, power.end() - 1);
    const double bend = peak[-1] - 2 * peak[0] + peak[1];
    const double shift = bend < 0 ? std::clamp(0.5 * (peak[-1] - peak[1]) / bend, -0.5, 0.5) : 0;
    const double x = step * (static_cast<double>(peak - power.begin()) - points + shift);
    return x + 0.5 * static_cast<double>(n_) * (frame().w0() - w0_);
}

void CarrierSums::use(double x) {
    Reference& wanted = reference(x);
    zone_.reset();
    zone_end_ = 0;
    at_ = &wanted;
    at_->sums.take(block_, count_, delayed_);
}

void CarrierSums::take(const WindowBlock& block, std::size_t count,
                       std::span<const double> delayed) {
    block_ = block;
    count_ = count;
    delayed_ = delayed;
    line_ = {};
    left_to_follow_ = most_followed;
    if (n_ >= least_probed && count > 0) {
        const double first = probe(0).value_or(0);
        const double last = count > 1 ? probe(count - 1).value_or(first) : first;
        if (std::abs(first) > near || std::abs(last) > near) {
            line_.x = first;
            line_.slope = count > 1 ? (last - first) / static_cast<double>(count - 1) : 0;
        }
    }
    use(x_at(0.5 * static_cast<double>(count - 1)));
}

// Sums of windows from `first` on at the frequency of the line. Returns their number.
std::size_t CarrierSums::sum_up(std::size_t first, ProjectionBatch& batch) {
    const double steep = std::abs(line_.slope);
    const auto on_line = [steep](std::size_t most, double width) {
        const double windows = 1 + std::floor(steep > 0 ? width / steep : 1e9);
        return std::min(most, static_cast<std::size_t>(std::min(windows, 1e9)));
    };
    const auto left = count_ - first;
    const auto x_of_middle = [&](std::size_t count) {
        return x_at(static_cast<double>(first) + 0.5 * static_cast<double>(count - 1));
    };
    if (!at_->sums.overlapping()) {
        const std::size_t count = on_line(std::min(lane_count, left), widest_on_grid);
        Reference& wanted = reference(x_of_middle(count));
        if (&wanted != at_) {
            at_ = &wanted;
            at_->sums.take(block_, count_, delayed_);
        }
        at_->sums.batch(first, count, batch);
        return count;
    }
    const double here = 0.5 * static_cast<double>(n_) * (at_->basis.w0() - w0_);
    const bool still = std::abs(x_at(0) - here) <= near &&
                       std::abs(x_at(static_cast<double>(count_ - 1)) - here) <= near;
    if (!still && first >= zone_end_) {
        const std::size_t count = on_line(std::min(at_->sums.most_moved(), left), widest);
        zone_.emplace(n_, w0_ + 2 * x_of_middle(count) / static_cast<double>(n_));
        at_->sums.move(first, count, *zone_);
        zone_end_ = first + count;
    }
    const std::size_t count = std::min(lane_count, still ? left : zone_end_ - first);
    at_->sums.batch(first, count, batch);
    return count;
}

// Moves the line through a window in which the steps have not converged; returns true if they then
// converge.
bool CarrierSums::follow(std::size_t first, std::size_t lane, ProjectionBatch& batch,
                         BatchMaximum& maximum, std::size_t& count) {
    const Line before = line_;
    const std::size_t window = first + lane;
    const double rough = rough_maximum(batch, lane);
    const double probed = n_ >= least_probed ? probe(window).value_or(rough) : rough;
    const double here = 0.5 * static_cast<double>(n_) * (frame().w0() - w0_);
    for (const double x : {probed, rough}) {
        if (std::abs(x - here) < 0.5 * near) {
            continue;
        }
        line_.x = x;
        line_.from = static_cast<double>(window);
        use(at_->sums.overlapping() ? x_at(0.5 * static_cast<double>(first + count_)) : x);
        count = sum_up(first, batch);
        maximise_batch(batch, frame(), maximum);
        if (lane < count && maximum.arrived[lane] > 0) {
            return true;
        }
    }
    line_ = before;
    use(x_at(0.5 * static_cast<double>(count_ - 1)));
    count = sum_up(first, batch);
    maximise_batch(batch, frame(), maximum);
    return false;
}

std::size_t CarrierSums::next(std::size_t first, ProjectionBatch& batch, BatchMaximum& maximum) {
    std::size_t count = sum_up(first, batch);
    maximise_batch(batch, frame(), maximum);
    const auto arrived = [&](std::size_t lane) {
        return maximum.arrived[lane] > 0 || !std::isfinite(batch.cc[lane] + batch.dd[lane]);
    };
    if (left_to_follow_ > 0 && !arrived(0)) {
        left_to_follow_ -= follow(first, 0, batch, maximum, count) ? 0 : 1;
    }
    // The next group begins with the last windows that have not converged.
    if (left_to_follow_ > 0 && arrived(0) && !arrived(count - 1)) {
        while (!arrived(count - 1)) {
            --count;
        }
    }
    return count;
}

}  // namespace vybeg
