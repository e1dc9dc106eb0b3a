// Two fits of one resonator against each other, as a passport and later recordings are.
//
// Statistical model: the passport's and the later runs have noise of their own, so that each
// difference of a comparison is Gaussian with the deviation it states. A comparison calls something
// changed by chance in 0.27 % of all cases: of a hundred, none is expected, and two or more have a
// chance of 3 %.
#include "core/analysis/passport.h"
#include "tests/closeness.h"
#include "tests/core/resonator/known_resonator.h"
#include "tests/test_registry.h"

namespace test_resonator_compare {

using namespace vybeg;
using namespace vybeg::test;

namespace {

constexpr std::int64_t window = 12000;

Passport passport_of(const ResonatorFit& fit) {
    Passport passport;
    passport.model = fit.model;
    passport.resonator = fit.resonator;
    passport.modes = fit.modes;
    passport.mode_order = fit.mode_order;
    passport.runs = fit.runs;
    return passport;
}

QString changed_ones(const std::vector<Difference>& differences) {
    QString text;
    for (const Difference& difference : differences) {
        if (difference.verdict == Verdict::changed) {
            text += QString("%1 by %2 of its deviations; ")
                        .arg(QString::fromStdString(difference.name))
                        .arg(difference.deviations());
        }
    }
    return text;
}

bool has_comparable(const std::vector<Difference>& differences, const std::string& name) {
    return std::ranges::any_of(differences, [&](const Difference& difference) {
        return difference.name == name && difference.verdict != Verdict::not_comparable;
    });
}

}  // namespace

class TestResonatorCompare : public QObject {
    Q_OBJECT

private slots:
    void a_resonator_is_not_changed_against_itself_data() {
        QTest::addColumn<double>("split_hz");
        QTest::addColumn<double>("anisotropy_per_s");
        QTest::addColumn<QString>("compared");
        // Named by frequency, the decay times of the first were exchanged at random: "changed" by
        // up to 231 deviations.
        QTest::newRow("modes told by decay alone") << 2e-7 << 2e-4 << "modes[0].tau_s";
        QTest::newRow("modes told by frequency") << 1e-3 << 2e-4 << "modes[0].f_hz";
    }

    void a_resonator_is_not_changed_against_itself() {
        QFETCH(double, split_hz);
        QFETCH(double, anisotropy_per_s);
        QFETCH(QString, compared);
        FreeDecay decay = reference();
        decay.split_hz = split_hz;
        decay.theta_w = 0.2;
        decay.damping_anisotropy_per_s = anisotropy_per_s;
        decay.theta_tau = -0.3;
        constexpr int pairs = 100;
        int changed = 0;
        int comparable = 0;
        QString which;
        for (int pair = 0; pair < pairs; ++pair) {
            const auto seed = static_cast<std::uint64_t>(pair);
            const ResonatorFit then = fitted(set_of(decay, four_angles, window, 2 * seed + 1));
            const ResonatorFit now = fitted(set_of(decay, four_angles, window, 2 * seed + 2));
            const std::vector<Difference> differences = compare(passport_of(then), now);
            const QString found = changed_ones(differences);
            changed += found.isEmpty() ? 0 : 1;
            which += found;
            comparable += has_comparable(differences, compared.toStdString()) ? 1 : 0;
        }
        // One of a hundred comparisons by chance (that of pair 45: -2.5 against 2.7 deviations);
        // none of the modes, which were exchanged once.
        VYBEG_AT_MOST(changed, 1, qPrintable(which));
        QVERIFY2(!which.contains("modes"), qPrintable(which));
        VYBEG_AT_LEAST(comparable, 95);
    }

    // A temperature moves the frequency by 20 ppm, below the limit of 30, and Q with it.
    void a_temperature_changes_nothing() {
        FreeDecay decay = reference();
        decay.split_hz = 1e-3;
        decay.theta_w = 0.2;
        decay.damping_anisotropy_per_s = 2e-4;
        decay.theta_tau = -0.3;
        FreeDecay warm = decay;
        warm.f0_hz *= 1 + 20e-6;
        for (std::uint64_t seed = 1; seed <= 30; ++seed) {
            const ResonatorFit then = fitted(set_of(decay, four_angles, window, 3000 + 2 * seed));
            const ResonatorFit now = fitted(set_of(warm, four_angles, window, 3001 + 2 * seed));
            const std::vector<Difference> differences = compare(passport_of(then), now);
            QVERIFY(has_comparable(differences, "q"));
            QVERIFY2(changed_ones(differences).isEmpty(), qPrintable(changed_ones(differences)));
        }
    }

    void a_resonator_that_has_changed_is_seen() {
        FreeDecay decay = reference();
        decay.split_hz = 1e-3;
        decay.theta_w = 0.2;
        FreeDecay other = decay;
        other.split_hz = 1.02e-3;
        for (std::uint64_t seed = 1; seed <= 5; ++seed) {
            const ResonatorFit then = fitted(set_of(decay, four_angles, window, 900 + seed));
            const ResonatorFit now = fitted(set_of(other, four_angles, window, 950 + seed));
            const std::vector<Difference> differences = compare(passport_of(then), now);
            const QString found = changed_ones(differences);
            QVERIFY2(found.startsWith("split_hz"), qPrintable(found));
        }
    }

    // f and tau of one direction were called the resonator's: 1700 deviations apart.
    void still_waves_of_other_directions_are_not_comparable() {
        FreeDecay decay = reference();
        decay.split_hz = 1e-4;
        decay.theta_w = 0.2;
        decay.damping_anisotropy_per_s = 3e-4;
        decay.theta_tau = -0.3;
        for (std::uint64_t seed = 1; seed <= 5; ++seed) {
            const auto fit_at = [&](double angle, std::uint64_t noise) {
                return fitted(set_of(decay, {angle}, window, 100 * seed + noise));
            };
            const Passport passport = passport_of(fit_at(10, 1));
            const std::vector<Difference> same = compare(passport, fit_at(10.5, 2));
            const std::vector<Difference> other = compare(passport, fit_at(40, 3));
            QVERIFY2(changed_ones(same).isEmpty(), qPrintable(changed_ones(same)));
            QVERIFY2(changed_ones(other).isEmpty(), qPrintable(changed_ones(other)));
            QVERIFY(has_comparable(same, "f_mean_hz") ||
                    has_comparable(same, "runs[0].direction.f_hz"));
            QVERIFY(!has_comparable(other, "runs[0].direction.f_hz"));
            QVERIFY(!has_comparable(other, "runs[0].direction.tau_s"));
        }
    }
};

VYBEG_TEST(TestResonatorCompare)

}  // namespace test_resonator_compare

#include "test_resonator_compare.moc"
