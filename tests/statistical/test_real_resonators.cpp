// The mode pairs of two bells (METHOD section 9) by the whole road from file to resonator. Their
// channels are no calibrated pair of pick-offs: the free model has to see that by itself.
#include "core/analysis/identify.h"
#include "core/recording/open/open_recording.h"
#include "core/recording/samples/recording.h"
#include "tests/closeness.h"
#include "tests/test_registry.h"

#include <QtTest>

namespace test_real_resonators {

using namespace vybeg;

class TestRealResonators : public QObject {
    Q_OBJECT

private slots:
    void the_pair_of_a_bell_is_found_data() {
        QTest::addColumn<QString>("name");
        QTest::addColumn<double>("upper_hz");
        QTest::addColumn<double>("lower_hz");
        QTest::addColumn<double>("upper_tau_s");
        QTest::addColumn<double>("lower_tau_s");
        QTest::addColumn<double>("within_hz");
        QTest::newRow("kyoto bell")
            << "kyoto-bell.wav" << 1023.07 << 1017.81 << 0.86 << 0.86 << 0.03;
        QTest::newRow("perc bell")
            << "perc-bell.flac" << 3620.97 << 3615.36 << 0.86 << 0.80 << 0.03;
    }

    void the_pair_of_a_bell_is_found() {
        QFETCH(QString, name);
        QFETCH(double, upper_hz);
        QFETCH(double, lower_hz);
        QFETCH(double, upper_tau_s);
        QFETCH(double, lower_tau_s);
        QFETCH(double, within_hz);
        const QString folder = qEnvironmentVariable("VYBEG_REAL_DATA");
        if (folder.isEmpty()) {
            QSKIP("VYBEG_REAL_DATA is not set: THE REAL RECORDINGS ARE NOT TESTED");
        }
        const Result<Recording> recording =
            open_recording((folder + "/" + name).toStdString(), {}, {});
        QVERIFY2(recording, "the recording does not open");
        for (const auto model : {FitOptions::Model::free, FitOptions::Model::automatic}) {
            IdentifySettings settings;
            settings.signal.filter = Band{lower_hz - 14, upper_hz + 14};
            settings.model = model;
            const Result<Identification> found = identify({&*recording, 1}, settings, {});
            QVERIFY(found);
            QVERIFY(found->fit.model == ResonatorModel::free);
            QCOMPARE(found->fit.modes.size(), std::size_t{2});
            const ModeEstimate& upper = found->fit.modes[0];
            const ModeEstimate& lower = found->fit.modes[1];
            const QString text = QString("%1 Hz, %2 s; %3 Hz, %4 s")
                                     .arg(upper.f_hz.value, 0, 'f', 4)
                                     .arg(upper.tau_s.value)
                                     .arg(lower.f_hz.value, 0, 'f', 4)
                                     .arg(lower.tau_s.value);
            qInfo("%s", qPrintable(text));
            // A constant frequency, fitted to a wave that decays by its amplitude in tau, is that
            // at tau; the fit gives it at tau/2, the mean instant by power, and its drift.
            const double drift = found->fit.runs[0].drift_hz_per_s.value;
            const auto at_tau = [drift](const ModeEstimate& mode) {
                return mode.f_hz.value + drift * mode.tau_s.value / 2;
            };
            VYBEG_CLOSE(at_tau(upper), upper_hz, within_hz, qPrintable(text));
            VYBEG_CLOSE(at_tau(lower), lower_hz, within_hz, qPrintable(text));
            VYBEG_CLOSE_RATIO(upper.tau_s.value, upper_tau_s, 0.1, qPrintable(text));
            VYBEG_CLOSE_RATIO(lower.tau_s.value, lower_tau_s, 0.1, qPrintable(text));
        }
    }
};

VYBEG_TEST(TestRealResonators)

}  // namespace test_real_resonators

#include "test_real_resonators.moc"
