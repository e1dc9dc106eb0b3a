#include "core/analysis/analyse.h"
#include "core/analysis/analysis.h"
#include "core/analysis/settings.h"
#include "core/simulation/simulate.h"
#include "core/track/events.h"
#include "core/track/track.h"
#include "tests/closeness.h"
#include "tests/largest_of.h"
#include "tests/statistical/simulated_recording.h"
#include "tests/test_registry.h"

#include <QtTest>

#include <numbers>

namespace test_demonstration {

using namespace vybeg;

// The article's case: 28 s at 33333 Hz, windows of 6 samples, 155,554 of them, against the
// simulator's truth.
class TestDemonstration : public QObject {
    Q_OBJECT

private slots:
    void initTestCase() {
        recording_ = test::simulated_recording(demo_decay());
        Result<Track> truth = true_track(demo_decay(), 6);
        QVERIFY(truth);
        truth_ = std::move(*truth);
    }

    void everyWindowAgreesWithTheTruth_data() {
        QTest::addColumn<Algorithm>("algorithm");
        QTest::addRow("conjugate gradient") << Algorithm::conjugate_gradient;
        QTest::addRow("maximum likelihood") << Algorithm::maximum_likelihood;
    }

    void everyWindowAgreesWithTheTruth() {
        QFETCH(Algorithm, algorithm);
        Settings settings;
        settings.algorithm = algorithm;
        settings.window = 6;
        const Result<Analysis> analysis = analyse(recording_, settings, {});
        QVERIFY(analysis);
        const Track& track = analysis->track;
        QCOMPARE(track.rows(), std::size_t{155554});

        std::size_t flagged = 0;
        for (const SlowVariable variable :
             {SlowVariable::a_A, SlowVariable::a_B, SlowVariable::two_theta_A, SlowVariable::f,
              SlowVariable::alpha, SlowVariable::delta_phi_CD}) {
            const double period =
                variable == SlowVariable::two_theta_A || variable == SlowVariable::alpha
                    ? std::numbers::pi
                : variable == SlowVariable::delta_phi_CD ? 2 * std::numbers::pi
                                                         : 1e300;
            double squares = 0;
            double variances = 0;
            double farthest = 0;
            flagged = 0;
            for (std::size_t k = 0; k < track.rows(); ++k) {
                if (track.flags()[k] != 0) {
                    ++flagged;
                    continue;
                }
                const double error =
                    std::remainder(track.values(variable)[k] - truth_.values(variable)[k], period);
                const double sd = track.sds(variable)[k];
                // Weighted, so that an instant at which a variable is hardly determined does not
                // rule the sum.
                squares += error * error / (sd * sd);
                variances += 1;
                farthest = test::largest_of({farthest, std::abs(error) / sd});
            }
            // sigma is that of the window's block, so that pulls are normal.
            const double scatter = std::sqrt(squares / variances);
            const QString where = QString("%1: pulls %2, farthest %3")
                                      .arg(info(variable).column)
                                      .arg(scatter)
                                      .arg(farthest);
            VYBEG_CLOSE(scatter, 1, 0.05, qPrintable(where));
        }
        VYBEG_LESS(flagged, track.rows() / 1000);
    }

    void theWaveSwingsAndTurnsThroughAnAxis() {
        Settings settings;
        settings.window = 60;
        const Result<Analysis> analysis = analyse(recording_, settings, {});
        QVERIFY(analysis);
        const auto a_A = analysis->track.values(SlowVariable::a_A);
        const auto a_B = analysis->track.values(SlowVariable::a_B);
        double largest = 0;
        for (std::size_t k = 0; k < a_A.size(); ++k) {
            largest = test::largest_of({largest, std::abs(a_B[k]) / a_A[k]});
        }
        VYBEG_MORE(largest, 0.2);

        const std::vector<Event> found = find_events(analysis->track);
        const Result<Track> truth = true_track(demo_decay(), 60);
        QVERIFY(truth);
        const std::vector<Event> expected = find_events(*truth);
        QVERIFY(!expected.empty());
        QCOMPARE(found.size(), expected.size());
        for (std::size_t k = 0; k < found.size(); ++k) {
            QVERIFY(!found[k].flag);
            QCOMPARE(found[k].direction, expected[k].direction);
            // Where 2theta_A moves by three standard deviations of a window, a crossing is known to
            // a part of that segment.
            VYBEG_CLOSE(found[k].time_s, expected[k].time_s, 0.05);
        }
    }

private:
    Recording recording_;
    Track truth_;
};

VYBEG_TEST(TestDemonstration)

}  // namespace test_demonstration

#include "test_demonstration.moc"
