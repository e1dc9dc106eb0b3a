// What a result shows of the channels, offered as their calibration and taken by a click.
#include "tests/closeness.h"
#include "tests/test_registry.h"
#include "tests/ui/gui_test.h"
#include "tests/ui/resonator_runs.h"

#include <QFileInfo>
#include <QLabel>
#include <QTest>

#include <algorithm>

namespace test_calibration_offers {

using namespace vybeg;
using namespace vybeg::ui;

class TestCalibrationOffers : public QObject, private WindowTest {
    Q_OBJECT

    QLabel& sentence() { return the<QLabel>("statistical"); }
    bool offers() { return sentence().text().remove("href=\"fold\"").contains("href"); }
    const Calibration& calibration() { return document().settings().calibration; }
    std::shared_ptr<const SetResult> outcome() {
        return document().sets().outcome(*document().sets().current());
    }

    void identify() {
        window_->action(Command::identify)->trigger();
        QVERIFY(QTest::qWaitFor([&] { return !document().busy(); }, 60000));
        QVERIFY(outcome());
    }

    void identifyRuns(const TestResonator& resonator) {
        document().open(resonatorRuns(home_, "run", resonator));
        const auto open = [](const auto& entry) { return entry.recording.has_value(); };
        QVERIFY(QTest::qWaitFor(
            [&] {
                return std::ranges::all_of(document().recordings(), open) && !document().busy();
            },
            20000));
        identify();
    }

private slots:
    void init() { window_ = shownWindow(); }
    void cleanup() { window_.reset(); }

    void the_gain_ratio_that_is_found_calibrates() {
        identifyRuns({.kappa = 1.02});
        QVERIFY2(sentence().text().contains("Calibrate with κ = 1.0"),
                 qPrintable(sentence().text()));
        const Estimate found = outcome()->identification.fit.resonator.kappa;
        emit sentence().linkActivated("kappa");
        VYBEG_EQUAL(calibration().kappa, found.value);
        VYBEG_CLOSE(*document().tolerance()[kappa_error], found.uncertainty() / 1.02, 1e-6);
        identify();
        VYBEG_CLOSE(outcome()->identification.fit.resonator.kappa.value, 1.02, 3 * found.sd);
        QVERIFY(!offers());
        document().undoStack().undo();
        VYBEG_EQUAL(calibration().kappa, 1.0);
    }

    // 20 us at 1 kHz are 0.13 rad. Two digits of it at a time.
    void the_delay_that_is_found_calibrates() {
        identifyRuns({.delay_d_s = 20e-6});
        QVERIFY2(sentence().text().contains("Calibrate with δ"), qPrintable(sentence().text()));
        emit sentence().linkActivated("delay");
        VYBEG_CLOSE(calibration().delay_d_s, 20e-6, 1e-6);
        identify();
        const double left = std::abs(calibration().delay_d_s - 20e-6);
        if (sentence().text().contains("href=\"delay\"")) {
            emit sentence().linkActivated("delay");
            VYBEG_LESS(std::abs(calibration().delay_d_s - 20e-6), left);
        }
    }

    void offsets_that_are_found_are_taken_out() {
        identifyRuns({.offset_c = 0.05});
        QVERIFY2(sentence().text().contains("href=\"offset\""), qPrintable(sentence().text()));
        emit sentence().linkActivated("offset");
        QVERIFY(calibration().offset_auto);
        identify();
        QVERIFY2(!offers(), qPrintable(sentence().text()));
    }

    // Of a measurement list its own calibration counts, not that of the panel.
    void of_a_listed_set_its_own_calibration_changes() {
        QByteArray list = "set,file,kappa,tolerance\n";
        for (const QString& path : resonatorRuns(home_, "listed", {.kappa = 1.02})) {
            list += "one," + QFileInfo(path).fileName().toUtf8() + ",1.001,kappa=0.05\n";
        }
        document().sets().openList(home_.file("list.csv", list), {});
        QVERIFY(QTest::qWaitFor(
            [&] {
                const RecordingSet* set = document().sets().current();
                return set && set->recordings.size() == 4 && document().sets().canIdentify() &&
                       !document().busy();
            },
            20000));
        identify();
        const Estimate found = outcome()->identification.fit.resonator.kappa;
        QVERIFY2(sentence().text().contains("href=\"kappa\""), qPrintable(sentence().text()));
        emit sentence().linkActivated("kappa");
        VYBEG_EQUAL(calibration().kappa, 1.0);
        const auto measured = [&] {
            return document().sets().measured(*document().sets().current());
        };
        for (std::size_t k = 0; k < 4; ++k) {
            VYBEG_EQUAL(measured().settings.signal_of(k).calibration.kappa, found.value);
        }
        identify();
        QVERIFY2(!offers(), qPrintable(sentence().text()));
        document().undoStack().undo();
        VYBEG_EQUAL(measured().settings.signal_of(0).calibration.kappa, 1.001);
    }

    void a_calibrated_pair_is_offered_nothing() {
        identifyRuns({});
        QVERIFY2(!offers(), qPrintable(sentence().text()));
    }
};

VYBEG_TEST(TestCalibrationOffers)

}  // namespace test_calibration_offers

#include "test_calibration_offers.moc"
