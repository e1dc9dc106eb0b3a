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

// Hum h and offset o leave (o + h cos)^2, up to nine times its median (o = h/2), known from some
// ten short windows.
constexpr double least_ratio = 12;
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
    // Even or odd as the window, so that both have one centre.
    const std::int64_t wish = 12 * least_window(f0_hz, rate_hz);
    return std::min(length, wish + (length - wish) % 2);
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

std::int64_t NoiseLevel::stride(std::int64_t windows, std::int64_t frames) const {
    const auto wish =
        static_cast<std::int64_t>(share_of_frames * static_cast<double>(frames)) / short_;
    return std::max<std::int64_t>(windows / std::clamp(wish, fewest_short, most_short), 1);
}

void NoiseLevel::take(std::span<const WaveEstimate> estimates, double centre_s, std::int64_t hop) {
    shorts_.clear();
    variance_ =
        known_ ? known_->in_band * known_->in_band : level_of(estimates, steady_freedom(short_));
    if (length_ < 2 * short_) {
        return;
    }
    for (std::size_t k = 0; k < estimates.size(); ++k) {
        if (is_measured(estimates[k])) {
            shorts_.push_back(
                {centre_s + static_cast<double>(k) * static_cast<double>(hop) / rate_hz_,
                 to_phasors(estimates[k].state)});
        }
    }
}

bool NoiseLevel::holds_no_wave(const WaveEstimate& window, double centre_s) const {
    return window.steady_noise * window.steady_noise > limit_ * variance_ ||
           apart(window, centre_s) > rare_phasors;
}

bool NoiseLevel::all_move(std::vector<double> apart) const {
    std::erase_if(apart, [](double x) { return std::isnan(x); });
    if (known_ || apart.size() < 4 || shorts_.size() < 4) {
        return false;  // behind a band-pass the short windows are no independent witnesses
    }
    // A median scatters by 1.25 times as much as a mean.
    const double scatter = 1.25 * std::sqrt(2 / (4 * static_cast<double>(shorts_.size())));
    return median(std::move(apart)) > 4 * (1 + rare * scatter);
}

double NoiseLevel::apart(const WaveEstimate& window, double centre_s) const {
    const double tolerance = 0.25 / rate_hz_;
    const auto at = std::ranges::lower_bound(shorts_, centre_s - tolerance, {}, &Short::centre_s);
    if (at == shorts_.end() || at->centre_s > centre_s + tolerance) {
        return std::numeric_limits<double>::quiet_NaN();
    }
    // Variance of a phasor component: 2 sigma^2/n.
    const double level = std::sqrt(variance_);
    const double of_short = known_ ? known_->of_short.phasors : level;
    const double of_long = known_ ? known_->of_long.phasors : level;
    const double variance = 2 * of_short * of_short / static_cast<double>(short_) +
                            2 * of_long * of_long / static_cast<double>(length_);
    const Phasors phasors = to_phasors(window.state);
    return (std::norm(at->phasors.c - phasors.c) + std::norm(at->phasors.d - phasors.d)) / variance;
}

void pool_noise(std::span<WaveEstimate> windows, std::int64_t length, double independent) {
    const double freedom = steady_freedom(length);
    const double level = level_of(windows, freedom);
    const double pooled = std::min(pooled_freedom, efficiency_of_median * freedom * independent *
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
