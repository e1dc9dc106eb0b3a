#include "tests/core/resonator/known_resonator.h"

using namespace vybeg;
using namespace vybeg::test;
using std::numbers::pi;

class TestFitDrift : public QObject {
    Q_OBJECT

private slots:
    void aDriftIsFoundAndQIsFreeOfIt();
    void aSteadyFrequencyHasNoDrift();
    void aFrequencyThatFollowsTheAmplitudeIsToldFromADrift();
    void aStrangePhaseLeavesTheEnvelopeAlone();
};

void TestFitDrift::aDriftIsFoundAndQIsFreeOfIt() {
    // 1 mHz over the run: drift * tau = 0.014, where a fit of constant frequency begins to fail.
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

void TestFitDrift::aSteadyFrequencyHasNoDrift() {
    for (std::uint64_t seed = 1; seed <= 10; ++seed) {
        const ResonatorFit fit = fitted(set_of(reference(), {0, 22.5}, 1000, seed));
        QVERIFY(!warns(fit, DiagnosticKind::frequency_drifts));
        QVERIFY(!warns(fit, DiagnosticKind::frequency_follows_amplitude));
        QVERIFY(!warns(fit, DiagnosticKind::q_disagrees));
        VYBEG_NEAR(fit.runs[0].drift_hz_per_s, 0, 4, 1e-7);
        QVERIFY(fit.resonator.frequency_per_power.reason.code == ReasonCode::not_nonlinear);
    }
}

void TestFitDrift::aFrequencyThatFollowsTheAmplitudeIsToldFromADrift() {
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

void TestFitDrift::aStrangePhaseLeavesTheEnvelopeAlone() {
    // A frequency that wanders as no polynomial does: the coherent fit loses amplitude, the
    // envelope does not, and the difference is told.
    std::vector<PhasorRun> runs = set_of(reference(), {15}, 1000, 1);
    for (std::size_t k = 0; k < runs[0].c.size(); ++k) {
        const double t = runs[0].time_s[k] / 28;
        const auto turn = std::polar(1.0, 6 * std::pow(t, 4) * std::sin(3 * t));
        runs[0].c[k] *= turn;
        runs[0].d[k] *= turn;
    }
    const ResonatorFit fit = fitted(runs);
    QVERIFY(warns(fit, DiagnosticKind::residual_coloured));
    const double q = pi * 5300 * 400;
    QVERIFY(std::abs(fit.runs[0].q_envelope.value / q - 1) < 0.01);
    if (fit.resonator.q.given() && std::abs(fit.resonator.q.value / q - 1) > 0.5) {
        QVERIFY(warns(fit, DiagnosticKind::q_disagrees));
    }
}

QTEST_GUILESS_MAIN(TestFitDrift)
#include "test_fit_drift.moc"
