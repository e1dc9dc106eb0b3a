#include "core/analysis/estimate_track.h"

#include "core/analysis/window_noise.h"
#include "core/base/guarded.h"
#include "core/track/motion.h"
#include "core/track/track.h"

#include <tbb/blocked_range.h>
#include <tbb/enumerable_thread_specific.h>
#include <tbb/parallel_for.h>
#include <tbb/parallel_pipeline.h>
#include <tbb/task_arena.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <numeric>
#include <optional>

namespace vybeg {
namespace {

// Frames of the block of windows that one task takes at a time.
constexpr std::int64_t block_frames = std::int64_t{1} << 13;
// Windows of it at most: the stop token is looked at between blocks.
constexpr std::int64_t block_windows = 1024;
// Chunks in work: one is read, one estimated, one written.
constexpr std::size_t chunks_at_once = 3;

std::int64_t windows_in(std::int64_t frames, const WindowPlan& plan) {
    return std::max<std::int64_t>(1, (frames - plan.length) / plan.hop + 1);
}

// Windows of a block. Where they overlap, what they share is summed up once a block: a block holds
// twice as many hops as a window has.
std::int64_t windows_of_block(const WindowPlan& plan) {
    const std::int64_t windows = std::min(windows_in(block_frames, plan), block_windows);
    return plan.hop < plan.length ? std::max(windows, 2 * (plan.length / plan.hop)) : windows;
}

std::int64_t windows_of_chunk(const WindowPlan& plan) {
    const std::int64_t windows = windows_in(chunk_frames, plan);
    return plan.hop < plan.length ? std::max(windows, 2 * windows_of_block(plan)) : windows;
}

// `rate_relative_sd`: every frequency in Hz is wrong by as much as the sample rate is.
void fill_row(Track& track, std::size_t row, double time_s, const WaveEstimate& estimate,
              double rate_relative_sd) {
    const WaveState& state = estimate.state;
    const WaveErrors& sd = estimate.sd;
    track.time_s()[row] = time_s;
    track.put(row, SlowVariable::a_A, state.a_A, sd.a_A);
    track.put(row, SlowVariable::a_B, state.a_B, sd.a_B);
    track.put(row, SlowVariable::two_theta_A, state.two_theta_A, sd.two_theta_A);
    track.put(row, SlowVariable::alpha, state.alpha, sd.alpha);
    track.put(
        row, SlowVariable::f, estimate.f_hz,
        rate_relative_sd > 0 ? std::hypot(sd.f_hz, rate_relative_sd * estimate.f_hz) : sd.f_hz);
    track.put(row, SlowVariable::delta_phi_CD, estimate.delta_phi_CD, sd.delta_phi_CD);
    track.values(SlowVariable::noise)[row] = estimate.noise;
    track.values(SlowVariable::rms)[row] = estimate.rms;
    track.values(SlowVariable::orthogonality)[row] = estimate.orthogonality;
    track.flags()[row] = estimate.flags;
    track.leakage_f_hz()[row] = estimate.leakage.f_hz;
}

// A chunk of samples, the windows in it, and their rows once they are estimated.
struct TrackChunk {
    std::vector<double> c;
    std::vector<double> d;
    std::int64_t first_frame = 0;
    std::int64_t first_window = 0;
    std::int64_t windows = 0;
    Track rows;
    std::vector<NoiseLevel::Judged> judged;
    std::vector<char> no_wave;  // rows whose window holds no steady wave
    double excess = 1;          // NoiseLevel::excess()
};

class TrackEstimation {
public:
    TrackEstimation(const ConditionedRecording& prepared, const WindowPlan& plan,
                    const Settings& settings, double rate_hz)
        : prepared_(prepared), plan_(plan), rate_hz_(rate_hz), algorithm_(settings.algorithm) {
        options_ = {plan.length,
                    rate_hz,
                    prepared.f0_hz,
                    settings.start,
                    settings.initial,
                    plan.centre_s(0, rate_hz),
                    {}};
        std::optional<NoiseLevel::Known> known;
        if (settings.filter && prepared.noise_in_band) {
            const Band& band = *settings.filter;
            const auto noise = [&](std::int64_t n) {
                return equivalent_noise(*prepared.noise_in_band, band, prepared.f0_hz, n, rate_hz);
            };
            const double share = 2 * (band.high_hz - band.low_hz) / rate_hz;
            options_.noise = noise(plan.length);
            known = {noise(noise_window(plan.length, prepared.f0_hz, rate_hz)), *options_.noise,
                     *prepared.noise_in_band * std::sqrt(std::min(share, 1.0)), share};
        }
        level_ = NoiseLevel(plan.length, prepared.f0_hz, rate_hz, known);
        EstimatorOptions of_short = options_;
        of_short.length = level_->short_length();
        of_short.noise = std::nullopt;
        short_ = make_estimator(Algorithm::maximum_likelihood, of_short);
        sequential_ = make_estimator(algorithm_, options_);
    }

    std::int64_t context() const { return sequential_->context(); }

    // Reads the chunk that begins with a window, with context on both sides as far as there are
    // samples.
    Status read(TrackChunk& chunk, std::int64_t first_window) const {
        chunk.first_window = first_window;
        chunk.windows = std::min(windows_of_chunk(plan_), plan_.count - first_window);
        const std::int64_t last = plan_.start(first_window + chunk.windows - 1) + plan_.length;
        chunk.first_frame = std::max<std::int64_t>(plan_.start(first_window) - context(), 0);
        const std::int64_t end = std::min(last + context(), prepared_.source->frames());
        chunk.c.resize(static_cast<std::size_t>(end - chunk.first_frame));
        chunk.d.resize(chunk.c.size());
        return prepared_.source->read(chunk.first_frame, chunk.c, chunk.d);
    }

    // Fills the rows of the chunk; leaves the rest undone once the job is cancelled. Returns the
    // seconds that the threads spent on it together.
    double estimate(TrackChunk& chunk, const JobControl& job) {
        if (chunk.rows.rows() != static_cast<std::size_t>(chunk.windows)) {
            chunk.rows = Track(static_cast<std::size_t>(chunk.windows));
        }
        chunk.judged.assign(static_cast<std::size_t>(chunk.windows), {});
        const double measured = job.now();
        measure_noise(chunk);
        const double noise_s = job.now() - measured;
        // The blocks are the same whatever the number of threads, and so is every result.
        const std::int64_t per_block = windows_of_block(plan_);
        const std::int64_t blocks = (chunk.windows + per_block - 1) / per_block;
        std::vector<double> seconds(static_cast<std::size_t>(blocks));
        const auto run = [&](Estimator& estimator, std::int64_t begin, std::int64_t end) {
            for (std::int64_t b = begin; b < end && !job.cancelled(); ++b) {
                const double begun = job.now();
                const std::int64_t first = b * per_block;
                estimate_block(chunk, estimator, first, std::min(per_block, chunk.windows - first));
                seconds[static_cast<std::size_t>(b)] = job.now() - begun;
            }
        };
        if (sequential_->sequential()) {
            run(*sequential_, 0, blocks);
        } else {
            // Isolated: a thread that waits here for the others must not begin to read or write.
            tbb::this_task_arena::isolate([&] {
                tbb::parallel_for(tbb::blocked_range<std::int64_t>(0, blocks, 1),
                                  [&](const auto& range) {
                                      run(*of_thread_.local(), range.begin(), range.end());
                                  });
            });
        }
        chunk.no_wave = level_->hold_no_wave(chunk.judged);
        chunk.excess = level_->excess();
        return std::accumulate(seconds.begin(), seconds.end(), noise_s);
    }

    bool sequential() const { return sequential_->sequential(); }

private:
    // By short windows, evenly over the chunk and over its windows.
    void measure_noise(const TrackChunk& chunk) {
        const std::int64_t start = plan_.start(chunk.first_window) - chunk.first_frame;
        const std::int64_t length = level_->short_length();
        level_->measure(chunk.windows, plan_.hop,
                        [&](std::int64_t first, std::int64_t hop, std::span<WaveEstimate> into) {
                            const std::int64_t from = start + first;
                            const double centre_s =
                                WindowPlan{chunk.first_frame + from, length, hop, 1}.centre_s(
                                    0, rate_hz_);
                            short_->estimate({chunk.c, chunk.d, from, length, hop}, centre_s, into);
                            return centre_s;
                        });
    }

    // `first`: from the first window of the chunk.
    void estimate_block(TrackChunk& chunk, Estimator& estimator, std::int64_t first,
                        std::int64_t count) {
        const std::int64_t first_window = chunk.first_window + first;
        const std::int64_t start = plan_.start(first_window) - chunk.first_frame;
        const std::int64_t end = start + (count - 1) * plan_.hop + plan_.length;
        const std::int64_t from = std::max<std::int64_t>(start - estimator.context(), 0);
        const std::int64_t to =
            std::min(end + estimator.context(), static_cast<std::int64_t>(chunk.c.size()));
        const auto part = [from, to](const std::vector<double>& x) {
            return std::span(x).subspan(static_cast<std::size_t>(from),
                                        static_cast<std::size_t>(to - from));
        };
        std::vector<WaveEstimate> estimates(static_cast<std::size_t>(count));
        estimator.estimate({part(chunk.c), part(chunk.d), start - from, plan_.length, plan_.hop},
                           plan_.centre_s(first_window, rate_hz_), estimates);
        if (!options_.noise && plan_.length == level_->short_length()) {
            pool_noise(estimates, plan_.length, plan_.independent());
        }
        for (std::size_t k = 0; k < estimates.size(); ++k) {
            const std::size_t row = static_cast<std::size_t>(first) + k;
            const double centre_s =
                plan_.centre_s(first_window + static_cast<std::int64_t>(k), rate_hz_);
            // Rounding of a signal without noise is no event.
            constexpr double rounding = 1e-12;  // of the wave
            const WaveEstimate& of = estimates[k];
            if (!(of.steady_noise < rounding * of.state.a_A)) {
                chunk.judged[row] = {of.steady_noise * of.steady_noise,
                                     level_->apart(of, centre_s)};
            }
            name_transient(estimates[k], first_window + static_cast<std::int64_t>(k));
            fill_row(chunk.rows, row, centre_s, estimates[k], prepared_.rate_relative_sd);
        }
    }

    // Samples missing where the band-pass reaches beyond the recording were not lost.
    void name_transient(WaveEstimate& estimate, std::int64_t window) const {
        if (!has(estimate.flags, Flag::gap)) {
            return;
        }
        const std::int64_t start = plan_.start(window);
        const std::int64_t reach = prepared_.filter_reach;
        if (start < reach || start + plan_.length > prepared_.source->frames() - reach) {
            estimate.flags = static_cast<Flags>(Flag::filter_transient);
        }
    }

    const ConditionedRecording& prepared_;
    WindowPlan plan_;
    double rate_hz_;
    Algorithm algorithm_;
    EstimatorOptions options_;
    std::optional<NoiseLevel> level_;   // of the chunk in work
    std::unique_ptr<Estimator> short_;  // of its short windows
    // What an estimator prepares for its windows it prepares once a thread.
    tbb::enumerable_thread_specific<std::unique_ptr<Estimator>> of_thread_{
        [this] { return make_estimator(algorithm_, options_); }};
    std::unique_ptr<Estimator>
        sequential_;  // carries the window before, where the algorithm wants it
};

// Quotient rounded down, for b > 0.
std::int64_t floor_div(std::int64_t a, std::int64_t b) {
    return a >= 0 ? a / b : -((-a + b - 1) / b);
}

// Adds the windows that begin before frame `before` and end after frame `after`, the frame after
// their last one.
void add_windows(std::int64_t before, std::int64_t after, Flag flag, const WindowPlan& plan,
                 std::vector<FlaggedRows>& flagged) {
    const std::int64_t first =
        std::max<std::int64_t>(floor_div(after - plan.length - plan.first, plan.hop) + 1, 0);
    const std::int64_t end = std::min(floor_div(before - 1 - plan.first, plan.hop) + 1, plan.count);
    if (!flagged.empty() && flagged.back().flag == flag) {
        FlaggedRows& last = flagged.back();
        const auto last_end = static_cast<std::int64_t>(last.first + last.count);
        if (first <= last_end) {
            if (end > last_end) {
                last.count = static_cast<std::size_t>(end) - last.first;
            }
            return;
        }
    }
    if (first < end) {
        flagged.push_back(
            {static_cast<std::size_t>(first), static_cast<std::size_t>(end - first), flag});
    }
}

}  // namespace

Result<EstimationSummary> estimate_track(const ConditionedRecording& prepared,
                                         const WindowPlan& plan, const Settings& settings,
                                         double rate_hz, int threads, const TrackSink& sink,
                                         const JobControl& job) {
    TrackEstimation estimation(prepared, plan, settings, rate_hz);
    AngleUnwrapper angle(prepared.calibration.two_theta_zero());
    EstimationSummary summary;
    summary.f_correlation = settings.filter
                                ? frequency_correlation(*settings.filter, prepared.f0_hz,
                                                        plan.length, plan.hop, rate_hz)
                                : overlap_correlation(plan.independent());
    MotionMarker motion(plan.length, plan.hop, rate_hz, prepared.f0_hz, summary.f_correlation);
    TrackSummariser tracks(static_cast<std::size_t>(plan.count), plan.independent(),
                           summary.f_correlation);
    summary.context = estimation.context();
    Guarded<std::optional<Error>> error;  // the first of those who work at the same time
    const auto has_failed = [&error](const Status& status) {
        if (!status) {
            const auto first = error.hold();
            *first = first->value_or(status.error());
        }
        return !status;
    };
    const auto stopped = [&] { return job.cancelled() || error.hold()->has_value(); };

    std::array<TrackChunk, chunks_at_once> chunks;
    std::size_t chunks_read = 0;
    std::int64_t next_window = 0;
    const auto read = [&](tbb::flow_control& flow) -> TrackChunk* {
        TrackChunk& chunk = chunks[chunks_read++ % chunks_at_once];
        const double begun = job.now();
        if (next_window >= plan.count || stopped() ||
            has_failed(estimation.read(chunk, next_window))) {
            flow.stop();
            return nullptr;
        }
        summary.read_s += job.now() - begun;
        next_window += chunk.windows;
        return &chunk;
    };
    const int workers = estimation.sequential() ? 1 : threads;
    const auto estimate = [&](TrackChunk* chunk) {
        if (!stopped()) {
            summary.estimate_s += estimation.estimate(*chunk, job) / workers;
        }
        return chunk;
    };
    const auto deliver = [&](TrackChunk* chunk) {
        if (stopped()) {
            return;
        }
        angle.unwrap(chunk->rows);
        motion.take(chunk->rows, chunk->no_wave, chunk->excess);
        tracks.take(chunk->rows);
        summary.not_converged += std::ranges::count_if(
            chunk->rows.flags(), [](Flags flags) { return has(flags, Flag::not_converged); });
        if (!has_failed(sink(chunk->rows))) {
            job.report(static_cast<double>(chunk->first_window + chunk->windows) /
                       static_cast<double>(plan.count));
        }
    };
    constexpr auto in_order = tbb::filter_mode::serial_in_order;
    tbb::task_arena(threads).execute([&] {
        tbb::parallel_pipeline(chunks_at_once,
                               tbb::make_filter<void, TrackChunk*>(in_order, read) &
                                   tbb::make_filter<TrackChunk*, TrackChunk*>(in_order, estimate) &
                                   tbb::make_filter<TrackChunk*, void>(in_order, deliver));
    });
    if (const std::optional<Error> first = *error.hold()) {
        return *first;
    }
    TRY(job.go_on());
    summary.moving = motion.finish();
    summary.track = tracks.summary();
    return summary;
}

std::vector<FlaggedRows> windows_over(const SampleFaults& faults, const WindowPlan& plan,
                                      std::int64_t filter_reach) {
    std::vector<FlaggedRows> flagged;
    for (const FrameRange& range : faults.clipped) {
        add_windows(range.end(), range.first, Flag::clipped, plan, flagged);
    }
    std::vector<FrameRange> gaps;
    for (const FrameRange& range : faults.still) {
        gaps.push_back({range.first - filter_reach, range.count + 2 * filter_reach});
    }
    for (const PhaseStep& step : faults.steps) {
        gaps.push_back({step.frame, 0});
    }
    std::ranges::sort(gaps, {}, &FrameRange::first);
    for (const FrameRange& range : gaps) {
        add_windows(range.end(), range.first, Flag::gap, plan, flagged);
    }
    std::ranges::stable_sort(flagged, {}, &FlaggedRows::first);
    return flagged;
}

std::vector<FlaggedRows> moving_apart(const std::vector<FlaggedRows>& moving,
                                      const std::vector<FlaggedRows>& over_faults,
                                      const WindowPlan& plan) {
    const auto reach = static_cast<std::size_t>((2 * plan.length + plan.hop - 1) / plan.hop);
    std::vector<FlaggedRows> apart;
    for (const FlaggedRows& rows : moving) {
        std::size_t first = rows.first;
        const std::size_t end = rows.first + rows.count;
        for (const FlaggedRows& fault : over_faults) {
            const std::size_t from = fault.first - std::min(fault.first, reach);
            const std::size_t to = fault.first + fault.count + reach;
            if (to <= first || from >= end) {
                continue;
            }
            if (from > first) {
                apart.push_back({first, from - first, rows.flag});
            }
            first = std::min(to, end);
        }
        if (first < end) {
            apart.push_back({first, end - first, rows.flag});
        }
    }
    return apart;
}

}  // namespace vybeg
