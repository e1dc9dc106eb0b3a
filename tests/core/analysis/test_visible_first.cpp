#include "core/analysis/analyse.h"
#include "tests/closeness.h"
#include "tests/statistical/simulated_recording.h"
#include "tests/test_registry.h"

#include <QtTest>

#include <algorithm>
#include <numbers>
#include <vector>

namespace test_visible_first {

using namespace vybeg;

namespace {

constexpr TimeRange visible{4.1, 4.6};

Recording decay_of(double seconds) {
    const FreeDecay decay{.seconds = seconds, .a_B = 0.2, .two_theta_A = 0.3, .noise = 0.001};
    return test::simulated_recording(decay);
}

// Long enough to be shown early.
Settings slow(Algorithm algorithm) {
    Settings settings;
    settings.algorithm = algorithm;
    settings.window = 60;
    settings.hop = algorithm == Algorithm::conjugate_gradient ? 6 : 1;
    return settings;
}

std::size_t row_at(const Track& track, double time_s) {
    return static_cast<std::size_t>(std::ranges::lower_bound(track.time_s(), time_s - 1e-9) -
                                    track.time_s().begin());
}

// The greatest difference of a variable between each row of `part` and the row of `whole` at the
// same time, relative to `scale`; infinite where there is none.
double difference(const Track& part, const Track& whole, SlowVariable variable, double scale) {
    double greatest = 0;
    for (std::size_t k = 0; k < part.rows(); ++k) {
        const std::size_t row = row_at(whole, part.time_s()[k]);
        if (row == whole.rows() || std::abs(whole.time_s()[row] - part.time_s()[k]) > 1e-9) {
            return std::numeric_limits<double>::infinity();
        }
        double off = std::abs(part.values(variable)[k] - whole.values(variable)[row]);
        if (info(variable).quantity == Quantity::angle) {
            off = std::abs(std::remainder(off, 2 * std::numbers::pi));
        }
        greatest = std::max(greatest, off / scale);
    }
    return greatest;
}

}  // namespace

class TestVisibleFirst : public QObject {
    Q_OBJECT

private slots:
    void the_visible_part_comes_first_and_is_that_of_the_whole_data() {
        QTest::addColumn<int>("algorithm");
        for (int algorithm = 0; algorithm < 6; ++algorithm) {
            QTest::newRow(qPrintable(QString::number(algorithm + 1))) << algorithm;
        }
    }
    void the_visible_part_comes_first_and_is_that_of_the_whole() {
        QFETCH(int, algorithm);
        const Recording recording = decay_of(24);
        Settings settings = slow(static_cast<Algorithm>(algorithm));
        settings.calibration.offset_auto = true;
        settings.calibration.angle_zero_deg = 5;
        std::vector<Analysis> early;
        const auto whole =
            analyse_visible_first(recording, settings, visible,
                                  [&](Analysis some) { early.push_back(std::move(some)); }, {});
        QVERIFY(whole);
        QCOMPARE(early.size(), std::size_t(1));
        const Analysis& part = early.back();
        const double hop_s = static_cast<double>(settings.hop) / recording.rate_hz;
        const std::size_t from = row_at(part.track, visible.from_s);
        const std::size_t to = row_at(part.track, visible.to_s);
        VYBEG_WITHIN(static_cast<double>(to - from), 0.5 / hop_s, 1);
        for (const Analysis& some : early) {
            QCOMPARE(some.plan, whole->plan);
            QCOMPARE(some.settings, whole->settings);
            QCOMPARE(some.track.time_s().front(), whole->track.time_s().front());
            QCOMPARE(some.track.time_s().back(), whole->track.time_s().back());
            QVERIFY(std::ranges::is_sorted(some.track.time_s()));
            // Rounding alone; the conjugate gradient ends at 1e-9 of its functional.
            const double tolerance = algorithm == 4 ? 1e-6 : 1e-9;
            VYBEG_CLOSE(difference(some.track, whole->track, SlowVariable::a_A, 1), 0, tolerance);
            VYBEG_CLOSE(difference(some.track, whole->track, SlowVariable::two_theta_A, 1), 0,
                        tolerance);
            VYBEG_CLOSE(difference(some.track, whole->track, SlowVariable::alpha, 1), 0, tolerance);
            VYBEG_CLOSE(difference(some.track, whole->track, SlowVariable::f, 5300), 0, tolerance);
        }
    }

    void a_long_visible_part_is_seen_by_single_windows_first() {
        const Recording recording = decay_of(24);
        std::vector<std::size_t> rows;
        const TimeRange half{2, 13};
        const auto whole = analyse_visible_first(
            recording, slow(Algorithm::conjugate_gradient), half,
            [&](const Analysis& some) { rows.push_back(some.track.rows()); }, {});
        QVERIFY(whole);
        QCOMPARE(rows.size(), std::size_t(2));
        VYBEG_MORE(rows[0], 500);
        VYBEG_LESS(rows[0], 1100);
        VYBEG_MORE(rows[1], 11 * 33333 / 6);
    }

    void the_result_is_that_of_analyse_to_the_bit() {
        const Recording recording = decay_of(24);
        Settings settings = slow(Algorithm::maximum_likelihood);
        settings.calibration.offset_auto = true;
        const auto shown = analyse_visible_first(recording, settings, visible, [](Analysis) {}, {});
        const auto plain = analyse(recording, settings, {});
        QVERIFY(shown && plain);
        QCOMPARE(shown->settings, plain->settings);
        for (const SlowVariable variable : all_slow_variables) {
            QVERIFY(
                std::ranges::equal(shown->track.values(variable), plain->track.values(variable)));
        }
        QVERIFY(std::ranges::equal(shown->track.flags(), plain->track.flags()));
    }

    void what_is_quick_or_all_visible_has_no_part_of_its_own() {
        const Recording recording = decay_of(24);
        int early = 0;
        const auto count = [&](const Analysis&) { ++early; };
        QVERIFY(analyse_visible_first(recording, {}, visible, count, {}));
        QCOMPARE(early, 0);
        const Settings settings = slow(Algorithm::maximum_likelihood);
        QVERIFY(analyse_visible_first(recording, settings, {0, 24}, count, {}));
        QCOMPARE(early, 1);
        // Where nothing of the recording is visible.
        QVERIFY(analyse_visible_first(recording, settings, {100, 200}, count, {}));
        QCOMPARE(early, 2);
    }

    void typed_start_values_are_carried_to_the_visible_part() {
        const Recording recording = decay_of(24);
        Settings settings = slow(Algorithm::conjugate_gradient);
        const auto first = analyse(recording, settings, {});
        QVERIFY(first);
        const Track& track = first->track;
        settings.initial = StartValues{
            {track.values(SlowVariable::a_A)[0], track.values(SlowVariable::a_B)[0],
             track.values(SlowVariable::two_theta_A)[0], track.values(SlowVariable::alpha)[0]},
            track.values(SlowVariable::f)[0]};
        std::vector<Analysis> early;
        const auto whole =
            analyse_visible_first(recording, settings, visible,
                                  [&](Analysis some) { early.push_back(std::move(some)); }, {});
        QVERIFY(whole);
        QCOMPARE(early.size(), std::size_t(1));
        VYBEG_CLOSE(difference(early[0].track, whole->track, SlowVariable::a_A, 1), 0, 1e-6);
        VYBEG_CLOSE(difference(early[0].track, whole->track, SlowVariable::alpha, 1), 0, 1e-6);
    }

    void it_is_stopped_between_its_steps() {
        const Recording recording = decay_of(24);
        std::stop_source stop;
        const auto result = analyse_visible_first(
            recording, slow(Algorithm::conjugate_gradient), visible,
            [&](const Analysis&) { stop.request_stop(); }, JobControl(stop.get_token()));
        QVERIFY(!result);
        QCOMPARE(result.error().code, ErrorCode::interrupted);
    }
};

VYBEG_TEST(TestVisibleFirst, threads)

}  // namespace test_visible_first

#include "test_visible_first.moc"
