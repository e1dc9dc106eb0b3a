// Which windows of a track are flagged over faults of the samples.
#include "core/analysis/analyse.h"
#include "core/analysis/analysis.h"
#include "core/analysis/estimate_track.h"
#include "core/analysis/settings.h"
#include "core/simulation/simulate.h"
#include "core/track/track.h"
#include "core/windows/window_plan.h"
#include "tests/closeness.h"
#include "tests/statistical/simulated_recording.h"
#include "tests/test_registry.h"

#include <QtTest>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <random>

namespace test_window_faults {

using namespace vybeg;
using namespace vybeg::test;

namespace {

FreeDecay two_seconds() {
    FreeDecay decay{.seconds = 2, .a_B = 0.2, .tau_s = 20, .noise = 0.003};
    return decay;
}

}  // namespace

class TestWindowFaults : public QObject {
    Q_OBJECT

private slots:
    void windows_are_those_that_overlap() {
        std::mt19937_64 random(5);
        const auto any = [&](std::int64_t low, std::int64_t high) {
            return std::uniform_int_distribution<std::int64_t>(low, high)(random);
        };
        for (int trial = 0; trial < 2000; ++trial) {
            const WindowPlan plan{any(0, 50), any(1, 40), any(1, 60), any(1, 30)};
            SampleFaults faults;
            std::int64_t at = 0;
            for (std::int64_t k = any(0, 4); k > 0; --k) {
                at += any(1, 200);
                faults.clipped.push_back({at, any(1, 30)});
            }
            at = 0;
            for (std::int64_t k = any(0, 4); k > 0; --k) {
                at += any(1, 300);
                PhaseStep step;
                step.frame = at;
                step.phase_rad = 1;
                step.lost = 1;
                faults.steps.push_back(step);
            }
            at = 0;
            for (std::int64_t k = any(0, 2); k > 0; --k) {
                at += any(60, 300);
                faults.still.push_back({at, any(16, 40)});
            }
            const std::int64_t reach = any(0, 1) * any(0, 20);
            Track found(static_cast<std::size_t>(plan.count));
            const std::vector<FlaggedRows> flagged = windows_over(faults, plan, reach);
            set_flags(found.flags(), 0, flagged);
            QVERIFY(std::ranges::is_sorted(flagged, {}, &FlaggedRows::first));
            for (std::int64_t k = 0; k < plan.count; ++k) {
                const std::int64_t begin = plan.start(k);
                const std::int64_t end = begin + plan.length;
                Flags expected = 0;
                for (const FrameRange& range : faults.clipped) {
                    if (begin < range.end() && range.first < end) {
                        set(expected, Flag::clipped);
                    }
                }
                for (const FrameRange& range : faults.still) {
                    if (begin < range.end() + reach && range.first - reach < end) {
                        set(expected, Flag::gap);
                    }
                }
                for (const PhaseStep& step : faults.steps) {
                    // The sample before the step and the first behind it are both inside.
                    if (begin <= step.frame - 1 && step.frame < end) {
                        set(expected, Flag::gap);
                    }
                }
                QVERIFY2(found.flags()[static_cast<std::size_t>(k)] == expected,
                         qPrintable(QString("trial %1, window %2").arg(trial).arg(k)));
            }
        }
    }

    void clipped_samples_flag_their_windows_and_no_others() {
        SimulatedDecay samples = simulated(two_seconds());
        const double top = 0.97 * *std::ranges::max_element(samples.d);
        std::vector<bool> clipped;
        for (double& x : samples.d) {
            clipped.push_back(x >= top);
            x = std::min(x, top);
        }
        for (const std::int64_t hop : {7, 60, 200}) {
            Settings settings;
            settings.hop = hop;
            const auto analysis = analyse(recording_of(samples.c, samples.d, 33333), settings, {});
            QVERIFY(analysis);
            QCOMPARE(std::ranges::count(analysis->diagnostics, DiagnosticKind::clipped,
                                        &Diagnostic::kind),
                     1);
            std::ptrdiff_t flagged = 0;
            for (std::int64_t k = 0; k < analysis->plan.count; ++k) {
                const auto begin = clipped.begin() + analysis->plan.start(k);
                const bool expected = std::find(begin, begin + 60, true) != begin + 60;
                const Flags flags = analysis->track.flags()[static_cast<std::size_t>(k)];
                flagged += expected ? 1 : 0;
                QVERIFY2(has(flags, Flag::clipped) == expected,
                         qPrintable(QString("hop %1, window %2").arg(hop).arg(k)));
            }
            VYBEG_MORE(flagged, 10);
            VYBEG_LESS(flagged, analysis->plan.count / 2);
        }
    }

    void a_window_over_a_lost_sample_is_flagged_and_a_repair_leaves_the_rest_true() {
        const FreeDecay decay = two_seconds();
        SimulatedDecay samples = simulated(decay);
        const std::ptrdiff_t lost = 33333;
        samples.c.erase(samples.c.begin() + lost);
        samples.d.erase(samples.d.begin() + lost);
        const Recording recording = recording_of(samples.c, samples.d, 33333);
        Settings settings;
        settings.f0_hz = decay.f0_hz;
        const auto plain = analyse(recording, settings, {});
        settings.repair_lost = true;
        const auto repaired = analyse(recording, settings, {});
        QVERIFY(plain && repaired);
        const auto kinds = [](const Analysis& analysis) {
            QStringList names;
            for (const Diagnostic& diagnostic : analysis.diagnostics) {
                names << QString::fromStdString(kind_name(diagnostic.kind));
            }
            return names.join(" ");
        };
        QCOMPARE(kinds(*plain), "samples-lost");
        QCOMPARE(kinds(*repaired), "gaps-inserted");
        const auto flagged = [](const Analysis& analysis) {
            return std::ranges::count_if(analysis.track.flags(),
                                         [](Flags f) { return has(f, Flag::gap); });
        };
        QCOMPARE(flagged(*plain), 1);
        QCOMPARE(flagged(*repaired), 1);

        // Behind the loss, alpha(t) = 2 pi f t - phase is a turn by one sample off without the
        // repair, and true with it: alpha is that of the truth within six of its deviations.
        const Result<Track> truth = true_track(decay, 60);
        QVERIFY(truth);
        const double turn = 2 * std::numbers::pi * decay.f0_hz / decay.rate_hz;
        for (const auto& [analysis, off] : {std::pair{&*plain, turn}, std::pair{&*repaired, 0.0}}) {
            const auto alpha = analysis->track.values(SlowVariable::alpha);
            const auto sd = analysis->track.sds(SlowVariable::alpha);
            const auto expected = truth->values(SlowVariable::alpha);
            for (std::size_t k = 0; k < analysis->track.rows(); ++k) {
                if (has(analysis->track.flags()[k], Flag::gap)) {
                    continue;
                }
                const double behind = analysis->track.time_s()[k] > 1 ? off : 0;
                const double error =
                    std::remainder(alpha[k] - expected[k] + behind, std::numbers::pi);
                VYBEG_CLOSE(error, 0, 6 * sd[k], qPrintable(QString("window %1").arg(k)));
            }
        }
    }
};

VYBEG_TEST(TestWindowFaults, threads)

}  // namespace test_window_faults

#include "test_window_faults.moc"
