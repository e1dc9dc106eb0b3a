#include "core/track/events.h"
#include "tests/closeness.h"
#include "tests/test_registry.h"

#include <QtTest>

#include <numbers>
#include <random>

namespace test_events {

using namespace vybeg;

namespace {

constexpr double half_pi = std::numbers::pi / 2;

// 2theta_A rising or falling evenly through axes, in noise of sd per row.
Track turning(std::size_t rows, double from, double to, double sd, std::uint64_t seed) {
    std::mt19937_64 random(seed);
    std::normal_distribution<double> gauss(0, 1);
    Track track(rows);
    for (std::size_t k = 0; k < rows; ++k) {
        const double t = static_cast<double>(k) / static_cast<double>(rows - 1);
        track.time_s()[k] = t;
        track.values(SlowVariable::two_theta_A)[k] = from + (to - from) * t + sd * gauss(random);
        track.sds(SlowVariable::two_theta_A)[k] = sd;
    }
    return track;
}

}  // namespace

class TestEvents : public QObject {
    Q_OBJECT

private slots:
    void everyAxisIsCrossedOnceInEitherDirection() {
        for (const int direction : {1, -1}) {
            for (const double sd : {0.0, 0.001, 0.03}) {
                for (std::uint64_t seed = 1; seed <= 20; ++seed) {
                    // From between axes -2 and -1 to between 2 and 3: axes -1, 0, 1, 2.
                    const double from = -1.4 * half_pi * direction;
                    const double to = 2.3 * half_pi * direction;
                    const std::vector<Event> events =
                        find_events(turning(20000, from, to, sd, seed));
                    QCOMPARE(events.size(), std::size_t{4});
                    for (int k = 0; k < 4; ++k) {
                        const Event& event = events[static_cast<std::size_t>(k)];
                        QVERIFY(!event.flag);
                        QCOMPARE(event.direction, direction);
                        QCOMPARE(event.multiple_of_half_pi, direction * (k - 1));
                        const double expected =
                            (event.multiple_of_half_pi * half_pi - from) / (to - from);
                        // A line through m rows of noise sd at slope s knows its zero to sd/(s sqrt
                        // m); the segment of twelve sd holds m = 12 sd/s/dt rows.
                        const double slope = std::abs(to - from);
                        const double rows = std::max(12 * sd / slope * 20000, 2.0);
                        VYBEG_CLOSE(event.time_s, expected,
                                    5 * sd / slope / std::sqrt(rows) + 1e-6);
                    }
                }
            }
        }
    }

    void aWaveThatRestsOnAnAxisCrossesNothing() {
        for (std::uint64_t seed = 1; seed <= 20; ++seed) {
            QVERIFY(find_events(turning(5000, half_pi, half_pi, 0.01, seed)).empty());
        }
    }

    void segmentsOfFlagsAreGathered() {
        Track track = turning(101, 0.2, 0.4, 0, 1);
        for (const std::size_t k : {0UL, 1UL, 2UL, 50UL, 99UL, 100UL}) {
            set(track.flags()[k], k == 50 ? Flag::not_converged : Flag::gap);
        }
        const std::vector<Event> events = find_events(track);
        QCOMPARE(events.size(), std::size_t{3});
        QVERIFY((events[0] == Event{Flag::gap, 0, events[0].seconds, 0, 0}));
        VYBEG_CLOSE(events[0].seconds, 0.02, 1e-12);
        QVERIFY(events[1].flag == Flag::not_converged);
        QVERIFY(events[2].flag == Flag::gap);
        QCOMPARE(events[2].time_s, 0.99);
    }

    void wavesThatMoveCrossNothing() {
        Track track = turning(101, -0.5, 0.5, 0, 1);
        QCOMPARE(find_events(track).size(), std::size_t{1});
        for (const std::size_t k : {49UL, 50UL, 51UL}) {
            set(track.flags()[k], Flag::moving);
        }
        const std::vector<Event> events = find_events(track);
        QCOMPARE(events.size(), std::size_t{1});
        QVERIFY(events[0].flag == Flag::moving);
        VYBEG_CLOSE(events[0].seconds, 0.02, 1e-12);
    }
};

VYBEG_TEST(TestEvents)

}  // namespace test_events

#include "test_events.moc"
