// What an engineer does with the window from beginning to end: in as few actions as the design
// allows, and without a mouse.
#include "tests/closeness.h"
#include "tests/test_registry.h"
#include "tests/ui/gui_test.h"
#include "tests/ui/resonator_runs.h"
#include "ui/panels/findings_flag.h"
#include "ui/panels/ledger.h"
#include "ui/plots/track_view.h"
#include "ui/resonator/dossier_dialogs.h"
#include "ui/session/session_keeper.h"
#include "ui/widgets/quantity_table.h"
#include "ui/window/export_dialogs.h"
#include "ui/window/file_commands.h"
#include "ui/window/page_stack.h"
#include "ui/window/status_line.h"
#include "ui/window/tracks_page.h"

#include <QApplication>
#include <QClipboard>
#include <QDialogButtonBox>
#include <QDir>
#include <QFileDialog>
#include <QLabel>
#include <QLineEdit>
#include <QMenu>
#include <QMenuBar>
#include <QPushButton>
#include <QRegularExpression>
#include <QStandardPaths>
#include <QStatusBar>
#include <QTest>
#include <QTextBrowser>

namespace test_journeys {

using namespace vybeg;
using namespace vybeg::ui;

class TestJourneys : public QObject, private WindowTest {
    Q_OBJECT

    QStringList files_;

    void open(const QStringList& files) {
        window_->files().open(files);
        QVERIFY(QTest::qWaitFor(
            [&] {
                return document().analyses().size() == static_cast<std::size_t>(files.size()) &&
                       !document().busy();
            },
            20000));
    }
    void press(int key, Qt::KeyboardModifiers modifiers = Qt::NoModifier) {
        QTest::keyClick(window_.get(), static_cast<Qt::Key>(key), modifiers);
    }
    // By the Tab key alone; whether it is there.
    static bool reach(QWidget& window, const std::function<bool(const QWidget&)>& wanted) {
        constexpr int most = 200;
        for (int steps = 0; steps < most; ++steps) {
            const QWidget* now = window.focusWidget();
            if (now && wanted(*now)) {
                return true;
            }
            QTest::keyClick(&window, Qt::Key_Tab);
        }
        return false;
    }
    static void type(QWidget& window, const QString& text) {
        QTest::keyClicks(window.focusWidget(), text);
    }
    // Clicks on the menu that has the command, and on its entry.
    void choose(Command command) {
        QAction* const wanted = window_->action(command);
        auto& bar = the<QMenuBar>();
        for (QAction* top : bar.actions()) {
            if (top->menu()->actions().contains(wanted)) {
                QTest::mouseClick(&bar, Qt::LeftButton, {}, bar.actionGeometry(top).center());
                QTRY_VERIFY(top->menu()->isVisible());
                QTest::mouseClick(top->menu(), Qt::LeftButton, {},
                                  top->menu()->actionGeometry(wanted).center());
                QVERIFY(!top->menu()->isVisible());
                return;
            }
        }
        QFAIL("no menu has the command");
    }
    // The answer to the question for a file, typed.
    void answer(const QString& path) {
        QTRY_VERIFY(window_->findChild<QFileDialog*>() && the<QFileDialog>().isVisible());
        auto& dialog = the<QFileDialog>();
        QApplication::setActiveWindow(&dialog);
        QVERIFY(reach(dialog, [](const QWidget& widget) {
            return widget.objectName() == QLatin1String("fileNameEdit");
        }));
        qobject_cast<QLineEdit*>(dialog.focusWidget())->selectAll();
        type(dialog, path);
        QTest::keyClick(dialog.focusWidget(), Qt::Key_Return);
        QTRY_VERIFY(QFile::exists(path));
        QApplication::setActiveWindow(window_.get());
    }
    static std::function<bool(const QWidget&)> buttonOf(const char* words) {
        return [words](const QWidget& widget) {
            const auto* button = qobject_cast<const QPushButton*>(&widget);
            return button && button->text().remove('&').startsWith(QLatin1String(words));
        };
    }

private slots:
    void initTestCase() { files_ = resonatorRuns(home_, "run"); }
    void init() {
        window_ = shownWindow();
        window_->resize(1280, 720);
        window_->activateWindow();
        QVERIFY(QTest::qWaitForWindowActive(window_.get()));
    }
    void cleanup() { window_.reset(); }

    // Opened together they are a set; F7 identifies it; the menu asks for limits; a number and
    // Return, and the verdict stands beside the parameter, with nothing to scroll.
    void from_four_files_to_a_verdict_in_four_actions() {
        open(files_);       // 1
        press(Qt::Key_F7);  // 2
        QVERIFY(QTest::qWaitFor([&] { return !document().busy(); }, 60000));
        QCOMPARE(the<PageStack>().page(), Page::resonator);
        window_->action(Command::limits)->trigger();  // 3
        auto& dialog = the<LimitsDialog>();
        auto& field = childOf<NumberField>(dialog, "split_hz.upper");
        field.setFocus();
        QTest::keyClicks(&field, "20");
        QTest::keyClick(&field, Qt::Key_Return);  // 4
        QTRY_VERIFY(cellOf("resonator", "Frequency split", "Limits"));
        const QTableWidgetItem& verdict = *cellOf("resonator", "Frequency split", "Limits");
        QCOMPARE(verdict.text(), QStringLiteral("✓ ≤ 20"));
        auto& table = the<QuantityTable>("resonator");
        const auto seen = [&] {
            return QRegion(table.visualItemRect(&verdict))
                .subtracted(table.viewport()->visibleRegion())
                .isEmpty();
        };
        QTRY_VERIFY(seen());
    }

    // The same four with a mouse: files dropped, two entries of menus, a field and its OK.
    void from_four_files_to_a_verdict_by_mouse() {
        QVERIFY(dropFiles(*window_, files_));  // 1
        QVERIFY(QTest::qWaitFor(
            [&] { return document().analyses().size() == 4 && !document().busy(); }, 20000));
        choose(Command::identify);  // 2
        QVERIFY(QTest::qWaitFor([&] { return !document().busy(); }, 60000));
        QCOMPARE(the<PageStack>().page(), Page::resonator);
        choose(Command::limits);  // 3
        auto& dialog = the<LimitsDialog>();
        QApplication::setActiveWindow(&dialog);
        auto& field = childOf<NumberField>(dialog, "split_hz.upper");
        QTest::mouseClick(&field, Qt::LeftButton);
        QVERIFY(field.hasFocus());
        QTest::keyClicks(&field, "20");
        QTest::mouseClick(childOf<QDialogButtonBox>(dialog).button(QDialogButtonBox::Ok),
                          Qt::LeftButton);  // 4
        QTRY_VERIFY(cellOf("resonator", "Frequency split", "Limits"));
        QCOMPARE(cellOf("resonator", "Frequency split", "Limits")->text(),
                 QStringLiteral("✓ ≤ 20"));
    }

    // A session is saved, its plots are exported, and what a crash has left is recovered.
    void nothing_is_lost_by_keyboard_alone() {
        open({files_[0]});
        press(Qt::Key_S, Qt::ControlModifier);
        answer(home_.path("kept.vybeg"));
        QTRY_VERIFY(!window_->session().isModified());
        press(Qt::Key_E, Qt::ControlModifier);
        {
            auto& dialog = the<ExportDialog>();
            QApplication::setActiveWindow(&dialog);
            QVERIFY(reach(dialog, buttonOf("Save")));
            QTest::keyClick(dialog.focusWidget(), Qt::Key_Space);
            answer(home_.path("kept.png"));
        }
        QTRY_VERIFY(!window_->findChild<ExportDialog*>());

        // The copy against crashes without the lock of its program, as a crash leaves it.
        const QDir copies(QStandardPaths::writableLocation(QStandardPaths::AppDataLocation) +
                          "/backups");
        const QString left = copies.filePath("zz-left.vybeg");
        const auto copied = [&] {
            QFile::remove(left);
            const QStringList all = copies.entryList({"*.vybeg"}, QDir::Files);
            return std::ranges::any_of(all, [&](const QString& name) {
                QFile copy(copies.filePath(name));
                return copy.open(QIODevice::ReadOnly) &&
                       copy.readAll().contains(home_.path("kept.vybeg").toUtf8()) &&
                       copy.copy(left);
            });
        };
        QTRY_VERIFY_WITH_TIMEOUT(copied(), 20000);
        window_.reset();
        init();
        window_->session().offerAbandoned();
        QVERIFY(reach(*window_, buttonOf("Recover")));
        QTest::keyClick(window_->focusWidget(), Qt::Key_Space);
        QVERIFY(idle(1));
        QTRY_VERIFY(!QFile::exists(left));
    }

    // Analyse, measure, copy, scale, identify, undo.
    void a_day_by_keyboard_alone() {
        open(files_);
        press(Qt::Key_1, Qt::ControlModifier);
        const auto named = [](const char* name) {
            return [name](const QWidget& widget) {
                return widget.accessibleName() == QLatin1String(name);
            };
        };
        QVERIFY(reach(*window_, named("Length")));
        type(*window_, "120");
        press(Qt::Key_F5);
        QVERIFY(idle(5));
        auto& tracks = the<TrackView>();
        for (const auto& [name, time] :
             {std::pair{"Time of cursor A", "1"}, std::pair{"Time of cursor B", "3"}}) {
            QVERIFY2(reach(*window_, named(name)), name);
            type(*window_, time);
            QTest::keyClick(window_->focusWidget(), Qt::Key_Return);
        }
        QCOMPARE(tracks.cursor(Cursor::a), std::optional(1.0));
        QCOMPARE(tracks.cursor(Cursor::b), std::optional(3.0));
        press(Qt::Key_T, Qt::ControlModifier | Qt::ShiftModifier);
        VYBEG_AT_LEAST(QApplication::clipboard()->text().split('\n').size(), 5);

        QVERIFY(reach(*window_, [](const QWidget& widget) {
            return widget.accessibleName().startsWith("Plot of a_A") ||
                   widget.accessibleName().startsWith("Plot of aA");
        }));
        const AxisRange whole = tracks.valueRange(SlowVariable::a_A);
        press(Qt::Key_L);
        {
            auto& limits = the<AxisLimitsDialog>();
            QApplication::setActiveWindow(&limits);  // or no field is left
            QVERIFY(reach(limits, named("From")));
            type(limits, "0.25");
            QVERIFY(reach(limits, named("To")));
            type(limits, "0.75");
            QTest::keyClick(limits.focusWidget(), Qt::Key_Return);
        }
        // As window managers do when a dialog has gone.
        QTRY_VERIFY(!window_->findChild<AxisLimitsDialog*>());
        QApplication::setActiveWindow(window_.get());
        QTRY_COMPARE(tracks.valueRange(SlowVariable::a_A), (AxisRange{0.25, 0.75}));
        press(Qt::Key_Left, Qt::AltModifier);
        QTRY_COMPARE(tracks.valueRange(SlowVariable::a_A), whole);

        press(Qt::Key_Z, Qt::ControlModifier);  // an analysis stays, its settings are those before
        QCOMPARE(document().settings().window, std::int64_t{60});

        press(Qt::Key_F7);
        QVERIFY(QTest::qWaitFor([&] { return !document().busy(); }, 60000));
        QCOMPARE(the<PageStack>().page(), Page::resonator);
        QVERIFY(cellOf("resonator", "Frequency split", 1));
        for (int page = 0; page <= static_cast<int>(Page::history); ++page) {
            press(Qt::Key_1 + page, Qt::ControlModifier);
            QTRY_COMPARE(static_cast<int>(the<PageStack>().page()), page);
        }
    }

    void limits_of_an_axis_that_make_no_sense_are_refused() {
        open({files_[0]});
        auto& tracks = the<TrackView>();
        const auto asked = [&]() -> AxisLimitsDialog& {
            askForAxisLimits(tracks, window_.get());
            return the<AxisLimitsDialog>();
        };
        auto& dialog = asked();
        auto& lower = childOf<NumberField>(dialog, "axisLower");
        auto& upper = childOf<NumberField>(dialog, "axisUpper");
        const auto fill = [](NumberField& field, const char* text) {
            field.selectAll();
            QTest::keyClicks(&field, text);
            field.commit();
        };
        fill(lower, "2");
        fill(upper, "1");
        QVERIFY(!childOf<QLabel>(dialog, "axisFault").text().isEmpty());
        QTest::keyClick(&dialog, Qt::Key_Return);
        QVERIFY(tracks.zoom().current().fixed.empty());
        fill(upper, "3");
        QVERIFY(childOf<QLabel>(dialog, "axisFault").text().isEmpty());
        QTest::keyClick(&dialog, Qt::Key_Return);
        QTRY_VERIFY(!window_->findChild<AxisLimitsDialog*>());
        const SlowVariable variable = *tracks.chosenVariable();
        QCOMPARE(tracks.valueRange(variable), (AxisRange{2, 3}));
        // Emptied, the axis follows the data again.
        auto& again = asked();
        for (const char* name : {"axisLower", "axisUpper"}) {
            auto& field = childOf<NumberField>(again, name);
            QVERIFY(field.value());
            field.clear();
            field.setModified(true);
            field.commit();
        }
        QTest::keyClick(&again, Qt::Key_Return);
        QVERIFY(tracks.zoom().current().fixed.empty());
    }

    // A finding about which the settings can do something has the button that does it.
    void findings_have_the_button_that_helps() {
        FreeDecay decay;
        decay.seconds = 4;
        decay.rate_hz = 8000;
        decay.f0_hz = 1000;
        decay.noise = 1e-3;
        decay.offset_c = 0.1;
        open({home_.recording("offset.wav", decay)});
        QTRY_VERIFY_WITH_TIMEOUT(document().currentRecording()->faults, 20000);
        auto& list = *the<FindingsFlag>().findChild<CheckList*>();
        auto& text = childOf<QTextBrowser>(list);
        QTRY_VERIFY2(text.toPlainText().contains("Take the offsets from the signals"),
                     qPrintable(text.toPlainText()));
        QVERIFY(!document().settings().calibration.offset_auto);
        const auto link = QRegularExpression("remedy,\\d+").match(text.toHtml());
        QVERIFY(link.hasMatch());
        emit text.anchorClicked(QUrl(link.captured()));
        QVERIFY(document().settings().calibration.offset_auto);
        QVERIFY(!text.toPlainText().contains("Take the offsets"));
        document().undoStack().undo();
        QVERIFY(text.toPlainText().contains("Take the offsets"));
    }

    // Where the page owns the window no empty row stands below it: what is new stands over it.
    void pages_that_own_the_window_have_no_empty_row() {
        open(files_);
        auto& bar = *window_->statusBar();
        QVERIFY(bar.isVisible());
        for (const Page page : {Page::resonator, Page::drift, Page::history}) {
            the<PageStack>().showPage(page);
            QVERIFY(!bar.isVisible());
        }
        press(Qt::Key_F7);
        QVERIFY(QTest::qWaitFor([&] { return !document().busy(); }, 60000));
        auto& line = the<StatusLine>();
        QVERIFY2(line.text().contains("Resonator of 4"), qPrintable(line.text()));
        QVERIFY(line.isVisible());
        QCOMPARE(line.geometry().bottom(), line.parentWidget()->height() - 1);
        the<PageStack>().showPage(Page::tracks);
        QVERIFY(bar.isVisible() && line.isVisible());
        QVERIFY(bar.isAncestorOf(&line));
    }
};

VYBEG_TEST(TestJourneys)

}  // namespace test_journeys

#include "test_journeys.moc"
