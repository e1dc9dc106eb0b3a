// The resonator from E, R, S, Q of 200 random sets.
//
// Statistical model: errors are Gaussian with the deviations told, so that their rms in units of
// these is 1 within 15 %.
#include "tests/closeness.h"
#include "tests/core/resonator/simulated_powers.h"
#include "tests/statistical/each_seed.h"
#include "tests/test_registry.h"

#include <QtTest>

#include <cmath>
#include <map>
#include <mutex>
#include <numbers>
#include <random>
#include <string>
#include <vector>

namespace test_power_pulls {

using namespace vybeg;
using namespace vybeg::test;

constexpr double pi = std::numbers::pi;

class TestPowerPulls : public QObject {
    Q_OBJECT

private slots:
    void pulls_of_random_sets_are_one_data() {
        QTest::addColumn<double>("power");
        QTest::addColumn<double>("phasor");
        QTest::newRow("noise of the powers") << 1e-4 << 0.0;
        QTest::newRow("noise of the phasors") << 0.0 << 1e-4;
    }
    void pulls_of_random_sets_are_one() {
        QFETCH(double, power);
        QFETCH(double, phasor);
        std::map<std::string, std::vector<double>> pulls;
        std::mutex mutex;
        for_each_seed(200, [&](int seed) {
            std::mt19937_64 random(static_cast<unsigned>(seed) + 500);
            std::uniform_real_distribution<double> any(0, 1);
            Resonator of;
            of.tau = std::pow(10, 1.5 + 1.2 * any(random));
            of.split = std::pow(10, -3.5 + 2 * any(random));
            of.theta_w = pi * any(random);
            of.g = (0.02 + 0.2 * any(random)) / of.tau;
            of.theta_tau = pi * any(random);
            of.r = 0.01 * (any(random) - 0.5);
            const int runs = 2 + static_cast<int>(3 * any(random));
            const auto set =
                set_of(of, runs, 20 + 20 * any(random), {.power = power, .phasor = phasor},
                       static_cast<unsigned>(seed));
            FitOptions options = known_channels();
            const auto found = pulls_of(resonator_of(set, options), of);
            const std::lock_guard lock(mutex);
            for (const auto& [name, pull] : found) {
                pulls[name].push_back(pull);
            }
        });
        QCOMPARE(pulls.size(), std::size_t{6});
        std::map<std::string, double> rms;
        for (const auto& [name, values] : pulls) {
            double square = 0;
            for (const double value : values) {
                square += value * value;
            }
            rms[name] = std::sqrt(square / static_cast<double>(values.size()));
            qInfo("%s: %zu given, rms pull %.3f", name.c_str(), values.size(), rms[name]);
        }
        for (const auto& [name, values] : pulls) {
            VYBEG_AT_LEAST(values.size(), std::size_t{120}, name.c_str());
            VYBEG_LESS(rms[name], 1.15, name.c_str());
            VYBEG_MORE(rms[name], 0.85, name.c_str());
        }
    }
};

VYBEG_TEST(TestPowerPulls, statistical, unsanitized)

}  // namespace test_power_pulls

#include "test_power_pulls.moc"
