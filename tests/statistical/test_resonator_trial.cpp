// The resonator's fit on random sets whose truth is known: an exact model in white noise, channels
// drawn from their tolerances, noise about the carrier, and mixtures that are no resonator's.
//
// Statistical model: each number that is given lies within its combined uncertainty of the truth as
// a normal deviate does. Over some hundred sets the root mean square of the pulls is 0.85 to 1.1,
// and none of the some thousand lies beyond 4.6.
#include "core/resonator/results/free_decay.h"
#include "tests/closeness.h"
#include "tests/statistical/each_seed.h"
#include "tests/statistical/random_sets.h"
#include "tests/test_registry.h"

#include <QtTest>

#include <array>
#include <map>
#include <mutex>
#include <string>

namespace test_resonator_trial {

using namespace vybeg;
using namespace vybeg::test;
using std::numbers::pi;

namespace {

struct Pulls {
    int given = 0;
    int refused = 0;
    int within = 0;  // two uncertainties
    double squares = 0;
    double worst = 0;

    void add(const Estimate& estimate, double truth, double period = 0) {
        if (!estimate.given()) {
            ++refused;
            return;
        }
        double off = estimate.value - truth;
        if (period > 0) {
            off = std::remainder(off, period);
        }
        const double pull = std::abs(off) / estimate.uncertainty();
        ++given;
        within += pull < 2 ? 1 : 0;
        squares += pull * pull;
        worst = std::max(worst, pull);
    }

    double rms() const { return std::sqrt(squares / given); }
    double share() const { return static_cast<double>(within) / given; }
    QString text() const {
        return QString("given %1, refused %2, rms %3, within 2u %4, worst %5")
            .arg(given)
            .arg(refused)
            .arg(rms())
            .arg(share())
            .arg(worst);
    }
};

using Tally = std::map<std::string, Pulls>;

// 1/tau is normal also where tau is hardly seen.
Estimate rate_of(const Estimate& tau) {
    if (!tau.given()) {
        return tau;
    }
    const double by = 1 / (tau.value * tau.value);
    return {1 / tau.value, tau.sd * by, {}, tau.u * by};
}

void add(const RandomSet& set, const ResonatorFit& fit, Tally& tally) {
    const FreeDecay& gyro = set.resonator;
    const ResonatorEstimate& found = fit.resonator;
    double f_mean = 0;
    for (const double f : set.f_offset_hz) {
        f_mean += f / static_cast<double>(set.f_offset_hz.size());
    }
    tally["f_mean"].add(found.f_mean_hz, gyro.f0_hz + f_mean);
    tally["split"].add(found.split_hz, gyro.split_hz);
    tally["theta_w"].add(found.theta_w_rad, gyro.theta_w, pi / 2);
    tally["decay"].add(rate_of(found.tau_s), 1 / gyro.tau_s);
    tally["g"].add(found.damping_anisotropy_per_s, gyro.damping_anisotropy_per_s);
    tally["theta_tau"].add(found.theta_tau_rad, gyro.theta_tau, pi / 2);
    tally["rate"].add(found.angle_rate_rad_s, -gyro.bryan * gyro.omega_rad_s);
    tally["kappa"].add(found.kappa, gyro.kappa);
    for (std::size_t k = 0; k < fit.runs.size(); ++k) {
        const RunEstimate& run = fit.runs[k];
        const FreeDecay& truth = set.each[k];
        const double four_theta = 2 * truth.two_theta_A;
        tally["a_A"].add(run.a_A, truth.a_A);
        tally["a_B"].add(run.a_B, truth.a_B);
        tally["2theta"].add(run.two_theta_A_rad, truth.two_theta_A, pi);
        tally["split_sin"].add(run.split_sin_hz,
                               gyro.split_hz * std::sin(four_theta - 4 * gyro.theta_w));
        if (fit.runs.size() > 1) {
            tally["f_offset"].add(run.f_offset_hz, set.f_offset_hz[k] - f_mean);
        }
    }
}

bool says_verdict(const ResonatorFit& fit) {
    constexpr std::array verdicts{DiagnosticKind::no_free_decay, DiagnosticKind::no_free_decay_part,
                                  DiagnosticKind::same_projection, DiagnosticKind::mode_grows,
                                  DiagnosticKind::misfit_damping};
    return std::ranges::any_of(fit.warnings, [&](const Diagnostic& each) {
        return std::ranges::find(verdicts, each.kind) != verdicts.end();
    });
}

// D as imperfect channels show it.
void spoil(RandomSet& set, std::mt19937_64& random, const ChannelTolerance& tolerance) {
    // Box and Muller: the standard's normal distribution differs between libraries.
    const auto normal = [&] {
        const double u = (static_cast<double>(random() >> 11) + 0.5) * 0x1p-53;
        const double v = static_cast<double>(random() >> 11) * 0x1p-53;
        return std::sqrt(-2 * std::log(u)) * std::cos(2 * pi * v);
    };
    const double skew = tolerance[skew_error] * normal();
    const double phase = tolerance[delay_error] * normal();
    const double crosstalk = tolerance[crosstalk_error] * normal();
    const double phase_drift = tolerance[phase_drift_error] * normal();
    const double gain_drift = tolerance[gain_drift_error] * normal();
    for (PhasorRun& run : set.runs) {
        const double duration = run.time_s.back() + run.window_s / 2;
        for (std::size_t k = 0; k < run.d.size(); ++k) {
            const double x = run.time_s[k] / duration;
            run.d[k] = run.d[k] * std::polar(1 + gain_drift * x, phase + phase_drift * x) +
                       std::complex(std::sin(skew), crosstalk) * run.c[k];
        }
    }
}

struct Mixture {
    PhasorRun run;
    double split_hz = 0;
};

// Two modes in any mixture of both channels.
Mixture mixture(int seed) {
    std::mt19937_64 random(static_cast<std::uint64_t>(seed) + 1);
    GaussianNoise noise(static_cast<std::uint64_t>(seed) + 1);
    const auto uniform = [&] { return static_cast<double>(random() >> 11) * 0x1p-53; };
    const auto normal = [&] {
        const auto [re, im] = noise.next();
        return std::complex(re, im);
    };
    const double seconds = 3 + 25 * uniform();
    const double split = std::pow(10, -1 + 1.7 * uniform());
    const double tau_1 = seconds * (0.2 + uniform());
    const double tau_2 = tau_1 * (0.8 + 0.4 * uniform());
    const std::array<std::complex<double>, 4> share{normal(), normal(), normal(), normal()};
    const double sd = 0.1 * std::pow(10, -1.5 - 1.5 * uniform());
    const auto windows = static_cast<int>(std::max(120.0, seconds * split * 12));
    PhasorRun run;
    run.f_ref_hz = 3600;
    run.window_s = seconds / windows;
    for (int k = 0; k < windows; ++k) {
        const double t = (k + 0.5) * run.window_s;
        const auto one = std::exp(std::complex(-t / tau_1, pi * split * t));
        const auto two = std::exp(std::complex(-t / tau_2, -pi * split * t));
        run.time_s.push_back(t);
        run.c.push_back(share[0] * one + share[1] * two + sd * normal());
        run.d.push_back(share[2] * one + share[3] * two + sd * normal());
        run.sd.push_back(sd);
    }
    return {std::move(run), split};
}

void add_beat(const ResonatorFit& fit, double split_hz, Pulls& beat) {
    if (fit.modes.size() != 2) {
        return;
    }
    const Estimate& upper = fit.modes[0].f_hz;
    const Estimate& lower = fit.modes[1].f_hz;
    beat.add({upper.value - lower.value, std::hypot(upper.sd, lower.sd), {}}, split_hz);
}

}  // namespace

class TestResonatorTrial : public QObject {
    Q_OBJECT

private slots:
    void random_sets_are_right_within_their_uncertainty() {
        constexpr int sets = 400;
        Tally tally;
        int free = 0;
        int coloured = 0;
        int words = 0;
        std::mutex mutex;
        for_each_seed(sets, [&](int seed) {
            const RandomSet set = random_set(static_cast<std::uint64_t>(seed) + 1);
            Result<ResonatorFit> fit = fit_resonator(set.runs, {}, {});
            if (fit) {
                judge_free_decay(set.runs, {}, {}, *fit);
            }
            const std::lock_guard lock(mutex);
            words += fit && says_verdict(*fit) ? 1 : 0;
            if (!fit || fit->model != ResonatorModel::structured) {
                ++free;
                return;
            }
            coloured += fit->noise.white() ? 0 : 1;
            add(set, *fit, tally);
        });
        for (const auto& [name, pulls] : tally) {
            qInfo("%-9s %s", name.c_str(), qPrintable(pulls.text()));
        }
        VYBEG_AT_MOST(free, 2);
        VYBEG_AT_MOST(coloured, sets / 20);
        VYBEG_LESS(words, 0.01 * sets);  // "no free decay" of a free decay
        for (const auto& [name, pulls] : tally) {
            const QString text = QString("%1: %2").arg(name.c_str(), pulls.text());
            // The gain ratio, and what rests on it, is drawn uniformly inside its prior's width.
            const bool of_kappa = name == "kappa" || name == "a_A" || name == "2theta";
            VYBEG_LESS(pulls.rms(), 1.1, qPrintable(text));
            VYBEG_MORE(pulls.rms(), (of_kappa ? 0.75 : 0.85), qPrintable(text));
            VYBEG_LESS(pulls.worst, 4.6, qPrintable(text));
        }
        // Refusals of one 400 in FIT section 7, with the scatter of other seeds.
        const std::map<std::string, int> most_refused{
            {"split", 90}, {"theta_w", 95}, {"g", 135},   {"theta_tau", 150},
            {"rate", 95},  {"decay", 30},   {"f_mean", 8}};
        for (const auto& [name, most] : most_refused) {
            VYBEG_AT_MOST(tally[name].refused, most,
                          qPrintable(QString("%1: %2").arg(name.c_str(), tally[name].text())));
        }
    }

    // FIT section 7: of 200 sets whose gain ratio is told, g is given in 173, the rotation in 185,
    // the split in 163; other seeds scatter by six.
    void a_told_gain_ratio_gives_more() {
        constexpr int sets = 200;
        Tally tally;
        std::mutex mutex;
        for_each_seed(sets, [&](int seed) {
            RandomSet set = random_set(static_cast<std::uint64_t>(seed) + 3001);
            for (PhasorRun& run : set.runs) {
                for (std::complex<double>& d : run.d) {
                    d *= set.resonator.kappa;
                }
            }
            set.resonator.kappa = 1;
            const Result<ResonatorFit> fit = fit_resonator(set.runs, {.tolerance = {}}, {});
            const std::lock_guard lock(mutex);
            if (fit && fit->model == ResonatorModel::structured) {
                add(set, *fit, tally);
            }
        });
        for (const auto& [name, least] :
             {std::pair{"split", 151}, {"g", 161}, {"rate", 173}, {"decay", 180}}) {
            const QString text = QString("%1: %2").arg(name, tally[name].text());
            qInfo("%s", qPrintable(text));
            VYBEG_AT_LEAST(tally[name].given, least, qPrintable(text));
            VYBEG_LESS(tally[name].worst, 4.6, qPrintable(text));
        }
    }

    void errors_of_the_channels_lie_within_their_tolerances_data() {
        QTest::addColumn<bool>("told");
        QTest::addColumn<double>("phase_rad");
        QTest::newRow("told") << true << 1e-3;
        QTest::newRow("assumed: 10 ns at 5300 Hz") << false << 3.3e-4;
    }

    // The fit holds assumed ones at zero, so that only the sensitivities bring them into u.
    void errors_of_the_channels_lie_within_their_tolerances() {
        QFETCH(bool, told);
        QFETCH(double, phase_rad);
        constexpr int sets = 400;
        const ChannelTolerance tolerance{0.01, 0.1 * pi / 180, phase_rad, 1e-4, 1e-4, 1e-4};
        Tally tally;
        int free = 0;
        int warned = 0;
        std::mutex mutex;
        for_each_seed(sets, [&](int seed) {
            RandomSet set = random_set(static_cast<std::uint64_t>(seed) + 5001);
            std::mt19937_64 random(static_cast<std::uint64_t>(seed) + 9001);
            spoil(set, random, tolerance);
            const FitOptions options =
                told ? FitOptions{.tolerance = tolerance} : FitOptions{.assumed = tolerance};
            const Result<ResonatorFit> fit = fit_resonator(set.runs, options, {});
            const std::lock_guard lock(mutex);
            if (!fit || fit->model != ResonatorModel::structured) {
                ++free;
                return;
            }
            // Of these sets a warning says that their numbers may be off by more than u.
            const bool told_off = std::ranges::any_of(fit->warnings, [](const Diagnostic& each) {
                return each.kind == DiagnosticKind::prior_left ||
                       each.kind == DiagnosticKind::quadrature_by_channel ||
                       each.kind == DiagnosticKind::anisotropy_not_passive ||
                       each.kind == DiagnosticKind::foreign_recording ||
                       each.kind == DiagnosticKind::foreign_among ||
                       each.kind == DiagnosticKind::set_inconsistent;
            });
            warned += told_off ? 1 : 0;
            if (!told_off) {
                add(set, *fit, tally);
            }
        });
        qInfo("warned: %d", warned);
        VYBEG_AT_MOST(warned, sets / 100);
        Pulls all;
        for (const auto& [name, pulls] : tally) {
            qInfo("%-9s %s", name.c_str(), qPrintable(pulls.text()));
            // Those of the starts rest on the gain ratio, which is not drawn from its prior.
            if (name != "a_A" && name != "2theta" && name != "kappa") {
                all.given += pulls.given;
                all.within += pulls.within;
                VYBEG_LESS(pulls.worst, 5, qPrintable(QString(name.c_str()) + ": " + pulls.text()));
            }
        }
        VYBEG_AT_MOST(free, 8);
        VYBEG_MORE(all.share(), 0.93);
        VYBEG_LESS(all.share(), 0.97);
    }

    // TRUTH row 5: two microphones hear some mixtures of two modes.
    void mixtures_of_two_modes_are_no_resonator() {
        constexpr int mixtures = 200;
        int claims = 0;
        Pulls beat;
        std::mutex mutex;
        for_each_seed(mixtures, [&](int seed) {
            const auto [run, split] = mixture(seed);
            const Result<ResonatorFit> fit = fit_resonator({&run, 1}, {}, {});
            const std::lock_guard lock(mutex);
            if (!fit || fit->model == ResonatorModel::structured) {
                ++claims;
            } else {
                add_beat(*fit, split, beat);
            }
        });
        QCOMPARE(claims, 0);
        QVERIFY2(beat.given == mixtures, qPrintable(beat.text()));
        VYBEG_LESS(beat.worst, 4.6, qPrintable(beat.text()));
    }

    // Row 39: they do so in both halves, which are no recordings of two resonators.
    void halves_of_a_mixture_are_one_set() {
        constexpr int mixtures = 60;
        int sets = 0;
        int refused = 0;
        Pulls beat;
        std::mutex mutex;
        for_each_seed(mixtures, [&](int seed) {
            const auto [whole, split] = mixture(seed);
            const std::size_t half = whole.time_s.size() / 2;
            const double half_s = whole.time_s[half] - whole.time_s[0];
            constexpr double told_apart = 2;  // beats in a half
            if (split * half_s < told_apart) {
                return;
            }
            std::vector<PhasorRun> halves{whole, whole};
            const auto cut = [&halves, half](auto column) {
                (halves[0].*column).resize(half);
                auto& second = halves[1].*column;
                second.erase(second.begin(), second.begin() + static_cast<std::ptrdiff_t>(half));
            };
            cut(&PhasorRun::time_s);
            cut(&PhasorRun::sd);
            cut(&PhasorRun::c);
            cut(&PhasorRun::d);
            for (double& time_s : halves[1].time_s) {
                time_s -= half_s;
            }
            const Result<ResonatorFit> fit = fit_resonator(halves, {}, {});
            const std::lock_guard lock(mutex);
            ++sets;
            if (!fit || fit->modes.size() != 2 || !fit->modes[0].f_hz.given()) {
                ++refused;
            } else {
                add_beat(*fit, split, beat);
            }
        });
        VYBEG_AT_LEAST(sets, 30);
        VYBEG_AT_MOST(refused, sets / 10);
        VYBEG_LESS(beat.worst, 4.6, qPrintable(beat.text()));
    }

    // TRUTH row 6: a second phasor in each channel that wanders with a width.
    void noise_about_the_carrier_is_in_the_deviations_data() {
        QTest::addColumn<double>("sd");
        QTest::addColumn<double>("half_width_hz");
        for (const auto& [sd, width] : {std::pair{1e-5, 0.05},
                                        {1e-5, 0.2},
                                        {1e-5, 1.0},
                                        {1e-4, 0.05},
                                        {1e-4, 0.2},
                                        {1e-4, 1.0},
                                        {1e-3, 0.05},
                                        {1e-3, 0.2},
                                        {1e-3, 1.0}}) {
            QTest::newRow(qPrintable(QString("%1, %2 Hz").arg(sd).arg(width))) << sd << width;
        }
    }

    void noise_about_the_carrier_is_in_the_deviations() {
        QFETCH(double, sd);
        QFETCH(double, half_width_hz);
        constexpr int seeds = 16;
        constexpr int parts = 8;  // of a window, over which the noise is averaged
        Pulls all;
        int free = 0;
        std::mutex mutex;
        for_each_seed(seeds, [&](int seed) {
            const FreeDecay gyro{.split_hz = 1e-3,
                                 .theta_w = 0.2,
                                 .tau_s = 400,
                                 .damping_anisotropy_per_s = 2e-4,
                                 .theta_tau = -0.3,
                                 .noise = 1e-3};
            GaussianNoise noise(static_cast<std::uint64_t>(seed) + 77);
            std::vector<PhasorRun> runs;
            for (int k = 0; k < 4; ++k) {
                FreeDecay decay = gyro;
                decay.two_theta_A = 0.3 + k * pi / 4;
                decay.alpha = 0.4 + k;
                runs.push_back(simulated_phasors(
                    decay, 500, static_cast<std::uint64_t>(100 * seed + k + 1), 0.003 * k));
                PhasorRun& run = runs.back();
                const double keeps = std::exp(-2 * pi * half_width_hz * run.window_s / parts);
                const double gains = sd * std::sqrt(1 - keeps * keeps);
                for (std::vector<std::complex<double>>* signal : {&run.c, &run.d}) {
                    const auto [re, im] = noise.next();
                    std::complex<double> x = sd * std::complex(re, im);
                    for (std::complex<double>& phasor : *signal) {
                        for (int part = 0; part < parts; ++part) {
                            phasor += x / static_cast<double>(parts);
                            const auto [step_re, step_im] = noise.next();
                            x = keeps * x + gains * std::complex(step_re, step_im);
                        }
                    }
                }
            }
            const Result<ResonatorFit> fit = fit_resonator(runs, {}, {});
            const std::lock_guard lock(mutex);
            if (!fit || fit->model != ResonatorModel::structured) {
                ++free;
                return;
            }
            const ResonatorEstimate& found = fit->resonator;
            all.add(found.f_mean_hz, 5300 + 0.0045);
            all.add(found.split_hz, gyro.split_hz);
            all.add(found.theta_w_rad, gyro.theta_w, pi / 2);
            all.add(rate_of(found.tau_s), 1 / gyro.tau_s);
            all.add(found.damping_anisotropy_per_s, gyro.damping_anisotropy_per_s);
            all.add(found.angle_rate_rad_s, 0);
            for (int k = 0; k < 4; ++k) {
                all.add(fit->runs[static_cast<std::size_t>(k)].a_B, 0);
            }
        });
        VYBEG_EQUAL(free, 0);
        VYBEG_MORE(all.given, 6 * seeds, qPrintable(all.text()));
        VYBEG_MORE(all.rms(), 0.7, qPrintable(all.text()));
        VYBEG_LESS(all.rms(), 1.5, qPrintable(all.text()));
    }
};

VYBEG_TEST(TestResonatorTrial, first)

}  // namespace test_resonator_trial

#include "test_resonator_trial.moc"
