// How the time of an estimation grows with overlap, threads and length: maximum likelihood over
// recordings in memory, from samples to the rows of a track. 33333 Hz, 60 dB, the article's case.
#include "core/analysis/estimate_track.h"
#include "core/recording/samples/sample_source.h"
#include "core/simulation/free_decay.h"
#include "core/simulation/simulate.h"
#include "tests/benchmarks/ratio_table.h"
#include "tests/needed.h"

#include <tbb/blocked_range.h>
#include <tbb/enumerable_thread_specific.h>
#include <tbb/parallel_for.h>
#include <tbb/task_arena.h>

#include <cstdio>

namespace {

using namespace vybeg;
using namespace vybeg::benchmarks;

constexpr double longest_s = 1000;

ConditionedRecording decay_in_memory(double seconds) {
    FreeDecay decay = demo_decay();
    decay.noise = 1e-3 * decay.a_A;
    decay.seconds = seconds;
    decay.tau_s = 10 * seconds;  // the wave is there to the end
    decay.damping_anisotropy_per_s = 0;
    SimulatedDecay simulated = test::needed(simulate(decay, {}));
    ConditionedRecording prepared;
    prepared.end = static_cast<std::int64_t>(simulated.c.size());
    prepared.source = memory_source(std::move(simulated.c), std::move(simulated.d));
    prepared.f0_hz = decay.f0_hz;
    return prepared;
}

struct Case {
    std::string name;
    double seconds;
    std::int64_t length;
    std::int64_t hop;
    int threads;

    WindowPlan plan() const {
        return plan_windows(0, static_cast<std::int64_t>(seconds * 33333), length, hop);
    }
};

void estimate(benchmark::State& state, const ConditionedRecording& prepared, const Case& one) {
    const WindowPlan plan = one.plan();
    const TrackSink sink = [](const Track& rows) {
        benchmark::DoNotOptimize(rows.time_s().data());
        return Status{};
    };
    for ([[maybe_unused]] const auto _ : state) {
        const auto summary =
            estimate_track(prepared, plan, Settings{}, 33333, one.threads, sink, {});
        if (!summary) {
            state.SkipWithError("the estimation failed");
        }
    }
    state.SetItemsProcessed(state.iterations() * plan.count);
}

// The estimators alone, on samples that nobody copies: blocks of windows over `threads` threads.
void estimate_alone(benchmark::State& state, const ConditionedRecording& prepared, int threads) {
    constexpr std::int64_t n = 60;
    constexpr std::int64_t per_block = 136;  // as estimate_track() has them
    constexpr std::int64_t blocks = 400;
    std::vector<double> c(n * per_block * blocks);
    std::vector<double> d(c.size());
    if (!prepared.source->read(0, c, d)) {
        state.SkipWithError("the samples cannot be read");
        return;
    }
    std::vector<WaveEstimate> found(per_block * blocks);
    const EstimatorOptions options{.length = n, .rate_hz = 33333, .f0_hz = prepared.f0_hz};
    tbb::enumerable_thread_specific<std::unique_ptr<Estimator>> estimators(
        [&] { return make_estimator(Algorithm::maximum_likelihood, options); });
    tbb::task_arena arena(threads);
    for ([[maybe_unused]] const auto _ : state) {
        arena.execute([&] {
            tbb::parallel_for(tbb::blocked_range<std::int64_t>(0, blocks), [&](const auto& range) {
                for (std::int64_t block = range.begin(); block < range.end(); ++block) {
                    estimators.local()->estimate(
                        {c, d, block * per_block * n, n, n}, 0,
                        std::span(found).subspan(static_cast<std::size_t>(block * per_block),
                                                 static_cast<std::size_t>(per_block)));
                }
            });
        });
        benchmark::DoNotOptimize(found.data());
    }
    state.SetItemsProcessed(state.iterations() * per_block * blocks);
}

// At most three times the time of windows that stand apart and 0.3 us for each further window.
bool print_overlaps(const RatioReporter& reporter, const std::vector<std::vector<Case>>& groups) {
    std::printf("\n%-24s %12s %12s %12s\n", "overlapping windows", "ms", "at most", "us/window");
    bool enough = true;
    for (const std::vector<Case>& group : groups) {
        const double apart = reporter.seconds(group.front().name);
        for (const Case& one : group) {
            const double seconds = reporter.seconds(one.name);
            const auto more = static_cast<double>(one.plan().count - group.front().plan().count);
            const double most = 3 * apart + 0.3e-6 * more;
            std::printf("%-24s %12.3f %12.3f %12.3f\n", one.name.c_str(), 1e3 * seconds, 1e3 * most,
                        1e6 * seconds / static_cast<double>(one.plan().count));
            enough = enough && seconds <= most;
        }
    }
    return enough;
}

void print_growth(const RatioReporter& reporter, const std::vector<Case>& cases) {
    std::printf("\n%-24s %12s %12s\n", "length, two threads", "ms", "ns/frame");
    for (const Case& one : cases) {
        const double seconds = reporter.seconds(one.name);
        std::printf("%-24s %12.3f %12.3f\n", one.name.c_str(), 1e3 * seconds,
                    1e9 * seconds / (one.seconds * 33333));
    }
}

}  // namespace

int main(int argc, char** argv) {
    benchmark::Initialize(&argc, argv);
    const ConditionedRecording prepared = decay_in_memory(longest_s);
    const auto add = [&prepared](const Case& one) {
        benchmark::RegisterBenchmark(
            one.name.c_str(),
            [&prepared, one](benchmark::State& state) { estimate(state, prepared, one); })
            ->UseRealTime()
            ->Unit(benchmark::kMillisecond)
            ->MinTime(0.1)
            ->Repetitions(3);
        return one;
    };
    std::vector<std::vector<Case>> overlaps;
    for (const std::int64_t n : {60, 600, 33333}) {
        std::vector<Case> group;
        for (const std::int64_t hop : {n, n / 10, std::max<std::int64_t>(1, n / 100)}) {
            group.push_back(
                add({"n " + std::to_string(n) + ", hop " + std::to_string(hop), 28, n, hop, 1}));
        }
        overlaps.push_back(group);
    }
    add({"track, one thread", 100, 60, 60, 1});
    add({"track, two threads", 100, 60, 60, 2});
    for (const int threads : {1, 2}) {
        benchmark::RegisterBenchmark(
            threads == 1 ? "estimators, one thread" : "estimators, two threads",
            [&prepared, threads](benchmark::State& state) {
                estimate_alone(state, prepared, threads);
            })
            ->UseRealTime()
            ->Unit(benchmark::kMillisecond)
            ->MinTime(0.1)
            ->Repetitions(3);
    }
    std::vector<Case> growth;
    for (const int seconds : {1, 10, 100, 1000}) {
        growth.push_back(
            add({std::to_string(seconds) + " s", static_cast<double>(seconds), 60, 60, 2}));
    }
    RatioReporter reporter;
    benchmark::RunSpecifiedBenchmarks(&reporter);
    const bool overlapping = print_overlaps(reporter, overlaps);
    print_growth(reporter, growth);
    const bool threads = reporter.print({{"estimators, two threads", "estimators, one thread", 1.7},
                                         {"track, two threads", "track, one thread", 0}});
    return overlapping && threads ? 0 : 1;
}
