// The empty window, and where things stand in it: the overview over the plots, values of two runs
// uncut.
#include "tests/closeness.h"
#include "tests/test_registry.h"
#include "tests/ui/gui_test.h"
#include "ui/panels/analysis_list.h"
#include "ui/panels/cursor_panel.h"
#include "ui/plots/signal_view.h"
#include "ui/plots/track_view.h"
#include "ui/window/main_window.h"
#include "ui/window/window_menus.h"

#include <QDockWidget>
#include <QFileInfo>
#include <QListWidget>
#include <QPushButton>
#include <QScreen>
#include <QScrollArea>
#include <QScrollBar>
#include <QSettings>
#include <QTableWidget>
#include <QTest>
#include <qcustomplot.h>

namespace test_window_layout {

using namespace vybeg;
using namespace vybeg::ui;

class TestWindowLayout : public QObject {
    Q_OBJECT

    GuiTestHome home_;
    std::unique_ptr<MainWindow> window_;

    template <class Widget>
    Widget& the() {
        return childOf<Widget>(*window_);
    }

    // Where a widget's area begins and ends, in the window's coordinates.
    std::pair<int, int> span(const QWidget& widget, const QRect& area) const {
        return {widget.mapTo(window_.get(), area.topLeft()).x(),
                widget.mapTo(window_.get(), area.bottomRight()).x()};
    }

    std::pair<int, int> plotSpan() {
        const auto& plot = childOf<QCustomPlot>(childOf<TrackView>(*window_));
        return span(plot, plot.axisRects().front()->rect());
    }

    std::pair<int, int> overviewSpan() {
        const auto& view = childOf<SignalView>(*window_);
        return span(view, view.plotArea());
    }

private slots:
    // All five are seen on the smallest usual screen; in a lower window the page scrolls.
    void plots_have_room_data() {
        QTest::addColumn<QSize>("window");
        QTest::addColumn<int>("least");
        QTest::addColumn<bool>("scrolls");
        QTest::newRow("1600x1000") << QSize(1600, 1000) << 110 << false;
        QTest::newRow("1400x900") << QSize(1400, 900) << 90 << false;
        QTest::newRow("1280x720") << QSize(1280, 720) << 55 << false;
        QTest::newRow("1280x600") << QSize(1280, 600) << 50 << true;
    }
    void plots_have_room() {
        QFETCH(QSize, window);
        QFETCH(int, least);
        QFETCH(bool, scrolls);
        window_ = shownWindow();
        window_->resize(window);
        Document& document = window_->document();
        document.open({home_.recording("room.wav")});
        QTRY_VERIFY(!document.busy() && document.analyses().size() == 1);
        auto& view = the<TrackView>();
        auto* scroll = qobject_cast<QScrollArea*>(view.parentWidget()->parentWidget());
        QVERIFY(scroll);
        QTRY_COMPARE(scroll->verticalScrollBar()->isVisible(), scrolls);
        QTRY_COMPARE(overviewSpan(), plotSpan());
        const auto panels = childOf<QCustomPlot>(view).axisRects();
        QCOMPARE(panels.size(), 5);
        for (const QCPAxisRect* panel : panels) {
            VYBEG_AT_LEAST(panel->rect().height(), least);
        }
        if (scrolls) {
            // The last plot can be reached, and the mouse still acts where it points.
            scroll->verticalScrollBar()->setValue(scroll->verticalScrollBar()->maximum());
            const QRect last = panels.back()->rect();
            QVERIFY(
                scroll->viewport()->rect().contains(view.mapTo(scroll->viewport(), last.center())));
            view.setFocus();
            QTest::mouseMove(&view, last.center());
            QTest::keyClick(&view, Qt::Key_1);
            QVERIFY(view.cursor(Cursor::a).has_value());
        }
    }

    void the_overview_stands_over_the_plots() {
        window_ = shownWindow();
        QTRY_COMPARE(overviewSpan(), plotSpan());
        Document& document = window_->document();
        document.open({home_.recording("demo.wav")});
        QTRY_VERIFY(!document.busy() && document.analyses().size() == 1);
        QTRY_COMPARE(overviewSpan(), plotSpan());
        for (const QSize by : {QSize(101, 0), QSize(-60, 40)}) {
            const auto before = plotSpan();
            window_->resize(window_->size() + by);
            QTRY_VERIFY(plotSpan() != before);
            QTRY_COMPARE(overviewSpan(), plotSpan());
        }
    }

    void the_values_of_two_runs_at_the_cursor_are_not_cut() {
        window_ = shownWindow();
        Document& document = window_->document();
        document.open({home_.recording("demo.wav"), home_.recording("other.wav")});
        QTRY_VERIFY(!document.busy() && document.analyses().size() == 2);
        const auto& table = childOf<QTableWidget>(childOf<CursorPanel>(*window_));
        QTRY_COMPARE(table.columnCount(), 3);
        QTRY_COMPARE(table.horizontalScrollBar()->maximum(), 0);
        QVERIFY(table.item(0, 1)->text().contains("\n± "));
    }

    // A reason is longer than the numbers above it, and is wrapped under them.
    void a_reason_does_not_widen_the_columns() {
        window_ = shownWindow();
        Document& document = window_->document();
        document.open({home_.recording("short.wav", 1.0), home_.recording("long.wav", 3.0)});
        QTRY_VERIFY(!document.busy() && document.analyses().size() == 2);
        auto& cursor = the<CursorPanel>();
        const auto& table = childOf<QTableWidget>(cursor);
        cursor.setTime(0.5);
        const int reason = table.rowCount() - 1;
        QVERIFY(table.isRowHidden(reason));
        cursor.setTime(2.5);
        QVERIFY(!table.isRowHidden(reason));
        const QString text = table.item(reason, 1)->text();
        VYBEG_LESS(table.columnWidth(1), table.fontMetrics().horizontalAdvance(text),
                   qPrintable(text));
        VYBEG_AT_LEAST(table.rowHeight(reason), 2 * table.fontMetrics().height());
    }

    void numbers_of_analyses_are_not_cut() {
        window_ = shownWindow();
        window_->resize(1280, 720);
        Document& document = window_->document();
        document.open({home_.recording("a_recording_with_a_long_name_1.wav"),
                       home_.recording("a_recording_with_a_long_name_2.wav")});
        QTRY_VERIFY(!document.busy() && document.analyses().size() == 2);
        auto& list = the<AnalysisList>();
        for (int column = 2; column < list.columnCount(); ++column) {
            for (int row = 0; row < list.topLevelItemCount(); ++row) {
                const QString text = list.topLevelItem(row)->text(column);
                VYBEG_AT_LEAST(list.columnWidth(column), list.fontMetrics().horizontalAdvance(text),
                               qPrintable(text));
            }
        }
    }

    // Recordings that are five times as long or as short are drawn alone, the chosen one.
    void a_short_recording_does_not_flatten_a_long_one() {
        window_ = shownWindow();
        Document& document = window_->document();
        document.open({home_.recording("long.wav", 20.0)});
        QTRY_VERIFY(!document.busy() && document.analyses().size() == 1);
        document.open({home_.recording("short.wav", 1.0)});
        QTRY_VERIFY(!document.busy() && document.analyses().size() == 2);
        const auto& tracks = the<TrackView>();
        const auto drawn = [&tracks] {
            QStringList names;
            for (const ShownAnalysis& shown : tracks.analyses()) {
                if (shown.visible) {
                    names << shown.recording;
                }
            }
            return names;
        };
        QTRY_COMPARE(drawn(), QStringList{"short.wav"});
        VYBEG_AT_MOST(tracks.timeRange().upper, 1);
        QCOMPARE(tracks.content().unlike, 1);
        auto& list = the<AnalysisList>();
        list.setCurrentItem(list.topLevelItem(0));
        QTRY_COMPARE(drawn(), QStringList{"long.wav"});
        VYBEG_AT_LEAST(tracks.timeRange().upper, 19);
        // Both stay ticked, and one of them alone is no reason for a note.
        QVERIFY(document.analyses()[0].shown.visible && document.analyses()[1].shown.visible);
        document.setAnalysisVisible(document.analyses()[1].shown.id, false);
        QTRY_COMPARE(tracks.content().unlike, 0);
    }

    void a_page_shows_the_panels_that_act_on_it() {
        window_ = shownWindow();
        window_->document().open({home_.recording("demo.wav")});
        QTRY_VERIFY(!window_->document().busy() && window_->document().analyses().size() == 1);
        const auto shown = [this] {
            QStringList names;
            for (const QDockWidget* dock : window_->findChildren<QDockWidget*>()) {
                if (!dock->isHidden()) {
                    names << dock->objectName();
                }
            }
            names.sort();
            return names;
        };
        const QStringList all{"analysis", "readings", "recordings", "runs"};
        QCOMPARE(shown(), all);
        const int width = childOf<QDockWidget>(*window_, "readings").width();
        window_->action(Command::page_resonator)->trigger();
        QCOMPARE(shown(), QStringList{"recordings"});
        window_->action(Command::page_history)->trigger();
        QCOMPARE(shown(), QStringList());
        window_->action(Command::page_tracks)->trigger();
        QCOMPARE(shown(), all);
        QTRY_COMPARE(childOf<QDockWidget>(*window_, "readings").width(), width);
        // What the user has closed stays closed, in the next window, too.
        childOf<QDockWidget>(*window_, "runs").close();
        window_->action(Command::page_history)->trigger();
        window_->action(Command::page_tracks)->trigger();
        const QStringList rest{"analysis", "readings", "recordings"};
        QCOMPARE(shown(), rest);
        window_->action(Command::page_history)->trigger();
        QVERIFY(window_->close());
        window_ = std::make_unique<TestWindow>();
        window_->show();
        QCOMPARE(shown(), rest);
    }

    void the_first_window_is_not_larger_than_the_screen() {
        window_.reset();
        QSettings().clear();
        const TestWindow first;
        const QSize room = first.screen()->availableSize();
        VYBEG_AT_MOST(first.width(), room.width());
        VYBEG_AT_MOST(first.height(), room.height());
    }

    void the_empty_window_offers_the_demonstration_and_recent_files() {
        window_ = shownWindow();
        Document& document = window_->document();
        const auto idle = [&] {
            return QTest::qWaitFor(
                [&] { return !document.busy() && document.analyses().size() == 1; }, 20000);
        };
        auto& recent = childOf<QListWidget>(*window_, "recent");
        QVERIFY(!childOf<QPushButton>(*window_, "demonstration").toolTip().isEmpty());
        QTest::mouseClick(&childOf<QPushButton>(*window_, "demonstration"), Qt::LeftButton);
        QVERIFY(idle());
        QCOMPARE(document.analyses().front().shown.recording, QStringLiteral("demonstration.wav"));
        VYBEG_CLOSE(document.currentRecording()->recording->seconds(), 28, 0.001);
        const QString path = document.currentRecording()->path;
        document.closeRecording(document.currentRecording()->id);
        QVERIFY(recent.isVisible());
        VYBEG_AT_LEAST(recent.count(), 1);
        QCOMPARE(recent.item(0)->text(),
                 QStringLiteral("demonstration.wav\n") + QFileInfo(path).path());
        recent.setCurrentRow(0);
        recent.setFocus();
        QTest::keyClick(&recent, Qt::Key_Return);
        QVERIFY(idle());
        QCOMPARE(document.currentRecording()->path, path);
    }

    void units_and_plots_are_kept_from_window_to_window() {
        window_ = shownWindow();
        QVERIFY(the<TrackView>().units().angle == AngleUnit::degrees);
        DisplayUnits units;
        units.frequency = FrequencyUnit::deviation_ppm;
        units.angle = AngleUnit::radians;
        units.sigma_bands = false;
        emit the<WindowMenus>().unitsChosen(units);
        const std::vector<SlowVariable> plots{SlowVariable::a_B, SlowVariable::noise};
        the<TrackView>().setShownVariables(plots);
        QVERIFY(window_->close());
        TestWindow next;
        const auto& tracks = childOf<TrackView>(next);
        QVERIFY(tracks.units() == units);
        QVERIFY(tracks.shownVariables() == plots);
        QVERIFY(!next.action(Command::sigma_bands)->isChecked());
    }

    void the_cursor_reads_nothing_where_a_run_has_no_windows() {
        window_->document().open(
            {home_.recording("short.wav", 1.0), home_.recording("long.wav", 3.0)});
        QTRY_VERIFY_WITH_TIMEOUT(
            !window_->document().busy() && window_->document().analyses().size() == 2, 20000);
        auto& cursor = the<CursorPanel>();
        cursor.setTime(2.5);
        // Symbol, then value and deviation of each run.
        const QStringList cells = cursor.tableText().split('\n')[1].split('\t');
        QCOMPARE(cells[1], QString());
        QCOMPARE(cells[2], QString());
        QVERIFY2(!cells[3].isEmpty(), qPrintable(cursor.tableText()));
        cursor.setTime(0.5);
        QVERIFY(!cursor.tableText().split('\n')[1].split('\t')[1].isEmpty());
    }
};

VYBEG_TEST(TestWindowLayout)

}  // namespace test_window_layout

#include "test_window_layout.moc"
