#include "core/analysis/analyse.h"
#include "core/analysis/analysis.h"
#include "core/analysis/settings.h"
#include "tests/closeness.h"
#include "tests/needed.h"
#include "tests/statistical/simulated_recording.h"
#include "tests/test_registry.h"

#include <QtTest>

namespace test_descent_convergence {

using namespace vybeg;

// The model: a still wave at 40 dB, every quadrant, both signs of a_B; conjugate gradient from the
// in-phase start values against maximum likelihood on the same windows.
namespace {

struct Outcome {
    std::int64_t windows = 0;
    std::int64_t converged = 0;
    std::int64_t elsewhere = 0;  // converged, but not to the same minimum
};

Outcome compare(const Recording& recording, Settings settings) {
    settings.algorithm = Algorithm::maximum_likelihood;
    const Analysis likelihood = test::needed(analyse(recording, settings, {}));
    settings.algorithm = Algorithm::conjugate_gradient;
    const Analysis descent = test::needed(analyse(recording, settings, {}));
    const auto least = likelihood.track.values(SlowVariable::rms);
    const auto reached = descent.track.values(SlowVariable::rms);
    Outcome outcome;
    for (std::size_t k = 0; k < least.size(); ++k) {
        ++outcome.windows;
        if (descent.track.flags()[k] == 0) {
            ++outcome.converged;
            // F, relative to itself.
            outcome.elsewhere +=
                std::abs(reached[k] * reached[k] / (least[k] * least[k]) - 1) > 1e-9;
        }
    }
    return outcome;
}

FreeDecay still_wave(double a_B, double angle, int window, std::int64_t windows) {
    FreeDecay wave{.a_B = a_B, .two_theta_A = angle, .noise = 0.01};
    wave.seconds = static_cast<double>(windows * window + 1) / wave.rate_hz;
    wave.seed = 17;
    return wave;
}

}  // namespace

class TestDescentConvergence : public QObject {
    Q_OBJECT

private slots:
    void inPhaseStartLeadsToTheSameMinimumAsMaximumLikelihood_data() {
        QTest::addColumn<int>("window");
        for (const int n : {6, 7, 22, 60, 600}) {
            QTest::addRow("n = %d", n) << n;
        }
    }

    void inPhaseStartLeadsToTheSameMinimumAsMaximumLikelihood() {
        QFETCH(int, window);
        Outcome total;
        for (const double a_B : {-0.8, -0.4, -0.05, 0.0, 0.3, 0.7}) {
            for (const double angle : {-2.9, -1.6, -0.785, 0.0, 0.4, 1.5708, 2.356}) {
                Settings settings;
                settings.window = window;
                const Outcome outcome = compare(test::simulated_recording(still_wave(
                                                    a_B, angle, window, window > 60 ? 50 : 500)),
                                                settings);
                total.windows += outcome.windows;
                total.converged += outcome.converged;
                total.elsewhere += outcome.elsewhere;
            }
        }
        const QString where = QString("%1 windows, %2 converged, %3 elsewhere")
                                  .arg(total.windows)
                                  .arg(total.converged)
                                  .arg(total.elsewhere);
        qInfo("%s", qPrintable(where));
        VYBEG_AT_LEAST(static_cast<double>(total.converged),
                       0.999 * static_cast<double>(total.windows), qPrintable(where));
        VYBEG_EQUAL(total.elsewhere, 0, qPrintable(where));
    }

    void startFromPreviousWindowLeadsThereToo() {
        Settings settings;
        settings.window = 22;
        settings.start = StartRule::previous;
        const Outcome outcome =
            compare(test::simulated_recording(still_wave(0.3, 1.2, 22, 3000)), settings);
        QCOMPARE(outcome.elsewhere, 0);
        VYBEG_AT_LEAST(outcome.converged, 2997);
    }

    void typedStartFarAwayIsFlaggedWhereItDoesNotArrive() {
        Settings settings;
        settings.window = 60;
        for (const double off_hz : {0.0, 100.0, 400.0, 2000.0}) {
            settings.initial = StartValues{{0.2, -0.1, 2.0, -3.0}, 5300 + off_hz};
            const Outcome outcome =
                compare(test::simulated_recording(still_wave(0.3, 1.2, 60, 500)), settings);
            VYBEG_EQUAL(outcome.elsewhere, 0,
                        qPrintable(QString("%1 Hz off: %2 of %3 converged elsewhere")
                                       .arg(off_hz)
                                       .arg(outcome.elsewhere)
                                       .arg(outcome.converged)));
        }
    }
};

VYBEG_TEST(TestDescentConvergence)

}  // namespace test_descent_convergence

#include "test_descent_convergence.moc"
