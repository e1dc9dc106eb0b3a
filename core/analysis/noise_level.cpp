#include "core/analysis/noise_level.h"

#include "core/estimators/batch/window_estimate.h"
#include "core/numerics/median.h"
#include "core/windows/window_plan.h"

#include <algorithm>
#include <cmath>
#include <complex>
#include <limits>
#include <numbers>

namespace vybeg {
namespace {

// Share of the frames that the short windows of a stretch take, and their number.
constexpr double share_of_frames = 0.03;
constexpr std::int64_t fewest_short = 32;
constexpr std::int64_t most_short = 512;

// Hum h and offset o leave (o + h cos)^2, at most four times its median.
constexpr double least_ratio = 4;
// One in 10^6, normal deviate.
constexpr double rare = 4.75;
// chi^2 of a phasor pair, 4 degrees of freedom, beyond which lies one in 10^8.
constexpr double rare_phasors = 42;
// Behind a band-pass a window shorter than the inverse bandwidth leaves the quadratic part of four
// phasor components.
constexpr double least_freedom = 4;
constexpr double pooled_freedom = 100;
constexpr double efficiency_of_median = 0.6;

bool is_measured(const WaveEstimate& estimate) {
    return std::isfinite(estimate.steady_noise) && std::isfinite(estimate.f_hz);
}

// Mean of variances of `freedom` degrees of freedom from their median; NaN of none.
double level_of(std::span<const WaveEstimate> windows, double freedom) {
    std::vector<double> variances;
    variances.reserve(windows.size());
    for (const WaveEstimate& window : windows) {
        if (is_measured(window)) {
            variances.push_back(window.steady_noise * window.steady_noise);
        }
    }
    return median(std::move(variances)) / chi2_ratio(0, freedom);
}

}  // namespace

std::int64_t noise_window(std::int64_t length, double f0_hz, double rate_hz) {
    return std::min(length, 12 * least_window(f0_hz, rate_hz));
}

NoiseLevel::NoiseLevel(std::int64_t length, double f0_hz, double rate_hz,
                       std::optional<Known> known)
    : length_(length),
      short_(noise_window(length, f0_hz, rate_hz)),
      rate_hz_(rate_hz),
      known_(known) {
    const double share = known ? known->share : 1;
    const double freedom = std::max(2 * static_cast<double>(length) * share - 8, least_freedom);
    limit_ = least_ratio * chi2_ratio(rare, known ? freedom : steady_freedom(length));
}

std::int64_t NoiseLevel::hop(std::int64_t frames) const {
    const auto wish = static_cast<std::int64_t>(share_of_frames * static_cast<double>(frames)) /
                      short_;
    const std::int64_t count = std::clamp(wish, fewest_short, most_short);
    return std::max<std::int64_t>((frames - short_) / count, 1);
}

void NoiseLevel::take(std::span<const WaveEstimate> estimates, double centre_s, std::int64_t hop) {
    shorts_.clear();
    variance_ = known_ ? known_->in_band * known_->in_band
                       : level_of(estimates, steady_freedom(short_));
    if (length_ < 2 * short_) {
        return;
    }
    for (std::size_t k = 0; k < estimates.size(); ++k) {
        if (is_measured(estimates[k])) {
            shorts_.push_back({centre_s + static_cast<double>(k) * static_cast<double>(hop) / rate_hz_,
                               to_phasors(estimates[k].state)});
        }
    }
}

bool NoiseLevel::holds_no_wave(const WaveEstimate& window, double centre_s) const {
    return leaves_residual(window) || leaves_wave(window, centre_s);
}

bool NoiseLevel::leaves_residual(const WaveEstimate& window) const {
    return window.steady_noise * window.steady_noise > limit_ * variance_;
}

bool NoiseLevel::leaves_wave(const WaveEstimate& window, double centre_s) const {
    const double reach = 0.5 * static_cast<double>(length_ - short_) / rate_hz_;
    const auto first = std::ranges::lower_bound(shorts_, centre_s - reach, {}, &Short::centre_s);
    if (first == shorts_.end() || first->centre_s > centre_s + reach) {
        return false;
    }
    // Variance of a phasor component: 2 sigma^2/n; at the end of a window, where the error of its
    // frequency adds, 8 sigma^2/n.
    const double level = std::sqrt(variance_);
    const double of_short = known_ ? known_->of_short.phasors : level;
    const double of_long =
        known_ ? std::max(known_->of_long.phasors, known_->of_long.frequency) : level;
    const double variance = 2 * of_short * of_short / static_cast<double>(short_) +
                            8 * of_long * of_long / static_cast<double>(length_);
    const Phasors phasors = to_phasors(window.state);
    for (auto at = first; at != shorts_.end() && at->centre_s <= centre_s + reach; ++at) {
        const double turns = window.f_hz * (at->centre_s - centre_s);
        const std::complex<double> turn =
            std::polar(1.0, 2 * std::numbers::pi * std::remainder(turns, 1.0));
        const double off =
            std::norm(at->phasors.c - phasors.c * turn) + std::norm(at->phasors.d - phasors.d * turn);
        if (off > rare_phasors * variance) {  // NaN: a circular wave has no phasors here
            return true;
        }
    }
    return false;
}

void pool_noise(std::span<WaveEstimate> windows, std::int64_t length, double independent) {
    const double freedom = steady_freedom(length);
    const double level = level_of(windows, freedom);
    const double pooled =
        std::min(pooled_freedom, efficiency_of_median * freedom * independent *
                                     (static_cast<double>(windows.size()) - 1));
    if (!(level > 0 && pooled > 0)) {
        return;
    }
    for (WaveEstimate& window : windows) {
        if (is_measured(window)) {
            const double own = window.steady_noise * window.steady_noise;
            set_noise(window, std::sqrt((freedom * own + pooled * level) / (freedom + pooled)));
        }
    }
}

}  // namespace vybeg
