#include "core/analysis/window_noise.h"

#include "core/estimators/batch/window_estimate.h"
#include "core/numerics/fft.h"
#include "core/numerics/kaiser.h"
#include "core/numerics/statistics.h"
#include "core/track/track_summary.h"
#include "core/windows/window_plan.h"

#include <algorithm>
#include <array>
#include <bit>
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
// Short windows on end in a run, over half a period of hum for a carrier up to 100 times its
// frequency, and frames by those of runs.
constexpr std::int64_t shorts_of_run = 8;
constexpr std::int64_t frames_by_run = 64;
constexpr std::int64_t fewest_runs = 4;
constexpr std::size_t fewest_fourth = 12;

// Hum h and offset o leave (o + h cos)^2, up to nine times its median (o = h/2), known from some
// ten short windows.
constexpr double least_ratio = 12;
// One in 10^6, normal deviate.
constexpr double rare = 4.75;
// chi^2 of a phasor pair, 4 degrees of freedom, beyond which lies one in 10^8.
constexpr double rare_phasors = 42;
// After a band-pass a window shorter than the inverse bandwidth leaves the quadratic part of four
// phasor components.
constexpr double least_freedom = 4;
constexpr double pooled_freedom = 100;
constexpr double efficiency_of_median = 0.6;

bool is_measured(const WaveEstimate& estimate) {
    return std::isfinite(estimate.steady_noise) && std::isfinite(estimate.f_hz);
}

// The value beyond which a fifth of the others lies, and that of chi^2 with one degree of freedom.
double upper(std::vector<double> values) {
    const auto at = values.begin() + static_cast<std::ptrdiff_t>(4 * values.size() / 5);
    std::ranges::nth_element(values, at);
    return *at;
}
constexpr double upper_chi2 = 1.642;

// Mean of variances of `freedom` degrees of freedom from their median; NaN of none.
double level_of(std::vector<double> variances, double freedom) {
    std::erase_if(variances, [](double x) { return std::isnan(x); });
    return median(std::move(variances)) / chi2_ratio(0, freedom);
}

double level_of(std::span<const WaveEstimate> windows, double freedom) {
    std::vector<double> variances;
    variances.reserve(windows.size());
    for (const WaveEstimate& window : windows) {
        if (is_measured(window)) {
            variances.push_back(window.steady_noise * window.steady_noise);
        }
    }
    return level_of(std::move(variances), freedom);
}

// Least hop from window to window, without overlap, by which the wave turns most nearly half a
// turn: what an offset leaves in the estimates alternates.
std::int64_t alternating_hop(std::int64_t length, double f0_hz, double rate_hz) {
    std::int64_t best = length;
    double least = 1;
    for (std::int64_t hop = length; hop <= length + static_cast<std::int64_t>(rate_hz / f0_hz);
         ++hop) {
        const double off = std::abs(
            std::abs(std::remainder(static_cast<double>(hop) * f0_hz / rate_hz, 1.0)) - 0.5);
        if (off < least) {
            least = off;
            best = hop;
        }
    }
    return best;
}

constexpr std::int64_t most_frames = std::int64_t{1} << 18;
constexpr std::int64_t read_frames = std::int64_t{1} << 16;

using Analytic = std::vector<std::complex<double>>;

// The longest run of frames without a missing sample, as C + iD, up to most_frames; looked for in
// no more than four times as many from `first` on.
Result<Analytic> whole_segment(const SampleSource& source, std::int64_t first, std::int64_t end,
                               const JobControl& job) {
    Analytic longest;
    Analytic run;
    std::vector<double> c(static_cast<std::size_t>(read_frames));
    std::vector<double> d(c);
    const std::int64_t last = std::min(end, first + 4 * most_frames);
    for (std::int64_t at = first; at < last && std::ssize(run) < most_frames; at += read_frames) {
        TRY(job.go_on());
        const auto count = static_cast<std::size_t>(std::min(read_frames, last - at));
        TRY(source.read(at, std::span(c).first(count), std::span(d).first(count)));
        for (std::size_t j = 0; j < count; ++j) {
            if (std::isfinite(c[j]) && std::isfinite(d[j])) {
                run.emplace_back(c[j], d[j]);
            } else if (!run.empty()) {
                if (run.size() > longest.size()) {
                    longest.swap(run);
                }
                run.clear();
            }
        }
    }
    return run.size() > longest.size() ? run : longest;
}

// Power response of the band-pass: flat, with edges of a raised cosine, whose energy is that of the
// filter's within a hundredth of the band.
double power_gain(double f_hz, const Band& band, double rate_hz) {
    const double transition =
        std::min({(band.high_hz - band.low_hz) / 2, band.low_hz, rate_hz / 2 - band.high_hz});
    const double beyond = std::max({band.low_hz - f_hz, f_hz - band.high_hz, 0.0}) / transition;
    const double gain = beyond < 1 ? 0.5 + 0.5 * std::cos(std::numbers::pi * beyond) : 0;
    return gain * gain;
}

// sum u sin phi u over n samples, at an offset from the carrier, cycles per sample.
double moment_at(double offset, double n) {
    const double half = std::numbers::pi * offset;
    const double sine = std::sin(half);
    const double turns = n * half;
    return std::abs(turns) < 1e-3
               ? half * n * (n * n - 1) / 6
               : (0.5 * std::sin(turns) * std::cos(half) - 0.5 * n * std::cos(turns) * sine) /
                     (sine * sine);
}

// Its square by sum u^2.
double frequency_response(double offset, double n) {
    const double moment = moment_at(offset, n);
    return 12 * moment * moment / (n * (n * n - 1));
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
      run_hop_(alternating_hop(short_, f0_hz, rate_hz)),
      rate_hz_(rate_hz),
      known_(known) {
    const double share = known ? known->share : 1;
    const double freedom = std::max(2 * static_cast<double>(length) * share - 8, least_freedom);
    leaks_ = static_cast<double>(length) * f0_hz < 3 * rate_hz;
    limit_ = least_ratio * chi2_ratio(rare, known ? freedom : steady_freedom(length));
}

// Estimates of runs of short windows: hum has any phase in them, while at the centres of windows of
// whole periods it has one.
std::vector<WaveEstimate> NoiseLevel::in_runs(std::int64_t frames,
                                              const EstimateShorts& estimate) const {
    std::vector<WaveEstimate> found;
    if (known_ || !(has_shorts() || leaks_)) {
        return found;
    }
    const std::int64_t of_run =
        std::clamp<std::int64_t>((frames - short_) / run_hop_ + 1, 1, shorts_of_run);
    const std::int64_t length = (of_run - 1) * run_hop_ + short_;
    const std::int64_t count = std::min(std::max(frames / (frames_by_run * length), fewest_runs),
                                        std::max<std::int64_t>(frames / length, 1));
    found.resize(static_cast<std::size_t>(count * of_run));
    for (std::int64_t k = 0; k < count; ++k) {
        estimate(k * (frames - length) / std::max<std::int64_t>(count - 1, 1), run_hop_,
                 std::span(found).subspan(static_cast<std::size_t>(k * of_run),
                                          static_cast<std::size_t>(of_run)));
    }
    return found;
}

void NoiseLevel::measure(std::int64_t windows, std::int64_t hop, const EstimateShorts& estimate) {
    const std::int64_t frames = (windows - 1) * hop + length_;
    std::vector<WaveEstimate> runs = in_runs(frames, estimate);
    shorts_.clear();
    variance_ = known_ ? known_->in_band * known_->in_band : level_of(runs, steady_freedom(short_));
    if (leaks_ && !known_) {
        pool_noise(runs, short_, 1);
        excess_ = excess_of(runs);
    }
    if (!has_shorts()) {
        return;
    }
    // At centres of windows, on the same half sample as these.
    const auto wish =
        static_cast<std::int64_t>(share_of_frames * static_cast<double>(frames)) / short_;
    const std::int64_t stride =
        std::max<std::int64_t>(windows / std::clamp(wish, fewest_short, most_short), 1);
    std::vector<WaveEstimate> at_centres(static_cast<std::size_t>((windows - 1) / stride + 1));
    const double centre_s = estimate((length_ - short_) / 2, stride * hop, at_centres);
    const double step = static_cast<double>(stride * hop);
    for (std::size_t k = 0; k < at_centres.size(); ++k) {
        if (is_measured(at_centres[k])) {
            shorts_.push_back({centre_s + static_cast<double>(k) * step / rate_hz_,
                               to_phasors(at_centres[k].state)});
        }
    }
}

std::vector<char> NoiseLevel::hold_no_wave(std::span<const Judged> windows) const {
    if (all_move(windows)) {
        return std::vector<char>(windows.size(), 1);
    }
    double level = variance_;
    if (!has_shorts()) {
        std::vector<double> variances;
        for (const Judged& window : windows) {
            variances.push_back(window.variance);
        }
        // The larger one; either may be unknown.
        level = excess_ * std::fmax(level, level_of(std::move(variances), steady_freedom(length_)));
    }
    std::vector<char> found;
    for (const Judged& window : windows) {
        found.push_back(window.variance > limit_ * level || window.apart > rare_phasors ? 1 : 0);
    }
    return found;
}

double NoiseLevel::excess_of(std::span<const WaveEstimate> shorts) const {
    std::array<std::vector<double>, 4> squares;
    const auto add = [&squares](std::size_t variable, const std::array<double, 5>& x, double sd) {
        // 1, -4, 6, -4, 1: variance 70.
        const double fourth = x[0] - 4 * x[1] + 6 * x[2] - 4 * x[3] + x[4];
        const double square = fourth * fourth / (70 * sd * sd);
        if (std::isfinite(square)) {
            squares[variable].push_back(square);
        }
    };
    for (std::size_t k = 0; k + 5 <= shorts.size(); ++k) {
        if (k % shorts_of_run > shorts_of_run - 5) {
            continue;  // across two runs
        }
        std::array<double, 5> a_A;
        std::array<double, 5> a_B;
        std::array<double, 5> angle;
        std::array<double, 5> f;
        for (std::size_t j = 0; j < 5; ++j) {
            const WaveEstimate& one = shorts[k + j];
            a_A[j] = one.state.a_A;
            a_B[j] = one.state.a_B;
            f[j] = one.f_hz;
            angle[j] = j == 0 ? one.state.two_theta_A
                              : angle[j - 1] + std::remainder(one.state.two_theta_A - angle[j - 1],
                                                              std::numbers::pi);
        }
        const WaveEstimate& middle = shorts[k + 2];
        add(0, a_A, middle.sd.a_A);
        add(1, a_B, middle.sd.a_B);
        add(2, angle, middle.sd.two_theta_A);
        add(3, f, middle.sd.f_hz);
    }
    double largest = 1;
    for (std::vector<double>& of : squares) {
        if (of.size() >= fewest_fourth) {
            largest = std::max(largest, upper(std::move(of)) / upper_chi2);
        }
    }
    return largest;
}

bool NoiseLevel::all_move(std::span<const Judged> windows) const {
    std::vector<double> apart;
    for (const Judged& window : windows) {
        if (!std::isnan(window.apart)) {
            apart.push_back(window.apart);
        }
    }
    if (known_ || apart.size() < 4 || shorts_.size() < 4) {
        return false;  // after a band-pass the short windows are not independent
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
    // Of the best wave: the leakage of an algorithm is no motion.
    const WaveState& state = window.state;
    const WaveErrors& leakage = window.leakage;
    const Phasors phasors =
        to_phasors({state.a_A - leakage.a_A, state.a_B - leakage.a_B,
                    state.two_theta_A - leakage.two_theta_A, state.alpha - leakage.alpha});
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

Result<double> noise_in_band(const SampleSource& source, std::int64_t first, std::int64_t end,
                             const Band& band, double rate_hz, const JobControl& job) {
    auto segment = TRY(whole_segment(source, first, end, job));
    const std::size_t size = std::bit_floor(segment.size());
    if (size < 16) {
        return std::numeric_limits<double>::quiet_NaN();
    }
    segment.resize(size);
    double squares = 0;
    for (std::size_t j = 0; j < size; ++j) {
        const double place = (static_cast<double>(j) + 0.5) / static_cast<double>(size);
        const double weight = blackman_harris(2 * std::numbers::pi * place);
        segment[j] *= weight;
        squares += weight * weight;
    }
    Fft fft(size);
    fft.forward(segment);
    const double bins_per_hz = static_cast<double>(size) / rate_hz;
    const auto low = static_cast<std::size_t>(std::ceil(band.low_hz * bins_per_hz));
    const auto high = std::max(low, static_cast<std::size_t>(band.high_hz * bins_per_hz));
    std::vector<double> powers;
    for (std::size_t bin = low; bin <= high && bin < size / 2; ++bin) {
        // Both channels: the density of C + iD is the sum of theirs.
        powers.push_back(std::norm(segment[bin]));
        powers.push_back(std::norm(segment[size - bin]));
    }
    // The median of an exponential distribution is ln 2 of its mean.
    return std::sqrt(median(std::move(powers)) / (std::numbers::ln2 * 2 * squares));
}

EquivalentNoise equivalent_noise(double noise, const Band& band, double f0_hz, std::int64_t n,
                                 double rate_hz) {
    // |sum e^{-i phi u}|^2 / n and |sum u e^{-i phi u}|^2 / sum u^2, integrated over the offset
    // from the carrier, have the integral 1 over all frequencies. Beyond 64 / n cycles per sample
    // lies less than a hundredth of either.
    constexpr int points = 16384;
    const auto count = static_cast<double>(n);
    const double reach = std::min(0.5, 64 / count);  // cycles per sample
    const double step = 2 * reach / points;
    double phasors = 0;
    double frequency = 0;
    double all_phasors = 0;
    double all_frequency = 0;
    for (int k = 0; k < points; ++k) {
        const double offset = (k + 0.5) * step - reach;
        const double half = std::numbers::pi * offset;
        const double sine = std::sin(half);
        const double turns = count * half;
        const double sum = std::sin(turns) / sine;
        const double own = sum * sum / count;
        const double by_time = frequency_response(offset, count);
        const double gain = power_gain(f0_hz + offset * rate_hz, band, rate_hz);
        phasors += gain * own;
        frequency += gain * by_time;
        all_phasors += own;
        all_frequency += by_time;
    }
    return {noise * std::sqrt(phasors / all_phasors), noise * std::sqrt(frequency / all_frequency)};
}

std::vector<double> frequency_correlation(const Band& band, double f0_hz, std::int64_t n,
                                          std::int64_t hop, double rate_hz) {
    // The noise of the band forgets within some inverse bandwidths.
    constexpr double memory = 16;
    constexpr double most_points = std::int64_t{1} << 20;
    const double reach = static_cast<double>(n) + memory * rate_hz / (band.high_hz - band.low_hz);
    if (4 * reach > most_points) {  // such windows are long for every band
        return overlap_correlation(
            std::min(1.0, static_cast<double>(hop) / static_cast<double>(n)));
    }
    const std::size_t size = std::bit_ceil(static_cast<std::size_t>(4 * reach));
    std::vector<std::complex<double>> density(size);
    for (std::size_t k = 0; k < size; ++k) {
        const double offset =
            (static_cast<double>(k) + (k < size / 2 ? 0.0 : -static_cast<double>(size))) /
            static_cast<double>(size);
        const auto count = static_cast<double>(n);
        double moment = moment_at(offset, count);
        // Noise about -f0 enters, too, twice the carrier away, as far as it is no steady wave.
        const double image = 2 * f0_hz / rate_hz;
        const double from_image = std::remainder(offset + image, 1.0);
        if (std::abs(from_image) < std::abs(offset)) {
            const double half = std::numbers::pi * from_image;
            const double mean =
                std::abs(half) < 1e-9 ? 1 : std::sin(count * half) / (count * std::sin(half));
            moment -= moment_at(std::remainder(-image, 1.0), count) * mean;
        }
        const double f_hz = std::abs(std::remainder(f0_hz + offset * rate_hz, rate_hz));
        density[k] = power_gain(f_hz, band, rate_hz) * moment * moment;
    }
    Fft(size).forward(density);
    std::vector<double> correlation;
    for (std::size_t lag = 0; lag <= static_cast<std::size_t>(reach);
         lag += static_cast<std::size_t>(hop)) {
        correlation.push_back(density[lag].real() / density[0].real());
    }
    return correlation;
}

}  // namespace vybeg
