// Verdicts on recordings that are no free decay of a wave seen from two sides: each kind over
// angles, seeds and sizes from a tenth of what dominates to ten times, one of each kind from
// samples, and none on faultless sets.
#include "core/analysis/identify.h"
#include "core/base/diagnostic.h"
#include "core/recording/open/open_recording.h"
#include "core/resonator/results/free_decay.h"
#include "core/resonator/runs/sum_of_modes.h"
#include "tests/closeness.h"
#include "tests/core/resonator/known_resonator.h"
#include "tests/needed.h"
#include "tests/statistical/each_seed.h"
#include "tests/statistical/simulated_recording.h"
#include "tests/test_registry.h"

#include <QtTest>

#include <algorithm>
#include <atomic>
#include <cmath>
#include <ctime>
#include <mutex>
#include <numbers>
#include <vector>

namespace test_verdicts {

using namespace vybeg;
using namespace vybeg::test;
using std::numbers::pi;

namespace {

using Kinds = std::vector<DiagnosticKind>;

const Kinds verdicts{DiagnosticKind::no_free_decay, DiagnosticKind::no_free_decay_part,
                     DiagnosticKind::same_projection, DiagnosticKind::mode_grows,
                     DiagnosticKind::misfit_damping};

bool says(const std::vector<Diagnostic>& warnings, DiagnosticKind kind) {
    return std::ranges::find(warnings, kind, &Diagnostic::kind) != warnings.end();
}

// What identify() says of phasors.
ResonatorFit judged(std::span<const PhasorRun> runs) {
    if (std::ranges::any_of(runs, shares_projection)) {
        return *fit_one_projection(runs);
    }
    ResonatorFit fit = needed(fit_resonator(runs, {}, {}));
    judge_free_decay(runs, {}, {}, fit);
    return fit;
}

QString texts(const std::vector<Diagnostic>& warnings) {
    QStringList list;
    for (const Diagnostic& warning : warnings) {
        list.append(QString::fromStdString(english(warning)));
    }
    return list.join("\n");
}

// A slow gyro, so that the means over the windows of a motion that is not linear are cheap.
FreeDecay slow_gyro(std::uint64_t seed) {
    FreeDecay gyro{.seconds = 28,
                   .rate_hz = 1000,
                   .f0_hz = 251.3,
                   .two_theta_A = 0.7 * static_cast<double>(seed),
                   .alpha = 1.1 * static_cast<double>(seed),
                   .split_hz = 0.02 * static_cast<double>(seed % 4),
                   .theta_w = 0.2,
                   .tau_s = 30,
                   .damping_anisotropy_per_s = 2e-3,
                   .theta_tau = -0.3,
                   .noise = 1e-3};
    return gyro;
}

constexpr std::int64_t slow_window = 100;

// Four runs 45 degrees of 2 theta_A apart; `change` alters one of them.
template <class Change>
std::vector<PhasorRun> four_runs(std::uint64_t seed, std::size_t which, const Change& change) {
    std::vector<PhasorRun> runs;
    for (std::size_t k = 0; k < 4; ++k) {
        FreeDecay decay = slow_gyro(seed);
        decay.two_theta_A += static_cast<double>(k) * pi / 4;
        if (k == which) {
            change(decay);
        }
        runs.push_back(moved_phasors(decay, slow_window, 16 * seed + k));
    }
    return runs;
}

// D shows (1 - share) d + share c, as the simulator's pick-offs do.
PhasorRun in_one_projection(FreeDecay decay, double share, std::uint64_t seed) {
    constexpr double noise = 1e-4;
    decay.noise = 0;
    PhasorRun run = moved_phasors(decay, 50, seed);
    GaussianNoise random(seed);
    for (std::size_t k = 0; k < run.c.size(); ++k) {
        const auto [c_re, c_im] = random.next();
        const auto [d_re, d_im] = random.next();
        run.d[k] += share * (run.c[k] - run.d[k]) + noise * std::complex(d_re, d_im);
        run.c[k] += noise * std::complex(c_re, c_im);
        run.sd[k] = noise;
    }
    return run;
}

// Tau, anisotropy, rotation and quadrature over their whole range, one or two runs.
std::vector<PhasorRun> wide_set(std::uint64_t seed) {
    std::mt19937_64 random(seed);
    const auto uniform = [&](double low, double high) {
        return low + (high - low) * static_cast<double>(random() >> 11) * 0x1p-53;
    };
    FreeDecay gyro{.tau_s = std::pow(10, uniform(-1.3, 7))};
    gyro.seconds = std::min(28.0, uniform(3, 10) * gyro.tau_s);
    gyro.split_hz = seed % 3 == 0 ? 0 : uniform(0, 1);
    gyro.damping_anisotropy_per_s = uniform(0, 1.9) / gyro.tau_s;
    gyro.theta_w = uniform(-pi, pi) / 4;
    gyro.theta_tau = uniform(-pi, pi) / 4;
    gyro.omega_rad_s = seed % 2 == 0 ? 0 : uniform(-0.4, 0.4);
    gyro.noise = std::pow(10, -uniform(40, 80) / 20);
    const double windows = std::max(200.0, gyro.seconds * 60 * (gyro.split_hz + 0.4));
    const auto window = static_cast<std::int64_t>(gyro.seconds * gyro.rate_hz / windows);
    std::vector<PhasorRun> runs;
    for (std::size_t k = 0; k <= seed % 2; ++k) {
        gyro.a_B = seed % 5 == 0 ? 1 : uniform(-0.3, 0.3);
        gyro.two_theta_A = uniform(-3, 3);
        runs.push_back(simulated_phasors(gyro, window, seed * 16 + k, uniform(-0.3, 0.3)));
    }
    return runs;
}

}  // namespace

class TestVerdicts : public QObject {
    Q_OBJECT

private slots:
    // The whole range; TestResonatorTrial asks usual gyros.
    void faultless_sets_raise_no_word() {
        constexpr int sets = 150;
        std::atomic<int> words = 0;
        std::mutex mutex;
        for_each_seed(sets, [&](int seed) {
            const auto from = static_cast<std::uint64_t>(1000 + seed);
            const std::vector<PhasorRun> runs = wide_set(from);
            const ResonatorFit fit = judged(runs);
            const auto said = std::ranges::find_if(fit.warnings, [](const Diagnostic& warning) {
                return std::ranges::find(verdicts, warning.kind) != verdicts.end();
            });
            if (said != fit.warnings.end()) {
                ++words;
                const std::lock_guard lock(mutex);
                qInfo("seed %d: %s", seed, qPrintable(texts(fit.warnings)));
            }
        });
        qInfo("%d of %d sets have a needless word", words.load(), sets);
        VYBEG_LESS(words.load(), 0.01 * sets + 0.6);
    }

    void friction_is_named_by_its_law_data() {
        QTest::addColumn<bool>("dry");
        QTest::addColumn<double>("size");  // of the friction's share in units of the free decay's
        for (const bool dry : {true, false}) {
            for (const double size : {0.1, 0.3, 1.0, 3.0, 10.0}) {
                QTest::addRow("%s, %g", dry ? "dry" : "air", size) << dry << size;
            }
        }
    }

    void friction_is_named_by_its_law() {
        QFETCH(bool, dry);
        QFETCH(double, size);
        int named = 0;
        int small = 0;
        int silent = 0;
        constexpr int seeds = 4;
        for (int seed = 0; seed < seeds; ++seed) {
            FreeDecay decay = slow_gyro(static_cast<std::uint64_t>(seed));
            decay.tau_s = 60;
            (dry ? decay.dry_friction_per_s : decay.air_friction_per_s) = size / decay.tau_s;
            const std::vector<PhasorRun> runs{
                moved_phasors(decay, slow_window, static_cast<std::uint64_t>(seed))};
            const ResonatorFit fit = judged(runs);
            const bool dominates = says(fit.warnings, DiagnosticKind::no_free_decay);
            named += dominates ? 1 : 0;
            small += !dominates && says(fit.warnings, DiagnosticKind::misfit_damping) ? 1 : 0;
            silent += dominates || says(fit.warnings, DiagnosticKind::misfit_damping) ? 0 : 1;
            if (dominates) {
                QVERIFY(fit.runs[0].law.has_value());
                const DecayLaw& law = *fit.runs[0].law;
                VYBEG_CLOSE(law.power, dry ? 0 : 2, 0.5);
                const QBand band = q_band(law, fit.runs[0].q_envelope.value);
                const double friction = dry ? decay.dry_friction_per_s / band.amplitude
                                            : decay.air_friction_per_s * band.amplitude;
                const double rate = 1 / decay.tau_s + friction;
                VYBEG_CLOSE_RATIO(fit.runs[0].q_envelope.value, pi * decay.f0_hz / rate, 0.1);
                VYBEG_LESS(band.smallest, band.amplitude);
                VYBEG_LESS(band.amplitude, band.largest);
            } else if (!says(fit.warnings, DiagnosticKind::misfit_damping)) {
                qInfo("seed %d: %s", seed, qPrintable(texts(fit.warnings)));
            }
        }
        qInfo("dominates %d, named %d, silent %d of %d", named, small, silent, seeds);
        if (size >= 3) {
            QCOMPARE(named, seeds);
        } else if (size >= 0.3) {
            QCOMPARE(silent, 0);
        }
    }

    void a_held_recording_of_four_is_named() {
        for (std::uint64_t seed = 0; seed < 8; ++seed) {
            const std::size_t which = seed % 4;
            const std::vector<PhasorRun> runs = four_runs(
                seed, which, [](FreeDecay& decay) { decay.drive_per_s = 1 / decay.tau_s; });
            const ResonatorFit fit = judged(runs);
            const auto word =
                std::ranges::find(fit.warnings, DiagnosticKind::no_free_decay, &Diagnostic::kind);
            QVERIFY2(word != fit.warnings.end(), qPrintable(texts(fit.warnings)));
            QVERIFY2(word->args[0] == recording_arg(which), qPrintable(texts(fit.warnings)));
            QCOMPARE(
                std::ranges::count(fit.warnings, DiagnosticKind::no_free_decay, &Diagnostic::kind),
                std::ptrdiff_t{1});
        }
    }

    void a_growing_wave_is_named_and_refuses_the_modes() {
        for (std::uint64_t seed = 0; seed < 8; ++seed) {
            for (const double size : {1.1, 2.0, 5.0}) {
                FreeDecay decay = slow_gyro(seed);
                decay.drive_per_s = size / decay.tau_s;
                const ResonatorFit fit =
                    judged(std::vector{moved_phasors(decay, slow_window, seed)});
                const QString all = texts(fit.warnings);
                QVERIFY2(says(fit.warnings, DiagnosticKind::no_free_decay), qPrintable(all));
                QVERIFY2(fit.modes.empty(), qPrintable(all));
                QVERIFY2(!fit.resonator.tau_s.given(), qPrintable(all));
            }
        }
    }

    // A pendulum that swings in beside its drive.
    void a_drive_at_its_own_frequency_holds_one_motion() {
        for (std::uint64_t seed = 0; seed < 6; ++seed) {
            for (const double driven : {0.0, 0.2, 2.0}) {
                FreeDecay decay = slow_gyro(seed);
                decay.tau_s = 5;
                decay.split_hz = 0;
                decay.damping_anisotropy_per_s = 0;
                PhasorRun run = moved_phasors(decay, slow_window, seed);
                for (std::size_t k = 0; k < run.c.size(); ++k) {
                    const double turn = 2 * pi * 0.03 * run.time_s[k];
                    run.c[k] += std::polar(0.8 * driven, turn);
                    run.d[k] += std::polar(0.6 * driven, turn + 1);
                }
                const ResonatorFit fit = judged(std::vector{run});
                QVERIFY2(says(fit.warnings, DiagnosticKind::no_free_decay) == (driven > 0),
                         qPrintable(QString("seed %1, %2: ").arg(seed).arg(driven) +
                                    texts(fit.warnings)));
            }
        }
    }

    void the_part_in_free_decay_is_offered_data() {
        QTest::addColumn<double>("drive");  // in units of 1/tau
        QTest::addColumn<double>("from_s");
        QTest::addColumn<double>("to_s");
        QTest::newRow("drive held for 4 s") << 1.0 << 0.0 << 4.0;
        QTest::newRow("drive grows for 6 s") << 4.0 << 0.0 << 6.0;
        QTest::newRow("a hand at the end") << -20.0 << 24.0 << 1e300;
        QTest::newRow("a light hand at the end") << -3.0 << 22.0 << 1e300;
    }

    void the_part_in_free_decay_is_offered() {
        QFETCH(double, drive);
        QFETCH(double, from_s);
        QFETCH(double, to_s);
        for (std::uint64_t seed = 0; seed < 6; ++seed) {
            FreeDecay decay = slow_gyro(seed);
            decay.drive_per_s = drive / decay.tau_s;
            decay.drive_from_s = from_s;
            decay.drive_to_s = to_s;
            const ResonatorFit fit = judged(std::vector{moved_phasors(decay, slow_window, seed)});
            const auto word = std::ranges::find(fit.warnings, DiagnosticKind::no_free_decay_part,
                                                &Diagnostic::kind);
            QVERIFY2(word != fit.warnings.end(),
                     qPrintable(QString::number(seed) + ": " + texts(fit.warnings)));
            const double begin = QString::fromStdString(word->args[1].text).toDouble();
            const double end = QString::fromStdString(word->args[2].text).toDouble();
            const double free_from = from_s == 0 ? to_s : 0;
            const double free_to = from_s == 0 ? decay.seconds : from_s;
            const QString text = QString("%1 to %2").arg(begin).arg(end);
            VYBEG_CLOSE(begin, free_from, 2, qPrintable(text));
            VYBEG_CLOSE(end, free_to, 2, qPrintable(text));
        }
    }

    void one_projection_gives_its_modes_data() {
        QTest::addColumn<double>("share");
        QTest::addColumn<double>("split_hz");
        QTest::addColumn<double>("tau_s");
        for (const double share : {0.97, 1.0}) {
            QTest::addRow("share %g, slow beat", share) << share << 0.1 << 30.0;
            QTest::addRow("share %g, fast beat", share) << share << 1.0 << 10.0;
            QTest::addRow("share %g, bell", share) << share << 2.0 << 3.0;
        }
    }

    void one_projection_gives_its_modes() {
        QFETCH(double, share);
        QFETCH(double, split_hz);
        QFETCH(double, tau_s);
        for (std::uint64_t seed = 0; seed < 8; ++seed) {
            FreeDecay decay = slow_gyro(seed);
            decay.split_hz = split_hz;
            decay.tau_s = tau_s;
            decay.damping_anisotropy_per_s = 0.1 / tau_s;
            decay.theta_w = 0.35;
            decay.two_theta_A = -0.1 * static_cast<double>(seed);
            const std::vector<PhasorRun> runs{in_one_projection(decay, share, seed)};
            const ResonatorFit fit = judged(runs);
            QVERIFY2(says(fit.warnings, DiagnosticKind::same_projection),
                     qPrintable(texts(fit.warnings)));
            QCOMPARE(fit.modes.size(), std::size_t{2});
            VYBEG_NEAR(fit.modes[0].f_hz, decay.f0_hz + split_hz / 2, 5, 0.02 * split_hz);
            VYBEG_NEAR(fit.modes[1].f_hz, decay.f0_hz - split_hz / 2, 5, 0.02 * split_hz);
            QVERIFY(fit.resonator.theta_w_rad.reason.code == ReasonCode::same_projection);
            QVERIFY(fit.runs[0].a_B.reason.code == ReasonCode::same_projection);
        }
    }

    void a_kind_from_samples_data() {
        QTest::addColumn<int>("kind");
        QTest::addColumn<int>("expected");
        QTest::newRow("faultless") << 0 << -1;
        QTest::newRow("dry friction") << 1 << static_cast<int>(DiagnosticKind::no_free_decay);
        QTest::newRow("air friction") << 2 << static_cast<int>(DiagnosticKind::no_free_decay);
        QTest::newRow("drive") << 3 << static_cast<int>(DiagnosticKind::no_free_decay);
        QTest::newRow("messy start") << 4 << static_cast<int>(DiagnosticKind::no_free_decay_part);
        QTest::newRow("one electrode") << 5 << static_cast<int>(DiagnosticKind::same_projection);
        QTest::newRow("pendulum in air, by camera")
            << 6 << static_cast<int>(DiagnosticKind::no_free_decay);
        QTest::newRow("pendulum in vacuum, by camera") << 7 << -1;
        QTest::newRow("coupled pendulums") << 8 << -1;
    }

    void a_kind_from_samples() {
        QFETCH(int, kind);
        QFETCH(int, expected);
        FreeDecay decay = slow_gyro(1);
        decay.rate_hz = 8000;
        decay.f0_hz = 1251.3;
        switch (kind) {
            case 1: decay.dry_friction_per_s = 0.1; break;
            case 2: decay.air_friction_per_s = 0.5; break;
            case 3: decay.drive_per_s = 2 / decay.tau_s; break;
            case 4:
                decay.drive_per_s = 1 / decay.tau_s;
                decay.drive_to_s = 5;
                break;
            case 5:
                decay.same_projection = 1;
                decay.split_hz = 0.4;
                break;
            case 6:
            case 7:
                decay.seconds = 1440;
                decay.rate_hz = 8.6;
                decay.f0_hz = 0.356;
                decay.split_hz = 0;
                decay.tau_s = 4400;
                decay.damping_anisotropy_per_s = 0;
                decay.omega_rad_s = 5e-5;
                decay.noise = 3e-3;
                decay.air_friction_per_s = kind == 6 ? 2e-3 : 0;
                break;
            case 8:
                decay.seconds = 600;
                decay.rate_hz = 30;
                decay.f0_hz = 0.9;
                decay.split_hz = 0.02;
                decay.tau_s = 300;
                decay.damping_anisotropy_per_s = 1e-3;
                break;
            default: break;
        }
        const std::vector<Recording> recordings{simulated_recording(decay)};
        const Result<Identification> found = identify(recordings, {}, {});
        QVERIFY(found);
        const Result<SampleFaults> checked = inspect(recordings[0], {}, {});
        QVERIFY(checked);
        for (const std::vector<Diagnostic>& warnings : {found->fit.warnings, checked->findings}) {
            for (const DiagnosticKind verdict : verdicts) {
                if (verdict != DiagnosticKind::misfit_damping &&
                    verdict != DiagnosticKind::mode_grows) {
                    QVERIFY2(says(warnings, verdict) == (static_cast<int>(verdict) == expected),
                             qPrintable(texts(warnings)));
                }
            }
        }
    }

    // A wave that stands still shows one shape in the channels as well; a drive that ends, a knock,
    // a settling frequency or a weak line makes two modes of its motion.
    void a_driven_wave_has_no_projection() {
        std::atomic<int> words = 0;
        std::mutex mutex;
        constexpr int waves = 400;
        for_each_seed(waves, [&](int seed) {
            std::mt19937_64 random(static_cast<std::uint64_t>(seed) + 5000);
            const auto uniform = [&](double low, double high) {
                return low + (high - low) * static_cast<double>(random() >> 11) * 0x1p-53;
            };
            FreeDecay gyro = slow_gyro(static_cast<std::uint64_t>(seed));
            gyro.tau_s = std::pow(10, uniform(0.7, 2));
            gyro.theta_tau = gyro.theta_w;
            gyro.two_theta_A = 2 * gyro.theta_w + (seed % 2) * pi + (seed % 3 == 0 ? 0.1 : 0.0);
            gyro.split_hz = seed % 5 == 0 ? 0 : uniform(0, 0.3);
            gyro.drive_per_s = std::pow(10, uniform(-0.3, 0.9)) / gyro.tau_s;
            gyro.drive_from_s = seed % 4 < 2 ? 0 : uniform(0, 15);
            gyro.drive_to_s = gyro.drive_from_s + uniform(2, 12);
            PhasorRun run = moved_phasors(gyro, slow_window, static_cast<std::uint64_t>(seed));
            if (seed % 4 == 1) {
                shift(run, 0, uniform(-1e-3, 1e-3));
            }
            const double line = seed % 4 == 3 ? uniform(0, 0.1) : 0;
            const double line_hz = uniform(-0.3, 0.3);
            for (std::size_t k = 0; k < run.c.size(); ++k) {
                run.c[k] += std::polar(line, 2 * pi * line_hz * run.time_s[k]);
            }
            if (shares_projection(run)) {
                ++words;
                const std::lock_guard lock(mutex);
                qInfo("seed %d", seed);
            }
        });
        qInfo("%d of %d waves are taken for one projection", words.load(), waves);
        QCOMPARE(words.load(), 0);
    }

    void a_bell_before_two_near_microphones_has_modes_only_data() {
        QTest::addColumn<bool>("filtered");
        QTest::newRow("as recorded") << false;
        QTest::newRow("478 to 494 Hz") << true;
    }

    void a_bell_before_two_near_microphones_has_modes_only() {
        QFETCH(bool, filtered);
        const QString folder = qEnvironmentVariable("VYBEG_REAL_DATA");
        if (folder.isEmpty()) {
            QSKIP("VYBEG_REAL_DATA is not set: THE REAL RECORDINGS ARE NOT TESTED");
        }
        const Result<Recording> recording =
            open_recording((folder + "/same-projection.wav").toStdString(), {}, {});
        QVERIFY2(recording, "the recording does not open");
        IdentifySettings settings;
        if (filtered) {
            settings.signal.filter = Band{478, 494};
        }
        const std::clock_t begun = std::clock();
        const Result<Identification> found = identify({&*recording, 1}, settings, {});
        const double took_s = static_cast<double>(std::clock() - begun) / CLOCKS_PER_SEC;
        QVERIFY(found);
        for (const ModeEstimate& mode : found->fit.modes) {
            qInfo("%.4f +- %.4f Hz, %.4g +- %.2g s", mode.f_hz.value, mode.f_hz.sd,
                  mode.tau_s.value, mode.tau_s.sd);
        }
        QVERIFY2(says(found->fit.warnings, DiagnosticKind::same_projection),
                 qPrintable(texts(found->fit.warnings)));
        QCOMPARE(found->fit.modes.size(), std::size_t{2});
        QVERIFY(!found->fit.resonator.theta_w_rad.given());
        QVERIFY(!found->runs[0].wave.theta_rate_rad_s.given());
        // With the filter, the search for a coloured noise took minutes.
        VYBEG_LESS(took_s, 5);
    }
};

VYBEG_TEST(TestVerdicts, first)

}  // namespace test_verdicts

#include "test_verdicts.moc"
