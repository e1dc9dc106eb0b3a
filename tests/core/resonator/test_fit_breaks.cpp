// What happens at an instant of a recording, found in the residual, given parameters of its own,
// and named (TRUTH rows 16 and 32, principles 4 and 8): lost samples that the recording's own check
// does not see, an amplifier that changes its range, a knock.
#include "core/resonator/runs/wave_motion.h"
#include "tests/closeness.h"
#include "tests/core/resonator/known_resonator.h"
#include "tests/test_registry.h"

namespace test_fit_breaks {

using namespace vybeg;
using namespace vybeg::test;
using std::numbers::pi;

namespace {

// All windows after the instant turn; that over it by the share of it that comes after.
void step_at(PhasorRun& run, double at_s, double step_rad) {
    for (std::size_t k = 0; k < run.c.size(); ++k) {
        const double share = std::clamp((run.time_s[k] - at_s) / run.window_s + 0.5, 0.0, 1.0);
        const auto turn = 1.0 - share + share * std::polar(1.0, step_rad);
        run.c[k] *= turn;
        run.d[k] *= turn;
    }
}

// Gains of C and D after the instant, relative to those before.
void gains_at(PhasorRun& run, double at_s, double gain_c, double gain_d) {
    for (std::size_t k = 0; k < run.c.size(); ++k) {
        const double share = std::clamp((run.time_s[k] - at_s) / run.window_s + 0.5, 0.0, 1.0);
        run.c[k] *= 1 + share * gain_c;
        run.d[k] *= 1 + share * gain_d;
    }
}

// A knock that adds `change` to the wave of the run that started as `decay`.
void knock_at(PhasorRun& run, const FreeDecay& decay, double at_s, double offset_hz,
              const Eigen::Vector2cd& change) {
    const SlowMotion motion(decay);
    for (std::size_t k = 0; k < run.c.size(); ++k) {
        const double t = run.time_s[k];
        const double share = std::clamp((t - at_s) / run.window_s + 0.5, 0.0, 1.0);
        if (share > 0) {
            const Eigen::Vector2cd z = share * std::polar(1.0, 2 * pi * offset_hz * t) *
                                       (motion.propagator(t - at_s) * change);
            run.c[k] += z[0];
            run.d[k] += z[1] / decay.kappa;
        }
    }
}

// The phasors of a recording in which samples are missing (negative: doubled) at a share of it.
PhasorRun cut(const FreeDecay& gyro, std::int64_t window, std::uint64_t seed, double share,
              int samples) {
    DecayMotion motion(gyro);
    const auto place = static_cast<std::int64_t>(share * gyro.seconds * gyro.rate_hz);
    return noisy_phasors(gyro, window, seed, [&](std::int64_t first, double) {
        Eigen::Vector2cd z = Eigen::Vector2cd::Zero();
        for (std::int64_t frame = first; frame < first + window; ++frame) {
            const auto at = static_cast<double>(frame + (frame < place ? 0 : samples));
            const double turns = gyro.f0_hz * static_cast<double>(frame) / gyro.rate_hz;
            z += motion.at_frame(at) *
                 std::polar(1 / static_cast<double>(window), -2 * pi * std::remainder(turns, 1.0));
        }
        return z;
    });
}

}  // namespace

class TestFitBreaks : public QObject {
    Q_OBJECT

private slots:
    void a_step_is_found_named_and_left_open() {
        std::uint64_t seed = 0;
        for (const double split_hz : {1e-6, 1e-3, 0.03}) {
            for (const std::vector<double>& angles :
                 {std::vector<double>{20}, {8.6, 53.6}, four_angles}) {
                for (const double step_rad : {-0.25, -0.08, 0.02, 0.12}) {
                    check(split_hz, angles, step_rad, split_hz < 1e-2 ? 11.3 : 17.77, ++seed);
                }
            }
        }
    }

    void two_steps_are_found() {
        FreeDecay gyro = reference();
        gyro.split_hz = 1e-3;
        std::vector<PhasorRun> runs = set_of(gyro, four_angles, 500, 3);
        step_at(runs[1], 6.1, 0.1);
        step_at(runs[3], 20.04, -0.05);
        const ResonatorFit fit = fitted(runs);
        QCOMPARE(fit.breaks.size(), std::size_t{2});
        VYBEG_LESS(fit.chi2_per_dof, 1.2);
        VYBEG_NEAR(fit.resonator.split_hz, gyro.split_hz, 4.5, 1e-6);
    }

    // 19 samples lost: a step of 0.137 rad, and a beat that goes on later by as much.
    void the_number_of_samples_shows_beside_a_split() {
        struct Case {
            double split_hz;
            int samples;
        };
        for (const auto& [split_hz, samples] : {Case{0.3, 25}, {1.8, 19}}) {
            FreeDecay gyro = reference();
            gyro.split_hz = split_hz;
            gyro.theta_w = 0.3;
            gyro.seconds = 12;
            const PhasorRun run = cut(gyro, 200, 1, 0.43, samples);
            const ResonatorFit fit = fitted({run});
            const QString what = QString("split %1, %2 samples: chi^2/dof %3")
                                     .arg(split_hz)
                                     .arg(samples)
                                     .arg(fit.chi2_per_dof);
            VYBEG_EQUAL(fit.breaks.size(), 1, qPrintable(what));
            QCOMPARE(std::lround(fit.breaks[0].shift_s * run.rate_hz), samples);
            VYBEG_LESS(fit.chi2_per_dof, 1.2, qPrintable(what));
            VYBEG_NEAR(fit.resonator.split_hz, split_hz, 4.5, 1e-4);
            VYBEG_NEAR(fit.resonator.f_mean_hz, gyro.f0_hz, 4.5, 1e-4);
        }
    }

    void a_step_near_an_end_leaves_the_numbers_right() {
        for (const double where : {0.003, 0.007, 0.013, 0.985, 0.992}) {
            FreeDecay gyro = reference();
            gyro.split_hz = 1e-3;
            std::vector<PhasorRun> runs = set_of(gyro, four_angles, 500, 5);
            step_at(runs[2], where * 28, 0.137);
            const ResonatorFit fit = fitted(runs);
            const QString what = QString("at %1: chi^2/dof %2").arg(where).arg(fit.chi2_per_dof);
            VYBEG_LESS(fit.chi2_per_dof, 1.2, qPrintable(what));
            QVERIFY2(warns(fit, DiagnosticKind::fitted_phase_step), qPrintable(what));
            VYBEG_NEAR(fit.resonator.split_hz, gyro.split_hz, 4.5, 1e-6);
            VYBEG_NEAR(fit.resonator.tau_s, 400, 4.5, 1);
        }
    }

    // Both channels alike in the first seconds; later, or of one channel, it is an amplifier's.
    void a_drive_that_ends_is_named_beside_an_amplifier() {
        for (const double at_s : {1.4, 12.3}) {
            for (const double of_c : {0.0, 1.0}) {
                FreeDecay gyro = reference();
                gyro.split_hz = 1e-3;
                gyro.theta_w = 0.3;
                std::vector<PhasorRun> runs = set_of(gyro, four_angles, 500, 61);
                gains_at(runs[1], at_s, of_c * 0.05, 0.05);
                const ResonatorFit fit = fitted(runs);
                const Diagnostic* found = warning_of(fit, DiagnosticKind::fitted_gain_step);
                QVERIFY(found != nullptr);
                const QString text = QString::fromStdString(english(*found));
                QVERIFY2(text.contains("a drive ends") == (at_s < 10 && of_c > 0),
                         qPrintable(text));
                QVERIFY2(text.contains("--from"), qPrintable(text));
            }
        }
    }

    // Both gains, or that of D alone, of sizes from a tenth of an LSB of 12 bits on.
    void a_gain_step_is_found_and_the_numbers_are_right() {
        std::uint64_t seed = 40;
        for (const double size : {5e-4, 1.5e-3, 0.05, 1.0}) {
            for (const double of_c : {0.0, 1.0}) {
                FreeDecay gyro = reference();
                gyro.split_hz = 1e-3;
                gyro.theta_w = 0.3;
                std::vector<PhasorRun> runs = set_of(gyro, four_angles, 500, ++seed);
                gains_at(runs[1], 12.3, of_c * size, size);
                const ResonatorFit fit = fitted(runs);
                const QString what = QString("size %1, C %2: chi^2/dof %3")
                                         .arg(size)
                                         .arg(of_c)
                                         .arg(fit.chi2_per_dof);
                VYBEG_EQUAL(fit.breaks.size(), 1, qPrintable(what));
                QCOMPARE(fit.breaks[0].run, std::size_t{1});
                VYBEG_WITHIN(fit.breaks[0].time_s, 12.3, fit.breaks[0].reach_s, qPrintable(what));
                if (size < 1) {  // the noise grows with the gain
                    VYBEG_LESS(fit.chi2_per_dof, 1.2, qPrintable(what));
                }
                QVERIFY2(size == 1 || !warns(fit, DiagnosticKind::residual_coloured),
                         qPrintable(what));
                VYBEG_NEAR(fit.resonator.split_hz, gyro.split_hz, 4.5, 1e-6);
                VYBEG_NEAR(fit.resonator.tau_s, 400, 4.5, 1);
            }
        }
    }

    // A larger set tries to do without some of its recordings only, in the order of what they would
    // gain in units of their own noise, which a large step makes a million times that of the
    // others.
    void a_large_step_of_one_of_many_is_found() {
        std::uint64_t seed = 80;
        for (const std::vector<double>& angles :
             {std::vector<double>{0, 22.5, 45, 67.5, 14.3}, {0, 11, 22.5, 33, 45, 56, 67.5, 79}}) {
            for (const double size : {-0.5, -0.07, -5e-3, 0.07}) {
                FreeDecay gyro = reference();
                gyro.split_hz = 2e-3;
                gyro.theta_w = 0.2;
                std::vector<PhasorRun> runs = set_of(gyro, angles, 500, ++seed);
                const std::size_t where = seed % 2 == 0 ? 2 : runs.size() - 1;
                gains_at(runs[where], 8, size, size);
                const ResonatorFit fit = fitted(runs);
                const QString what = QString("%1 runs, size %2: chi^2/dof %3")
                                         .arg(runs.size())
                                         .arg(size)
                                         .arg(fit.chi2_per_dof);
                QVERIFY2(!fit.left_out && warns(fit, DiagnosticKind::fitted_gain_step),
                         qPrintable(what));
                VYBEG_EQUAL(fit.breaks.size(), 1, qPrintable(what));
                QCOMPARE(fit.breaks[0].run, where);
                VYBEG_WITHIN(fit.breaks[0].time_s, 8, fit.breaks[0].reach_s, qPrintable(what));
                VYBEG_CLOSE(fit.breaks[0].size[0], size, 1e-3, qPrintable(what));
                VYBEG_CLOSE(fit.breaks[0].size[1], size, 1e-3, qPrintable(what));
                VYBEG_LESS(fit.chi2_per_dof, 1.2, qPrintable(what));
                VYBEG_NEAR(fit.resonator.split_hz, gyro.split_hz, 4.5, 1e-6);
                VYBEG_NEAR(fit.resonator.tau_s, 400, 4.5, 1);
            }
        }
    }

    // No single recording makes the difference, and a third one may look foreign.
    void an_event_in_each_of_two_recordings_is_found() {
        std::uint64_t seed = 120;
        for (const std::vector<double>& angles : {std::vector<double>{0, 22.5, 45, 67.5},
                                                  {0, 22.5, 45, 67.5, 14.3},
                                                  {5, 16, 27.5, 38, 50, 61, 72.5}}) {
            for (const double size : {1e-3, 1e-2, 0.1}) {
                FreeDecay gyro = reference();
                gyro.split_hz = 1e-3;
                gyro.theta_w = 0.3;
                std::vector<PhasorRun> runs = set_of(gyro, angles, 500, ++seed);
                FreeDecay own = gyro;
                own.two_theta_A = 2 * angles[2] * pi / 180;
                const Eigen::Vector2cd change(size * std::polar(0.6, 1.0),
                                              size * std::polar(0.8, 2.3));
                knock_at(runs[2], own, 9.1, 0.013 * (1 - 0.8 * 2), change);
                gains_at(runs[0], 15, size, size / 2);
                const ResonatorFit fit = fitted(runs);
                const QString what = QString("%1 runs, size %2: chi^2/dof %3")
                                         .arg(runs.size())
                                         .arg(size)
                                         .arg(fit.chi2_per_dof);
                QVERIFY2(!fit.left_out, qPrintable(what));
                QVERIFY2(warns(fit, DiagnosticKind::fitted_knock), qPrintable(what));
                QVERIFY2(warns(fit, DiagnosticKind::fitted_gain_step), qPrintable(what));
                VYBEG_EQUAL(fit.breaks.size(), 2, qPrintable(what));
                VYBEG_LESS(fit.chi2_per_dof, 1.2, qPrintable(what));
                VYBEG_NEAR(fit.resonator.split_hz, gyro.split_hz, 4.5, 1e-6);
                VYBEG_NEAR(fit.resonator.tau_s, 400, 4.5, 1);
            }
        }
    }

    void a_knock_is_found_and_the_numbers_are_right() {
        std::uint64_t seed = 60;
        for (const double size : {1e-3, 1e-2, 0.1, 0.5}) {
            FreeDecay gyro = reference();
            gyro.split_hz = 1e-3;
            gyro.theta_w = 0.3;
            std::vector<PhasorRun> runs = set_of(gyro, four_angles, 500, ++seed);
            FreeDecay own = gyro;
            own.two_theta_A = 2 * four_angles[2] * pi / 180;
            const Eigen::Vector2cd change(size * std::polar(0.6, 1.0), size * std::polar(0.8, 2.3));
            knock_at(runs[2], own, 9.1, 0.013 * (1 - 0.8 * 2), change);
            const ResonatorFit fit = fitted(runs);
            const QString what = QString("size %1: chi^2/dof %2").arg(size).arg(fit.chi2_per_dof);
            VYBEG_EQUAL(fit.breaks.size(), 1, qPrintable(what));
            QVERIFY2(warns(fit, DiagnosticKind::fitted_knock), qPrintable(what));
            QCOMPARE(fit.breaks[0].run, std::size_t{2});
            VYBEG_WITHIN(fit.breaks[0].time_s, 9.1, fit.breaks[0].reach_s, qPrintable(what));
            VYBEG_CLOSE(fit.breaks[0].size[0], size, 0.2 * size, qPrintable(what));
            VYBEG_LESS(fit.chi2_per_dof, 1.2, qPrintable(what));
            VYBEG_NEAR(fit.resonator.split_hz, gyro.split_hz, 4.5, 1e-6);
            VYBEG_NEAR(fit.resonator.tau_s, 400, 4.5, 1);
        }
    }

    // White noise of unlike size in the channels, or common to both, is white.
    void unlike_noise_of_the_channels_is_white() {
        for (const bool common : {false, true}) {
            FreeDecay gyro = reference();
            gyro.split_hz = 1e-3;
            std::vector<PhasorRun> runs = set_of(gyro, four_angles, 500, 7);
            GaussianNoise noise(11);
            for (PhasorRun& run : runs) {
                for (std::size_t k = 0; k < run.c.size(); ++k) {
                    const auto [re, im] = noise.next();
                    const std::complex<double> more = run.sd[k] * std::complex(re, im);
                    run.d[k] += (common ? 1.5 : 9.95) * more;
                    run.c[k] += common ? 1.5 * more : 0.0;
                    run.sd[k] *= common ? std::sqrt(1 + 2.25) : std::sqrt(0.5 + 50);
                }
            }
            const ResonatorFit fit = fitted(runs);
            VYBEG_WITHIN(fit.chi2_per_dof, 1, 0.15);
            QVERIFY(!warns(fit, DiagnosticKind::residual_coloured));
            QVERIFY(!warns(fit, DiagnosticKind::motion_not_model));
            QVERIFY(fit.model == ResonatorModel::structured);
            VYBEG_NEAR(fit.resonator.split_hz, gyro.split_hz, 4.5, 1e-5);
        }
    }

    // Noise about the carrier and frequencies that settle or drift leave no step.
    void a_phase_that_wanders_is_no_step() {
        for (std::uint64_t seed = 1; seed <= 6; ++seed) {
            std::vector<PhasorRun> runs = set_of(reference(), four_angles, 1000, seed);
            GaussianNoise noise(seed);
            for (PhasorRun& run : runs) {
                double phase = 0;
                for (std::size_t k = 0; k < run.c.size(); ++k) {
                    phase += 2e-4 * noise.next().first;
                    run.c[k] *= std::polar(1.0, phase);
                    run.d[k] *= std::polar(1.0, phase);
                }
            }
            QVERIFY(fitted(runs).breaks.empty());
        }
    }

private:
    static void check(double split_hz, const std::vector<double>& angles, double step_rad,
                      double at_s, std::uint64_t seed) {
        FreeDecay gyro = reference();
        gyro.split_hz = split_hz;
        gyro.theta_w = 0.3;
        gyro.damping_anisotropy_per_s = 1e-4;
        std::vector<PhasorRun> runs = set_of(gyro, angles, 500, seed);
        const std::size_t where = seed % runs.size();
        step_at(runs[where], at_s, step_rad);
        const ResonatorFit fit = fitted(runs);
        const QString what = QString("split %1 Hz, %2 runs, step %3: chi^2/dof %4")
                                 .arg(split_hz)
                                 .arg(angles.size())
                                 .arg(step_rad)
                                 .arg(fit.chi2_per_dof);
        VYBEG_EQUAL(fit.breaks.size(), 1, qPrintable(what));
        QVERIFY(warns(fit, DiagnosticKind::fitted_phase_step));
        const FittedBreak& found = fit.breaks[0];
        QCOMPARE(found.run, where);
        VYBEG_WITHIN(found.time_s, at_s, found.reach_s, qPrintable(what));
        VYBEG_CLOSE(found.size[0], step_rad, 2e-3, qPrintable(what));
        VYBEG_LESS(fit.chi2_per_dof, 1.2, qPrintable(what));
        if (angles.size() > 1 && split_hz > 1e-5) {
            VYBEG_NEAR(fit.resonator.split_hz, split_hz, 4.5, 1e-5);
        }
        if (angles.size() > 1) {
            VYBEG_NEAR(fit.resonator.tau_s, 400, 4.5, 1);
        }
        // In a beat the windows left out change the mean itself.
        if (split_hz > 1e-2) {
            return;
        }
        const WaveMotion wave = wave_motion(with_break(runs[where], found));
        const WaveMotion whole = wave_motion(simulated_whole(gyro, angles, seed, where));
        const QString at = what + QString(", wave f %1 %2 sd %3")
                                      .arg(wave.f_hz.value, 0, 'f', 9)
                                      .arg(whole.f_hz.value, 0, 'f', 9)
                                      .arg(wave.f_hz.sd);
        QVERIFY2(fault(wave.f_hz, whole.f_hz.value, 5, 1e-4).isEmpty(), qPrintable(at));
    }

    static PhasorRun simulated_whole(const FreeDecay& gyro, const std::vector<double>& angles,
                                     std::uint64_t seed, std::size_t where) {
        return set_of(gyro, angles, 500, seed)[where];
    }
};

VYBEG_TEST(TestFitBreaks, first, statistical, unsanitized)

}  // namespace test_fit_breaks

#include "test_fit_breaks.moc"
