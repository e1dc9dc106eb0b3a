#include "core/analysis/phasor_windows.h"

#include "core/analysis/estimate_track.h"
#include "core/base/plain_text.h"
#include "core/estimators/wave/wave_state.h"
#include "core/estimators/wave/window_moments.h"
#include "core/numerics/dense_solvers.h"
#include "core/numerics/kaiser.h"
#include "core/numerics/statistics.h"
#include "core/recording/checks/recording_check.h"
#include "core/recording/conditioning/conditioned_source.h"

#include <Eigen/Core>
#include <tbb/parallel_pipeline.h>
#include <tbb/task_arena.h>

#include <algorithm>
#include <cmath>
#include <memory>
#include <numbers>
#include <numeric>
#include <span>

namespace vybeg {
namespace {

// Means of a window's phasors at a fixed frequency. Each channel is fitted by least squares with
//     sum over k of P_k(u) (A_k cos wu + B_k sin wu) + offset + slope u + lines of the mains,
// P_k the polynomials orthogonal over the window: A_0 - i B_0 is the phasor's mean. Slow variation
// of the wave, an offset and hum then neither bias the mean nor count as noise. The order of the
// polynomials grows with the window, from 2 (two periods) to 5 (ten periods and more): at a turn
// of 0.1 revolution in the window order 5 leaves 3e-6 of the amplitude. Everything that is the same
// for all windows is made once.
class WindowMean {
public:
    // Windows of n samples, carrier w (rad per sample), lines of the mains (rad per sample; they
    // lie 4 pi / n or more from w). Precondition: n >= 16 and n w >= 4 pi.
    WindowMean(std::int64_t n, double w, std::span<const double> lines);

    struct Estimate {
        Phasors mean;            // relative to the window's centre
        double noise_power = 0;  // variance per sample, from the residual; NaN: samples are missing
    };
    Estimate estimate(const Window& window) const;

    // Standard deviation of a real or imaginary part of a mean, in units of the noise's.
    double sd_of_part() const { return sd_of_part_; }
    // Degrees of freedom of noise_power.
    double freedom() const { return freedom_; }

private:
    // One channel: its mean, and the power that the functions take out of its samples.
    struct Channel {
        std::complex<double> mean;
        double power = 0;
    };
    Channel channel(std::span<const double> samples) const;

    Eigen::MatrixXd basis_;     // orthonormal columns
    Eigen::Matrix2Xd mean_of_;  // (A_0, -B_0) from the products with these columns
    double freedom_ = 0;
    double sd_of_part_ = 0;
};

// The polynomials orthogonal over the window up to an order, column by column, of size about 1.
Eigen::MatrixXd polynomials(const Eigen::VectorXd& u, Eigen::Index order) {
    Eigen::MatrixXd p(u.size(), order + 1);
    p.col(0).setOnes();
    for (Eigen::Index k = 0; k < order; ++k) {
        p.col(k + 1) = u.cwiseProduct(p.col(k));
        if (k > 0) {
            p.col(k + 1) -= p.col(k).squaredNorm() / p.col(k - 1).squaredNorm() * p.col(k - 1);
        }
    }
    return p;
}

Eigen::Index order_of(std::int64_t n, double w) {
    const double periods = static_cast<double>(n) * w / (2 * std::numbers::pi);
    return static_cast<Eigen::Index>(std::clamp(periods / 2, 2.0, 5.0));
}

WindowMean::WindowMean(std::int64_t n, double w, std::span<const double> lines) {
    const double half = 0.5 * static_cast<double>(n);
    const Eigen::VectorXd j = Eigen::VectorXd::LinSpaced(n, 0.5 - half, half - 0.5);
    const Eigen::Index order = order_of(n, w);
    const Eigen::MatrixXd p = polynomials(j / half, order);
    // Lines that a short window cannot hold beside the rest are slopes there.
    const auto held = std::min<Eigen::Index>(std::ssize(lines), n / 32);
    Eigen::MatrixXd functions(n, 2 * (order + 1) + 2 + 2 * held);
    const Eigen::ArrayXd cosine = (w * j.array()).cos();
    const Eigen::ArrayXd sine = (w * j.array()).sin();
    for (Eigen::Index k = 0; k <= order; ++k) {
        functions.col(2 * k) = p.col(k).array() * cosine;
        functions.col(2 * k + 1) = p.col(k).array() * sine;
    }
    functions.col(2 * order + 2) = p.col(0);
    functions.col(2 * order + 3) = p.col(1);
    for (Eigen::Index k = 0; k < held; ++k) {
        const double line = lines[static_cast<std::size_t>(k)];
        functions.col(2 * order + 4 + 2 * k) = (line * j.array()).cos();
        functions.col(2 * order + 5 + 2 * k) = (line * j.array()).sin();
    }
    const Eigen::Index count = functions.cols();
    const Eigen::HouseholderQR<Eigen::MatrixXd> qr(functions);
    basis_ = qr.householderQ() * Eigen::MatrixXd::Identity(n, count);
    const Eigen::MatrixXd inverse =
        qr.matrixQR().topRows(count).triangularView<Eigen::Upper>().solve(
            Eigen::MatrixXd::Identity(count, count));
    mean_of_ = inverse.topRows(2);
    mean_of_.row(1) *= -1;
    sd_of_part_ = std::sqrt(mean_of_.squaredNorm() / 2);
    freedom_ = 2 * static_cast<double>(n - count);
}

WindowMean::Channel WindowMean::channel(std::span<const double> samples) const {
    const Eigen::Map<const Eigen::VectorXd> x(samples.data(), std::ssize(samples));
    const Eigen::VectorXd products = basis_.transpose() * x;
    const Eigen::Vector2d mean = mean_of_ * products;
    return {{mean[0], mean[1]}, products.squaredNorm()};
}

WindowMean::Estimate WindowMean::estimate(const Window& window) const {
    const SampleProducts products = sample_products(window);
    const Channel c = channel(window.c);
    const Channel d = channel(window.d);
    const double power = products.cc + products.dd;
    // The difference has lost its digits where the fit is almost perfect; nothing recorded is.
    const double residual = std::max(power - c.power - d.power, 1e-14 * power);
    return {{c.mean, d.mean},
            std::isfinite(power) ? residual / freedom() : std::numeric_limits<double>::quiet_NaN()};
}

// Response at a frequency (cycles per sample) of a symmetric filter, from half of it.
double gain_at(const std::vector<double>& half, double frequency) {
    // Clenshaw's recurrence for the sum of h[m] cos(m x).
    const double x = 2 * std::cos(2 * std::numbers::pi * frequency);
    double next = 0;
    double after = 0;
    for (std::size_t m = half.size() - 1; m > 0; --m) {
        const double here = 2 * half[m] + x * next - after;
        after = next;
        next = here;
    }
    return half[0] + 0.5 * x * next - after;
}

// What a band-pass makes of white noise in the means of windows at a carrier.
struct FilteredNoise {
    // Variance of a window's mean, in units of that which white noise of the density at the carrier
    // gives it: h times the integral over frequency v from the carrier of |H(v)|^2 sinc^2(v h), H
    // relative to the carrier, h the window.
    double variance = 1;
    // Correlation of the means of windows 0, 1, 2, ... window lengths apart, from 1 at lag 0, up to
    // the last one above 1e-3: the same integral with cos(2 pi v h lag). The part that turns, from
    // a carrier beside the band's middle, is left out.
    std::vector<double> correlation;
};

// Precondition: 0 < band.low_hz <= f_hz <= band.high_hz < rate_hz / 2.
FilteredNoise filtered_noise(const Band& band, double f_hz, std::int64_t window, double rate_hz) {
    constexpr double most_lags = 256;
    constexpr double least = 1e-3;
    const std::vector<double> half = band_pass_response(band.low_hz, band.high_hz, rate_hz);
    const double h = static_cast<double>(window) / rate_hz;
    const double width = band.high_hz - band.low_hz;
    const auto lags =
        static_cast<std::size_t>(std::clamp(std::ceil(16 / (width * h)), 4.0, most_lags));
    // The band with its transitions, in steps that resolve the longest lag and the band's edges.
    const double from = std::max(band.low_hz - width, 0.0);
    const double to = std::min(band.high_hz + width, rate_hz / 2);
    const double step = std::min(1 / (8 * h * static_cast<double>(lags)), width / 64);
    std::vector<double> sums(lags, 0.0);
    const double centre = gain_at(half, f_hz / rate_hz);
    for (double f = from + step / 2; f < to; f += step) {
        const double gain = gain_at(half, f / rate_hz) / centre * sinc((f - f_hz) * h);
        for (std::size_t lag = 0; lag < lags; ++lag) {
            sums[lag] += gain * gain *
                         std::cos(2 * std::numbers::pi * (f - f_hz) * h * static_cast<double>(lag));
        }
    }
    FilteredNoise noise;
    noise.variance = sums[0] * step * h;
    for (double& sum : sums) {
        noise.correlation.push_back(sum / sums[0]);
    }
    while (noise.correlation.size() > 1 && std::abs(noise.correlation.back()) < least) {
        noise.correlation.pop_back();
    }
    return noise;
}

// A window whose noise power is this many of its deviations above the median is disturbed, and
// has its own noise; all others have the median, so that weights do not scatter.
constexpr double disturbed = 6;

struct PhasorChunk {
    std::int64_t first_window = 0;
    std::int64_t windows = 0;
    std::vector<double> c;
    std::vector<double> d;
};

using Estimates = std::vector<WindowMean::Estimate>;

// Estimates the windows of a chunk into their places.
double estimate_chunk(const PhasorChunk& chunk, const WindowPlan& plan, const WindowMean& mean,
                      Estimates& estimates, const JobControl& job) {
    const double begun = job.now();
    const auto length = static_cast<std::size_t>(plan.length);
    for (std::int64_t k = 0; k < chunk.windows; ++k) {
        const auto at = static_cast<std::size_t>(k) * length;
        const Window window{std::span(chunk.c).subspan(at, length),
                            std::span(chunk.d).subspan(at, length)};
        estimates[static_cast<std::size_t>(chunk.first_window + k)] = mean.estimate(window);
    }
    return job.now() - begun;
}

// All windows of the plan: one thread reads, the others estimate. `timing` gets the seconds.
Result<Estimates> estimate_all(const ConditionedRecording& prepared, const WindowPlan& plan,
                               const WindowMean& mean, int threads, const JobControl& job,
                               Timing& timing) {
    Estimates estimates(static_cast<std::size_t>(plan.count));
    const std::int64_t per_chunk = std::max<std::int64_t>(1, chunk_frames / plan.length);
    std::vector<double> seconds(static_cast<std::size_t>((plan.count + per_chunk - 1) / per_chunk));
    Status status;
    std::int64_t next = 0;
    const auto read = [&](tbb::flow_control& flow) {
        auto chunk = std::make_shared<PhasorChunk>();
        if (next >= plan.count || job.cancelled() || !status) {
            flow.stop();
            return chunk;
        }
        const double begun = job.now();
        chunk->first_window = next;
        chunk->windows = std::min(per_chunk, plan.count - next);
        chunk->c.resize(static_cast<std::size_t>(chunk->windows * plan.length));
        chunk->d.resize(chunk->c.size());
        status = prepared.source->read(plan.start(next), chunk->c, chunk->d);
        if (!status) {
            flow.stop();
            return chunk;
        }
        next += chunk->windows;
        timing.read_s += job.now() - begun;
        job.report(static_cast<double>(next) / static_cast<double>(plan.count));
        return chunk;
    };
    const auto estimate = [&](const std::shared_ptr<PhasorChunk>& chunk) {
        seconds[static_cast<std::size_t>(chunk->first_window / per_chunk)] =
            estimate_chunk(*chunk, plan, mean, estimates, job);
    };
    using ChunkPointer = std::shared_ptr<PhasorChunk>;
    tbb::task_arena(threads).execute([&] {
        tbb::parallel_pipeline(
            static_cast<std::size_t>(threads) + 1,
            tbb::make_filter<void, ChunkPointer>(tbb::filter_mode::serial_in_order, read) &
                tbb::make_filter<ChunkPointer, void>(tbb::filter_mode::parallel, estimate));
    });
    if (!status) {
        return status.error();
    }
    TRY(job.go_on());
    timing.estimate_s = std::accumulate(seconds.begin(), seconds.end(), 0.0) / threads;
    return estimates;
}

// Marks the windows over faults as missing.
void leave_out(const SampleFaults& faults, const WindowPlan& plan, std::int64_t filter_reach,
               Estimates& estimates) {
    for (const FlaggedRows& rows : windows_over(faults, plan, filter_reach)) {
        for (std::size_t k = rows.first; k < rows.first + rows.count; ++k) {
            estimates[k].noise_power = std::numeric_limits<double>::quiet_NaN();
        }
    }
}

bool counts(const WindowMean::Estimate& estimate) {
    return std::isfinite(estimate.noise_power);
}

// Power of both channels; zero where the window does not count.
double power_of(const WindowMean::Estimate& estimate) {
    return counts(estimate) ? std::norm(estimate.mean.c) + std::norm(estimate.mean.d) : 0;
}

// The first window of the free decay (phasor_windows.h).
std::size_t first_of_decay(const Estimates& estimates, const WindowPlan& plan,
                           std::int64_t filter_reach) {
    constexpr double silence = 1e-3;
    // The strongest window itself may come late where the first ones differ by their noise alone.
    constexpr double strong = 0.9;
    const auto place = [&](auto found) {
        return static_cast<std::size_t>(found - estimates.begin());
    };
    const double most = power_of(*std::ranges::max_element(estimates, {}, power_of));
    const auto begin = std::ranges::find_if(estimates, counts);
    const auto struck = std::ranges::find_if(
        estimates, [&](double power) { return power >= strong * most; }, power_of);
    const bool silent_before = std::any_of(begin, struck, [&](const auto& estimate) {
        return counts(estimate) && power_of(estimate) < silence * most;
    });
    const std::int64_t still_rings = (filter_reach + plan.length - 1) / plan.length;
    // The strike lies inside its window.
    return (silent_before ? place(struck) + 1 : place(begin)) +
           static_cast<std::size_t>(still_rings);
}

void leave_out_strike(const WindowPlan& plan, double rate_hz, std::int64_t filter_reach,
                      Estimates& estimates, std::vector<Diagnostic>& diagnostics) {
    const std::size_t first = first_of_decay(estimates, plan, filter_reach);
    bool any = false;
    for (std::size_t k = 0; k < std::min(first, estimates.size()); ++k) {
        any = any || counts(estimates[k]);
        estimates[k].noise_power = std::numeric_limits<double>::quiet_NaN();
    }
    if (any) {
        const double seconds =
            static_cast<double>(static_cast<std::int64_t>(first) * plan.length) / rate_hz;
        diagnostics.push_back({DiagnosticKind::strike_left_out, {number_arg(seconds, 3)}});
    }
}

// Degrees of freedom of a window's noise power: after a band-pass only those of the noise in
// the band over a window's length, less the two numbers of each channel that describe the wave.
double noise_freedom(const WindowMean& mean, const ConditionedRecording& prepared,
                     double window_s) {
    if (!prepared.filter) {
        return mean.freedom();
    }
    const double width = prepared.filter->high_hz - prepared.filter->low_hz;
    return std::clamp(4 * (width * window_s - 1), 1.0, mean.freedom());
}

// Median of the noise powers that exist, without its bias for chi^2 of few degrees of freedom; NaN
// where there is none.
double median_power(const Estimates& estimates, double freedom) {
    std::vector<double> powers;
    for (const WindowMean::Estimate& estimate : estimates) {
        if (counts(estimate)) {
            powers.push_back(estimate.noise_power);
        }
    }
    return median(std::move(powers)) / chi2_ratio(0, freedom);
}

// Variance per sample of the white noise that has the density beside the carrier. The residual
// knows it best where it is white, but includes noise far from the carrier, and after a
// band-pass the band's edges.
double noise_at_carrier(double residual, const CarrierLines& lines,
                        const ConditionedRecording& prepared) {
    constexpr double significant = 4;
    // Fewer segments are not robust: outliers in one of them are no noise of the others.
    constexpr int robust = 4;
    if (!std::isfinite(lines.noise_power)) {
        return residual;
    }
    if (prepared.filter) {
        return lines.noise_power;
    }
    const double over = lines.noise_power / residual - 1;
    const bool coloured =
        std::abs(over) > significant * lines.relative_sd && (over < 0 || lines.segments >= robust);
    return coloured ? lines.noise_power : residual;
}

std::vector<double> in_turns(std::vector<double> frequencies_hz, double rate_hz) {
    for (double& frequency : frequencies_hz) {
        frequency *= 2 * std::numbers::pi / rate_hz;
    }
    return frequencies_hz;
}

// Samples lost (less those doubled) before each window, from the steps in their order; where their
// number is ambiguous, the smallest.
class LostBefore {
public:
    explicit LostBefore(const std::vector<PhaseStep>& steps) : steps_(steps) {}

    // For frames that do not fall from call to call.
    std::int64_t at(std::int64_t frame) {
        for (; next_ < steps_.size() && steps_[next_].frame <= frame; ++next_) {
            const PhaseStep& step = steps_[next_];
            if (step.is_ambiguous) {
                breaks_.push_back(step.frame + lost_);
            }
            lost_ += step.lost;
        }
        return lost_;
    }
    // Of the steps passed, the frames after which the phase is unknown against that before,
    // counted with the lost samples.
    const std::vector<std::int64_t>& phase_breaks() const { return breaks_; }

private:
    const std::vector<PhaseStep>& steps_;
    std::size_t next_ = 0;
    std::int64_t lost_ = 0;
    std::vector<std::int64_t> breaks_;
};

// e^{-i angle} both phasors, from the window's centre to the start of the recording, and turned so
// that angles count from the first electrode.
Phasors moved(const Phasors& local, double cycles, double two_theta_zero) {
    const std::complex<double> back =
        std::polar(1.0, -2 * std::numbers::pi * std::remainder(cycles, 1.0));
    Phasors phasors{back * local.c, back * local.d};
    turn_channels(two_theta_zero, phasors.c, phasors.d);
    return phasors;
}

struct Noise {
    double residual = 0;    // variance per sample, from the windows' residuals
    double at_carrier = 0;  // variance per sample of white noise of the density there
    double freedom = 0;     // of a window's residual
};

// The windows that exist, with their times, phasors and deviations.
PhasorRun collect(const Estimates& estimates, const ConditionedRecording& prepared,
                  const WindowPlan& plan, const std::vector<PhaseStep>& steps, double rate_hz,
                  const WindowMean& mean, const Noise& noise) {
    const double limit = noise.residual * chi2_ratio(disturbed, noise.freedom);
    const double two_theta_zero = prepared.calibration.two_theta_zero();
    PhasorRun run;
    run.f_ref_hz = prepared.f0_hz;
    run.rate_hz = rate_hz;
    run.two_theta_zero = two_theta_zero;
    run.window_s = static_cast<double>(plan.length) / rate_hz;
    FilteredNoise filtered;
    if (prepared.filter) {
        filtered = filtered_noise(*prepared.filter, prepared.f0_hz, plan.length, rate_hz);
        run.noise_correlation = filtered.correlation;
    }
    const double sd = mean.sd_of_part() * std::sqrt(noise.at_carrier * filtered.variance);
    LostBefore lost(steps);
    for (std::int64_t k = 0; k < plan.count; ++k) {
        const WindowMean::Estimate& estimate = estimates[static_cast<std::size_t>(k)];
        const auto moved_on = static_cast<double>(lost.at(plan.start(k)));
        if (!counts(estimate)) {
            continue;
        }
        const double time_s = plan.centre_s(k, rate_hz) + moved_on / rate_hz;
        const Phasors phasors = moved(estimate.mean, prepared.f0_hz * time_s, two_theta_zero);
        run.time_s.push_back(time_s);
        run.c.push_back(phasors.c);
        run.d.push_back(phasors.d);
        const bool stands_out = estimate.noise_power > limit;
        run.sd.push_back(stands_out ? sd * std::sqrt(estimate.noise_power / noise.residual) : sd);
    }
    for (const std::int64_t frame : lost.phase_breaks()) {
        run.breaks.push_back({static_cast<double>(frame) / rate_hz});
    }
    return run;
}

void tell_of_lost_samples(const std::vector<PhaseStep>& steps,
                          std::vector<Diagnostic>& diagnostics) {
    std::int64_t samples = 0;
    std::int64_t places = 0;
    std::int64_t ambiguous = 0;
    for (const PhaseStep& step : steps) {
        if (step.is_ambiguous) {
            ++ambiguous;
        } else {
            samples += step.lost;
            ++places;
        }
    }
    if (ambiguous > 0) {
        diagnostics.push_back({DiagnosticKind::phase_unknown, {count_arg(ambiguous)}});
    }
    if (places > 0) {
        diagnostics.push_back(
            {DiagnosticKind::lost_counted, {count_arg(samples), count_arg(places)}});
    }
}

// Why no window is left.
Error nothing_left(const SampleFaults& faults) {
    if (faults.clipped.empty()) {
        return {ErrorCode::no_valid_samples, "", {}};
    }
    std::vector<std::string> channels;
    for (const Diagnostic& finding : faults.findings) {
        if (finding.kind == DiagnosticKind::clipped &&
            std::ranges::find(channels, english(finding.args[0])) == channels.end()) {
            channels.push_back(english(finding.args[0]));
        }
    }
    return {ErrorCode::every_window_clipped, "", {joined(channels, ", ")}};
}

}  // namespace

Result<RecordedRun> phasor_windows(const WindowChoice& choice, double rate_hz, int threads,
                                   const JobControl& job) {
    const auto& [prepared, plan, lines] = choice;
    const WindowMean mean(plan.length, 2 * std::numbers::pi * prepared.f0_hz / rate_hz,
                          in_turns(lines.mains_hz, rate_hz));
    RecordedRun found;
    found.rate_relative_sd = prepared.rate_relative_sd;
    found.timing = {0, prepared.carrier_s, 0, threads};
    IdentifiedRun& told = found.told;
    told.f0_hz = prepared.f0_hz;
    told.window = plan.length;
    told.windows = plan.count;
    auto estimates = TRY(estimate_all(prepared, plan, mean, threads, job, found.timing));
    told.diagnostics = prepared.diagnostics;
    const SampleFaults faults = prepared.check->finish();
    add_findings(faults.findings, told.diagnostics);
    add_findings(prepared.check->offsets(), told.diagnostics);
    tell_of_lost_samples(faults.steps, told.diagnostics);
    const bool any_sample = std::ranges::any_of(estimates, counts);
    leave_out(faults, plan, prepared.filter_reach, estimates);
    leave_out_strike(plan, rate_hz, prepared.filter_reach, estimates, told.diagnostics);
    Noise noise;
    noise.freedom = noise_freedom(mean, prepared, static_cast<double>(plan.length) / rate_hz);
    noise.residual = median_power(estimates, noise.freedom);
    if (!std::isfinite(noise.residual)) {
        return any_sample ? nothing_left(faults) : Error{ErrorCode::no_valid_samples, "", {}};
    }
    noise.at_carrier = noise_at_carrier(noise.residual, lines, prepared);
    told.noise_sd = std::sqrt(noise.at_carrier);
    found.phasors = collect(estimates, prepared, plan, faults.steps, rate_hz, mean, noise);
    told.windows_used = static_cast<std::int64_t>(found.phasors.time_s.size());
    return found;
}

}  // namespace vybeg
