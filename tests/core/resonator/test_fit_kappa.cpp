#include "tests/core/resonator/known_resonator.h"

using namespace vybeg;
using namespace vybeg::test;

namespace {

// Turns by 90 degrees within the 28 s.
FreeDecay turning() {
    FreeDecay decay = reference();
    decay.omega_rad_s = std::numbers::pi / 2 / 28 / 0.277;
    return decay;
}

}  // namespace

class TestFitKappa : public QObject {
    Q_OBJECT

private slots:
    void aTurningWaveShowsTheGainRatio();
    void aSplitShowsItWithoutAnyAssumption();
    void aStillWaveDoesNot();
    void aDampingAnisotropyIsNotTakenForIt();
    void aBalancedPairIsLeftAsItIs();
    void channelsThatAreNoPairAreNotBalanced();
};

void TestFitKappa::aTurningWaveShowsTheGainRatio() {
    for (const double kappa : {1.01, 0.97}) {
        FreeDecay decay = turning();
        decay.kappa = kappa;
        for (const double split : {0.0, 1e-6, 1e-4}) {
            decay.split_hz = split;
            decay.theta_w = 0.3;
            const ResonatorFit fit = fitted(set_of(decay, {7}, 1000, 1));
            VYBEG_NEAR(fit.resonator.kappa, kappa, 4, 2.5e-5);
            QVERIFY(fit.model == ResonatorModel::structured);
            QVERIFY(fit.identifiable.kappa);
            QVERIFY(warns(fit, DiagnosticKind::kappa_assumes_equal_damping));
            QVERIFY(fit.resonator.damping_anisotropy_per_s.reason.code ==
                    ReasonCode::kappa_like_damping);
            VYBEG_NEAR(fit.runs[0].a_A, 1, 4, 1e-4);
        }
    }
}

void TestFitKappa::aSplitShowsItWithoutAnyAssumption() {
    FreeDecay decay = reference();
    decay.split_hz = 0.01;
    decay.theta_w = 0.2;
    decay.damping_anisotropy_per_s = 1e-4;
    decay.theta_tau = 0.1;
    decay.kappa = 1.01;
    const ResonatorFit fit = fitted(set_of(decay, four_angles, 1000, 1));
    QVERIFY(fit.model == ResonatorModel::structured);
    VYBEG_NEAR(fit.resonator.kappa, 1.01, 4, 1e-4);
    VYBEG_NEAR(fit.resonator.split_hz, 0.01, 4, 1e-6);
    VYBEG_NEAR(fit.resonator.theta_w_rad, 0.2, 4, 1e-4);
    VYBEG_NEAR(fit.resonator.damping_anisotropy_per_s, 1e-4, 4, 1e-5);
    QVERIFY(!warns(fit, DiagnosticKind::kappa_assumes_equal_damping));
    QVERIFY(!warns(fit, DiagnosticKind::structured_refused));
}

void TestFitKappa::aStillWaveDoesNot() {
    FreeDecay decay = reference();
    decay.kappa = 1.01;
    const ResonatorFit one = fitted(set_of(decay, {7}, 1000, 1));
    QVERIFY(one.resonator.kappa.reason.code == ReasonCode::kappa_still_wave);
    QVERIFY(!one.identifiable.kappa);
    const ResonatorFit set = fitted(set_of(decay, four_angles, 1000, 1));
    QVERIFY(!set.resonator.kappa.given());
}

void TestFitKappa::aDampingAnisotropyIsNotTakenForIt() {
    FreeDecay decay = turning();
    decay.damping_anisotropy_per_s = 2e-4;
    decay.theta_tau = 0.15;
    const ResonatorFit fit = fitted(set_of(decay, {7}, 1000, 1));
    QVERIFY(fit.resonator.kappa.reason.code == ReasonCode::kappa_like_damping);
    VYBEG_NEAR(fit.resonator.damping_anisotropy_per_s, 2e-4, 4, 1e-5);
    VYBEG_NEAR(fit.resonator.theta_tau_rad, 0.15, 4, 1e-2);
}

void TestFitKappa::aBalancedPairIsLeftAsItIs() {
    const ResonatorFit fit = fitted(set_of(turning(), {7}, 1000, 1));
    VYBEG_NEAR(fit.resonator.kappa, 1, 4, 1e-4);
    // And the rest has its own deviations, as with kappa known.
    VYBEG_NEAR(fit.resonator.damping_anisotropy_per_s, 0, 4, 1e-5);
}

void TestFitKappa::channelsThatAreNoPairAreNotBalanced() {
    FreeDecay decay = reference();
    decay.split_hz = 0.5;
    decay.theta_w = 0.2;
    decay.kappa = 2;
    const ResonatorFit fit = fitted(set_of(decay, four_angles, 1000, 1));
    QVERIFY(fit.model == ResonatorModel::free);
    QVERIFY(fit.resonator.kappa.reason.code == ReasonCode::free_model);
}

QTEST_GUILESS_MAIN(TestFitKappa)
#include "test_fit_kappa.moc"
