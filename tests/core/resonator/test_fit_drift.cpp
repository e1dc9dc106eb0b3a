#include "tests/closeness.h"
#include "tests/core/resonator/known_resonator.h"
#include "tests/test_registry.h"

namespace test_fit_drift {

using namespace vybeg;
using namespace vybeg::test;
using std::numbers::pi;

class TestFitDrift : public QObject {
    Q_OBJECT

private slots:
    void aDriftIsFoundAndQIsFreeOfIt() {
        // 1 mHz over the run: drift * tau = 0.014, where a fit of constant frequency begins to
        // fail.
        FreeDecay decay = reference();
        decay.split_hz = 1e-6;
        for (const auto& angles : {std::vector<double>{15.0}, four_angles}) {
            std::vector<PhasorRun> runs = set_of(decay, angles, 1000, 1);
            for (PhasorRun& run : runs) {
                shift(run, 0, 1e-3 / 28);
            }
            const ResonatorFit fit = fitted(runs);
            QVERIFY(warns(fit, DiagnosticKind::frequency_drifts));
            QVERIFY(!warns(fit, DiagnosticKind::q_disagrees));
            for (const RunEstimate& run : fit.runs) {
                VYBEG_NEAR(run.drift_hz_per_s, 1e-3 / 28, 4, 1e-7);
                VYBEG_NEAR(run.q_envelope, pi * 5300 * 400, 5, 0.003 * pi * 5300 * 400);
                VYBEG_NEAR(run.direction_tau_s, 400, 5, 0.003 * 400);
            }
            if (angles.size() > 1) {
                VYBEG_NEAR(fit.resonator.q, pi * 5300 * 400, 5, 0.003 * pi * 5300 * 400);
            }
        }
    }

    void aSteadyFrequencyHasNoDrift() {
        for (std::uint64_t seed = 1; seed <= 10; ++seed) {
            const ResonatorFit fit = fitted(set_of(reference(), {0, 22.5}, 1000, seed));
            QVERIFY(!warns(fit, DiagnosticKind::frequency_drifts));
            QVERIFY(!warns(fit, DiagnosticKind::frequency_follows_amplitude));
            QVERIFY(!warns(fit, DiagnosticKind::q_disagrees));
            VYBEG_NEAR(fit.runs[0].drift_hz_per_s, 0, 4, 1e-7);
            QVERIFY(fit.resonator.frequency_per_power.reason.code == ReasonCode::not_nonlinear);
        }
    }

    void aFrequencyThatFollowsTheAmplitudeIsToldFromADrift() {
        // f = f_0 + b |z|^2 with b = 0.01 Hz per squared unit, amplitude 2, tau 30 s.
        FreeDecay decay = reference();
        decay.tau_s = 30;
        decay.a_A = 2;
        std::vector<PhasorRun> runs = set_of(decay, four_angles, 1000, 1);
        for (PhasorRun& run : runs) {
            for (std::size_t k = 0; k < run.c.size(); ++k) {
                const double integral = 4 * 15 * (1 - std::exp(-run.time_s[k] / 15));
                const auto turn = std::polar(1.0, 2 * pi * 0.01 * integral);
                run.c[k] *= turn;
                run.d[k] *= turn;
            }
        }
        const ResonatorFit fit = fitted(runs);
        QVERIFY(warns(fit, DiagnosticKind::frequency_follows_amplitude));
        VYBEG_NEAR(fit.resonator.frequency_per_power, 0.01, 4, 1e-4);
        VYBEG_NEAR(fit.resonator.tau_s, 30, 4, 0.01);
        QVERIFY(!warns(fit, DiagnosticKind::residual_above_noise));
    }

    // The frequency of runs that do not belong together bends with a cubic term, too.
    void aRunOfAnotherSplitIsNoCubicSpring() {
        FreeDecay decay = reference();
        decay.tau_s = 30;
        decay.split_hz = 0.3;
        decay.theta_w = 0.2;
        decay.damping_anisotropy_per_s = 0.002;
        decay.theta_tau = 0.5;
        for (const double other : {0.31, 0.3006, 0.5, 0.29}) {
            for (std::uint64_t seed = 1; seed <= 3; ++seed) {
                std::vector<PhasorRun> runs = set_of(decay, {8.6, 25.8, 43}, 1000, seed);
                FreeDecay last = decay;
                last.split_hz = other;
                runs.push_back(set_of(last, {-17.2}, 1000, 100 + seed).front());
                const ResonatorFit fit = fitted(runs);
                QVERIFY(!warns(fit, DiagnosticKind::frequency_follows_amplitude));
                QVERIFY(warns(fit, DiagnosticKind::recordings_differ) ||
                        warns(fit, DiagnosticKind::foreign_recording) ||
                        warns(fit, DiagnosticKind::foreign_among));
            }
        }
    }

    void onlyNumbersThatDifferAreNamed() {
        FreeDecay decay = reference();
        decay.split_hz = 1e-3;
        decay.theta_w = 0.2;
        std::vector<PhasorRun> runs;
        for (const double angle : {3.0, 21.0, 39.0, 57.0, 75.0}) {
            decay.tau_s = 100 / (1 + 0.01 * static_cast<double>(runs.size()) / 4);
            runs.push_back(set_of(decay, {angle}, 1000, 1 + runs.size()).front());
        }
        const ResonatorFit fit = fitted(runs);
        const Diagnostic* found = warning_of(fit, DiagnosticKind::recordings_differ);
        QVERIFY(found != nullptr);
        const QString text = QString::fromStdString(english(*found));
        QVERIFY2(text.contains("the decay rate by"), qPrintable(text));
        QVERIFY2(!text.contains("split") && !text.contains("gain"), qPrintable(text));
    }

    // Rates that a still wave does not see feign the drift; a fit that begins with them ends at a
    // rotation of 0.26 rad/s.
    void aSmallSplitDoesNotHideADrift() {
        FreeDecay decay = reference();
        decay.seconds = 14;
        decay.tau_s = 1659;
        decay.split_hz = 1.2e-4;
        decay.theta_w = -0.94;
        for (const double drift : {-2e-3, -0.95e-3, -0.3e-3, 0.3e-3, 0.95e-3, 2e-3}) {
            for (std::uint64_t seed = 1; seed <= 3; ++seed) {
                PhasorRun run = simulated_phasors(decay, 290, seed);
                shift(run, 0, drift);
                const ResonatorFit fit = fitted({run});
                QVERIFY(!warns(fit, DiagnosticKind::fit_not_converged));
                VYBEG_LESS(fit.chi2_per_dof, 1.25);
                QVERIFY(!fit.resonator.angle_rate_rad_s.given());
                VYBEG_NEAR(fit.runs[0].drift_hz_per_s, drift, 4, 1e-6);
            }
        }
    }

    void unequalAmplitudesOfACubicSpringConverge() {
        FreeDecay gyro = reference();
        gyro.rate_hz = 20024;
        gyro.split_hz = 4.74176e-4;
        gyro.theta_w = -1.30115;
        gyro.tau_s = 1051;
        gyro.damping_anisotropy_per_s = 1.627e-4;
        gyro.theta_tau = -0.84266;
        gyro.omega_rad_s = -4.4415e-4;
        gyro.frequency_per_power_hz = -0.015607;
        gyro.noise = 6.6e-4;
        struct Start {
            double seconds, two_theta_A, a_A, a_B;
        };
        for (std::uint64_t seed = 1; seed <= 2; ++seed) {
            std::vector<PhasorRun> runs;
            for (const Start& start : {Start{19.635, 1.19145, 1, 0},
                                       {12.539, 2.77829, 0.78846, 0},
                                       {12.539, 3.36711, 0.476477, -0.174768},
                                       {12.539, 0.301535, 1, 0}}) {
                FreeDecay decay = gyro;
                decay.seconds = start.seconds;
                decay.two_theta_A = start.two_theta_A;
                decay.a_A = start.a_A;
                decay.a_B = start.a_B;
                runs.push_back(moved_phasors(decay, 300, 10 * seed + runs.size()));
            }
            const ResonatorFit fit = fitted(runs);
            QVERIFY(!warns(fit, DiagnosticKind::fit_not_converged));
            VYBEG_LESS(fit.chi2_per_dof, 1.1);
            VYBEG_NEAR(fit.resonator.frequency_per_power, gyro.frequency_per_power_hz, 4, 3e-5);
            VYBEG_NEAR(fit.resonator.split_hz, gyro.split_hz, 4, 1e-6);
            VYBEG_NEAR(fit.resonator.kappa, 1, 4, 1e-3);
        }
    }

    void aStrangePhaseLeavesTheEnvelopeAlone() {
        // A frequency that wanders as no polynomial does: the coherent fit loses amplitude, the
        // envelope does not, and the difference is told.
        std::vector<PhasorRun> runs = set_of(reference(), {15}, 1000, 1);
        for (std::size_t k = 0; k < runs[0].c.size(); ++k) {
            const double t = runs[0].time_s[k] / 28;
            const auto turn = std::polar(1.0, 10 * std::pow(t, 4) * std::sin(3 * t));
            runs[0].c[k] *= turn;
            runs[0].d[k] *= turn;
        }
        const ResonatorFit fit = fitted(runs);
        // A phase that wanders in one half alone is no stationary noise.
        QVERIFY(warns(fit, DiagnosticKind::residual_coloured) ||
                warns(fit, DiagnosticKind::motion_not_model));
        const double q = pi * 5300 * 400;
        VYBEG_CLOSE_RATIO(fit.runs[0].q_envelope.value, q, 0.01);
        // What a fit stops at has no deviation.
        QVERIFY(warns(fit, DiagnosticKind::fit_not_converged));
        QVERIFY(fit.resonator.q.reason.code == ReasonCode::not_converged);
        QVERIFY(fit.runs[0].direction_f_hz.reason.code == ReasonCode::not_converged);
        QVERIFY(fit.modes.empty() && fit.no_modes.code == ReasonCode::not_converged);
    }
};

VYBEG_TEST(TestFitDrift, statistical, unsanitized)

}  // namespace test_fit_drift

#include "test_fit_drift.moc"
