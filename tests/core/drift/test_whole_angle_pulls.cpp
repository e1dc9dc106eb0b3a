// Whole-angle logs: errors of the harmonics, of tau and of the split in units of their deviations.
//
// Statistical model: over many loops the errors are Gaussian with the covariance told, so that the
// rms pull of each number is 1 within its own scatter, 5 % for 200 loops.
#include "core/drift/whole_angle_drift.h"
#include "tests/closeness.h"
#include "tests/core/drift/simulated_log.h"
#include "tests/needed.h"
#include "tests/statistical/each_seed.h"
#include "tests/test_registry.h"

#include <QtTest>

#include <array>
#include <cmath>
#include <cstddef>
#include <functional>
#include <mutex>
#include <random>
#include <vector>

namespace test_whole_angle_pulls {

using namespace vybeg;
using namespace vybeg::test;

namespace {

constexpr int loops = 200;
// Of mean, c2, s2, c4, s4, tau, split.
using Pulls = std::array<std::vector<double>, 7>;

HeldLoop loop_of(int seed) {
    std::mt19937_64 random(static_cast<unsigned>(seed) + 1000);
    std::uniform_real_distribution<double> any(-1, 1);
    HeldLoop loop;
    loop.seconds = 400 + 300 * any(random);
    loop.turn = (any(random) > 0 ? 1 : -1) * (0.08 + 0.04 * any(random));
    loop.start = 3 * any(random);
    loop.c2 = 3e-4 * any(random);
    loop.s2 = 3e-4 * any(random);
    loop.c4 = 3e-4 + 1e-4 * any(random);
    loop.s4 = 3e-4 * any(random);
    loop.tau_s = 300 + 100 * any(random);
    loop.effort_noise = 0.02;
    loop.seed = static_cast<unsigned>(seed) + 1;
    return loop;
}

Pulls pulls_of(const std::function<void(HeldLoop&)>& noise) {
    Pulls pulls;
    std::mutex mutex;
    for_each_seed(loops, [&](int seed) {
        HeldLoop loop = loop_of(seed);
        noise(loop);
        const auto found = needed(whole_angle_drift(std::vector{simulated_log(loop)}, {}));
        const std::array truth{loop.turn, loop.c2,    loop.s2,      loop.c4,
                               loop.s4,   loop.tau_s, loop.split_hz};
        const std::lock_guard lock(mutex);
        for (std::size_t k = 0; k < truth.size(); ++k) {
            const Estimate& estimate = k < 5    ? found.harmonics[k]
                                       : k == 5 ? found.resonator.tau_s
                                                : found.resonator.split_hz;
            if (estimate.given()) {
                pulls[k].push_back((estimate.value - truth[k]) / estimate.sd);
            }
        }
    });
    return pulls;
}

double rms(const std::vector<double>& values) {
    double square = 0;
    for (const double value : values) {
        square += value * value;
    }
    return std::sqrt(square / static_cast<double>(values.size()));
}

}  // namespace

class TestWholeAnglePulls : public QObject {
    Q_OBJECT

private slots:
    void pulls_are_one_data() {
        QTest::addColumn<double>("white");
        QTest::addColumn<double>("walk");
        QTest::addColumn<double>("slow");
        QTest::addColumn<double>("slow_rate");
        QTest::addColumn<double>("slow_s");
        QTest::newRow("white angle") << 1e-5 << 0.0 << 0.0 << 0.0 << 1.0;
        QTest::newRow("white rate") << 1e-5 << 3e-6 << 0.0 << 0.0 << 1.0;
        QTest::newRow("coloured angle") << 3e-6 << 0.0 << 2e-5 << 0.0 << 3.0;
        QTest::newRow("coloured rate") << 1e-5 << 0.0 << 0.0 << 3e-6 << 5.0;
    }
    void pulls_are_one() {
        QFETCH(double, white);
        QFETCH(double, walk);
        QFETCH(double, slow);
        QFETCH(double, slow_rate);
        QFETCH(double, slow_s);
        const Pulls pulls = pulls_of([&](HeldLoop& loop) {
            loop.white = white;
            loop.walk = walk;
            loop.slow = slow;
            loop.slow_rate = slow_rate;
            loop.slow_s = slow_s;
        });
        for (std::size_t k = 0; k < pulls.size(); ++k) {
            qInfo("%zu: %zu given, rms pull %.3f", k, pulls[k].size(), rms(pulls[k]));
        }
        for (const std::vector<double>& of_one : pulls) {
            VYBEG_AT_LEAST(of_one.size(), std::size_t{loops * 9 / 10});
            VYBEG_LESS(rms(of_one), 1.15);
            VYBEG_MORE(rms(of_one), 0.85);
        }
    }
};

VYBEG_TEST(TestWholeAnglePulls, first, statistical, unsanitized)

}  // namespace test_whole_angle_pulls

#include "test_whole_angle_pulls.moc"
