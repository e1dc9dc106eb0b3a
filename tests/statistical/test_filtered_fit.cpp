// The resonator behind a band-pass, from samples: its noise is correlated from window to window,
// and a window's residual has few degrees of freedom.
//
// Statistical model: pulls of 60 sets have a root mean square of 1 with a scatter of a twelfth for
// each quantity; sd lies within 10 % of that without the filter, which takes no noise at the
// carrier.
#include "core/analysis/identify.h"
#include "tests/closeness.h"
#include "tests/statistical/each_seed.h"
#include "tests/statistical/simulated_recording.h"
#include "tests/test_registry.h"

#include <QtTest>

#include <algorithm>
#include <cmath>
#include <map>
#include <mutex>
#include <numbers>
#include <string>

namespace test_filtered_fit {

using namespace vybeg;
using namespace vybeg::test;
using std::numbers::pi;

class TestFilteredFit : public QObject {
    Q_OBJECT

private slots:
    void deviations_are_those_without_the_filter_data() {
        QTest::addColumn<double>("low_hz");
        QTest::addColumn<double>("high_hz");
        QTest::newRow("50 Hz") << 5275.0 << 5325.0;
        QTest::newRow("200 Hz") << 5200.0 << 5400.0;
        QTest::newRow("600 Hz, off the middle") << 5100.0 << 5700.0;
    }

    void deviations_are_those_without_the_filter() {
        QFETCH(double, low_hz);
        QFETCH(double, high_hz);
        constexpr int sets = 20;
        std::map<std::string, double> squares;
        std::map<std::string, std::vector<double>> widening;
        int drifts = 0;
        std::mutex mutex;
        for_each_seed(sets, [&](int seed) {
            const FreeDecay gyro{.seconds = 8,
                                 .split_hz = seed % 2 == 0 ? 3e-3 : 0.05,
                                 .theta_w = 0.1 * seed - 0.9,
                                 .tau_s = 100,
                                 .damping_anisotropy_per_s = 1e-3,
                                 .theta_tau = -0.3,
                                 .noise = 1e-3};
            std::vector<Recording> recordings;
            for (int k = 0; k < 3; ++k) {
                FreeDecay run = gyro;
                run.two_theta_A = 0.3 + 0.35 * seed + k * pi / 4;
                run.alpha = 0.4 + k;
                run.seed = static_cast<std::uint64_t>(10 * seed + k + 1);
                recordings.push_back(simulated_recording(run));
            }
            IdentifySettings settings;
            settings.threads = 1;
            const Result<Identification> plain = identify(recordings, settings, {});
            settings.signal.filter = Band{low_hz, high_hz};
            const Result<Identification> filtered = identify(recordings, settings, {});
            const std::lock_guard lock(mutex);
            QVERIFY(plain && filtered);
            const ResonatorEstimate& truth = plain->fit.resonator;
            const ResonatorEstimate& found = filtered->fit.resonator;
            const auto add = [&](const char* name, const Estimate& estimate,
                                 const Estimate& unfiltered, double value, double period = 0) {
                QVERIFY2(estimate.given() && unfiltered.given(), name);
                double off = estimate.value - value;
                off = period > 0 ? std::remainder(off, period) : off;
                squares[name] += off * off / (estimate.sd * estimate.sd) / sets;
                widening[name].push_back(estimate.sd / unfiltered.sd);
            };
            add("f_mean", found.f_mean_hz, truth.f_mean_hz, gyro.f0_hz);
            add("split", found.split_hz, truth.split_hz, gyro.split_hz);
            add("theta_w", found.theta_w_rad, truth.theta_w_rad, gyro.theta_w, pi / 2);
            add("tau", found.tau_s, truth.tau_s, gyro.tau_s);
            add("rate", found.angle_rate_rad_s, truth.angle_rate_rad_s, 0);
            for (const RunEstimate& run : filtered->fit.runs) {
                const Estimate& drift = run.drift_hz_per_s;
                drifts += drift.given() && std::abs(drift.value) > 4 * drift.uncertainty() ? 1 : 0;
            }
        });
        QCOMPARE(drifts, 0);
        double all = 0;
        for (auto& [name, ratios] : widening) {
            std::ranges::sort(ratios);
            const double rms = std::sqrt(squares[name]);
            const QString text = QString("%1: rms pull %2, sd over that without filter %3")
                                     .arg(name.c_str())
                                     .arg(rms)
                                     .arg(ratios[ratios.size() / 2]);
            qInfo("%s", qPrintable(text));
            VYBEG_MORE(rms, 0.55, qPrintable(text));
            VYBEG_LESS(rms, 1.5, qPrintable(text));
            VYBEG_CLOSE(ratios[ratios.size() / 2], 1, 0.1, qPrintable(text));
            all += squares[name] / static_cast<double>(widening.size());
        }
        VYBEG_MORE(std::sqrt(all), 0.8);
        VYBEG_LESS(std::sqrt(all), 1.2);
    }
};

VYBEG_TEST(TestFilteredFit)

}  // namespace test_filtered_fit

#include "test_filtered_fit.moc"
