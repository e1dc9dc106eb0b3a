// One case from samples for each statement of TRUTH about the resonator, through everything that
// `identify` does: the sweeps of those rows draw phasors. Every number that is given lies within
// five of its combined uncertainties of the truth, over two seeds; what must be refused is refused,
// what must be named is named.
#include "core/analysis/identify.h"
#include "tests/closeness.h"
#include "tests/needed.h"
#include "tests/statistical/simulated_recording.h"
#include "tests/test_registry.h"

#include <QtTest>

#include <algorithm>
#include <cmath>
#include <memory>
#include <numbers>
#include <optional>
#include <string>
#include <vector>

namespace test_rows_from_samples {

using namespace vybeg;
using namespace vybeg::test;
using std::numbers::pi;

namespace {

FreeDecay gyro() {
    FreeDecay decay{.f0_hz = 5300.37,
                    .split_hz = 1e-3,
                    .theta_w = 0.2,
                    .tau_s = 400,
                    .damping_anisotropy_per_s = 2e-4,
                    .theta_tau = -0.3,
                    .noise = 1e-3};
    return decay;
}

struct Case {
    FreeDecay truth = gyro();
    std::vector<double> angles_deg{8.6, 31.1, 53.6, 76.1};
    IdentifySettings settings;
    // Parameters that must be given, by their names; all others are right or refused.
    std::vector<std::string> given;
    std::vector<std::string> refused;
    std::optional<DiagnosticKind> warning;
    double amplitude_step = 0;  // of a_A from run to run
    bool f_mean_is_f0 = true;   // else among the frequencies that occurred, settling or power
};

struct Number {
    std::string name;
    const Estimate* estimate;
    double truth;
    double period;
};

Identification identified(const Case& one, int seed) {
    std::vector<Recording> recordings;
    for (std::size_t k = 0; k < one.angles_deg.size(); ++k) {
        FreeDecay run = one.truth;
        run.two_theta_A = 2 * one.angles_deg[k] * pi / 180;
        run.alpha = 0.4 + 1.7 * static_cast<double>(k);
        run.a_A += one.amplitude_step * static_cast<double>(k);
        run.seed = static_cast<std::uint64_t>(100 * seed) + k + 1;
        recordings.push_back(simulated_recording(run));
    }
    return needed(identify(recordings, one.settings, {}));
}

std::vector<Number> numbers_of(const Case& one, const Identification& found) {
    const ResonatorEstimate& r = found.fit.resonator;
    const FreeDecay& t = one.truth;
    std::vector<Number> numbers{{"split", &r.split_hz, t.split_hz, 0},
                                {"theta_w", &r.theta_w_rad, t.theta_w, pi / 2},
                                {"tau", &r.tau_s, t.tau_s, 0},
                                {"g", &r.damping_anisotropy_per_s, t.damping_anisotropy_per_s, 0},
                                {"theta_tau", &r.theta_tau_rad, t.theta_tau, pi / 2},
                                {"rate", &r.angle_rate_rad_s, -t.bryan * t.omega_rad_s, 0},
                                {"kappa", &r.kappa, t.kappa, 0},
                                {"b", &r.frequency_per_power, t.frequency_per_power_hz, 0}};
    if (one.f_mean_is_f0) {
        numbers.push_back({"f_mean", &r.f_mean_hz, t.f0_hz, 0});
    }
    return numbers;
}

}  // namespace

class TestRowsFromSamples : public QObject {
    Q_OBJECT

private slots:
    void every_given_number_is_right_data() {
        QTest::addColumn<std::shared_ptr<Case>>("one");
        const auto row = [](const char* name, Case one) {
            QTest::newRow(name) << std::make_shared<Case>(std::move(one));
        };
        const std::vector<std::string> most{"split", "theta_w", "tau", "g", "rate", "f_mean"};
        Case one;
        one.given = most;
        row("exact", one);
        one = {};
        one.truth.split_hz = 0.03;
        one.angles_deg = {22.5 + 0.2 * 180 / pi};
        row("1: near the circular state", one);
        one = {};
        one.truth.kappa = 1.008;
        one.truth.omega_rad_s = 0.06;
        one.given = {"split", "theta_w", "tau", "rate", "kappa"};
        row("4: gain ratio and rotation, four runs", one);
        one.angles_deg = {20};
        one.truth.omega_rad_s = 0.2;
        one.given = {"rate"};
        row("4: gain ratio and rotation, one run", one);
        one = {};
        one.truth.carrier_noise = 1e-4;
        one.truth.carrier_noise_width_hz = 0.2;
        one.given = {"split", "tau", "rate", "f_mean"};
        one.warning = DiagnosticKind::residual_coloured;
        row("6: noise about the carrier", one);
        one = {};
        one.truth.phase_noise_rad = 1e-3;
        one.given = {"split", "tau", "rate", "f_mean"};
        one.warning = DiagnosticKind::residual_coloured;
        row("6: 1/f noise of the phase", one);
        one = {};
        one.truth.settling_hz = 2e-3;
        one.truth.settling_time_s = 4;
        one.f_mean_is_f0 = false;
        one.given = {"split", "theta_w", "tau", "rate"};
        one.refused = {"b"};
        one.warning = DiagnosticKind::misfit_settling;
        row("7: a settling frequency", one);
        one = {};
        one.truth.frequency_per_power_hz = 0.03;
        one.amplitude_step = -0.2;
        one.f_mean_is_f0 = false;
        one.given = {"split", "theta_w", "tau", "b"};
        row("7: a cubic spring", one);
        one = {};
        one.truth.split_hz = 0.03;
        one.truth.frequency_per_power_hz = 0.01;
        one.truth.kappa = 0.994;
        one.angles_deg = {31.1};
        one.f_mean_is_f0 = false;
        one.given = {"split", "kappa"};
        row("8: a cubic spring and a gain ratio, one run", one);
        one = {};
        one.truth.split_hz = 1e-4;
        one.angles_deg = {40};
        row("10: one still wave", one);
        one.angles_deg = {10, 10.5};
        row("10: two starts in one direction", one);
        one = {};
        one.truth.omega_rad_s = 0.01;
        one.angles_deg = {15};
        one.truth.split_hz = 0;
        one.truth.damping_anisotropy_per_s = 0;
        row("12: one wave that turns", one);
        one = {};
        one.truth.offset_c = 0.01;
        one.truth.offset_d = -0.02;
        one.truth.hum = 0.003;
        one.given = most;
        row("13: offset and hum", one);
        one = {};
        one.truth.skew_deg = 0.08;
        one.truth.delay_d_s = 8e-9;
        one.truth.gain_drift = 1e-4;
        one.truth.phase_drift_rad = -7e-5;
        for (const auto& [source, size] : {std::pair{skew_error, 0.1},
                                           {delay_error, 1e-8},
                                           {crosstalk_error, 1e-4},
                                           {phase_drift_error, 1e-4},
                                           {gain_drift_error, 1e-4}}) {
            one.settings.tolerance[source] = size;
        }
        row("14: errors of the channels within their tolerances", one);
        one = {};
        one.truth.damping_per_power_per_s = 5e-4;
        one.truth.tau_s = 400;
        one.warning = DiagnosticKind::misfit_damping;
        row("damping that follows the amplitude", one);
        one = {};
        one.truth.lost = {{300000, 6}};
        one.truth.split_hz = 0.7;
        one.angles_deg = {31.1};
        one.given = {"split", "tau"};
        one.warning = std::nullopt;
        row("16: lost samples in a beat", one);
        one = {};
        one.settings.signal.filter = Band{5250, 5350};
        one.given = most;
        row("18: behind a band-pass", one);
        one = {};
        one.truth.tau_s = 28 * 1000;
        one.truth.damping_anisotropy_per_s = 0;
        one.truth.noise = 3e-2;
        row("19: hardly a decay", one);
    }

    void every_given_number_is_right() {
        QFETCH(std::shared_ptr<Case>, one);
        for (const int seed : {1, 2}) {
            const Identification found = identified(*one, seed);
            QVERIFY(found.fit.model == ResonatorModel::structured);
            const bool named_misfit = one->warning == DiagnosticKind::misfit_damping;
            if (one->warning) {
                QVERIFY(std::ranges::find(found.fit.warnings, *one->warning, &Diagnostic::kind) !=
                        found.fit.warnings.end());
            }
            for (const Number& number : numbers_of(*one, found)) {
                const auto listed = [&](const std::vector<std::string>& names) {
                    return std::ranges::find(names, number.name) != names.end();
                };
                const Estimate& estimate = *number.estimate;
                const QString text = QString("%1 = %2 +- %3 for %4")
                                         .arg(number.name.c_str())
                                         .arg(estimate.value, 0, 'g', 12)
                                         .arg(estimate.uncertainty())
                                         .arg(number.truth, 0, 'g', 12);
                QVERIFY2(!listed(one->refused) || !estimate.given(), qPrintable(text));
                QVERIFY2(!listed(one->given) || estimate.given(), qPrintable(text));
                if (!estimate.given() || (named_misfit && number.name == "tau")) {
                    continue;
                }
                const double off =
                    number.period > 0 ? std::remainder(estimate.value - number.truth, number.period)
                                      : estimate.value - number.truth;
                VYBEG_CLOSE(off, 0, 5 * estimate.uncertainty(), qPrintable(text));
            }
            if (!one->f_mean_is_f0 && found.fit.resonator.f_mean_hz.given()) {
                const double off = found.fit.resonator.f_mean_hz.value - one->truth.f0_hz;
                const double most =
                    std::max(one->truth.settling_hz, one->truth.frequency_per_power_hz);
                VYBEG_MORE(off, 0);
                VYBEG_LESS(off, most);
            }
        }
    }

    // Row 5, from samples: a pair before two microphones, each a mixture of its own.
    void two_microphones_are_no_resonator() {
        for (int seed = 1; seed <= 3; ++seed) {
            const FreeDecay mixture{
                .seconds = 8,
                .f0_hz = 3618,
                .a_A = 0.6,
                .tau_s = 2,
                .noise = 1e-3,
                .seed = static_cast<std::uint64_t>(seed),
                .modes_beside = {{3618.9 + seed, 0.5, 0.3 * seed, 0.7 * seed, 2.0 - seed, 1.7}}};
            const std::vector<Recording> recordings{simulated_recording(mixture)};
            const Result<Identification> found = identify(recordings, {}, {});
            QVERIFY(found);
            QVERIFY(found->fit.model == ResonatorModel::free);
            QCOMPARE(found->fit.modes.size(), std::size_t{2});
            VYBEG_CLOSE(found->fit.modes[0].f_hz.value - 3618.9, seed,
                        5 * found->fit.modes[0].f_hz.uncertainty());
            VYBEG_CLOSE(found->fit.modes[1].f_hz.value, 3618,
                        5 * found->fit.modes[1].f_hz.uncertainty());
        }
    }
};

VYBEG_TEST(TestRowsFromSamples, first)

}  // namespace test_rows_from_samples

#include "test_rows_from_samples.moc"
