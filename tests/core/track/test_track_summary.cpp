#include "core/track/track_summary.h"

#include <QTest>

#include <cmath>
#include <limits>

using namespace vybeg;

namespace {

Track track_of(const std::vector<double>& f, double rms) {
    Track track(f.size());
    for (std::size_t k = 0; k < f.size(); ++k) {
        track.values(SlowVariable::f)[k] = f[k];
        track.values(SlowVariable::rms)[k] = rms;
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
        QCOMPARE(summary.rms, 0.5);
    }

    void a_scatter_of_nine_digits_below_the_value_is_not_lost() {
        std::vector<double> f;
        for (int k = 0; k < 1000; ++k) {
            f.push_back(5300 + (k % 2 == 0 ? 1e-6 : -1e-6));
        }
        const TrackSummary summary = summarise(track_of(f, 1), 1);
        const double expected = 1e-6 * std::sqrt(1000.0 / 999) / std::sqrt(1000.0);
        // Two numbers near 5300 differ by their rounding, 1e-12, at worst.
        QVERIFY(std::abs(summary.sd_mean_f_hz / expected - 1) < 1e-4);
    }

    void overlapping_windows_count_for_what_they_add() {
        const Track track = track_of({1, 2, 3, 4, 5}, 1);
        QCOMPARE(summarise(track, 0.25).sd_mean_f_hz, 2 * summarise(track, 1).sd_mean_f_hz);
        QCOMPARE(summarise(track, 3).sd_mean_f_hz, summarise(track, 1).sd_mean_f_hz);
    }

    void missing_windows_are_left_out_and_counted() {
        Track track = track_of({10, 20, 30}, 2);
        track.values(SlowVariable::f)[1] = std::numeric_limits<double>::quiet_NaN();
        track.values(SlowVariable::rms)[1] = std::numeric_limits<double>::quiet_NaN();
        set(track.flags()[1], Flag::gap);
        set(track.flags()[2], Flag::no_quadrature);  // the algorithm's nature, no fault
        const TrackSummary summary = summarise(track, 1);
        QCOMPARE(summary.mean_f_hz, 20.0);
        QCOMPARE(summary.rms, 2.0);
        QCOMPARE(summary.flagged, std::size_t(1));
    }

    void nothing_is_known_of_no_windows_and_no_scatter_of_one() {
        const TrackSummary none = summarise(Track(0), 1);
        QVERIFY(std::isnan(none.mean_f_hz) && std::isnan(none.sd_mean_f_hz) &&
                std::isnan(none.rms));
        const TrackSummary one = summarise(track_of({7}, 1), 1);
        QCOMPARE(one.mean_f_hz, 7.0);
        QVERIFY(std::isnan(one.sd_mean_f_hz));
    }
};

QTEST_GUILESS_MAIN(TestTrackSummary)
#include "test_track_summary.moc"
