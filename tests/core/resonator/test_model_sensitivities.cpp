// Sensitivities to what the model does not hold, against fits to motions that have it: springs
// unlike along the axes and an eighth harmonic of the drift (TRUTH row 35).
#include "core/simulation/decay_motion.h"
#include "tests/closeness.h"
#include "tests/core/resonator/known_resonator.h"
#include "tests/test_registry.h"

namespace test_model_sensitivities {

using namespace vybeg;
using namespace vybeg::test;
using std::numbers::pi;
using Complex = std::complex<double>;

namespace {

constexpr std::int64_t window = 3333;

FreeDecay resonator() {
    FreeDecay decay = reference();
    decay.seconds = 20;
    decay.tau_s = 15;
    decay.split_hz = 4e-3;
    decay.theta_w = 0.2;
    decay.damping_anisotropy_per_s = 2e-3;
    decay.theta_tau = -0.1;
    decay.noise = 1e-4;
    return decay;
}

struct Effects {
    std::array<double, 2> springs_hz{};    // per power: cos and sin
    std::array<double, 2> eighth_rad_s{};  // likewise
};

// dz/dt of the linear motion and of the effects, written out in the channels c and d.
Eigen::Vector2cd slope(const FreeDecay& decay, const Effects& effects, const Eigen::Vector2cd& z) {
    const double c4 = std::cos(4 * decay.theta_w);
    const double s4 = std::sin(4 * decay.theta_w);
    const double ct = std::cos(4 * decay.theta_tau);
    const double st = std::sin(4 * decay.theta_tau);
    const double g = decay.damping_anisotropy_per_s / 2;
    const Complex i(0, 1);
    const Complex c = z[0];
    const Complex d = z[1];
    Eigen::Vector2cd rate(
        -c / decay.tau_s + i * pi * decay.split_hz * (c4 * c + s4 * d) - g * (ct * c + st * d),
        -d / decay.tau_s + i * pi * decay.split_hz * (s4 * c - c4 * d) - g * (st * c - ct * d));
    // A quartic potential r^4 cos 2phi of the rim's displacement r (cos phi, sin phi), averaged
    // over a period by eight instants.
    for (int k = 0; k < 8; ++k) {
        const Complex turn = std::polar(1.0, pi * k / 4);
        const double x = (c * turn).real();
        const double y = (d * turn).real();
        const double fx = effects.springs_hz[0] * 4 * x * x * x +
                          effects.springs_hz[1] * (6 * x * x * y + 2 * y * y * y);
        const double fy = effects.springs_hz[0] * -4 * y * y * y +
                          effects.springs_hz[1] * (2 * x * x * x + 6 * x * y * y);
        const Complex along = i * pi * std::conj(turn) / 8.0 * 2.0 / 3.0;
        rate += Eigen::Vector2cd(along * fx, along * fy);
    }
    const Complex u = std::conj(z[0] - i * z[1]) * (z[0] + i * z[1]);  // angle 4 theta_A
    const double eight_theta = 2 * std::arg(u);
    const double turning = effects.eighth_rad_s[0] * std::cos(eight_theta) +
                           effects.eighth_rad_s[1] * std::sin(eight_theta);
    rate += 2 * turning * Eigen::Vector2cd(-d, c);
    return rate;
}

std::vector<PhasorRun> runs_of(const FreeDecay& decay, const Effects& effects,
                               const std::vector<double>& angles) {
    std::vector<PhasorRun> runs;
    for (const double angle : angles) {
        FreeDecay run = decay;
        run.two_theta_A = 2 * angle * pi / 180;
        const double theta = run.two_theta_A;
        const Complex i(0, 1);
        Eigen::Vector2cd z(run.a_A * std::cos(theta) + i * run.a_B * std::sin(theta),
                           run.a_A * std::sin(theta) - i * run.a_B * std::cos(theta));
        double at = 0;
        runs.push_back(noisy_phasors(run, window, 1 + runs.size(), [&](std::int64_t, double t) {
            constexpr int steps = 20;
            const double h = (t - at) / steps;
            for (int k = 0; k < steps; ++k) {
                const Eigen::Vector2cd one = slope(run, effects, z);
                const Eigen::Vector2cd two = slope(run, effects, z + h / 2 * one);
                const Eigen::Vector2cd three = slope(run, effects, z + h / 2 * two);
                const Eigen::Vector2cd four = slope(run, effects, z + h * three);
                z += h / 6 * (one + 2 * two + 2 * three + four);
            }
            at = t;
            return z;
        }));
    }
    return runs;
}

}  // namespace

class TestModelSensitivities : public QObject {
    Q_OBJECT

private slots:
    void the_error_of_a_value_is_foretold_data() {
        QTest::addColumn<int>("source");
        QTest::addColumn<double>("size");
        QTest::addColumn<std::vector<double>>("angles");
        const std::vector<double> two{8.6, 31.1};
        const std::vector<double> four{5, 30, 50, 75};
        // So small that the runs still agree as a set.
        QTest::newRow("springs, two angles") << int{springs_error} << 4e-7 << two;
        QTest::newRow("springs, four angles") << int{springs_error} << 4e-7 << four;
        QTest::newRow("eighth harmonic, two angles") << int{eighth_error} << 4e-7 << two;
    }

    // Four angles show it: no linear motion joins them.
    void an_eighth_harmonic_at_four_angles_is_a_misfit_of_the_set() {
        Effects effects;
        effects.eighth_rad_s[0] = 2e-6;
        const ResonatorFit fit = fitted(runs_of(resonator(), effects, {5, 30, 50, 75}),
                                        {.model = FitOptions::Model::structured, .tolerance = {}});
        QVERIFY(fit.resonator.split_hz.reason.code == ReasonCode::set_refused);
    }

    // The sensitivity is that of the worst of all phases of the effect.
    void the_error_of_a_value_is_foretold() {
        QFETCH(int, source);
        QFETCH(double, size);
        QFETCH(std::vector<double>, angles);
        const FreeDecay decay = resonator();
        const FitOptions told{.model = FitOptions::Model::structured, .tolerance = {}};
        const ResonatorFit before = fitted(runs_of(decay, {}, angles), told);
        std::array<ResonatorFit, 2> after;
        for (std::size_t k = 0; k < 2; ++k) {
            Effects effects;
            (source == springs_error ? effects.springs_hz : effects.eighth_rad_s)[k] = size;
            after[k] = fitted(runs_of(decay, effects, angles), told);
        }
        int felt = 0;
        for (std::size_t k = 0; k < resonator_parameters.size(); ++k) {
            const ResonatorParameter& parameter = resonator_parameters[k];
            const Estimate& one = before.resonator.*parameter.member;
            // A spring changes the frequency itself.
            if (!one.given() || parameter.member == &ResonatorEstimate::f_mean_hz) {
                continue;
            }
            double squares = 0;
            for (const ResonatorFit& fit : after) {
                const Estimate& other = fit.resonator.*parameter.member;
                QVERIFY2(other.given(), (parameter.name + (": " + english(other.reason))).c_str());
                const double change = other.value - one.value;
                squares += std::pow(
                    parameter.period > 0 ? std::remainder(change, parameter.period) : change, 2);
            }
            const double expected =
                before.sensitivities[k][static_cast<std::size_t>(source)] * size;
            felt += expected > one.sd ? 1 : 0;
            VYBEG_CLOSE(std::sqrt(squares), expected, 0.1 * expected + 0.1 * one.sd,
                        qPrintable(QString("%1 (sd %2)").arg(parameter.name).arg(one.sd)));
        }
        VYBEG_AT_LEAST(felt, 2);
    }
};

VYBEG_TEST(TestModelSensitivities)

}  // namespace test_model_sensitivities

#include "test_model_sensitivities.moc"
