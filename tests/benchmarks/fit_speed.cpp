// The resonator's fit of window phasors, 28 s a recording, everything on: model test, noise model,
// causes. White noise, noise about the carrier, 1/f-like settling and a cubic spring; one recording
// and four. The limits of the table are 0.1 and 0.2 s.
#include "core/resonator/results/resonator_fit.h"
#include "tests/core/resonator/simulated_phasors.h"

#include <benchmark/benchmark.h>

#include <cstdio>
#include <functional>
#include <map>
#include <numbers>
#include <string>
#include <vector>

namespace {

using namespace vybeg;
using namespace vybeg::test;
using std::numbers::pi;

constexpr std::int64_t window = 500;

FreeDecay gyro(std::size_t run) {
    FreeDecay decay;
    decay.tau_s = 400;
    decay.noise = 1e-3;
    decay.split_hz = 1e-3;
    decay.theta_w = 0.2;
    decay.damping_anisotropy_per_s = 2e-4;
    decay.theta_tau = -0.3;
    decay.two_theta_A = 0.3 + static_cast<double>(run) * pi / 4;
    decay.alpha = 0.4 + static_cast<double>(run);
    return decay;
}

PhasorRun white(std::size_t run) {
    return simulated_phasors(gyro(run), window, run + 1);
}

// A thousandth of the wave, 0.2 Hz wide.
PhasorRun coloured(std::size_t run) {
    PhasorRun phasors = white(run);
    GaussianNoise noise(run + 77);
    const double keeps = std::exp(-2 * pi * 0.2 * phasors.window_s);
    const double gains = 1e-3 * std::sqrt(1 - keeps * keeps);
    for (std::vector<std::complex<double>>* signal : {&phasors.c, &phasors.d}) {
        const auto [re, im] = noise.next();
        std::complex<double> x = 1e-3 * std::complex(re, im);
        for (std::complex<double>& phasor : *signal) {
            phasor += x;
            const auto [step_re, step_im] = noise.next();
            x = keeps * x + gains * std::complex(step_re, step_im);
        }
    }
    return phasors;
}

PhasorRun settling(std::size_t run) {
    PhasorRun phasors = white(run);
    for (std::size_t k = 0; k < phasors.c.size(); ++k) {
        const auto turn = std::polar(1.0, -2 * pi * 0.05 * std::expm1(-phasors.time_s[k] / 5));
        phasors.c[k] *= turn;
        phasors.d[k] *= turn;
    }
    return phasors;
}

PhasorRun cubic(std::size_t run) {
    FreeDecay decay = gyro(run);
    decay.frequency_per_power_hz = 0.01;
    return moved_phasors(decay, window, run + 1);
}

// Keeps the fastest iteration of each benchmark.
class Fastest : public benchmark::ConsoleReporter {
public:
    void ReportRuns(const std::vector<Run>& runs) override {
        for (const Run& run : runs) {
            const double seconds = run.real_accumulated_time / static_cast<double>(run.iterations);
            const auto [place, is_new] = seconds_.emplace(run.benchmark_name(), seconds);
            place->second = is_new ? seconds : std::min(place->second, seconds);
        }
        ConsoleReporter::ReportRuns(runs);
    }

    // Whether all lie below their limits.
    bool print() const {
        bool fine = true;
        std::printf("\n%-24s %10s %10s\n", "fit of phasors", "ms", "limit");
        for (const auto& [name, seconds] : seconds_) {
            const double limit = name.find("/4") != std::string::npos ? 0.2 : 0.1;
            std::printf("%-24s %10.1f %10.0f%s\n", name.c_str(), 1e3 * seconds, 1e3 * limit,
                        seconds > limit ? "  above" : "");
            fine = fine && seconds <= limit;
        }
        return fine;
    }

private:
    std::map<std::string, double> seconds_;
};

}  // namespace

int main(int argc, char** argv) {
    benchmark::Initialize(&argc, argv);
    const std::map<std::string, PhasorRun (*)(std::size_t)> makers{
        {"white", white}, {"coloured", coloured}, {"settling", settling}, {"cubic", cubic}};
    for (const auto& [name, make] : makers) {
        std::vector<PhasorRun> runs;
        for (std::size_t k = 0; k < 4; ++k) {
            runs.push_back(make(k));
        }
        for (const std::size_t count : {std::size_t{1}, std::size_t{4}}) {
            const std::string title = name + "/" + std::to_string(count);
            benchmark::RegisterBenchmark(title.c_str(),
                                         [runs, count](benchmark::State& state) {
                                             for ([[maybe_unused]] const auto _ : state) {
                                                 benchmark::DoNotOptimize(fit_resonator(
                                                     std::span(runs).first(count), {}, {}));
                                             }
                                         })
                ->Unit(benchmark::kMillisecond)
                ->UseRealTime();
        }
    }
    Fastest reporter;
    benchmark::RunSpecifiedBenchmarks(&reporter);
    return reporter.print() ? 0 : 1;
}
