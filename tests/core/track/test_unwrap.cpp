#include "core/estimators/wave/wave_state.h"
#include "core/numerics/phase.h"
#include "core/track/track.h"
#include "tests/closeness.h"
#include "tests/test_registry.h"

#include <QtTest>

#include <numbers>

namespace test_unwrap {

using namespace vybeg;

namespace {

constexpr double pi = std::numbers::pi;

// A wave that turns by `rate` rad of 2theta_A per row, as an estimator would give it, row by row.
Track turning(std::size_t rows, double start, double rate) {
    Track track(rows);
    for (std::size_t k = 0; k < rows; ++k) {
        const WaveState row =
            to_wave_state(to_phasors({1, 0.2, start + rate * static_cast<double>(k), 0.3}));
        track.time_s()[k] = static_cast<double>(k);
        track.values(SlowVariable::two_theta_A)[k] = row.two_theta_A;
        track.values(SlowVariable::alpha)[k] = row.alpha;
    }
    return track;
}

}  // namespace

class TestUnwrap : public QObject {
    Q_OBJECT

private slots:
    void angleRunsOnThroughEveryAxisAndAlphaStaysOfTheSameMotion() {
        for (const double rate : {-0.7, -0.01, 0.0, 0.3, 1.4}) {
            for (double start = -1.5; start <= 1.57; start += 0.3) {
                Track track = turning(50, start, rate);
                AngleUnwrapper(0).unwrap(track);
                for (std::size_t k = 0; k < track.rows(); ++k) {
                    // The start lies in (-pi/2, pi/2], so that no half turn is left open.
                    VYBEG_CLOSE(track.values(SlowVariable::two_theta_A)[k],
                                start + rate * static_cast<double>(k), 1e-12);
                    VYBEG_CLOSE(wrap(track.values(SlowVariable::alpha)[k] - 0.3), 0, 1e-12);
                }
            }
        }
    }

    void missingRowsAreStepped() {
        Track track = turning(40, 1.2, 0.1);
        for (const std::size_t k : {0UL, 1UL, 10UL, 11UL, 12UL}) {
            track.values(SlowVariable::two_theta_A)[k] = std::nan("");
            track.values(SlowVariable::alpha)[k] = std::nan("");
        }
        AngleUnwrapper(0).unwrap(track);
        QVERIFY(std::isnan(track.values(SlowVariable::two_theta_A)[11]));
        // The first valid row is the third: 1.4, inside (-pi/2, pi/2].
        VYBEG_CLOSE(track.values(SlowVariable::two_theta_A)[39], 1.2 + 3.9, 1e-12);
    }

    void electrodeAngleIsTakenOff() {
        for (const double zero : {-2.0, 0.1, 1.0, 3.0}) {
            Track track = turning(50, 0.2, 0.2);
            AngleUnwrapper(zero).unwrap(track);
            const double first = track.values(SlowVariable::two_theta_A)[0];
            VYBEG_MORE(first, -pi / 2);
            VYBEG_AT_MOST(first, pi / 2);
            const double half_turns = (first - (0.2 - zero)) / pi;
            VYBEG_CLOSE(half_turns, std::round(half_turns), 1e-12);
            for (std::size_t k = 0; k < track.rows(); ++k) {
                VYBEG_CLOSE(track.values(SlowVariable::two_theta_A)[k] - first,
                            0.2 * static_cast<double>(k), 1e-12);
                // A half turn of the angle goes with a half turn of the phase.
                VYBEG_CLOSE(
                    wrap(track.values(SlowVariable::alpha)[k] - 0.3 - pi * std::round(half_turns)),
                    0, 1e-12);
            }
        }
    }

    void piecesGiveTheWhole() {
        Track whole = turning(40, 1.2, 0.7);
        for (const std::size_t k : {0UL, 9UL, 10UL, 20UL}) {
            whole.values(SlowVariable::two_theta_A)[k] = std::nan("");
        }
        AngleUnwrapper unwrapper(0.3);
        Track joined;
        for (std::size_t first = 0; first < whole.rows(); first += 10) {
            Track piece(10);
            for (std::size_t k = 0; k < 10; ++k) {
                for (const SlowVariable variable :
                     {SlowVariable::two_theta_A, SlowVariable::alpha}) {
                    piece.values(variable)[k] = whole.values(variable)[first + k];
                }
            }
            unwrapper.unwrap(piece);
            joined.append(piece);
        }
        AngleUnwrapper(0.3).unwrap(whole);
        QCOMPARE(joined.rows(), whole.rows());
        for (std::size_t k = 0; k < whole.rows(); ++k) {
            const double angle = whole.values(SlowVariable::two_theta_A)[k];
            const double same = joined.values(SlowVariable::two_theta_A)[k];
            QCOMPARE(std::isnan(same), std::isnan(angle));
            if (!std::isnan(angle)) {
                VYBEG_EQUAL(same, angle);
            }
            QCOMPARE(joined.values(SlowVariable::alpha)[k], whole.values(SlowVariable::alpha)[k]);
        }
    }
};

VYBEG_TEST(TestUnwrap)

}  // namespace test_unwrap

#include "test_unwrap.moc"
