#include "core/resonator/runs/merge_windows.h"
#include "tests/closeness.h"
#include "tests/core/resonator/known_resonator.h"
#include "tests/test_registry.h"

namespace test_merge_windows {

using namespace vybeg;
using namespace vybeg::test;

namespace {

FreeDecay decay_with(double split_hz) {
    FreeDecay decay = reference();
    decay.seconds = 6;
    decay.split_hz = split_hz;
    decay.theta_w = 0.2;
    return decay;
}

}  // namespace

class TestMergeWindows : public QObject {
    Q_OBJECT

private slots:
    void touchingWindowsAreOneLongWindow() {
        FreeDecay decay = decay_with(0.1);
        decay.noise = 1e-9;
        const PhasorRun merged = merge_windows(simulated_phasors(decay, 100, 1), 200);
        const PhasorRun whole = simulated_phasors(decay, 1000, 1);
        QCOMPARE(merged.time_s.size(), std::size_t{199});
        VYBEG_CLOSE(merged.window_s, whole.window_s, 1e-12);
        for (std::size_t k = 0; k < merged.time_s.size(); ++k) {
            VYBEG_CLOSE(merged.time_s[k], whole.time_s[k], 1e-9);
            VYBEG_CLOSE(merged.c[k], whole.c[k], 1e-8);
            VYBEG_CLOSE(merged.d[k], whole.d[k], 1e-8);
            VYBEG_CLOSE_RATIO(merged.sd[k], whole.sd[k], 1e-9);
        }
    }

    void fewWindowsAreLeftAlone() {
        const PhasorRun run = simulated_phasors(decay_with(0.1), 1000, 1);
        QCOMPARE(merge_windows(run, 1000).time_s.size(), run.time_s.size());
    }

    void aBeatIsNotAveragedAway() {
        // A split of 5 Hz turns each mode by 2.5 Hz: 0.3 rad in 19 ms.
        const PhasorRun merged = merge_windows(simulated_phasors(decay_with(5), 60, 1), 10);
        VYBEG_LESS(merged.window_s, 0.02);
        VYBEG_MORE(merged.window_s, 0.015);
    }

    void gapsBeginAnew() {
        PhasorRun run = simulated_phasors(decay_with(0.1), 100, 1);
        const auto drop = [&](std::size_t k) {
            const auto at = static_cast<std::ptrdiff_t>(k);
            run.time_s.erase(run.time_s.begin() + at);
            run.c.erase(run.c.begin() + at);
            run.d.erase(run.d.begin() + at);
            run.sd.erase(run.sd.begin() + at);
        };
        drop(1005);
        const PhasorRun merged = merge_windows(run, 200);
        // Of the ten windows around the gap five before it are lost, then the tens go on behind it.
        for (const double time : merged.time_s) {
            const double first = time * 33333 - 499.5;
            const bool before = first < 100000;
            const double phase = std::remainder(first - (before ? 0 : 600), 1000);
            VYBEG_CLOSE(phase, 0, 1e-3);
        }
        // Every seventh missing: nothing longer than three would keep nine tenths.
        PhasorRun sparse = simulated_phasors(decay_with(0.1), 100, 1);
        run = sparse;
        for (std::size_t k = sparse.time_s.size() - 1; k > 7; k -= 7) {
            drop(k);
        }
        VYBEG_AT_LEAST(10 * merge_windows(run, 200).time_s.size(), 9 * run.time_s.size() / 3);
    }

    void theFitIsTheSame() {
        // 60 samples a window: 15,000 of them are merged before the fit.
        FreeDecay decay = reference();
        decay.split_hz = 1e-3;
        decay.theta_w = 0.2;
        const ResonatorFit fit = fitted(set_of(decay, four_angles, 60, 1));
        VYBEG_NEAR(fit.resonator.split_hz, 1e-3, 4, 6e-8);
        VYBEG_NEAR(fit.resonator.theta_w_rad, 0.2, 4, 1e-4);
        VYBEG_CLOSE(fit.chi2_per_dof, 1, 0.05);
    }
};

VYBEG_TEST(TestMergeWindows)

}  // namespace test_merge_windows

#include "test_merge_windows.moc"
