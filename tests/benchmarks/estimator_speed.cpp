// How fast windows are estimated, against Ceres Solver on the same windows from the same start
// values, and against one plain pass that sums the same samples. One thread. 28 s at 33333 Hz and
// 60 dB, the article's case.
//
// Ceres is measured twice: as ceres::Solve, which most programs call, its problem set up once and
// solved anew for each window; and as ceres::TinySolver, its smallest solver, which has no overhead
// of a problem's description and does little but evaluate the errors. The required ratios are
// against the former.
#include "core/estimators/batch/descent.h"
#include "core/estimators/wave/estimator.h"
#include "core/simulation/free_decay.h"
#include "core/simulation/simulate.h"
#include "tests/benchmarks/ratio_table.h"
#include "tests/needed.h"

#include <array>
#include <ceres/ceres.h>
#include <ceres/tiny_solver.h>
#include <cmath>
#include <cstdio>
#include <numbers>

namespace {

using namespace vybeg;
using namespace vybeg::benchmarks;

struct Samples {
    std::vector<double> c;
    std::vector<double> d;
    double rate_hz = 0;
    double f0_hz = 0;
};

Samples samples_of_the_article() {
    FreeDecay decay = demo_decay();
    decay.noise = 1e-3 * decay.a_A;
    SimulatedDecay simulated = test::needed(simulate(decay, {}));
    return {std::move(simulated.c), std::move(simulated.d), decay.rate_hz, decay.f0_hz};
}

// The errors of one window and their derivatives by (a_A, a_B, 2theta_A, alpha, w), for TinySolver.
class WindowErrors {
public:
    using Scalar = double;
    enum { NUM_RESIDUALS = Eigen::Dynamic, NUM_PARAMETERS = 5 };

    explicit WindowErrors(const Window& window) : window_(window) {}

    int NumResiduals() const { return static_cast<int>(2 * window_.length()); }

    bool operator()(const double* at, double* errors, double* jacobian) const {
        const double cosine = std::cos(at[2]);
        const double sine = std::sin(at[2]);
        const auto rows = static_cast<std::size_t>(NumResiduals());
        const double middle = 0.5 * static_cast<double>(window_.length() - 1);
        for (std::size_t j = 0; j < window_.c.size(); ++j) {
            const double u = static_cast<double>(j) - middle;
            const double tau = at[4] * u - at[3];
            const double ct = std::cos(tau);
            const double st = std::sin(tau);
            // C = A cos - B sin, D = A sin + B cos, with A = a_A cos tau and B = a_B sin tau.
            const double c = at[0] * ct * cosine - at[1] * st * sine;
            const double d = at[0] * ct * sine + at[1] * st * cosine;
            errors[2 * j] = c - window_.c[j];
            errors[2 * j + 1] = d - window_.d[j];
            if (jacobian) {
                const double c_tau = -at[0] * st * cosine - at[1] * ct * sine;
                const double d_tau = -at[0] * st * sine + at[1] * ct * cosine;
                const auto set = [&](std::size_t parameter, double by_c, double by_d) {
                    jacobian[parameter * rows + 2 * j] = by_c;
                    jacobian[parameter * rows + 2 * j + 1] = by_d;
                };
                set(0, ct * cosine, ct * sine);
                set(1, -st * sine, st * cosine);
                set(2, -d, c);
                set(3, -c_tau, -d_tau);
                set(4, u * c_tau, u * d_tau);
            }
        }
        return true;
    }

private:
    Window window_;
};

// The same for ceres::Solve: derivatives by row.
class WindowCost final : public ceres::CostFunction {
public:
    explicit WindowCost(std::int64_t n) : jacobian_(static_cast<std::size_t>(10 * n)) {
        mutable_parameter_block_sizes()->push_back(5);
        set_num_residuals(static_cast<int>(2 * n));
    }

    void look_at(const Window& window) { window_ = window; }

    bool Evaluate(double const* const* at, double* errors, double** jacobians) const override {
        const WindowErrors of(window_);
        if (jacobians == nullptr || jacobians[0] == nullptr) {
            return of(at[0], errors, nullptr);
        }
        of(at[0], errors, jacobian_.data());
        const auto rows = static_cast<std::size_t>(num_residuals());
        for (std::size_t row = 0; row < rows; ++row) {
            for (std::size_t k = 0; k < 5; ++k) {
                jacobians[0][5 * row + k] = jacobian_[k * rows + row];
            }
        }
        return true;
    }

private:
    Window window_;
    mutable std::vector<double> jacobian_;
};

Window window_at(const Samples& samples, std::int64_t n, std::int64_t k) {
    const auto first = static_cast<std::size_t>(k * n);
    const auto length = static_cast<std::size_t>(n);
    return {std::span(samples.c).subspan(first, length),
            std::span(samples.d).subspan(first, length)};
}

std::int64_t windows_of(const Samples& samples, std::int64_t n) {
    // A second's worth is enough to measure, except of long windows.
    return std::min(static_cast<std::int64_t>(samples.c.size()) / n,
                    std::max<std::int64_t>(20000 / n * 10, 4));
}

void by_ceres_solve(benchmark::State& state, const Samples& samples, std::int64_t n) {
    const double w0 = 2 * std::numbers::pi * samples.f0_hz / samples.rate_hz;
    const std::int64_t count = windows_of(samples, n);
    std::array<double, 5> at{};
    WindowCost cost(n);
    ceres::Problem::Options owned;
    owned.cost_function_ownership = ceres::DO_NOT_TAKE_OWNERSHIP;
    ceres::Problem problem(owned);
    problem.AddResidualBlock(&cost, nullptr, at.data());
    ceres::Solver::Options options;
    options.linear_solver_type = ceres::DENSE_QR;
    options.logging_type = ceres::SILENT;
    options.num_threads = 1;
    options.gradient_tolerance = 1e-12;
    options.parameter_tolerance = 1e-12;
    options.function_tolerance = 1e-12;
    ceres::Solver::Summary summary;
    for ([[maybe_unused]] const auto _ : state) {
        for (std::int64_t k = 0; k < count; ++k) {
            const Window window = window_at(samples, n, k);
            at = in_phase_start(window, w0);
            cost.look_at(window);
            ceres::Solve(options, &problem, &summary);
            benchmark::DoNotOptimize(at);
        }
    }
    state.SetItemsProcessed(state.iterations() * count);
}

void by_tiny_solver(benchmark::State& state, const Samples& samples, std::int64_t n) {
    const double w0 = 2 * std::numbers::pi * samples.f0_hz / samples.rate_hz;
    const std::int64_t count = windows_of(samples, n);
    ceres::TinySolver<WindowErrors> solver;
    solver.options.gradient_tolerance = 1e-12;
    solver.options.parameter_tolerance = 1e-12;
    solver.options.function_tolerance = 1e-12;
    for ([[maybe_unused]] const auto _ : state) {
        for (std::int64_t k = 0; k < count; ++k) {
            const Window window = window_at(samples, n, k);
            Eigen::Matrix<double, 5, 1> at(in_phase_start(window, w0).data());
            const WindowErrors errors(window);
            solver.Solve(errors, &at);
            benchmark::DoNotOptimize(at);
        }
    }
    state.SetItemsProcessed(state.iterations() * count);
}

void by_estimator(benchmark::State& state, const Samples& samples, Algorithm algorithm,
                  std::int64_t n) {
    const auto estimator = make_estimator(
        algorithm, {.length = n, .rate_hz = samples.rate_hz, .f0_hz = samples.f0_hz});
    const std::int64_t context = estimator->context();
    const std::int64_t count = windows_of(samples, n);
    std::vector<WaveEstimate> found(static_cast<std::size_t>(count));
    const auto frames =
        std::min(static_cast<std::size_t>(count * n + 2 * context), samples.c.size());
    const WindowBlock block{std::span(samples.c).first(frames), std::span(samples.d).first(frames),
                            0, n, n};
    for ([[maybe_unused]] const auto _ : state) {
        estimator->estimate(block, 0, found);
        benchmark::DoNotOptimize(found.data());
    }
    state.SetItemsProcessed(state.iterations() * count);
}

void plain_pass(benchmark::State& state, const Samples& samples, std::int64_t n) {
    const std::int64_t count = windows_of(samples, n);
    for ([[maybe_unused]] const auto _ : state) {
        for (std::int64_t k = 0; k < count; ++k) {
            const Window window = window_at(samples, n, k);
            double c = 0;
            double d = 0;
            for (std::size_t j = 0; j < window.c.size(); ++j) {
                c += window.c[j];
                d += window.d[j];
            }
            benchmark::DoNotOptimize(c);
            benchmark::DoNotOptimize(d);
        }
    }
    state.SetItemsProcessed(state.iterations() * count);
}

template <class Function, class... Arguments>
void add(const std::string& name, Function function, const Arguments&... arguments) {
    benchmark::RegisterBenchmark(name.c_str(),
                                 [=](benchmark::State& state) { function(state, arguments...); })
        ->MeasureProcessCPUTime()
        ->Unit(benchmark::kMicrosecond)
        ->MinTime(0.1)
        ->Repetitions(3);
}

}  // namespace

int main(int argc, char** argv) {
    benchmark::Initialize(&argc, argv);
    const Samples samples = samples_of_the_article();
    std::vector<Ratio> ratios;
    for (const std::int64_t n : {6, 60, 600, 33333}) {
        const std::string of_n = ", n = " + std::to_string(n);
        add(
            "plain pass" + of_n,
            [&samples](auto& state, auto length) { plain_pass(state, samples, length); }, n);
        add(
            "Ceres" + of_n,
            [&samples](auto& state, auto length) { by_ceres_solve(state, samples, length); }, n);
        add(
            "TinySolver" + of_n,
            [&samples](auto& state, auto length) { by_tiny_solver(state, samples, length); }, n);
        for (const Algorithm algorithm :
             {Algorithm::in_phase, Algorithm::phase_shift, Algorithm::moving_axes,
              Algorithm::demodulation, Algorithm::conjugate_gradient,
              Algorithm::maximum_likelihood}) {
            const std::string name = std::string(algorithm_name(algorithm)) + of_n;
            add(
                name,
                [&samples](auto& state, auto kind, auto length) {
                    by_estimator(state, samples, kind, length);
                },
                algorithm, n);
            const bool required = n == 6 || n == 60;
            double least = 0;
            if (algorithm == Algorithm::maximum_likelihood && required) {
                least = 40;
            } else if (algorithm == Algorithm::conjugate_gradient && n == 6) {
                least = 8;
            }
            ratios.push_back({name, "Ceres" + of_n, least});
            ratios.push_back({name, "TinySolver" + of_n, 0});
            ratios.push_back({name, "plain pass" + of_n, 0});
        }
    }
    RatioReporter reporter;
    benchmark::RunSpecifiedBenchmarks(&reporter);
    return reporter.print(ratios) ? 0 : 1;
}
