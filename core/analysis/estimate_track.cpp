#include "core/analysis/estimate_track.h"

#include <tbb/blocked_range.h>
#include <tbb/parallel_for.h>
#include <tbb/task_arena.h>

#include <algorithm>

namespace vybeg {
namespace {

// Frames of a chunk: 4 MiB of samples, some milliseconds of work between two looks at the stop
// token.
constexpr std::int64_t chunk_frames = std::int64_t{1} << 18;
// Frames of the block of windows that one task takes at a time.
constexpr std::int64_t block_frames = std::int64_t{1} << 13;
// Windows of it at most, where they overlap: the slowest algorithm takes 20 us for one, and the
// stop token is looked at between blocks.
constexpr std::int64_t block_windows = 1024;

std::int64_t windows_in(std::int64_t frames, const WindowPlan& plan) {
    return std::max<std::int64_t>(1, (frames - plan.length) / plan.hop + 1);
}

void fill_row(Track& track, std::size_t row, double time_s, const WaveEstimate& estimate) {
    const auto value = [&](SlowVariable variable, double x) { track.values(variable)[row] = x; };
    const auto sd = [&](SlowVariable variable, double x) { track.sds(variable)[row] = x; };
    track.time_s()[row] = time_s;
    value(SlowVariable::a_A, estimate.state.a_A);
    value(SlowVariable::a_B, estimate.state.a_B);
    value(SlowVariable::two_theta_A, estimate.state.two_theta_A);
    value(SlowVariable::alpha, estimate.state.alpha);
    value(SlowVariable::f, estimate.f_hz);
    value(SlowVariable::delta_phi_CD, estimate.delta_phi_CD);
    value(SlowVariable::rms, estimate.rms);
    value(SlowVariable::orthogonality, estimate.orthogonality);
    sd(SlowVariable::a_A, estimate.sd.a_A);
    sd(SlowVariable::a_B, estimate.sd.a_B);
    sd(SlowVariable::two_theta_A, estimate.sd.two_theta_A);
    sd(SlowVariable::alpha, estimate.sd.alpha);
    sd(SlowVariable::f, estimate.sd_f_hz);
    sd(SlowVariable::delta_phi_CD, estimate.sd_delta_phi_CD);
    track.flags()[row] = estimate.flags;
}

// A chunk of samples with the windows first .. first + count in it.
struct Chunk {
    std::vector<double> c;
    std::vector<double> d;
    std::int64_t first_frame = 0;
    std::int64_t first_window = 0;
    std::int64_t windows = 0;
};

class TrackEstimation {
public:
    TrackEstimation(const Prepared& prepared, const WindowPlan& plan, const Settings& settings,
                    double rate_hz)
        : prepared_(prepared),
          plan_(plan),
          rate_hz_(rate_hz),
          algorithm_(settings.algorithm),
          track_(static_cast<std::size_t>(plan.count)) {
        options_ = {plan.length,    rate_hz,          prepared.f0_hz,
                    settings.start, settings.initial, plan.centre_s(0, rate_hz)};
        sequential_ = make_estimator(algorithm_, options_);
    }

    std::int64_t context() const { return sequential_->context(); }
    Track take_track() { return std::move(track_); }

    // Reads the chunk that begins with a window, with context on both sides as far as there are
    // samples.
    Status read(Chunk& chunk, std::int64_t first_window) const {
        chunk.first_window = first_window;
        chunk.windows = std::min(windows_in(chunk_frames, plan_), plan_.count - first_window);
        const std::int64_t last = plan_.start(first_window + chunk.windows - 1) + plan_.length;
        chunk.first_frame = std::max<std::int64_t>(plan_.start(first_window) - context(), 0);
        const std::int64_t end = std::min(last + context(), prepared_.source->frames());
        chunk.c.resize(static_cast<std::size_t>(end - chunk.first_frame));
        chunk.d.resize(chunk.c.size());
        return prepared_.source->read(chunk.first_frame, chunk.c, chunk.d);
    }

    // Leaves the rest undone once the job is cancelled.
    void estimate(const Chunk& chunk, const JobControl& job) {
        const auto block = [&](Estimator& estimator, std::int64_t from, std::int64_t to) {
            estimate_block(chunk, estimator, chunk.first_window + from, to - from);
        };
        // The blocks are the same whatever the number of threads, and so is every result.
        const std::int64_t per_block = std::min(windows_in(block_frames, plan_), block_windows);
        const std::int64_t blocks = (chunk.windows + per_block - 1) / per_block;
        const auto run = [&](Estimator& estimator, std::int64_t begin, std::int64_t end) {
            for (std::int64_t b = begin; b < end && !job.cancelled(); ++b) {
                block(estimator, b * per_block, std::min((b + 1) * per_block, chunk.windows));
            }
        };
        if (sequential_->sequential()) {
            run(*sequential_, 0, blocks);
            return;
        }
        tbb::parallel_for(tbb::blocked_range<std::int64_t>(0, blocks, 1), [&](const auto& range) {
            run(*make_estimator(algorithm_, options_), range.begin(), range.end());
        });
    }

private:
    void estimate_block(const Chunk& chunk, Estimator& estimator, std::int64_t first_window,
                        std::int64_t count) {
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
        for (std::size_t k = 0; k < estimates.size(); ++k) {
            const std::int64_t window = first_window + static_cast<std::int64_t>(k);
            fill_row(track_, static_cast<std::size_t>(window), plan_.centre_s(window, rate_hz_),
                     estimates[k]);
        }
    }

    const Prepared& prepared_;
    WindowPlan plan_;
    double rate_hz_;
    Algorithm algorithm_;
    EstimatorOptions options_;
    std::unique_ptr<Estimator>
        sequential_;  // carries the window before, where the algorithm wants it
    Track track_;
};

}  // namespace

Result<EstimatedTrack> estimate_track(const Prepared& prepared, const WindowPlan& plan,
                                      const Settings& settings, double rate_hz, int threads,
                                      const JobControl& job) {
    EstimatedTrack result;
    TrackEstimation estimation(prepared, plan, settings, rate_hz);
    tbb::task_arena arena(threads);
    Chunk chunk;
    for (std::int64_t window = 0; window < plan.count; window += chunk.windows) {
        if (job.cancelled()) {
            return Error{ErrorCode::interrupted, "", {}};
        }
        const double begun = job.now();
        if (const Status read = estimation.read(chunk, window); !read) {
            return read.error();
        }
        const double have_read = job.now();
        arena.execute([&] { estimation.estimate(chunk, job); });
        if (job.cancelled()) {
            return Error{ErrorCode::interrupted, "", {}};
        }
        result.read_s += have_read - begun;
        result.estimate_s += job.now() - have_read;
        job.report(static_cast<double>(window + chunk.windows) / static_cast<double>(plan.count));
    }
    result.track = estimation.take_track();
    result.context = estimation.context();
    return result;
}

}  // namespace vybeg
