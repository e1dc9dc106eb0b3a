#include "core/resonator/results/resonator_fit.h"
#include "core/simulation/simulate.h"
#include "tests/closeness.h"
#include "tests/needed.h"
#include "tests/statistical/each_seed.h"
#include "tests/statistical/resonator_bound.h"
#include "tests/statistical/simulated_recording.h"
#include "tests/test_registry.h"

#include <numbers>
#include <random>

namespace test_resonator_set {

using namespace vybeg;
using std::numbers::pi;

namespace {

constexpr int seeds = 100;
constexpr double theta_w = 0.2;
const std::vector<double> angles{0, 22.5, 45, 67.5};

// The reference of METHOD section 8 but for the start angle.
FreeDecay reference() {
    FreeDecay decay{.split_hz = 1e-6, .theta_w = theta_w, .tau_s = 400, .noise = 1e-3};
    return decay;
}

// Least squares of cos and sin at f_ref over windows of n samples of a decay.
PhasorRun project(const FreeDecay& decay, double f_ref_hz, std::size_t n) {
    const SimulatedDecay samples = test::simulated(decay);
    const double rate_hz = decay.rate_hz;
    const double w = 2 * pi * f_ref_hz / rate_hz;
    std::vector<double> cosine(n);
    std::vector<double> sine(n);
    double cos2 = 0;
    double sin2 = 0;
    for (std::size_t k = 0; k < n; ++k) {
        // From the window's centre cos and sin are orthogonal.
        const double turn = w * (static_cast<double>(k) - static_cast<double>(n - 1) / 2);
        cosine[k] = std::cos(turn);
        sine[k] = std::sin(turn);
        cos2 += cosine[k] * cosine[k];
        sin2 += sine[k] * sine[k];
    }
    PhasorRun run;
    run.f_ref_hz = f_ref_hz;
    run.window_s = static_cast<double>(n) / rate_hz;
    for (std::size_t first = 0; first + n <= samples.c.size(); first += n) {
        const double centre = static_cast<double>(first) + static_cast<double>(n - 1) / 2;
        const auto back = std::polar(1.0, -std::fmod(w * centre, 2 * pi));
        const auto phasor = [&](const std::vector<double>& x) {
            double by_cos = 0;
            double by_sin = 0;
            for (std::size_t k = 0; k < n; ++k) {
                by_cos += x[first + k] * cosine[k];
                by_sin += x[first + k] * sine[k];
            }
            return back * std::complex(by_cos / cos2, -by_sin / sin2);
        };
        run.time_s.push_back(centre / rate_hz);
        run.c.push_back(phasor(samples.c));
        run.d.push_back(phasor(samples.d));
    }
    run.sd.assign(run.c.size(), decay.noise * std::sqrt(2 / static_cast<double>(n)));
    return run;
}

ResonatorFit fit_of_seed(std::uint64_t seed) {
    std::mt19937_64 random(seed);
    std::uniform_real_distribution<double> offset(-0.02, 0.02);
    std::uniform_real_distribution<double> phase(-pi, pi);
    std::vector<PhasorRun> runs;
    for (const double angle : angles) {
        FreeDecay decay = reference();
        decay.two_theta_A = 2 * angle * pi / 180;
        decay.f0_hz = 5300 + offset(random);
        decay.alpha = phase(random);
        decay.seed = random();
        runs.push_back(project(decay, 5300, 500));
    }
    return test::needed(fit_resonator(runs, {}, {}));
}

}  // namespace

class TestResonatorSet : public QObject {
    Q_OBJECT

private slots:
    // The main case: samples with white noise, a split of 1e-6 Hz, one hundred seeds.
    void fourRunsShowASplitOfAMicrohertz() {
        std::vector<ResonatorFit> fits(seeds);
        test::for_each_seed(seeds, [&](int k) {
            fits[static_cast<std::size_t>(k)] = fit_of_seed(static_cast<std::uint64_t>(k) + 1);
        });

        double sum = 0;
        double squares = 0;
        double reported = 0;
        double chi2 = 0;
        int axis_right = 0;
        for (const ResonatorFit& fit : fits) {
            QVERIFY(fit.model == ResonatorModel::structured);
            const Estimate& split = fit.resonator.split_hz;
            const Estimate& axis = fit.resonator.theta_w_rad;
            QVERIFY(split.given());
            sum += split.value / seeds;
            squares += (split.value - 1e-6) * (split.value - 1e-6) / seeds;
            reported += split.sd / seeds;
            chi2 += fit.chi2_per_dof / seeds;
            axis_right += axis.given() && std::abs(axis.value - theta_w) <= 3 * axis.sd ? 1 : 0;
        }
        const double scatter =
            std::sqrt((squares - (sum - 1e-6) * (sum - 1e-6)) * seeds / (seeds - 1));
        // The bound of the split's size at theta_w: the runs see both components alike.
        const test::ResonatorBound bound = test::resonator_bound(reference(), angles);
        const double least = std::hypot(std::cos(4 * theta_w) * bound.sd_split_cos_hz,
                                        std::sin(4 * theta_w) * bound.sd_split_sin_hz);
        qInfo(
            "mean %.4g Hz, scatter %.3g Hz, bound %.3g Hz, reported %.3g Hz, axis %d of %d, chi2 "
            "%.4f",
            sum, scatter, least, reported, axis_right, seeds, chi2);
        VYBEG_WITHIN(sum, 1e-6, 3 * scatter / std::sqrt(1.0 * seeds));
        VYBEG_AT_MOST(scatter, 1.2 * least);
        VYBEG_AT_MOST(scatter, 6e-8);
        VYBEG_WITHIN(reported / scatter, 1, 0.15);
        VYBEG_AT_LEAST(axis_right, 98);
        VYBEG_CLOSE(chi2, 1, 0.01);
    }
};

VYBEG_TEST(TestResonatorSet)

}  // namespace test_resonator_set

#include "test_resonator_set.moc"
