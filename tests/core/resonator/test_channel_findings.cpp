// What a fit says of channel errors that are far from what is known of them.
#include "core/base/diagnostic.h"
#include "core/resonator/results/channel_findings.h"
#include "tests/closeness.h"
#include "tests/core/resonator/known_resonator.h"
#include "tests/test_registry.h"

namespace test_channel_findings {

using namespace vybeg;
using namespace vybeg::test;
using std::numbers::pi;

namespace {

constexpr std::int64_t window = 3333;

FreeDecay resonator() {
    FreeDecay decay = reference();
    decay.tau_s = 60;
    decay.split_hz = 0.02;
    decay.theta_w = 0.2;
    decay.damping_anisotropy_per_s = 1e-3;
    decay.theta_tau = -0.3;
    return decay;
}

constexpr std::array kinds{DiagnosticKind::prior_left, DiagnosticKind::quadrature_by_channel,
                           DiagnosticKind::misfit_channel, DiagnosticKind::anisotropy_not_passive};

}  // namespace

class TestChannelFindings : public QObject {
    Q_OBJECT

private slots:
    void a_delay_is_a_phase_where_the_frequency_is_unknown() {
        const ToleratedError& delay = tolerated_errors[delay_error];
        QVERIFY(named_error(delay, -2 * pi * 1e-5, 1000).at(1) == number_arg(10, 2, "ns"));
        QVERIFY(named_error(delay, -0.01, 0).at(1) == number_arg(0.01, 2, "rad"));
    }

    // Waves of no quadrature and of any, the same at all angles or not.
    void good_channels_say_nothing() {
        for (std::uint64_t seed = 1; seed <= 12; ++seed) {
            std::vector<PhasorRun> runs;
            for (std::size_t k = 0; k < 4 + seed % 3; ++k) {
                FreeDecay decay = resonator();
                decay.two_theta_A = 0.3 + static_cast<double>(k) * pi / 4;
                const double random =
                    std::sin(100.0 * static_cast<double>(seed) + 37.0 * static_cast<double>(k));
                decay.a_B = seed % 2 == 0 ? 0.01 * random : 1e-3;
                decay.kappa = 1.008;
                runs.push_back(simulated_phasors(decay, window, 100 * seed + k));
            }
            const ResonatorFit fit = fitted(runs, assuming);
            for (const DiagnosticKind kind : kinds) {
                QVERIFY2(!warns(fit, kind), kind_name(kind).c_str());
            }
        }
    }

    // A line passes through two angles, however often each is recorded: 12 of 15 faultless sets
    // were told of a delay or a crosstalk.
    void angles_that_are_recorded_twice_say_nothing() {
        for (std::uint64_t seed = 1; seed <= 12; ++seed) {
            std::vector<PhasorRun> runs;
            const std::size_t angles = 2 + seed % 2;
            for (std::size_t k = 0; k < 2 * angles; ++k) {
                const auto angle = static_cast<double>(k % angles);
                FreeDecay decay = resonator();
                decay.two_theta_A = 0.3 + angle * (0.7 + 0.05 * static_cast<double>(seed));
                decay.a_B = 0.005 * std::sin(100.0 * static_cast<double>(seed) + 37 * angle) +
                            1e-5 * std::sin(11.0 * static_cast<double>(k));
                runs.push_back(simulated_phasors(decay, window, 100 * seed + k));
            }
            const ResonatorFit fit = fitted(runs, assuming);
            QVERIFY2(!warns(fit, DiagnosticKind::quadrature_by_channel),
                     qPrintable(QString::number(seed)));
        }
    }

    // Row 34: a gain ratio at 3.7 tolerances was taken in silence.
    void a_gain_ratio_beyond_three_tolerances_is_told() {
        for (const double kappa : {0.963, 1.028, 1.035}) {
            FreeDecay decay = resonator();
            decay.kappa = kappa;
            const ResonatorFit fit = fitted(set_of(decay, four_angles, window, 3), assuming);
            const bool far = std::abs(kappa - 1) > 0.03;
            const Diagnostic* left = warning_of(fit, DiagnosticKind::prior_left);
            QVERIFY2((left != nullptr || fit.model == ResonatorModel::free) == far,
                     qPrintable(QString::number(kappa)));
            if (left != nullptr) {
                const QString text = QString::fromStdString(english(*left));
                QVERIFY2(text.contains("kappa of"), qPrintable(text));
                QVERIFY2(text.contains(far && kappa > 1 ? "3.5 tolerances" : "3.7 tolerances"),
                         qPrintable(text));
            }
        }
    }

    // A converter that takes D half a sample after C: 15 us, which looks like a rotation.
    void quadratures_that_follow_the_angle_show_a_delay_data() {
        QTest::addColumn<double>("delay_s");
        QTest::addColumn<double>("crosstalk");
        QTest::addColumn<QString>("named");
        QTest::newRow("multiplexed") << 15e-6 << 0.0 << "delay, about 15000 ns";
        QTest::newRow("unlike corners") << -1e-7 << 0.0 << "delay, about -100 ns";
        QTest::newRow("crosstalk") << 0.0 << 1e-3 << "crosstalk, about 0.001";
        QTest::newRow("within the assumed tolerance") << 5e-9 << 1e-4 << "";
    }
    void quadratures_that_follow_the_angle_show_a_delay() {
        QFETCH(double, delay_s);
        QFETCH(double, crosstalk);
        QFETCH(QString, named);
        for (std::uint64_t seed = 1; seed <= 4; ++seed) {
            std::vector<PhasorRun> runs = set_of(resonator(), four_angles, window, seed);
            spoil(runs, channels({{delay_error, -2 * pi * 5300 * delay_s},
                                  {crosstalk_error, crosstalk}}));
            FitOptions options = assuming;
            options.model = FitOptions::Model::structured;
            const ResonatorFit fit = fitted(runs, options);
            const Diagnostic* found = warning_of(fit, DiagnosticKind::quadrature_by_channel);
            const Diagnostic* held = warning_of(fit, DiagnosticKind::misfit_channel);
            const Diagnostic* told = found != nullptr ? found : held;
            const QString text = told != nullptr ? QString::fromStdString(english(*told)) : "";
            QVERIFY2(named.isEmpty() ? text.isEmpty() : text.contains(named), qPrintable(text));
        }
    }

    // Of a base that turns, and of one that stands still before a D that comes late by more than
    // the tolerance, assumed or told.
    void a_rotation_that_a_delay_looks_like_is_told() {
        FitOptions told = assuming;
        told.tolerance[delay_error] = told.assumed[delay_error];
        for (const FitOptions& options : {assuming, told}) {
            for (const double turn_rad_s : {-1e-3, 0.0, 1e-3}) {
                FreeDecay decay = resonator();
                decay.omega_rad_s = -turn_rad_s / decay.bryan;
                const std::vector<PhasorRun> runs = set_of(decay, four_angles, window, 8);
                const ResonatorFit fit = fitted(runs, options);
                const Diagnostic* found = warning_of(fit, DiagnosticKind::rotation_or_channel);
                QCOMPARE(found != nullptr, turn_rad_s != 0);
                if (found != nullptr) {
                    const QString text = QString::fromStdString(english(*found));
                    QVERIFY2(text.contains("206 deg/h"), qPrintable(text));
                    QVERIFY2(text.contains("delay of about"), qPrintable(text));
                }
            }
        }
    }

    // Where the noise is low, errors within the assumed tolerances leave more than noise.
    void channels_within_the_assumed_tolerances_say_nothing() {
        int within = 0;
        constexpr int sets = 24;
        for (std::uint64_t seed = 1; seed <= sets; ++seed) {
            FreeDecay decay = resonator();
            decay.noise = 1e-4;
            std::vector<PhasorRun> runs = set_of(decay, {3, 29, 48, 71}, window, seed);
            spoil(runs, drawn_from(assuming.assumed, seed));
            const ResonatorFit fit = fitted(runs, assuming);
            for (const Diagnostic& warning : fit.warnings) {
                QVERIFY2(
                    severity(warning.kind) == Severity::note,
                    qPrintable(QString("seed %1: %2").arg(seed).arg(english(warning).c_str())));
            }
            within += fault(fit.resonator.split_hz, decay.split_hz, 2, 1e-3).isEmpty() ? 1 : 0;
        }
        VYBEG_AT_LEAST(within, 20);
    }

    // Nor do they hide a recording of another resonator.
    void a_foreign_recording_is_named_beside_them() {
        int named = 0;
        constexpr int sets = 4;
        for (std::uint64_t seed = 1; seed <= sets; ++seed) {
            FreeDecay decay = resonator();
            decay.noise = 1e-4;
            std::vector<PhasorRun> runs = set_of(decay, {3, 21, 39, 57, 75}, window, seed);
            FreeDecay other = decay;
            other.f0_hz += seed % 2 == 0 ? 2 : 0.01;
            other.tau_s = 90;
            other.split_hz = 0.05;
            other.theta_w = -0.5;
            const std::size_t out = seed % runs.size();
            runs[out] = set_of(other, {30}, window, seed + 50).front();
            spoil(runs, drawn_from(assuming.assumed, seed));
            const ResonatorFit fit = fitted(runs, assuming);
            named += fit.left_out == out && warns(fit, DiagnosticKind::foreign_recording) ? 1 : 0;
        }
        VYBEG_AT_LEAST(named, sets - 1);
    }

    // A residual that is noise by its chi^2 still shows an error of many tolerances.
    void a_score_names_an_error_that_chi_square_hides() {
        int named = 0;
        for (std::uint64_t seed = 1; seed <= 4; ++seed) {
            FreeDecay decay = resonator();
            decay.split_hz = 0.05;
            std::vector<PhasorRun> runs = set_of(decay, {5, 33}, window, seed);
            for (PhasorRun& run : runs) {
                for (std::size_t k = 0; k < run.d.size(); ++k) {
                    run.d[k] *= std::polar(1.0, 6e-4 * run.time_s[k] / 28);
                }
            }
            const ResonatorFit fit = fitted(runs, assuming);
            const Diagnostic* held = warning_of(fit, DiagnosticKind::misfit_channel);
            named += held != nullptr && held->args[0].text == "phase-drift" ? 1 : 0;
        }
        VYBEG_AT_LEAST(named, 3);
    }

    // The value of a passive resonator is a limit, and near it the model is in doubt.
    void an_anisotropy_at_its_limit_is_told() {
        FreeDecay decay = resonator();
        decay.damping_anisotropy_per_s = 2 / decay.tau_s;
        const ResonatorFit at = fitted(set_of(decay, four_angles, window, 5), assuming);
        QVERIFY(at.model == ResonatorModel::free ||
                warns(at, DiagnosticKind::anisotropy_not_passive));
        FitOptions structured = assuming;
        structured.model = FitOptions::Model::structured;
        QVERIFY(warns(fitted(set_of(decay, four_angles, window, 5), structured),
                      DiagnosticKind::anisotropy_not_passive));
        decay.damping_anisotropy_per_s = 1.6 / decay.tau_s;
        QVERIFY(!warns(fitted(set_of(decay, four_angles, window, 5), structured),
                       DiagnosticKind::anisotropy_not_passive));
    }
};

VYBEG_TEST(TestChannelFindings)

}  // namespace test_channel_findings

#include "test_channel_findings.moc"
