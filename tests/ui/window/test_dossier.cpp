// The gyro's data and the limits of its parameters, through their dialogs.
#include "tests/closeness.h"
#include "tests/test_registry.h"
#include "tests/ui/gui_test.h"
#include "tests/ui/resonator_runs.h"
#include "ui/resonator/dossier_dialogs.h"
#include "ui/widgets/quantity_table.h"

#include <QDialogButtonBox>
#include <QLineEdit>
#include <QPlainTextEdit>
#include <QPushButton>
#include <QTest>

#include <numbers>

namespace test_dossier {

using namespace vybeg;
using namespace vybeg::ui;

class TestDossier : public QObject, private WindowTest {
    Q_OBJECT

    QStringList files_;

    const Dossier& dossier() { return document().dossier().dossier(); }

    template <class Dialog>
    Dialog& opened(Command command) {
        window_->action(command)->trigger();
        return childOf<Dialog>(*window_);
    }
    static void press(const QDialog& dialog, QDialogButtonBox::StandardButton button) {
        auto& buttons = childOf<QDialogButtonBox>(dialog);
        QTest::mouseClick(buttons.button(button), Qt::LeftButton);
    }
    static QPushButton& ok(const QDialog& dialog) {
        return *childOf<QDialogButtonBox>(dialog).button(QDialogButtonBox::Ok);
    }
    // As a person does it who goes on to the next field: Return would accept the dialog.
    static void fill(NumberField& field, const char* text) {
        field.selectAll();
        QTest::keyClicks(&field, text);
        field.commit();
    }

private slots:
    void initTestCase() { files_ = resonatorRuns(home_, "run"); }
    void init() { window_ = shownWindow(); }
    void cleanup() { window_.reset(); }

    void the_data_are_typed_and_undone() {
        auto& dialog = opened<GyroDialog>(Command::gyro_data);
        QTest::keyClicks(&childOf<QLineEdit>(dialog, "serial"), " HRG-17 ");
        QTest::keyClicks(&childOf<QLineEdit>(dialog, "operator"), "Orlova");
        QTest::keyClicks(&childOf<QPlainTextEdit>(dialog, "comment"), "annealed");
        press(dialog, QDialogButtonBox::Ok);
        QCOMPARE(dossier().gyro, (GyroData{"HRG-17", "", "Orlova", "annealed"}));
        QVERIFY(window_->windowTitle().startsWith("HRG-17 — "));
        QVERIFY(window_->action(Command::undo)->text().contains("gyro"));
        window_->action(Command::undo)->trigger();
        QCOMPARE(dossier().gyro, GyroData());
        QVERIFY(!window_->windowTitle().contains("HRG-17"));
        window_->action(Command::redo)->trigger();
        QCOMPARE(dossier().gyro.serial, "HRG-17");
    }

    void cancel_changes_nothing() {
        auto& dialog = opened<GyroDialog>(Command::gyro_data);
        QTest::keyClicks(&childOf<QLineEdit>(dialog, "serial"), "5");
        press(dialog, QDialogButtonBox::Cancel);
        QCOMPARE(dossier(), Dossier());
        QVERIFY(!document().undoStack().canUndo());
    }

    // The split of the recordings is 0.01 Hz, known to better than a hundredth of it.
    void limits_are_judged_in_the_table_of_the_resonator() {
        document().open(files_);
        QVERIFY(QTest::qWaitFor(
            [&] {
                return !document().busy() &&
                       std::ranges::all_of(document().recordings(), [](const auto& entry) {
                           return entry.recording.has_value();
                       });
            },
            20000));
        std::vector<RecordingId> ids;
        for (const RecordingEntry& entry : document().recordings()) {
            ids.push_back(entry.id);
        }
        document().sets().addToCurrent(ids);
        window_->action(Command::identify)->trigger();
        QVERIFY(QTest::qWaitFor([&] { return !document().busy(); }, 60000));
        QVERIFY(!cellOf("resonator", "Frequency split", "Limits"));  // no limits, no column of them

        auto& dialog = opened<LimitsDialog>(Command::limits);
        fill(childOf<NumberField>(dialog, "split_hz.upper"), "20");
        fill(childOf<NumberField>(dialog, "q.lower"), "1e12");
        fill(childOf<NumberField>(dialog, "frequency_per_power.upper"), "1");
        press(dialog, QDialogButtonBox::Ok);
        QCOMPARE(dossier().limits.size(), std::size_t{3});
        QCOMPARE(cellOf("resonator", "Frequency split", "Limits")->text(),
                 QStringLiteral("✓ ≤ 20"));
        QCOMPARE(cellOf("resonator", "Quality factor", "Limits")->text().left(1),
                 QStringLiteral("✗"));
        QVERIFY(cellOf("resonator", "Quality factor", "Limits")->foreground().color() !=
                cellOf("resonator", "Frequency split", "Limits")->foreground().color());
        QCOMPARE(cellOf("resonator", "Amplitude dependence", "Limits")->text().left(1),
                 QStringLiteral("?"));
        QVERIFY(cellOf("resonator", "Decay time", "Limits")->text().isEmpty());
        window_->action(Command::undo)->trigger();
        QVERIFY(!cellOf("resonator", "Frequency split", "Limits"));
    }

    void limits_in_degrees_are_stored_in_radians() {
        {
            auto& dialog = opened<LimitsDialog>(Command::limits);
            auto& field = childOf<NumberField>(dialog, "non_orthogonality_rad.upper");
            QCOMPARE(field.unit(), QStringLiteral("°"));  // the unit of the first start
            fill(field, "0.1");
            press(dialog, QDialogButtonBox::Ok);
        }
        QCOMPARE(dossier().limits.size(), std::size_t{1});
        VYBEG_CLOSE_RATIO(*dossier().limits.front().upper, 0.1 * std::numbers::pi / 180, 1e-12);
        QTRY_VERIFY(!window_->findChild<LimitsDialog*>());
        // Opened and closed again, nothing has changed.
        const Dossier before = dossier();
        press(opened<LimitsDialog>(Command::limits), QDialogButtonBox::Ok);
        QCOMPARE(dossier(), before);
    }

    void limits_that_contradict_each_other_are_refused() {
        auto& dialog = opened<LimitsDialog>(Command::limits);
        fill(childOf<NumberField>(dialog, "tau_s.lower"), "20");
        QVERIFY(ok(dialog).isEnabled());
        auto& upper = childOf<NumberField>(dialog, "tau_s.upper");
        fill(upper, "10");
        QVERIFY(!ok(dialog).isEnabled());
        QVERIFY(upper.fault().contains("below"));
        fill(upper, "30");
        QVERIFY(ok(dialog).isEnabled());
        press(dialog, QDialogButtonBox::Cancel);
        QVERIFY(dossier().limits.empty());
    }
};

VYBEG_TEST(TestDossier, threads)

}  // namespace test_dossier

#include "test_dossier.moc"
