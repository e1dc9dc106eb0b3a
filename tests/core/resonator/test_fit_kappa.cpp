// The gain ratio of the channels and what else they do to the resonator (TRUTH rows 4, 8, 14).
#include "tests/closeness.h"
#include "tests/core/resonator/known_resonator.h"
#include "tests/test_registry.h"

namespace test_fit_kappa {

using namespace vybeg;
using namespace vybeg::test;
using std::numbers::pi;

namespace {

// Turns by 90 degrees within the 28 s.
FreeDecay turning() {
    FreeDecay decay = reference();
    decay.omega_rad_s = pi / 2 / 28 / 0.277;
    return decay;
}

double pull(const Estimate& estimate, double truth, double period = 0) {
    double off = estimate.value - truth;
    if (period > 0) {
        off = std::remainder(off, period);
    }
    return off / estimate.uncertainty();
}

// Every resonator parameter that is given lies within 4.6 uncertainties of the truth; what is
// wrong.
QString faults(const ResonatorFit& fit, const FreeDecay& truth) {
    QString text;
    const auto check = [&](const char* name, const Estimate& estimate, double value,
                           double period = 0) {
        if (estimate.given() && !(std::abs(pull(estimate, value, period)) < 4.6)) {
            text += QString("%1: %2 +- %3 for %4; ")
                        .arg(name)
                        .arg(estimate.value)
                        .arg(estimate.uncertainty())
                        .arg(value);
        }
    };
    const ResonatorEstimate& found = fit.resonator;
    check("split", found.split_hz, truth.split_hz);
    check("theta_w", found.theta_w_rad, truth.theta_w, pi / 2);
    check("tau", found.tau_s, truth.tau_s);
    check("g", found.damping_anisotropy_per_s, truth.damping_anisotropy_per_s);
    check("theta_tau", found.theta_tau_rad, truth.theta_tau, pi / 2);
    check("rate", found.angle_rate_rad_s, -truth.bryan * truth.omega_rad_s);
    check("kappa", found.kappa, truth.kappa);
    return text;
}

}  // namespace

class TestFitKappa : public QObject {
    Q_OBJECT

private slots:
    // Row 4: kappa was set to 1 where it was not, and an anisotropy took its place.
    void a_gain_ratio_makes_no_anisotropy_and_no_rotation_data() {
        QTest::addColumn<double>("kappa");
        QTest::addColumn<double>("split");
        QTest::addColumn<double>("rotation");
        QTest::addColumn<int>("runs");
        for (const double kappa : {0.99, 0.997, 1.003, 1.01}) {
            for (const double split : {1e-7, 1e-5, 1e-3}) {
                for (const double rotation : {0.0, 0.0175, 0.2}) {
                    for (const int runs : {1, 4}) {
                        QTest::newRow(qPrintable(QString("kappa %1, %2 Hz, %3 rad/s, %4 runs")
                                                     .arg(kappa)
                                                     .arg(split)
                                                     .arg(rotation)
                                                     .arg(runs)))
                            << kappa << split << rotation << runs;
                    }
                }
            }
        }
    }

    void a_gain_ratio_makes_no_anisotropy_and_no_rotation() {
        QFETCH(double, kappa);
        QFETCH(double, split);
        QFETCH(double, rotation);
        QFETCH(int, runs);
        FreeDecay decay = reference();
        decay.kappa = kappa;
        decay.split_hz = split;
        decay.theta_w = 0.3;
        decay.omega_rad_s = rotation / (2 * decay.bryan);
        std::vector<double> angles{7, 29.5, 52, 74.5};
        angles.resize(static_cast<std::size_t>(runs));
        for (std::uint64_t seed = 1; seed <= 3; ++seed) {
            const ResonatorFit fit = fitted(set_of(decay, angles, 1000, seed));
            QVERIFY(fit.model == ResonatorModel::structured);
            QCOMPARE(faults(fit, decay), QString());
        }
    }

    void one_turned_run_tells_the_rotation_and_neither_anisotropy_nor_gain_ratio() {
        for (const double kappa : {1.01, 0.992}) {
            FreeDecay decay = turning();
            decay.kappa = kappa;
            for (const double split : {0.0, 1e-6, 1e-4}) {
                decay.split_hz = split;
                decay.theta_w = 0.3;
                const ResonatorFit fit = fitted(set_of(decay, {7}, 1000, 1));
                QVERIFY(fit.model == ResonatorModel::structured);
                VYBEG_NEAR(fit.resonator.angle_rate_rad_s, -decay.bryan * decay.omega_rad_s, 4,
                           1e-3);
                QVERIFY(!fit.resonator.damping_anisotropy_per_s.given());
                QCOMPARE(faults(fit, decay), QString());
            }
        }
    }

    // Told that the channels are equal, the same run tells the anisotropy.
    void a_told_gain_ratio_shows_the_anisotropy() {
        FreeDecay decay = turning();
        decay.damping_anisotropy_per_s = 2e-4;
        decay.theta_tau = 0.15;
        const ResonatorFit fit =
            fitted(set_of(decay, {7}, 1000, 1), {.tolerance = channels({{kappa_error, 1e-5}})});
        VYBEG_NEAR(fit.resonator.damping_anisotropy_per_s, 2e-4, 4, 2e-5);
        VYBEG_NEAR(fit.resonator.theta_tau_rad, 0.15, 4, 3e-2);
    }

    void a_split_shows_the_gain_ratio() {
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
        QVERIFY(!warns(fit, DiagnosticKind::structured_refused));
    }

    // Row 8: the gain ratio that is reported is the one that is kept.
    void the_passport_has_the_gain_ratio_of_the_result() {
        FreeDecay decay = reference();
        decay.split_hz = 0.03;
        decay.theta_w = 0.2;
        decay.kappa = 1.004;
        const ResonatorFit fit = fitted(set_of(decay, {10}, 500, 2));
        const auto name = std::ranges::find(fit.raw.names, "kappa");
        QVERIFY(name != fit.raw.names.end());
        const auto at = static_cast<std::size_t>(name - fit.raw.names.begin());
        QVERIFY(fit.resonator.kappa.given());
        QCOMPARE(fit.raw.values[at], fit.resonator.kappa.value);
        VYBEG_NEAR(fit.resonator.kappa, 1.004, 4, 1e-3);
    }

    // Row 14: what an error of the channels changes stands beside each parameter.
    void sensitivities_foretell_what_an_error_of_the_channels_changes() {
        FreeDecay decay = reference();
        decay.split_hz = 1e-3;
        decay.theta_w = 0.2;
        decay.damping_anisotropy_per_s = 2e-4;
        decay.theta_tau = -0.1;
        const std::vector<PhasorRun> ideal = set_of(decay, four_angles, 1000, 3);
        const FitOptions told{.tolerance = {}};
        const ResonatorFit before = fitted(ideal, told);
        struct Error {
            const char* name;
            ErrorSource source;
            double size;
            std::complex<double> (*of)(std::complex<double> c, std::complex<double> d, double x,
                                       double size);
        };
        const std::vector<Error> errors{
            {"skew", skew_error, 0.01,
             [](std::complex<double> c, std::complex<double> d, double, double size) {
                 return d + std::sin(size * pi / 180) * c;
             }},
            {"delay", delay_error, 1e-9,
             [](std::complex<double>, std::complex<double> d, double, double size) {
                 return d * std::polar(1.0, -2 * pi * 5300 * size);
             }},
            {"crosstalk", crosstalk_error, 1e-5,
             [](std::complex<double> c, std::complex<double> d, double, double size) {
                 return d + std::complex(0.0, size) * c;
             }},
            {"phase drift", phase_drift_error, 1e-5,
             [](std::complex<double>, std::complex<double> d, double x, double size) {
                 return d * std::polar(1.0, x * size);
             }},
            {"gain drift", gain_drift_error, 1e-5,
             [](std::complex<double>, std::complex<double> d, double x, double size) {
                 return d * (1 + x * size);
             }},
            {"pick-offs", pickoff_error, 1e-4,
             [](std::complex<double>, std::complex<double> d, double, double size) {
                 return d * (1 + size * std::norm(d));
             }},
            {"kappa", kappa_error, 1e-4,
             [](std::complex<double>, std::complex<double> d, double, double size) {
                 return d / (1 + size);
             }},
        };
        for (const Error& error : errors) {
            std::vector<PhasorRun> runs = ideal;
            for (PhasorRun& run : runs) {
                const double duration = run.time_s.back() + run.window_s / 2;
                for (std::size_t k = 0; k < run.d.size(); ++k) {
                    run.d[k] = error.of(run.c[k], run.d[k], run.time_s[k] / duration, error.size);
                    if (error.source == pickoff_error) {
                        run.c[k] *= 1 + error.size * std::norm(run.c[k]);
                    }
                }
            }
            const ResonatorFit after = fitted(runs, told);
            for (std::size_t k = 0; k < resonator_parameters.size(); ++k) {
                const Estimate& one = before.resonator.*resonator_parameters[k].member;
                const Estimate& other = after.resonator.*resonator_parameters[k].member;
                if (!one.given() || !other.given()) {
                    continue;
                }
                const double expected = before.sensitivities[k][error.source] * error.size;
                const double change = other.value - one.value;
                const double least = 0.02 * one.sd;
                VYBEG_CLOSE(change, expected, 0.05 * std::abs(expected) + least,
                            qPrintable(QString("%1, %2 (sd %3)")
                                           .arg(error.name, resonator_parameters[k].name)
                                           .arg(one.sd)));
            }
        }
    }

    // What the model holds at zero: a cubic spring below its test, damping by amplitude. The spring
    // turns elliptic waves.
    void sensitivities_foretell_what_an_effect_of_the_amplitude_changes() {
        struct Effect {
            ErrorSource source;
            double size;
            double FreeDecay::*of;
            double unit;  // of the simulator's number
        };
        FreeDecay decay = reference();
        decay.split_hz = 1e-3;
        decay.theta_w = 0.2;
        decay.damping_anisotropy_per_s = 2e-4;
        decay.theta_tau = -0.1;
        decay.a_B = 0.1;
        const double power = 1.01;
        const auto runs_of = [](FreeDecay of) {
            std::vector<PhasorRun> runs;
            for (const double angle : {8.6, 31.1}) {
                of.two_theta_A = 2 * angle * pi / 180;
                runs.push_back(moved_phasors(of, 2000, 1 + runs.size()));
            }
            return runs;
        };
        // Small enough to be a motion by power in both.
        decay.damping_per_power_per_s = 1e-12;
        const FitOptions told{.tolerance = {}};
        const ResonatorFit before = fitted(runs_of(decay), told);
        for (const Effect& effect :
             {Effect{cubic_error, 1e-5, &FreeDecay::frequency_per_power_hz, 1 / power},
              Effect{damping_error, 2e-3, &FreeDecay::damping_per_power_per_s,
                     1 / (power * decay.tau_s)}}) {
            FreeDecay with = decay;
            with.*effect.of = effect.size * effect.unit;
            const ResonatorFit after = fitted(runs_of(with), told);
            bool felt = false;
            for (std::size_t k = 0; k < resonator_parameters.size(); ++k) {
                const ResonatorParameter& parameter = resonator_parameters[k];
                const Estimate& one = before.resonator.*parameter.member;
                const Estimate& other = after.resonator.*parameter.member;
                // The spring changes the frequency itself.
                if (!one.given() || !other.given() ||
                    parameter.member == &ResonatorEstimate::f_mean_hz) {
                    continue;
                }
                const double expected = before.sensitivities[k][effect.source] * effect.size;
                const double least = 0.1 * one.sd;
                felt = felt || std::abs(expected) > one.sd;
                VYBEG_CLOSE(other.value - one.value, expected, 0.1 * std::abs(expected) + least,
                            qPrintable(QString("%1 (sd %2)").arg(parameter.name).arg(one.sd)));
            }
            QVERIFY(felt);
        }
    }

    // Pick-offs alike, whose gain falls with the amplitude, change the decay of each mode as told.
    void modes_have_the_sensitivity_to_the_pickoffs() {
        constexpr double share = 1e-3;
        FreeDecay decay = reference();
        decay.split_hz = 1e-2;
        decay.theta_w = 0.2;
        decay.damping_anisotropy_per_s = 2e-4;
        decay.theta_tau = -0.1;
        const std::vector<PhasorRun> runs = set_of(decay, four_angles, 1000, 4);
        std::vector<PhasorRun> bent = runs;
        double most = 0;
        for (const PhasorRun& run : runs) {
            for (std::size_t k = 0; k < run.c.size(); ++k) {
                most = std::max(most, std::norm(run.c[k]) + std::norm(run.d[k]));
            }
        }
        for (PhasorRun& run : bent) {
            for (std::vector<std::complex<double>>* channel : {&run.c, &run.d}) {
                for (std::complex<double>& each : *channel) {
                    each *= 1 + share * std::norm(each) / most;
                }
            }
        }
        const FitOptions told{.tolerance = {}};
        const ResonatorFit before = fitted(runs, told);
        const ResonatorFit after = fitted(bent, told);
        QCOMPARE(before.modes.size(), std::size_t{2});
        QCOMPARE(after.modes.size(), std::size_t{2});
        for (std::size_t k = 0; k < 2; ++k) {
            const Estimate& one = before.modes[k].tau_s;
            QCOMPARE(before.modes[k].sensitivities.size(), mode_parameters.size());
            const double expected = share * before.modes[k].sensitivities[1][pickoff_error];
            VYBEG_LESS(3 * one.sd, std::abs(expected));
            VYBEG_CLOSE(after.modes[k].tau_s.value - one.value, expected,
                        0.1 * std::abs(expected) + 0.1 * one.sd);
        }
    }

    // Row 14: with a tolerance the combined uncertainty holds the error.
    void a_tolerance_holds_the_error() {
        FreeDecay decay = reference();
        decay.split_hz = 1e-3;
        decay.theta_w = 0.2;
        std::vector<PhasorRun> runs = set_of(decay, four_angles, 1000, 4);
        for (PhasorRun& run : runs) {
            for (std::complex<double>& d : run.d) {
                d *= std::polar(1.0, -2 * pi * 5300 * 0.01 / 33333);
            }
        }
        const ResonatorFit alone = fitted(runs);
        VYBEG_MORE(std::abs(alone.resonator.angle_rate_rad_s.value),
                   20 * alone.resonator.angle_rate_rad_s.sd);
        const ResonatorFit told =
            fitted(runs, {.tolerance = channels({{kappa_error, 0.01}, {delay_error, 0.01}})});
        QVERIFY(told.model == ResonatorModel::structured);
        VYBEG_CLOSE(told.resonator.angle_rate_rad_s.value, 0,
                    4 * told.resonator.angle_rate_rad_s.uncertainty());
        VYBEG_LESS(told.resonator.angle_rate_rad_s.sd, told.resonator.angle_rate_rad_s.u);
    }

    // Frequencies belong to the power of the wave, not to that of the recorded channels.
    void a_gain_ratio_leaves_the_frequency_of_a_cubic_spring() {
        for (const double kappa : {1.0, 0.99, 1.005}) {
            for (std::uint64_t seed = 1; seed <= 4; ++seed) {
                FreeDecay decay = reference();
                decay.tau_s = 40;
                decay.split_hz = 1e-3;
                decay.kappa = kappa;
                decay.frequency_per_power_hz = 5e-3;
                std::vector<PhasorRun> runs;
                double f_mean_hz = 0;
                for (const double angle : four_angles) {
                    // So few windows are not merged: their power is that of the fit.
                    decay.two_theta_A = 2 * angle * pi / 180;
                    decay.a_A = runs.size() == 1 ? 0.6 : 1;
                    runs.push_back(moved_phasors(decay, 6500, 10 * seed + runs.size()));
                    double power = 0;
                    double square = 0;
                    for (std::size_t k = 0; k < runs.back().c.size(); ++k) {
                        const double at =
                            std::norm(runs.back().c[k]) + std::norm(kappa * runs.back().d[k]);
                        power += at;
                        square += at * at;
                    }
                    f_mean_hz += (decay.f0_hz + 5e-3 * square / power) / 4;
                }
                const ResonatorFit fit = fitted(runs);
                VYBEG_NEAR(fit.resonator.frequency_per_power, 5e-3, 4.6, 1e-4);
                VYBEG_NEAR(fit.resonator.f_mean_hz, f_mean_hz, 4.6, 1e-5);
            }
        }
    }

    void channels_that_are_no_pair_are_not_balanced() {
        FreeDecay decay = reference();
        decay.split_hz = 0.5;
        decay.theta_w = 0.2;
        decay.kappa = 2;
        const ResonatorFit fit = fitted(set_of(decay, four_angles, 1000, 1));
        QVERIFY(fit.model == ResonatorModel::free);
        QVERIFY(fit.resonator.kappa.reason.code == ReasonCode::free_model);
    }

    // Any two projections have modes; the wave's amplitudes and angle are those of a calibrated
    // pair.
    void waves_of_the_free_model_hold_the_gain_ratio() {
        FreeDecay decay = reference();
        decay.split_hz = 0.5;
        decay.theta_w = 0.2;
        decay.a_B = 0.05;
        const FitOptions options{.model = FitOptions::Model::free};
        for (const double kappa : {0.985, 0.993, 1.007, 1.015}) {
            decay.kappa = kappa;
            const ResonatorFit fit = fitted(set_of(decay, four_angles, 1000, 1), options);
            QVERIFY(fit.model == ResonatorModel::free);
            double most = 0;  // standard deviations by which the wave is off
            for (std::size_t k = 0; k < fit.runs.size(); ++k) {
                const RunEstimate& run = fit.runs[k];
                const double two_theta = 2 * four_angles[k] * pi / 180;
                for (const auto& [found, truth] : {std::pair(&run.a_A, decay.a_A),
                                                   {&run.a_B, decay.a_B},
                                                   {&run.two_theta_A_rad, two_theta}}) {
                    const double off = std::remainder(found->value - truth, pi);
                    VYBEG_LESS(std::abs(off), 3 * found->u);
                    most = std::max(most, std::abs(off) / found->sd);
                }
            }
            VYBEG_MORE(most, 50);
            for (const ModeEstimate& mode : fit.modes) {
                VYBEG_CLOSE_RATIO(mode.f_hz.uncertainty(), mode.f_hz.sd, 0.01);
            }
        }
    }
};

VYBEG_TEST(TestFitKappa, statistical, unsanitized)

}  // namespace test_fit_kappa

#include "test_fit_kappa.moc"
