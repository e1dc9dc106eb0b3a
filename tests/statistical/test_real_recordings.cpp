#include "core/analysis/analyse.h"
#include "core/analysis/analysis.h"
#include "core/analysis/settings.h"
#include "core/recording/open/open_recording.h"
#include "core/recording/samples/recording.h"
#include "core/track/track.h"
#include "tests/closeness.h"
#include "tests/test_registry.h"

#include <QtTest>

namespace test_real_recordings {

using namespace vybeg;

// Two bell strikes (METHOD section 9). Their channels are no calibrated cos/sin pair, so that
// angles say nothing; frequencies and decay times can be held against the pairs measured there.
class TestRealRecordings : public QObject {
    Q_OBJECT

private slots:
    void trackLiesBetweenTheModesAndDecaysWithThem_data() {
        QTest::addColumn<QString>("name");
        QTest::addColumn<double>("lower_hz");
        QTest::addColumn<double>("upper_hz");
        QTest::addColumn<double>("tau_s");
        QTest::addRow("kyoto bell") << "kyoto-bell.wav" << 1017.806 << 1023.074 << 0.86;
        QTest::addRow("perc bell") << "perc-bell.flac" << 3615.355 << 3620.967 << 0.83;
    }

    void trackLiesBetweenTheModesAndDecaysWithThem() {
        QFETCH(QString, name);
        QFETCH(double, lower_hz);
        QFETCH(double, upper_hz);
        QFETCH(double, tau_s);
        const QString folder = qEnvironmentVariable("VYBEG_REAL_DATA");
        if (folder.isEmpty()) {
            QSKIP("VYBEG_REAL_DATA is not set: THE REAL RECORDINGS ARE NOT TESTED");
        }
        const Result<Recording> recording =
            open_recording((folder + "/" + name).toStdString(), {}, {});
        QVERIFY2(recording, "the recording does not open");

        Settings settings;
        settings.filter = Band{lower_hz - 12, upper_hz + 12};
        settings.periods = 10;
        const Result<Analysis> analysis = analyse(*recording, settings, {});
        QVERIFY(analysis);
        VYBEG_MORE(analysis->f0_hz(), lower_hz - 0.5);
        VYBEG_LESS(analysis->f0_hz(), upper_hz + 0.5);

        // From half a second after the strike, over whole beats of the pair, until the sound has
        // sunk by 30 dB.
        const double beat_s = 1 / (upper_hz - lower_hz);
        const Track& track = analysis->track;
        double strongest = 0;
        double struck_s = 0;
        for (std::size_t k = 0; k < track.rows(); ++k) {
            if (track.values(SlowVariable::a_A)[k] > strongest) {
                strongest = track.values(SlowVariable::a_A)[k];
                struck_s = track.time_s()[k];
            }
        }
        const double from_s = struck_s + 0.1;
        const double to_s = from_s + std::floor(3.4 * tau_s / 2 / beat_s) * beat_s;
        double count = 0;
        double mean_t = 0;
        double mean_log = 0;
        double weight = 0;
        double mean_f = 0;
        std::vector<std::pair<double, double>> points;
        for (std::size_t k = 0; k < track.rows(); ++k) {
            const double t = track.time_s()[k];
            if (t < from_s || t > to_s) {
                continue;
            }
            Flags flags = track.flags()[k];
            flags &= static_cast<Flags>(~static_cast<Flags>(Flag::moving));  // the pair beats
            QVERIFY2(flags == 0, qPrintable(QString("%1 s").arg(t)));
            const double a_A = track.values(SlowVariable::a_A)[k];
            const double a_B = track.values(SlowVariable::a_B)[k];
            const double power = a_A * a_A + a_B * a_B;
            mean_f += power * track.values(SlowVariable::f)[k];
            weight += power;
            points.emplace_back(t, std::log(power));
            mean_t += t;
            mean_log += std::log(power);
            count += 1;
        }
        VYBEG_MORE(count, 100);
        mean_t /= count;
        mean_log /= count;
        double slope = 0;
        double spread = 0;
        for (const auto& [t, logarithm] : points) {
            slope += (t - mean_t) * (logarithm - mean_log);
            spread += (t - mean_t) * (t - mean_t);
        }
        slope /= spread;
        // a_A^2 + a_B^2 is the energy: it falls twice as fast as the amplitudes.
        const double found_tau_s = -2 / slope;
        mean_f /= weight;
        const QString where = QString("f %1 Hz, tau %2 s").arg(mean_f).arg(found_tau_s);
        qInfo("%s", qPrintable(where));
        VYBEG_MORE(mean_f, lower_hz, qPrintable(where));
        VYBEG_LESS(mean_f, upper_hz, qPrintable(where));
        VYBEG_CLOSE_RATIO(found_tau_s, tau_s, 0.1, qPrintable(where));
    }
};

VYBEG_TEST(TestRealRecordings)

}  // namespace test_real_recordings

#include "test_real_recordings.moc"
