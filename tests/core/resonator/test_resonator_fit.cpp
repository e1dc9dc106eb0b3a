#include "tests/closeness.h"
#include "tests/core/resonator/known_resonator.h"
#include "tests/test_registry.h"

#include <complex>

namespace test_resonator_fit {

using namespace vybeg;
using namespace vybeg::test;
using std::numbers::pi;

namespace {

FreeDecay rich() {
    FreeDecay decay = reference();
    decay.a_B = 0.02;
    decay.split_hz = 0.012;
    decay.theta_w = -0.2;
    decay.tau_s = 30;
    decay.damping_anisotropy_per_s = 0.002;
    decay.theta_tau = 0.3;
    decay.omega_rad_s = 0.08;
    return decay;
}

// The same motion seen by two pick-offs that are any two mixtures of c and d.
void mix(PhasorRun& run) {
    using Complex = std::complex<double>;
    for (std::size_t k = 0; k < run.c.size(); ++k) {
        const Complex c = run.c[k];
        const Complex d = run.d[k];
        run.c[k] = Complex{0.9, 0.3} * c + Complex{0.2, -0.5} * d;
        run.d[k] = Complex{-0.1, 0.4} * c + Complex{0.6, 0.1} * d;
    }
}

}  // namespace

class TestResonatorFit : public QObject {
    Q_OBJECT

private slots:
    void aSetGivesBackTheResonator() {
        const ResonatorFit fit = fitted(set_of(rich(), four_angles, 1000, 1));
        QVERIFY(fit.model == ResonatorModel::structured);
        const ResonatorEstimate& found = fit.resonator;
        VYBEG_NEAR(found.split_hz, 0.012, 4, 1e-6);
        VYBEG_NEAR(found.theta_w_rad, -0.2, 4, 1e-5);
        VYBEG_NEAR(found.tau_s, 30, 4, 1e-3);
        VYBEG_NEAR(found.q, pi * found.f_mean_hz.value * 30, 4, 20);
        VYBEG_NEAR(found.damping_anisotropy_per_s, 0.002, 4, 1e-5);
        VYBEG_NEAR(found.theta_tau_rad, 0.3, 4, 1e-3);
        VYBEG_NEAR(found.angle_rate_rad_s, -0.277 * 0.08, 4, 1e-5);
        // The mean of the offsets that set_of() gives.
        VYBEG_NEAR(found.f_mean_hz, 5300 + 0.013 * (1 - 0.8 * 1.5), 4, 1e-6);
        QVERIFY(fit.resonator.split_hz.given() && fit.resonator.theta_w_rad.given() &&
                fit.resonator.tau_s.given() && fit.resonator.damping_anisotropy_per_s.given() &&
                fit.resonator.theta_tau_rad.given() && fit.resonator.angle_rate_rad_s.given());
        VYBEG_CLOSE(fit.chi2_per_dof, 1, 0.05);
        QVERIFY(fit.warnings.empty());
        // Eigenvalues of the simulator's M.
        QCOMPARE(fit.modes.size(), std::size_t{2});
        VYBEG_MORE(fit.modes[0].f_hz.value, fit.modes[1].f_hz.value);
    }

    void theRunsComeBackWithTheirStarts() {
        const ResonatorFit fit = fitted(set_of(rich(), four_angles, 1000, 2));
        QCOMPARE(fit.runs.size(), std::size_t{4});
        for (std::size_t k = 0; k < 4; ++k) {
            const RunEstimate& run = fit.runs[k];
            VYBEG_NEAR(run.a_A, 1.0, 4, 1e-5);
            VYBEG_NEAR(run.a_B, 0.02, 4, 1e-5);
            const double two_theta = 2 * four_angles[k] * pi / 180;
            VYBEG_CLOSE(std::remainder(run.two_theta_A_rad.value - two_theta, pi), 0,
                        4 * run.two_theta_A_rad.sd);
            VYBEG_NEAR(run.split_sin_hz, 0.012 * std::sin(2 * two_theta + 0.8), 4, 1e-6);
            VYBEG_NEAR(run.f_offset_hz, -0.013 * 0.8 * (static_cast<double>(k) - 1.5), 4, 1e-6);
        }
    }

    void anyMixtureOfTheChannelsGivesTheModes() {
        std::vector<PhasorRun> runs = set_of(rich(), four_angles, 1000, 3);
        const ResonatorFit straight = fitted(runs);
        for (PhasorRun& run : runs) {
            mix(run);
        }
        const ResonatorFit fit = fitted(runs);
        QVERIFY(fit.model == ResonatorModel::free);
        QVERIFY(warns(fit, DiagnosticKind::structured_refused));
        QVERIFY(fit.resonator.split_hz.reason.code == ReasonCode::free_model);
        QCOMPARE(fit.modes.size(), std::size_t{2});
        for (std::size_t k = 0; k < 2; ++k) {
            VYBEG_NEAR(fit.modes[k].f_hz, straight.modes[k].f_hz.value, 4, 1e-5);
            VYBEG_NEAR(fit.modes[k].tau_s, straight.modes[k].tau_s.value, 4, 0.1);
        }
    }

    void aBellIsResolvedFromOneStrike() {
        FreeDecay bell = reference();
        bell.seconds = 6;
        bell.rate_hz = 44100;
        bell.f0_hz = 1020.4;
        bell.split_hz = 5.268;
        bell.tau_s = 0.83;
        bell.damping_anisotropy_per_s = 0.09;
        bell.noise = 1e-2;
        std::vector<PhasorRun> runs = set_of(bell, {20}, 500, 4);
        mix(runs[0]);
        const ResonatorFit fit = fitted(runs);
        QVERIFY(fit.model == ResonatorModel::free);
        QCOMPARE(fit.modes.size(), std::size_t{2});
        const double offset = 0.013;
        VYBEG_NEAR(fit.modes[0].f_hz, 1020.4 + offset + 2.634, 4, 1e-3);
        VYBEG_NEAR(fit.modes[1].f_hz, 1020.4 + offset - 2.634, 4, 1e-3);
        VYBEG_NEAR(fit.modes[0].tau_s, 1 / (1 / 0.83 + 0.045), 4, 1e-3);
        VYBEG_NEAR(fit.modes[1].tau_s, 1 / (1 / 0.83 - 0.045), 4, 1e-3);
    }

    void referencePhaseAndScaleDoNotMatter() {
        std::vector<PhasorRun> runs = set_of(rich(), four_angles, 1000, 5);
        const ResonatorFit before = fitted(runs);
        for (PhasorRun& run : runs) {
            // So little that the windows' means do not notice.
            shift(run, 1e-4);
            run.f_ref_hz -= 1e-4;
            for (std::size_t k = 0; k < run.c.size(); ++k) {
                run.c[k] *= std::polar(3e4, 1.1);
                run.d[k] *= std::polar(3e4, 1.1);
                run.sd[k] *= 3e4;
            }
        }
        std::swap(runs[0], runs[3]);
        const ResonatorFit after = fitted(runs);
        // To a thousandth of the deviations: that far the fit converges.
        const auto same = [](const Estimate& one, const Estimate& other, double factor = 1) {
            VYBEG_WITHIN(one.value * factor, other.value, 2e-3 * other.sd);
            VYBEG_CLOSE_RATIO(one.sd * factor, other.sd, 1e-4);
        };
        same(before.resonator.f_mean_hz, after.resonator.f_mean_hz);
        same(before.resonator.split_hz, after.resonator.split_hz);
        same(before.resonator.theta_w_rad, after.resonator.theta_w_rad);
        same(before.resonator.tau_s, after.resonator.tau_s);
        same(before.resonator.angle_rate_rad_s, after.resonator.angle_rate_rad_s);
        same(before.runs[0].a_A, after.runs[3].a_A, 3e4);
        same(before.runs[1].a_B, after.runs[1].a_B, 3e4);
        same(before.runs[2].split_sin_hz, after.runs[2].split_sin_hz);
    }

    void gapsDoNotMatter() {
        std::vector<PhasorRun> runs = set_of(rich(), four_angles, 500, 6);
        for (PhasorRun& run : runs) {
            // A long gap, single windows missing, and one that is not a number.
            PhasorRun left{run.f_ref_hz, run.window_s, {}, {}, {}, {}};
            for (std::size_t k = 0; k < run.c.size(); ++k) {
                if ((k > 400 && k < 900) || k % 7 == 3) {
                    continue;
                }
                left.time_s.push_back(run.time_s[k]);
                left.c.push_back(run.c[k]);
                left.d.push_back(k == 5 ? std::nan("") : run.d[k]);
                left.sd.push_back(run.sd[k]);
            }
            run = left;
        }
        const ResonatorFit fit = fitted(runs);
        VYBEG_NEAR(fit.resonator.split_hz, 0.012, 4, 1e-6);
        VYBEG_NEAR(fit.resonator.theta_w_rad, -0.2, 4, 1e-5);
        VYBEG_NEAR(fit.resonator.tau_s, 30, 4, 2e-3);
        QVERIFY(fit.warnings.empty());
    }

    void longWindowsDoNotMatter() {
        // The beat turns by a tenth of a turn within one window: its mean is modelled, not
        // neglected.
        FreeDecay decay = rich();
        decay.split_hz = 1;
        const ResonatorFit fit = fitted(set_of(decay, four_angles, 6667, 7));
        VYBEG_NEAR(fit.resonator.split_hz, 1.0, 4, 1e-5);
        VYBEG_NEAR(fit.runs[1].a_A, 1.0, 4, 1e-4);
        VYBEG_NEAR(fit.runs[1].a_B, 0.02, 4, 1e-4);
        VYBEG_CLOSE(fit.chi2_per_dof, 1, 0.2);
    }

    void thePredictionIsWithinTheNoise() {
        std::vector<PhasorRun> runs = set_of(rich(), {10, 30}, 500, 8);
        shift(runs[1], 0, 1e-3);
        const ResonatorFit fit = fitted(runs);
        for (std::size_t run = 0; run < 2; ++run) {
            double sum = 0;
            const std::vector<Phasors> predicted =
                predicted_phasors(fit.motion, run, runs[run].time_s);
            for (std::size_t k = 0; k < runs[run].c.size(); ++k) {
                const Phasors& z = predicted[k];
                sum += std::norm(z.c - runs[run].c[k]) + std::norm(z.d - runs[run].d[k]);
            }
            const double rms = std::sqrt(sum / (4 * static_cast<double>(runs[run].c.size())));
            VYBEG_CLOSE_RATIO(rms, runs[run].sd[0], 0.05);
        }
    }

    void theSameDataGiveTheSameBits() {
        const std::vector<PhasorRun> runs = set_of(rich(), {0, 22.5}, 1000, 9);
        const ResonatorFit one = fitted(runs);
        const ResonatorFit other = fitted(runs);
        QVERIFY(one.raw.values == other.raw.values);
        QVERIFY(one.raw.covariance == other.raw.covariance);
        QCOMPARE(one.raw.covariance.size(), one.raw.names.size() * one.raw.names.size());
        QCOMPARE(one.raw.names.front(), std::string("split_cos4_hz"));
    }

    void excessResidualsEnlargeTheDeviations() {
        std::vector<PhasorRun> runs = set_of(rich(), four_angles, 1000, 10);
        const ResonatorFit before = fitted(runs);
        for (PhasorRun& run : runs) {
            for (double& sd : run.sd) {
                sd /= 3;
            }
        }
        const ResonatorFit after = fitted(runs);
        QVERIFY(warns(after, DiagnosticKind::residual_above_noise));
        VYBEG_CLOSE(after.chi2_per_dof, 9, 0.5);
        VYBEG_CLOSE_RATIO(after.resonator.split_hz.sd, before.resonator.split_hz.sd, 0.05);
        QVERIFY(after.model == ResonatorModel::structured);
    }

    // A wave near one mode's axis: merged windows of a fifth of a second would show the other mode
    // at its alias, 4.7 Hz at 0.43.
    void aWeakModeIsNoAlias() {
        int given = 0;
        int sets = 0;
        for (const double split : {2.3, 4.7, 5.3}) {
            for (const double beside_deg : {-4.0, 2.5}) {
                for (const double axis_deg : {0.0, 45.0}) {
                    FreeDecay gyro = reference();
                    gyro.split_hz = split;
                    gyro.theta_w = 0.2;
                    gyro.damping_anisotropy_per_s = 2e-4;
                    const double theta = 0.2 * 180 / std::numbers::pi + axis_deg + beside_deg;
                    const ResonatorFit fit =
                        fitted(set_of(gyro, {theta}, 500, static_cast<std::uint64_t>(++sets)));
                    QVERIFY(fit.model == ResonatorModel::structured);
                    if (fit.resonator.split_hz.given()) {
                        ++given;
                        VYBEG_NEAR(fit.resonator.split_hz, split, 5, 1e-4);
                    }
                }
            }
        }
        VYBEG_AT_LEAST(given, 0.9 * sets);
    }

    void whatCannotBeFittedSaysSo() {
        QVERIFY(fit_resonator({}, {}, {}).error().code == ErrorCode::fit_failed);
        std::vector<PhasorRun> runs = set_of(rich(), {0, 30}, 1000, 11);
        for (auto* values : {&runs[1].time_s, &runs[1].sd}) {
            values->resize(5);
        }
        runs[1].c.resize(5);
        runs[1].d.resize(5);
        const Error few = fit_resonator(runs, {}, {}).error();
        QVERIFY(few.code == ErrorCode::fit_too_few_windows);
        QCOMPARE(few.where, std::string("recording 2"));
        QCOMPARE(few.args, (std::vector<MessageArg>{"5", "8", "2"}));
        std::stop_source stop;
        stop.request_stop();
        const auto cancelled =
            fit_resonator(set_of(rich(), {0}, 1000, 12), {}, JobControl(stop.get_token()));
        QVERIFY(cancelled.error().code == ErrorCode::interrupted);
    }
};

VYBEG_TEST(TestResonatorFit)

}  // namespace test_resonator_fit

#include "test_resonator_fit.moc"
