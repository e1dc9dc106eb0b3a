#include "core/analysis/analyse.h"
#include "core/analysis/analysis.h"
#include "core/analysis/settings.h"
#include "core/estimators/wave/wave_formulas.h"
#include "core/simulation/simulate.h"
#include "core/track/track.h"
#include "tests/closeness.h"
#include "tests/statistical/simulated_recording.h"
#include "tests/test_registry.h"

#include <QtTest>

#include <numbers>

namespace test_cramer_rao {

using namespace vybeg;

namespace {

constexpr std::array variables{SlowVariable::a_A, SlowVariable::a_B, SlowVariable::two_theta_A,
                               SlowVariable::alpha, SlowVariable::f};

// METHOD section 6, as it is printed there.
std::array<double, 5> method_bound(const FreeDecay& wave, std::int64_t window) {
    const auto n = static_cast<double>(window);
    const double power = wave.a_A * wave.a_A + wave.a_B * wave.a_B;
    const double amplitude = wave.noise * std::sqrt(2 / n);
    const double angle =
        amplitude * std::sqrt(power) / std::abs(wave.a_A * wave.a_A - wave.a_B * wave.a_B);
    const double omega = wave.noise * wave.rate_hz * std::sqrt(24 / (power * n * (n * n - 1)));
    return {amplitude, amplitude, angle, angle, omega / (2 * std::numbers::pi)};
}

std::array<double, 5> exact_bound(const FreeDecay& wave, std::int64_t window) {
    // Averaged over the carrier's phase at the window, which runs through all values over a
    // recording.
    std::array<double, 5> variance{};
    constexpr int phases = 36;
    for (int k = 0; k < phases; ++k) {
        const WaveState state{wave.a_A, wave.a_B, wave.two_theta_A, k * std::numbers::pi / phases};
        const WaveErrors p =
            precision_bound(to_phasors(state), wave.f0_hz, wave.rate_hz, window, wave.noise);
        const std::array sds{p.a_A, p.a_B, p.two_theta_A, p.alpha, p.f_hz};
        for (std::size_t v = 0; v < 5; ++v) {
            variance[v] += sds[v] * sds[v] / phases;
        }
    }
    for (double& v : variance) {
        v = std::sqrt(v);
    }
    return variance;
}

}  // namespace

// The model: a still wave in white noise, 2000 windows or more; errors of each window against the
// simulator's truth. The standard deviation of a standard deviation over N windows is 1/sqrt(2N) of
// it: 1.6 % for 2000, 0.8 % for 8000; the bias of a mean is known to 2.2 % of the sd for 2000.
// The amplitudes' bias is that of any modulus in noise, s^2/2|u| for each of u+ and u-: it grows
// towards circular waves, and reaches 0.12 sd at n = 6, 20 dB, a_B = -0.5.
class TestCramerRao : public QObject {
    Q_OBJECT

private slots:
    void maximumLikelihoodReachesTheBound_data() {
        QTest::addColumn<int>("window");
        QTest::addColumn<double>("decibels");
        QTest::addColumn<double>("carrier");
        QTest::addColumn<double>("quadrature");
        QTest::addColumn<double>("angle");
        struct Wave {
            double f, a_B, angle;
        };
        const std::array waves{Wave{5300, 0.3, 0.3}, Wave{5300, -0.25, -2.0},
                               Wave{4321.987654321, 0.1, 1.5707},
                               Wave{7071.0678118654755, -0.2, 3.0}};
        for (const int n : {6, 22, 60, 600}) {
            for (const double decibels : {20.0, 40.0, 60.0, 80.0}) {
                for (const Wave& wave : waves) {
                    if (n * wave.f < 0.95 * 33333) {
                        continue;  // below one period the fit is not linear in noise of 20 dB
                    }
                    QTest::addRow("n = %d, %g dB, %g Hz, a_B = %g", n, decibels, wave.f, wave.a_B)
                        << n << decibels << wave.f << wave.a_B << wave.angle;
                }
            }
        }
    }

    void maximumLikelihoodReachesTheBound() {
        QFETCH(int, window);
        QFETCH(double, decibels);
        QFETCH(double, carrier);
        QFETCH(double, quadrature);
        QFETCH(double, angle);
        const std::int64_t windows = window == 600 ? 2000 : 8000;
        FreeDecay wave{.f0_hz = carrier,
                       .a_B = quadrature,
                       .two_theta_A = angle,
                       .noise = std::pow(10, -decibels / 20)};
        wave.seconds = static_cast<double>(windows * window + 1) / wave.rate_hz;
        wave.seed =
            static_cast<std::uint64_t>(window) * 1000 + static_cast<std::uint64_t>(decibels);

        Settings settings;
        settings.window = window;
        const Result<Analysis> analysis = analyse(test::simulated_recording(wave), settings, {});
        QVERIFY(analysis);
        const Result<Track> truth = true_track(wave, window);
        QVERIFY(truth);
        const Track& track = analysis->track;
        QCOMPARE(track.rows(), static_cast<std::size_t>(windows));

        // Off Snap, and at one period, the printed bound is not exact: METHOD section 6 leaves the
        // residual out.
        const bool printed = carrier == 5300;
        const std::array<double, 5> bound =
            printed ? method_bound(wave, window) : exact_bound(wave, window);
        const double tolerance = window >= 22 ? 0.05 : 0.15;
        for (std::size_t v = 0; v < variables.size(); ++v) {
            const auto found = track.values(variables[v]);
            const auto sds = track.sds(variables[v]);
            const auto exact = truth->values(variables[v]);
            double sum = 0;
            double squares = 0;
            double reported = 0;
            double count = 0;
            for (std::size_t k = 0; k < track.rows(); ++k) {
                if (track.flags()[k] != 0) {
                    continue;  // at 20 dB and n = 6 a few waves cannot be told from circular ones
                }
                count += 1;
                double error = found[k] - exact[k];
                if (variables[v] == SlowVariable::two_theta_A ||
                    variables[v] == SlowVariable::alpha) {
                    error = std::remainder(error, std::numbers::pi);
                }
                sum += error;
                squares += error * error;
                reported += sds[k] * sds[k];
            }
            VYBEG_AT_LEAST(count, 0.999 * static_cast<double>(windows));
            const double bias = sum / count;
            const double sd = std::sqrt(squares / count - bias * bias);
            const QString where = QString("%1: sd/bound %2, bias/sd %3, chi2 %4")
                                      .arg(info(variables[v]).column)
                                      .arg(sd / bound[v])
                                      .arg(bias / sd)
                                      .arg(squares / reported);
            VYBEG_CLOSE_RATIO(sd, bound[v], tolerance, qPrintable(where));
            VYBEG_CLOSE(bias, 0, 0.1 * sd, qPrintable(where));
            // The reported sd is right within 5 %: the squared errors over the reported variances.
            VYBEG_CLOSE(std::sqrt(squares / reported), 1, 0.05, qPrintable(where));
        }
    }
};

VYBEG_TEST(TestCramerRao)

}  // namespace test_cramer_rao

#include "test_cramer_rao.moc"
