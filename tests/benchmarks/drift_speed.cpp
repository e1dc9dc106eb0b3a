// What a carrier that drifts, or was told wrong, costs: the time of an estimation relative to that
// of a constant carrier that is known, in the same run. From samples in memory to the rows of the
// track, 28 s at 33333 Hz and 60 dB, one thread, every algorithm that uses the windows' sums.
#include "core/analysis/estimate_track.h"
#include "core/recording/samples/sample_source.h"
#include "core/simulation/free_decay.h"
#include "core/simulation/simulate.h"
#include "tests/benchmarks/ratio_table.h"
#include "tests/needed.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>

namespace {

using namespace vybeg;
using namespace vybeg::benchmarks;

constexpr double rate = 33333;
constexpr double seconds = 28;
constexpr double f0 = 5300;
constexpr double most = 1.5;

struct Recorded {
    double drift_hz_s;
    std::shared_ptr<const SampleSource> source;
};

// The frequency is f0 in the middle.
Recorded record(double drift_hz_s) {
    FreeDecay decay = demo_decay();
    decay.seconds = seconds;
    decay.f0_hz = f0 - 0.5 * seconds * drift_hz_s;
    decay.frequency_drift_hz_s = drift_hz_s;
    decay.noise = 1e-3 * decay.a_A;
    decay.tau_s = 400;
    decay.damping_anisotropy_per_s = 0;
    SimulatedDecay simulated = test::needed(simulate(decay, {}));
    return {drift_hz_s, memory_source(std::move(simulated.c), std::move(simulated.d))};
}

struct Case {
    Algorithm algorithm;
    std::int64_t length;
    std::int64_t hop;

    std::string name(const char* condition) const {
        return std::string(algorithm_name(algorithm)) + ", n " + std::to_string(length) + ", hop " +
               std::to_string(hop) + ", " + condition;
    }
};

struct Condition {
    const char* name;
    std::size_t recording;
    double off_lobes;  // of the carrier that is told, in half main lobes
};
constexpr std::array<Condition, 5> conditions{{{"still", 0, 0},
                                               {"0.02 Hz/s", 1, 0},
                                               {"0.2 Hz/s", 2, 0},
                                               {"f0 + lobe/2", 0, 0.5},
                                               {"f0 - lobe/4", 0, -0.25}}};

void estimate(benchmark::State& state, const Recorded& recorded, const Case& one,
              const Condition& condition) {
    ConditionedRecording prepared;
    prepared.source = recorded.source;
    prepared.end = recorded.source->frames();
    prepared.f0_hz = f0 + condition.off_lobes * rate / static_cast<double>(one.length);
    const WindowPlan plan = plan_windows(0, prepared.end, one.length, one.hop);
    Settings settings;
    settings.algorithm = one.algorithm;
    const TrackSink sink = [](const Track& rows) {
        benchmark::DoNotOptimize(rows.time_s().data());
        return Status{};
    };
    for ([[maybe_unused]] const auto _ : state) {
        if (!estimate_track(prepared, plan, settings, rate, 1, sink, {})) {
            state.SkipWithError("the estimation failed");
        }
    }
}

}  // namespace

int main(int argc, char** argv) {
    benchmark::Initialize(&argc, argv);
    const std::vector<Recorded> recordings{record(0), record(0.02), record(0.2)};
    std::vector<Case> cases;
    for (const Algorithm algorithm :
         {Algorithm::maximum_likelihood, Algorithm::conjugate_gradient, Algorithm::in_phase,
          Algorithm::phase_shift, Algorithm::moving_axes, Algorithm::demodulation}) {
        for (const std::int64_t n : {60, 600, 6000, 33333}) {
            for (const std::int64_t hop :
                 {std::max<std::int64_t>(1, n / 1111), n / 30, n / 3, n / 2, n}) {
                cases.push_back({algorithm, n, hop});
            }
        }
    }
    for (const Case& one : cases) {
        for (const Condition& condition : conditions) {
            benchmark::RegisterBenchmark(one.name(condition.name).c_str(),
                                         [&recordings, one, condition](benchmark::State& state) {
                                             estimate(state, recordings[condition.recording], one,
                                                      condition);
                                         })
                ->UseRealTime()
                ->Unit(benchmark::kMillisecond)
                ->MinTime(0.02)
                ->Repetitions(3);
        }
    }
    RatioReporter reporter;
    benchmark::RunSpecifiedBenchmarks(&reporter);
    std::printf("\n%-42s %9s", "time, still carrier 1", "still, ms");
    for (std::size_t k = 1; k < conditions.size(); ++k) {
        std::printf(" %11s", conditions[k].name);
    }
    std::printf("\n");
    double worst = 0;
    for (const Case& one : cases) {
        const double still = reporter.seconds(one.name(conditions[0].name));
        if (std::isnan(still)) {
            continue;  // left out by a filter
        }
        std::printf("%-42s %9.2f", one.name("").c_str(), 1e3 * still);
        for (std::size_t k = 1; k < conditions.size(); ++k) {
            const double ratio = reporter.seconds(one.name(conditions[k].name)) / still;
            worst = std::max(worst, ratio);
            std::printf(" %11.2f", ratio);
        }
        std::printf("\n");
    }
    std::printf("largest %.2f, at most %.2f\n", worst, most);
    return worst <= most ? 0 : 1;
}
