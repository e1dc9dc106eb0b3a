#include "core/estimators/wave/estimator.h"
#include "core/windows/window_plan.h"
#include "tests/closeness.h"
#include "tests/core/estimators/still_wave.h"
#include "tests/test_registry.h"

#include <QtTest>

#include <array>
#include <random>
#include <span>
#include <string>
#include <vector>

namespace test_exact_windows {

using namespace vybeg;
using vybeg::test::describe;
using vybeg::test::deviation;
using vybeg::test::Deviation;
using vybeg::test::StillWave;

namespace {

constexpr std::int64_t margin = 64;  // context for the quarter-period delay

// What each algorithm finds in the same samples, which cost more than the estimates.
template <std::size_t count>
std::array<WaveEstimate, count> estimates(const std::array<Algorithm, count>& algorithms,
                                          const StillWave& wave, std::int64_t n, double f0_hz) {
    std::vector<double> c;
    std::vector<double> d;
    const double centre = static_cast<double>(margin) + 0.5 * static_cast<double>(n - 1);
    wave.samples(n + 2 * margin, centre, c, d);
    const EstimatorOptions options{.length = n, .rate_hz = wave.rate_hz, .f0_hz = f0_hz};
    std::array<WaveEstimate, count> found;
    for (std::size_t k = 0; k < count; ++k) {
        make_estimator(algorithms[k], options)
            ->estimate({c, d, margin, n, n}, 0, std::span(found).subspan(k, 1));
    }
    return found;
}

WaveEstimate estimate(Algorithm algorithm, const StillWave& wave, std::int64_t n, double f0_hz) {
    return estimates(std::array{algorithm}, wave, n, f0_hz).front();
}

// The fits of all parameters.
constexpr std::array fits{Algorithm::conjugate_gradient, Algorithm::maximum_likelihood};

// Carriers of 4 to 9 kHz, commensurate and incommensurate with the rate; angles in every quadrant
// and near every axis; quadrature of both signs.
std::vector<StillWave> sweep() {
    std::mt19937_64 random(20260);
    std::uniform_real_distribution<double> angle(-std::numbers::pi, std::numbers::pi);
    std::vector<StillWave> waves;
    for (const double f : {4000.0, 4321.987654321, 5300.0, 33333.0 / 6,
                           33333.0 / std::numbers::pi / 2, 7071.0678118654755, 8999.99}) {
        for (const double a_B : {-0.9, -0.5, -0.01, 0.0, 1e-6, 0.3, 0.9}) {
            for (int quarter = -4; quarter <= 4; ++quarter) {
                for (const double aside : {0.0, 1e-3, 0.4}) {
                    StillWave wave;
                    wave.state = {1, a_B, quarter * std::numbers::pi / 4 + aside, angle(random)};
                    wave.f_hz = f;
                    waves.push_back(wave);
                }
            }
        }
    }
    return waves;
}

}  // namespace

// The model of these tests: no noise, constant slow variables. What is left is rounding (algorithms
// 5 and 6) or the window's residual of METHOD section 3 (algorithms 1 to 4).
class TestExactWindows : public QObject {
    Q_OBJECT

private slots:
    void fitsOfAllParametersAreExactToRounding_data() {
        QTest::addColumn<double>("periods");
        for (const double periods : {10.0, 31.7, 100.0, 1000.0}) {
            QTest::addRow("%g periods", periods) << periods;
        }
    }

    void fitsOfAllParametersAreExactToRounding() {
        QFETCH(double, periods);
        // Relative to a_A, in rad, relative to f.
        constexpr double tolerance = 1e-11;
        for (const StillWave& wave : sweep()) {
            const std::int64_t n = window_of_periods(periods, wave.f_hz, wave.rate_hz);
            // The search for the carrier is never exact: up to a fifth of the main lobe aside.
            const double aside =
                0.2 * wave.rate_hz / static_cast<double>(n) * std::sin(wave.state.alpha);
            const auto found = estimates(fits, wave, n, wave.f_hz + aside);
            for (std::size_t k = 0; k < fits.size(); ++k) {
                const Deviation off =
                    deviation(found[k].state, found[k].f_hz, wave.state, wave.f_hz);
                const std::string where =
                    std::string(algorithm_name(fits[k])) + " " + describe(wave, n);
                QVERIFY2(found[k].flags == 0,
                         (where + " flags " + flags_text(found[k].flags)).c_str());
                VYBEG_CLOSE(off.a_A, 0, tolerance, where.c_str());
                VYBEG_CLOSE(off.a_B, 0, tolerance, where.c_str());
                VYBEG_CLOSE(off.two_theta_A, 0, tolerance, where.c_str());
                VYBEG_CLOSE(off.f_hz, 0, tolerance * wave.f_hz, where.c_str());
                VYBEG_CLOSE(off.alpha, 0, 1e-10, where.c_str());
            }
        }
    }

    void fitsHoldFromFiveSamplesToAHundredThousand() {
        for (const std::int64_t n : {5, 6, 7, 9, 100000}) {
            for (const double f : {5300.0, 7071.0678118654755, 8999.99}) {
                for (const double a_B : {-0.7, 0.0, 0.4}) {
                    for (double angle = -3; angle < 3.1; angle += 0.7) {
                        const StillWave wave{{1, a_B, angle, 2 * angle}, f};
                        const auto found = estimates(fits, wave, n, f);
                        for (std::size_t k = 0; k < fits.size(); ++k) {
                            const Deviation off =
                                deviation(found[k].state, found[k].f_hz, wave.state, wave.f_hz);
                            const std::string where =
                                std::string(algorithm_name(fits[k])) + " " + describe(wave, n);
                            QVERIFY2(found[k].flags == 0, where.c_str());
                            // Five samples hold less than a period: rounding is magnified tenfold.
                            VYBEG_CLOSE(off.a_A, 0, 1e-11, where.c_str());
                            VYBEG_CLOSE(off.a_B, 0, 1e-11, where.c_str());
                            VYBEG_CLOSE(off.two_theta_A, 0, 1e-10, where.c_str());
                            VYBEG_CLOSE(off.f_hz, 0, 1e-10 * f, where.c_str());
                        }
                    }
                }
            }
        }
    }

    void closedFormsAreExactWhereTheResidualVanishes_data() {
        QTest::addColumn<Algorithm>("algorithm");
        for (const Algorithm algorithm : {Algorithm::in_phase, Algorithm::phase_shift,
                                          Algorithm::moving_axes, Algorithm::demodulation}) {
            QTest::addRow("%s", algorithm_name(algorithm).data()) << algorithm;
        }
    }

    void closedFormsAreExactWhereTheResidualVanishes() {
        QFETCH(Algorithm, algorithm);
        constexpr double tolerance = 1e-6;
        const bool in_phase = algorithm == Algorithm::in_phase;
        int tried = 0;
        for (StillWave wave : sweep()) {
            if (in_phase) {
                wave.state.a_B = 0;
            }
            // Move the carrier to the nearest one with whole half-periods in n samples.
            for (const std::int64_t n : {63, 315, 3150}) {
                const double half_periods =
                    std::round(2 * wave.f_hz / wave.rate_hz * static_cast<double>(n));
                wave.f_hz = half_periods / 2 * wave.rate_hz / static_cast<double>(n);
                VYBEG_LESS(orthogonality_residual(n, wave.f_hz, wave.rate_hz), 1e-8);
                const double aside =
                    0.05 * wave.rate_hz / static_cast<double>(n) * std::sin(wave.state.alpha);
                const WaveEstimate found = estimate(algorithm, wave, n, wave.f_hz + aside);
                const Deviation off = deviation(found.state, found.f_hz, wave.state, wave.f_hz);
                const std::string where = describe(wave, n);
                VYBEG_CLOSE(off.a_A, 0, tolerance, where.c_str());
                if (in_phase) {
                    QVERIFY(std::isnan(found.state.a_B) && has(found.flags, Flag::no_quadrature));
                } else {
                    VYBEG_CLOSE(off.a_B, 0, tolerance,
                                (where + " a_B " + std::to_string(found.state.a_B)).c_str());
                    QVERIFY2(wave.state.a_B == 0 ||
                                 std::signbit(found.state.a_B) == std::signbit(wave.state.a_B),
                             where.c_str());
                }
                VYBEG_CLOSE(off.two_theta_A, 0, tolerance, where.c_str());
                VYBEG_CLOSE(off.alpha, 0, 10 * tolerance, where.c_str());
                VYBEG_CLOSE(off.f_hz, 0, tolerance * wave.f_hz, where.c_str());
                ++tried;
            }
        }
        VYBEG_MORE(tried, 1000);
    }

    void closedFormsErrByNoMoreThanTheLeakage_data() {
        closedFormsAreExactWhereTheResidualVanishes_data();
    }

    void closedFormsErrByNoMoreThanTheLeakage() {
        QFETCH(Algorithm, algorithm);
        const bool in_phase = algorithm == Algorithm::in_phase;
        for (StillWave wave : sweep()) {
            if (in_phase) {
                wave.state.a_B = 0;
            }
            // The smallest a_B of moving axes is the root of a difference of powers: leakage enters
            // as its root.
            for (const std::int64_t n : {22, 44, 60, 601}) {
                const double residual = orthogonality_residual(n, wave.f_hz, wave.rate_hz);
                const WaveEstimate found = estimate(algorithm, wave, n, wave.f_hz);
                const Deviation off = deviation(found.state, found.f_hz, wave.state, wave.f_hz);
                const std::string where =
                    describe(wave, n) + " residual " + std::to_string(residual);
                // Leakage enters the powers, relative to a_A^2 + a_B^2; (a_A - |a_B|)^2 is a
                // difference of them, and its root is the worse the more circular the wave.
                const double leak = residual * (1 + wave.state.a_B * wave.state.a_B);
                const double bound =
                    std::min(2 * leak / (1 - std::abs(wave.state.a_B)), std::sqrt(leak)) + 1e-6;
                VYBEG_CLOSE(off.a_A, 0, bound, where.c_str());
                const double separation = 1 - wave.state.a_B * wave.state.a_B;
                if (!has(found.flags, Flag::circular)) {
                    VYBEG_CLOSE(off.two_theta_A, 0, 3 * residual / separation + 1e-6,
                                where.c_str());
                }
                if (!in_phase && std::abs(wave.state.a_B) > 2 * std::sqrt(residual)) {
                    QVERIFY2(std::signbit(found.state.a_B) == std::signbit(wave.state.a_B),
                             where.c_str());
                }
            }
        }
    }
};

VYBEG_TEST(TestExactWindows)

}  // namespace test_exact_windows

#include "test_exact_windows.moc"
