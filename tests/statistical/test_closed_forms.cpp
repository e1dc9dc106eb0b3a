#include "core/analysis/analyse.h"
#include "core/analysis/analysis.h"
#include "core/analysis/settings.h"
#include "core/estimators/wave/estimator.h"
#include "core/numerics/control_chart.h"
#include "core/simulation/simulate.h"
#include "tests/closeness.h"
#include "tests/statistical/simulated_recording.h"
#include "tests/statistical/track_errors.h"
#include "tests/test_registry.h"

#include <QtTest>

#include <random>

namespace test_closed_forms {

using namespace vybeg;
using namespace vybeg::test;

namespace {

constexpr double limit = 4;

struct Count {
    double windows = 0;
    double unflagged = 0;
    double values = 0;  // in unflagged windows
    double beyond = 0;  // of those, more than `limit` of their deviations off
    double flagged_values = 0;
    double flagged_beyond = 0;
};

void count_errors(const Track& track, const Track& truth, Count& count) {
    for (std::size_t k = 0; k < track.rows(); ++k) {
        const auto harmless = static_cast<Flags>(Flag::no_quadrature);
        const Flags flags = track.flags()[k] & static_cast<Flags>(~harmless);
        count.windows += 1;
        count.unflagged += flags == 0 ? 1 : 0;
        for (const SlowVariable variable : variables_with_sd) {
            const double pull = error_of(track, truth, variable, k, k) / track.sds(variable)[k];
            if (std::isnan(pull)) {
                continue;
            }
            const double beyond = std::abs(pull) > limit ? 1 : 0;
            if (flags == 0) {
                count.values += 1;
                count.beyond += beyond;
            } else if (flags == static_cast<Flags>(Flag::leakage)) {
                count.flagged_values += 1;
                count.flagged_beyond += beyond;
            }
        }
    }
}

}  // namespace

// Algorithms 1 to 4 over waves drawn from all frequencies, angles, phases and quadratures of both
// signs, from samples: their standard deviations hold what the closed forms leave out. The residual
// leaves 2n - 5 degrees of freedom, and of values in Student's t a known share lies beyond four
// deviations.
class TestClosedForms : public QObject {
    Q_OBJECT

private slots:
    void errors_beyond_four_deviations_are_as_rare_as_the_noise_makes_them_data() {
        QTest::addColumn<Algorithm>("algorithm");
        QTest::addColumn<int>("n");
        QTest::addColumn<bool>("snap");
        for (const Algorithm algorithm : {Algorithm::in_phase, Algorithm::phase_shift,
                                          Algorithm::moving_axes, Algorithm::demodulation}) {
            for (const int n : {6, 7, 22, 60, 63, 150, 600}) {
                for (const bool snap : {false, true}) {
                    QTest::addRow("%s, %d%s", algorithm_name(algorithm).data(), n,
                                  snap ? ", snap" : "")
                        << algorithm << n << snap;
                }
            }
        }
    }
    void errors_beyond_four_deviations_are_as_rare_as_the_noise_makes_them() {
        QFETCH(Algorithm, algorithm);
        QFETCH(int, n);
        QFETCH(bool, snap);
        std::mt19937_64 random(static_cast<std::uint64_t>(n) * 7 + (snap ? 1 : 0));
        std::uniform_real_distribution<double> any(0, 1);
        Count count;
        for (std::uint64_t seed = 1; seed <= 12; ++seed) {
            FreeDecay wave;
            wave.f0_hz = std::max(4000 + 6000 * any(random), 1.05 * wave.rate_hz / n);
            wave.a_B = (seed % 2 == 0 ? 1 : -1) * 0.6 * any(random);
            wave.two_theta_A = 2 * std::numbers::pi * any(random);
            wave.alpha = 2 * std::numbers::pi * any(random);
            wave.noise = std::pow(10.0, -1 - 3 * any(random));
            wave.seconds = 400.0 * n / wave.rate_hz;
            wave.seed = seed;
            Settings settings;
            settings.algorithm = algorithm;
            settings.window = n;
            settings.snap = snap;
            settings.f0_hz = wave.f0_hz;
            const Result<Analysis> analysis = analyse(simulated_recording(wave), settings, {});
            QVERIFY(analysis);
            const Result<Track> truth = true_track(wave, analysis->plan.length);
            QVERIFY(truth);
            count_errors(analysis->track, *truth, count);
        }
        const double expected = student_beyond(limit, 2 * n - 5);
        const auto most = [expected](double values) {
            return expected * values + 5 * std::sqrt(expected * values) + 2;
        };
        const QString found = QString(
                                  "%1 of %2 values beyond, %3 expected; with leakage %4 of %5; "
                                  "%6 of %7 windows unflagged")
                                  .arg(count.beyond)
                                  .arg(count.values)
                                  .arg(expected * count.values)
                                  .arg(count.flagged_beyond)
                                  .arg(count.flagged_values)
                                  .arg(count.unflagged)
                                  .arg(count.windows);
        qInfo("%s", qPrintable(found));
        VYBEG_AT_MOST(count.beyond, most(count.values), qPrintable(found));
        VYBEG_AT_MOST(count.flagged_beyond, most(count.flagged_values), qPrintable(found));
    }

    void windows_of_whole_half_periods_are_not_flagged() {
        for (const Algorithm algorithm :
             {Algorithm::phase_shift, Algorithm::moving_axes, Algorithm::demodulation}) {
            FreeDecay wave;
            wave.f0_hz = wave.rate_hz * 10 / 63;  // 63 samples are 20 half-periods
            wave.a_B = -0.3;
            wave.noise = 1e-3;
            wave.seconds = 2;
            Settings settings;
            settings.algorithm = algorithm;
            settings.window = 63;
            const Result<Analysis> analysis = analyse(simulated_recording(wave), settings, {});
            QVERIFY(analysis);
            std::size_t leaking = 0;
            for (const Flags flags : analysis->track.flags()) {
                leaking += has(flags, Flag::leakage) ? 1 : 0;
            }
            VYBEG_EQUAL(leaking, 0,
                        qPrintable(QString("%1: %2 of %3")
                                       .arg(algorithm_name(algorithm).data())
                                       .arg(leaking)
                                       .arg(analysis->track.rows())));
        }
    }
};

VYBEG_TEST(TestClosedForms)

}  // namespace test_closed_forms

#include "test_closed_forms.moc"
