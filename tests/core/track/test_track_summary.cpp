#include "core/track/track_summary.h"
#include "tests/closeness.h"
#include "tests/test_registry.h"

#include <QTest>

#include <algorithm>
#include <cmath>
#include <limits>
#include <random>

namespace test_track_summary {

using namespace vybeg;

namespace {

Track track_of(const std::vector<double>& f, double noise) {
    Track track(f.size());
    for (std::size_t k = 0; k < f.size(); ++k) {
        track.values(SlowVariable::f)[k] = f[k];
        track.values(SlowVariable::noise)[k] = noise;
        track.flags()[k] = 0;
    }
    return track;
}

}  // namespace

class TestTrackSummary : public QObject {
    Q_OBJECT

private slots:
    void mean_and_its_deviation_are_those_of_the_sample() {
        const TrackSummary summary = summarise(track_of({5300, 5301, 5303, 5304}, 0.5), 1);
        QCOMPARE(summary.windows, std::size_t(4));
        QCOMPARE(summary.mean_f_hz, 5302.0);
        // s^2 = (4 + 1 + 1 + 4) / 3, over 4 windows
        QCOMPARE(summary.sd_mean_f_hz, std::sqrt(10.0 / 3 / 4));
        QCOMPARE(summary.noise, 0.5);
    }

    void a_faulty_window_does_not_tell_the_noise() {
        Track track = track_of(std::vector<double>(100, 5300), 1);
        track.values(SlowVariable::noise)[40] = 300;
        track.flags()[40] = static_cast<Flags>(Flag::not_converged);
        QCOMPARE(summarise(track, 1).noise, 1.0);
        for (Flags& flags : track.flags()) {
            flags = static_cast<Flags>(Flag::clipped);
        }
        VYBEG_CLOSE_RATIO(summarise(track, 1).noise, std::sqrt((99 + 300. * 300) / 100), 1e-12);
    }

    void a_scatter_of_nine_digits_below_the_value_is_not_lost() {
        // Independent signs of +-1e-6; 250 blocks of four tell their deviation to 5 %.
        std::mt19937_64 random(1);
        std::vector<double> f;
        for (int k = 0; k < 1000; ++k) {
            f.push_back(5300 + (random() % 2 == 0 ? 1e-6 : -1e-6));
        }
        const double expected = 1e-6 / std::sqrt(1000.0);
        VYBEG_CLOSE_RATIO(summarise(track_of(f, 1), 1).sd_mean_f_hz, expected, 0.2);
        f.resize(10);  // by the scatter itself
        double squares = 0;
        double sum = 0;
        for (const double x : f) {
            sum += x - 5300;
            squares += (x - 5300) * (x - 5300);
        }
        const double exact = std::sqrt((squares - sum * sum / 10) / 9 / 10);
        // Two numbers near 5300 differ by their rounding, 1e-12, at worst.
        VYBEG_CLOSE_RATIO(summarise(track_of(f, 1), 1).sd_mean_f_hz, exact, 1e-4);
    }

    void overlapping_windows_count_for_what_they_add() {
        const Track track = track_of({1, 2, 3, 4, 5}, 1);
        QCOMPARE(summarise(track, 0.25).sd_mean_f_hz, 2 * summarise(track, 1).sd_mean_f_hz);
        QCOMPARE(summarise(track, 3).sd_mean_f_hz, summarise(track, 1).sd_mean_f_hz);
    }

    void missing_windows_are_left_out_and_counted() {
        Track track = track_of({10, 20, 30}, 2);
        track.values(SlowVariable::f)[1] = std::numeric_limits<double>::quiet_NaN();
        track.values(SlowVariable::noise)[1] = std::numeric_limits<double>::quiet_NaN();
        set(track.flags()[1], Flag::gap);
        set(track.flags()[2], Flag::no_quadrature);  // the algorithm's nature, no fault
        const TrackSummary summary = summarise(track, 1);
        QCOMPARE(summary.mean_f_hz, 20.0);
        QCOMPARE(summary.noise, 2.0);
        QCOMPARE(summary.flagged, std::size_t(1));
    }

    void a_drift_is_no_scatter_and_alternating_windows_are_no_drift() {
        std::vector<double> f;
        for (int k = 0; k < 2000; ++k) {
            f.push_back(5300 + 1e-3 * k);
        }
        const TrackSummary summary = summarise(track_of(f, 1), 1);
        VYBEG_CLOSE(summary.mean_f_hz, 5300.9995, 1e-9);
        VYBEG_LESS(summary.sd_mean_f_hz, 1e-3);  // a scatter about the mean would be 0.013
    }

    void windows_weigh_by_their_deviations() {
        Track track = track_of({1, 1, 4, 4}, 1);
        for (const std::size_t k : {0UL, 1UL, 2UL, 3UL}) {
            track.sds(SlowVariable::f)[k] = k < 2 ? 1 : 2;
        }
        // (1 + 1 + 4/4 + 4/4) / (1 + 1 + 1/4 + 1/4)
        VYBEG_CLOSE(summarise(track, 1).mean_f_hz, 1.6, 1e-12);
    }

    void leakage_is_common_to_all_windows() {
        Track track = track_of(std::vector<double>(400, 5300.0), 1);
        for (std::size_t k = 0; k < 400; ++k) {
            track.values(SlowVariable::f)[k] += k % 3 == 0 ? 2e-3 : -1e-3;
            track.leakage_f_hz()[k] = -0.5;
            set(track.flags()[k], Flag::leakage);
        }
        const TrackSummary summary = summarise(track, 1);
        QCOMPARE(summary.leaking, std::size_t(400));
        VYBEG_CLOSE(summary.leakage_f_hz, 0.5, 1e-12);
        QVERIFY(summary.leakage_limits());
        VYBEG_CLOSE(summary.sd_mean_f_hz, 0.5, 1e-3);
        std::ranges::fill(track.leakage_f_hz(), 0.0);
        QVERIFY(!summarise(track, 1).leakage_limits());
    }

    void windows_at_the_bound_are_left_out_and_widen_the_deviation() {
        Track track = track_of({100, 101, 99, 100, 200, 210}, 1);
        set(track.flags()[4], Flag::at_bound);
        set(track.flags()[5], Flag::at_bound);
        const TrackSummary summary = summarise(track, 1);
        QCOMPARE(summary.mean_f_hz, 100.0);
        QCOMPARE(summary.at_bound, std::size_t(2));
        // The two lie 100 and 110 above: 210/6 of the mean of all.
        VYBEG_CLOSE(summary.sd_mean_f_hz, std::hypot(35, summary.scatter_f_hz), 1e-9);
        VYBEG_LESS(summary.scatter_f_hz, 1);
        // Also where they come first, on either side: 190/6.
        Track early = track_of({200, 10, 100, 101, 99, 100}, 1);
        set(early.flags()[0], Flag::at_bound);
        set(early.flags()[1], Flag::at_bound);
        const TrackSummary found = summarise(early, 1);
        VYBEG_CLOSE(found.sd_mean_f_hz, std::hypot(190.0 / 6, found.scatter_f_hz), 1e-9);
    }

    void pieces_are_summarised_as_the_whole() {
        Track track = track_of({}, 1);
        std::mt19937_64 random(3);
        std::normal_distribution<double> gauss(5300, 0.01);
        TrackSummariser pieces(1000, 1);
        for (int piece = 0; piece < 10; ++piece) {
            std::vector<double> f(100);
            std::ranges::generate(f, [&] { return gauss(random); });
            const Track rows = track_of(f, 1);
            pieces.take(rows);
            track.append(rows);
        }
        const TrackSummary whole = summarise(track, 1);
        QCOMPARE(pieces.summary().mean_f_hz, whole.mean_f_hz);
        QCOMPARE(pieces.summary().sd_mean_f_hz, whole.sd_mean_f_hz);
    }

    void nothing_is_known_of_no_windows_and_no_scatter_of_one() {
        const TrackSummary none = summarise(Track(0), 1);
        QVERIFY(std::isnan(none.mean_f_hz) && std::isnan(none.sd_mean_f_hz) &&
                std::isnan(none.noise));
        const TrackSummary one = summarise(track_of({7}, 1), 1);
        QCOMPARE(one.mean_f_hz, 7.0);
        QVERIFY(std::isnan(one.sd_mean_f_hz));
    }
};

VYBEG_TEST(TestTrackSummary)

}  // namespace test_track_summary

#include "test_track_summary.moc"
