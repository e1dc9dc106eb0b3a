#include "core/analysis/identify.h"
#include "core/resonator/fit/map_fit.h"
#include "tests/closeness.h"
#include "tests/needed.h"
#include "tests/statistical/each_seed.h"
#include "tests/statistical/violated_sets.h"
#include "tests/test_registry.h"

#include <algorithm>
#include <cmath>
#include <functional>

namespace test_violated_sets {

using namespace vybeg;
using test::SetKind;

namespace {

// What became of many sets of one kind.
struct Tally {
    int fits = 0;
    int spread = 0;
    int right = 0;      // the run with the violation is named, alone
    int wrong = 0;      // another one is
    int among = 0;      // it is among those named
    int elsewhere = 0;  // others are named without it
    int refused = 0;
    int beyond = 0;  // a given number is further than four u from the truth
    int given = 0;   // split, decay or rotation is
};

bool names(const ResonatorFit& fit, std::size_t run) {
    for (const Diagnostic& warning : fit.warnings) {
        if (warning.kind == DiagnosticKind::foreign_among) {
            const std::string named = " " + english(warning.args[0]) + " ";
            return named.find(" " + std::to_string(run + 1) + " ") != std::string::npos;
        }
    }
    return false;
}

using MakeSet = std::function<test::ViolatedSet(std::uint64_t seed)>;

Tally tally(int count, const MakeSet& make, const FitOptions& options = {.spread = {}}) {
    std::vector<Tally> each(static_cast<std::size_t>(count));
    test::for_each_seed(count, [&](int k) {
        const test::ViolatedSet set = make(static_cast<std::uint64_t>(k) + 1);
        const ResonatorFit fit = test::needed(fit_resonator(set.runs, options, {}));
        Tally& out = each[static_cast<std::size_t>(k)];
        if (fit.left_out) {
            (*fit.left_out == set.bad ? out.right : out.wrong) = 1;
        } else if (test::has(fit, DiagnosticKind::foreign_among)) {
            (names(fit, set.bad) ? out.among : out.elsewhere) = 1;
        } else if (test::has(fit, DiagnosticKind::set_inconsistent)) {
            out.refused = 1;
        } else if (test::has(fit, DiagnosticKind::recordings_differ)) {
            out.spread = 1;
        } else {
            out.fits = 1;
        }
        out.beyond = test::worst_pull(fit, set.resonator) > 4 ? 1 : 0;
        out.given = fit.resonator.split_hz.given() || fit.resonator.tau_s.given() ? 1 : 0;
    });
    Tally sum;
    for (const Tally& one : each) {
        sum.fits += one.fits;
        sum.spread += one.spread;
        sum.right += one.right;
        sum.wrong += one.wrong;
        sum.among += one.among;
        sum.elsewhere += one.elsewhere;
        sum.refused += one.refused;
        sum.beyond += one.beyond;
        sum.given += one.given;
    }
    return sum;
}

Tally tally(SetKind kind, int count, std::size_t runs, double least, double most,
            double two_theta_zero = 0, const FitOptions& options = {.spread = {}}) {
    const auto make = [=](std::uint64_t seed) {
        // Sizes in a fixed order without a relation to the seeds' sets.
        const double share = std::fmod(static_cast<double>(seed - 1) * 0.618034, 1.0);
        const double size = least * std::pow(most / least, share);
        return test::violated_set(kind, seed, size, runs, two_theta_zero);
    };
    return tally(count, make, options);
}

// What a violation adds to the chi^2 of all runs under one resonator, in standard deviations.
double misfit_of(const test::ViolatedSet& set, const test::ViolatedSet& faultless,
                 const ResonatorFit& fit) {
    Eigen::VectorXd start = fit.motion.shared;
    for (const FittedMotion::Run& run : fit.motion.runs) {
        start.conservativeResize(start.size() + run.own.size());
        start.tail(run.own.size()) = run.own;
    }
    const auto chi2 = [&](const std::vector<PhasorRun>& runs) {
        FitProblem problem = problem_of(scaled_runs(runs, fit.motion.scale));
        problem.priors = structured_priors(problem.runs, problem.layout, untold_channels);
        return minimise(problem, start, 200, {}).chi2;
    };
    return std::sqrt(std::max(0.0, chi2(set.runs) - chi2(faultless.runs)));
}

// A set of four with a part of another gyro that adds about `wanted` deviations.
test::ViolatedSet set_of_misfit(double wanted, std::uint64_t seed) {
    const auto set = [&](double size) { return test::violated_set(SetKind::part, seed, size, 4); };
    const test::ViolatedSet faultless = set(0);
    const ResonatorFit fit = test::needed(fit_resonator(faultless.runs, {.spread = {}}, {}));
    // In proportion from a misfit far above the noise.
    constexpr double clear = 20;
    double size = 1e-3;
    for (int k = 0; k < 4; ++k) {
        const double misfit = misfit_of(set(size), faultless, fit);
        size = std::min(1.0, size * std::clamp(clear / std::max(misfit, 1e-3), 1e-3, 1e3));
    }
    size *= wanted / clear;
    return set(size);
}

}  // namespace

class TestViolatedSets : public QObject {
    Q_OBJECT

private slots:
    void faultless_sets_fit_and_their_numbers_are_right() {
        const Tally sets = tally(SetKind::faultless, 40, 0, 0, 0);
        VYBEG_EQUAL(sets.fits, 40);
        VYBEG_EQUAL(sets.beyond, 0);
        VYBEG_AT_LEAST(sets.given, 36);
    }

    void one_recording_that_does_not_belong_is_named_data() {
        QTest::addColumn<int>("kind");
        QTest::addColumn<double>("two_theta_zero");
        QTest::newRow("another gyro") << static_cast<int>(SetKind::foreign) << 0.0;
        QTest::newRow("channels exchanged") << static_cast<int>(SetKind::exchanged) << 0.0;
        QTest::newRow("sign of D") << static_cast<int>(SetKind::sign) << 0.0;
        QTest::newRow("drive left on") << static_cast<int>(SetKind::drive) << 0.0;
        QTest::newRow("exchanged, turned electrodes")
            << static_cast<int>(SetKind::exchanged) << 0.7;
        QTest::newRow("sign of D, turned electrodes") << static_cast<int>(SetKind::sign) << 0.7;
    }

    // Sets of four (rows 28 to 30).
    void one_recording_that_does_not_belong_is_named() {
        QFETCH(int, kind);
        QFETCH(double, two_theta_zero);
        const Tally sets = tally(static_cast<SetKind>(kind), 12, 4, 0, 0, two_theta_zero);
        VYBEG_EQUAL(sets.wrong + sets.elsewhere, 0);
        VYBEG_AT_LEAST(sets.right, 11);
        VYBEG_EQUAL(sets.fits + sets.spread, 0);
        VYBEG_EQUAL(sets.beyond, 0);
    }

    // Splits of 0.1 to 3 mHz. Where the turn of the wave in 10 s is too small, both readings of the
    // channels fit as well, with another frequency of that recording.
    void other_channels_that_a_frequency_nearly_makes_up_for_are_named() {
        int least_named = 24;
        int most_false = 0;
        for (const SetKind kind : {SetKind::exchanged, SetKind::sign}) {
            for (const std::size_t runs : {std::size_t{4}, std::size_t{5}}) {
                const Tally sets = tally(kind, 24, runs, 1e-4, 3e-3, 0, fit_options({}, 5300));
                qInfo("%d right, %d wrong, %d among, %d elsewhere, %d fit, %d beyond 4 u of 24",
                      sets.right, sets.wrong, sets.among, sets.elsewhere, sets.fits, sets.beyond);
                least_named = std::min(least_named, sets.right + sets.among);
                most_false = std::max({most_false, sets.wrong, sets.elsewhere, sets.beyond});
            }
        }
        VYBEG_AT_LEAST(least_named, 21);
        VYBEG_AT_MOST(most_false, 0);
    }

    // By the size of what it adds to the misfit of the set (row 28). Of 25 sets 6 were told at 5
    // standard deviations, 23 at 7, 24 or 25 from 10 on; up to 20 mostly as a spread that u holds.
    // A number lay beyond four u in 1 or 2 of 25.
    void a_partly_foreign_recording_is_told_by_its_size() {
        constexpr int each = 8;
        const FitOptions usual = fit_options({}, 5300);
        for (const double wanted : {3., 7., 14., 30.}) {
            const Tally sets = tally(
                each, [wanted](std::uint64_t seed) { return set_of_misfit(wanted, seed); }, usual);
            qInfo(
                "%g deviations: %d right, %d wrong, %d among, %d elsewhere, %d spread, "
                "%d refused, %d fit, %d beyond 4 u, of %d",
                wanted, sets.right, sets.wrong, sets.among, sets.elsewhere, sets.spread,
                sets.refused, sets.fits, sets.beyond, each);
            VYBEG_EQUAL(sets.wrong + sets.elsewhere, 0);
            VYBEG_AT_MOST(sets.fits, wanted < 7 ? each : 1);
            VYBEG_AT_MOST(sets.beyond, 2);
        }
    }

    void a_recording_of_another_gyro_in_a_small_set_is_refused_or_named() {
        for (const std::size_t runs : {std::size_t{2}, std::size_t{3}}) {
            const Tally sets = tally(SetKind::foreign, 10, runs, 0, 0);
            VYBEG_EQUAL(sets.wrong + sets.elsewhere, 0);
            VYBEG_AT_MOST(sets.fits + sets.spread, 2);
            VYBEG_AT_MOST(sets.beyond, 1);
        }
    }

    void small_differences_are_in_u_or_named_data() {
        QTest::addColumn<int>("kind");
        QTest::newRow("gain ratio of one") << static_cast<int>(SetKind::kappa);
        QTest::newRow("decay of one") << static_cast<int>(SetKind::tau);
        QTest::newRow("split of one") << static_cast<int>(SetKind::split);
        QTest::newRow("partly another gyro") << static_cast<int>(SetKind::part);
    }

    // Sizes from a tenth of the harm to many times it (row 31). Of 24 sets 0 to 3 have a number
    // beyond four u.
    void small_differences_are_in_u_or_named() {
        QFETCH(int, kind);
        const Tally sets = tally(static_cast<SetKind>(kind), 16, 4, 3e-4, 0.3);
        VYBEG_EQUAL(sets.wrong + sets.elsewhere, 0);
        VYBEG_AT_MOST(sets.beyond, 3);
    }

    // Temperatures: decay by 1 %, split by 3 %, gain ratio by 0.1 %.
    void a_spread_between_recordings_is_in_u() {
        const Tally sets = tally(SetKind::all_differ, 12, 4, 0, 0);
        VYBEG_AT_LEAST(sets.spread, 10);
        VYBEG_AT_MOST(sets.beyond, 2);
    }

    void recordings_that_differ_widely_have_no_resonator() {
        const Tally sets = tally(SetKind::widely, 12, 4, 0, 0);
        VYBEG_AT_LEAST(sets.refused + sets.among + sets.right, 9);
        VYBEG_AT_MOST(sets.beyond, 1);
    }
};

VYBEG_TEST(TestViolatedSets)

}  // namespace test_violated_sets

#include "test_violated_sets.moc"
