// The empty window, and where things stand in it: the overview over the plots, values of two runs
// uncut.
#include "tests/closeness.h"
#include "tests/test_registry.h"
#include "tests/ui/gui_test.h"
#include "tests/ui/resonator_runs.h"
#include "ui/charts/round_plot.h"
#include "ui/panels/ledger.h"
#include "ui/panels/wave_panel.h"
#include "ui/plots/signal_view.h"
#include "ui/plots/track_view.h"
#include "ui/resonator/outcome_views.h"
#include "ui/resonator/resonator_page.h"
#include "ui/settings/settings_panel.h"
#include "ui/widgets/page_parts.h"
#include "ui/widgets/quantity_table.h"
#include "ui/window/main_window.h"
#include "ui/window/window_menus.h"

#include <QFileInfo>
#include <QHeaderView>
#include <QLabel>
#include <QLayout>
#include <QListWidget>
#include <QMenuBar>
#include <QPushButton>
#include <QScreen>
#include <QScrollArea>
#include <QScrollBar>
#include <QSettings>
#include <QTest>
#include <QToolButton>
#include <qcustomplot.h>

namespace test_window_layout {

using namespace vybeg;
using namespace vybeg::ui;

class TestWindowLayout : public QObject, private WindowTest {
    Q_OBJECT

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
        QTest::newRow("1600x1000") << QSize(1600, 1000) << 150 << false;
        QTest::newRow("1400x900") << QSize(1400, 900) << 130 << false;
        QTest::newRow("1280x720") << QSize(1280, 720) << 95 << false;
        QTest::newRow("1280x420") << QSize(1280, 420) << 45 << true;
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

    // Theme, language and size may change while another page is shown.
    void what_changed_while_a_page_was_hidden_is_laid_out_when_it_is_shown() {
        window_ = shownWindow();
        Document& document = window_->document();
        document.open(resonatorRuns(home_, "laid"));
        QTRY_VERIFY(!document.busy() && document.sets().canIdentify());
        window_->action(Command::identify)->trigger();
        QTRY_VERIFY_WITH_TIMEOUT(!document.busy() && document.sets().current(), 60000);
        for (const char* language : {"en", "ru"}) {
            for (const ThemeMode theme : {ThemeMode::dark, ThemeMode::light}) {
                window_->action(Command::page_resonator)->trigger();
                window_->resize(2560, 1440);
                QTest::qWait(1);
                window_->action(Command::page_signals)->trigger();
                window_->setLanguage(QLatin1String(language));
                window_->setThemeMode(theme);
                window_->resize(1280, 720);
                window_->action(Command::page_resonator)->trigger();
                QTest::qWait(1);
                // Table, sentence and tabs stand one below the other, each as high as it needs.
                auto& numbers = the<NumbersView>();
                const QLayout& parts = *numbers.layout();
                int seen = 0;
                int next = 0;
                for (int k = 0; k < parts.count(); ++k) {
                    const QWidget& part = *parts.itemAt(k)->widget();
                    if (part.isVisible()) {
                        QCOMPARE(part.y(), next);
                        next += part.height() + parts.spacing();
                        ++seen;
                        if (const auto* label = qobject_cast<const QLabel*>(&part)) {
                            QCOMPARE(label->height(), label->heightForWidth(label->width()));
                        }
                    }
                }
                QCOMPARE(next - parts.spacing(), numbers.height());
                VYBEG_AT_LEAST(seen, 3);
                for (const auto* table : the<ResonatorPage>().findChildren<QuantityTable*>()) {
                    int needed = table->horizontalHeader()->isVisible()
                                     ? table->horizontalHeader()->height()
                                     : 0;
                    for (int row = 0; row < table->rowCount(); ++row) {
                        needed += table->rowHeight(row);
                    }
                    if (table->isVisible()) {
                        QCOMPARE(table->height(), needed);
                    }
                }
            }
        }
        window_->setLanguage(QStringLiteral("en"));
    }

    void the_overview_stands_over_the_plots() {
        window_ = shownWindow();
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

    // A reason is longer than the numbers beside it, and has the column that takes the rest.
    void a_reason_does_not_widen_the_columns() {
        window_ = shownWindow();
        Document& document = window_->document();
        document.open({home_.recording("short.wav", 1.0), home_.recording("long.wav", 3.0)});
        QTRY_VERIFY(!document.busy() && document.analyses().size() == 2);
        auto& ledger = the<Ledger>();
        ledger.setMouse(0.5);
        const int column = ledger.columnOf(SlowVariable::a_A);
        const int width = ledger.columnWidth(column);
        const auto reason = [&ledger](int row) {
            return ledger.topLevelItem(row)->text(Ledger::trend);
        };
        QVERIFY(reason(0).isEmpty() && reason(1).isEmpty());
        ledger.setMouse(2.5);
        QCOMPARE(reason(0), QStringLiteral("no windows there"));
        QVERIFY(reason(1).isEmpty());
        QCOMPARE(ledger.columnWidth(column), width);
    }

    void numbers_of_analyses_are_not_cut_data() {
        QTest::addColumn<QString>("language");
        QTest::addColumn<QSize>("size");
        for (const char* language : {"en", "ru"}) {
            QTest::addRow("%s, small", language) << language << QSize(1280, 720);
            QTest::addRow("%s, large", language) << language << QSize(1920, 1080);
        }
    }
    void numbers_of_analyses_are_not_cut() {
        QFETCH(QString, language);
        QFETCH(QSize, size);
        window_ = shownWindow();
        window_->setLanguage(language);
        window_->resize(size);
        Document& document = window_->document();
        document.open({home_.recording("a_recording_with_a_long_name_1.wav"),
                       home_.recording("a_recording_with_a_long_name_2.wav")});
        QTRY_VERIFY(!document.busy() && document.analyses().size() == 2);
        auto& tracks = the<TrackView>();
        tracks.setFocus();
        for (const auto& [time_s, key] : {std::pair{0.5, Qt::Key_1}, std::pair{1.5, Qt::Key_2}}) {
            tracks.setTracker(time_s);
            QTest::keyClick(&tracks, key);
        }
        auto& ledger = the<Ledger>();
        for (const ReadAt at : {ReadAt::mouse, ReadAt::a, ReadAt::difference, ReadAt::rate}) {
            ledger.setReadAt(at);
            QCoreApplication::processEvents();
            int right = 0;
            for (int column = 0; column < ledger.columnCount(); ++column) {
                right += ledger.isColumnHidden(column) ? 0 : ledger.columnWidth(column);
                if (column == Ledger::name || ledger.isColumnHidden(column)) {
                    continue;
                }
                for (int row = 0; row < ledger.topLevelItemCount(); ++row) {
                    const QString text = ledger.topLevelItem(row)->text(column);
                    VYBEG_AT_LEAST(ledger.columnWidth(column),
                                   ledger.fontMetrics().horizontalAdvance(text), qPrintable(text));
                }
            }
            VYBEG_AT_MOST(right, ledger.viewport()->width());
            for (const SlowVariable variable : main_slow_variables) {
                QVERIFY(!ledger.isColumnHidden(ledger.columnOf(variable)));
            }
        }
        window_->setLanguage(QStringLiteral("en"));
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
        auto& list = the<Ledger>();
        list.setCurrentItem(list.topLevelItem(0));
        QTRY_COMPARE(drawn(), QStringList{"long.wav"});
        VYBEG_AT_LEAST(tracks.timeRange().upper, 19);
        // Both stay ticked, and one of them alone is no reason for a note.
        QVERIFY(document.analyses()[0].shown.visible && document.analyses()[1].shown.visible);
        document.setAnalysisVisible(document.analyses()[1].shown.id, false);
        QTRY_COMPARE(tracks.content().unlike, 0);
    }

    void a_page_shows_what_acts_on_it() {
        window_ = shownWindow();
        const auto shown = [this] {
            QStringList names;
            const auto add = [&](const QWidget& part, const char* name) {
                if (part.isVisible()) {
                    names << QLatin1String(name);
                }
            };
            add(the<SettingsPanel>(), "settings");
            add(the<Ledger>(), "ledger");
            add(the<SignalView>(), "overview");
            add(the<WavePanel>(), "wave");
            return names.join(' ');
        };
        QCOMPARE(shown(), QString());  // the start page has the window for itself
        window_->document().open({home_.recording("demo.wav")});
        QTRY_VERIFY(!window_->document().busy() && window_->document().analyses().size() == 1);
        QCOMPARE(shown(), QStringLiteral("settings ledger overview"));
        window_->action(Command::page_residuals)->trigger();
        QCOMPARE(shown(), QStringLiteral("settings ledger"));
        window_->action(Command::page_resonator)->trigger();
        QCOMPARE(shown(), QString());
        window_->action(Command::page_history)->trigger();
        QCOMPARE(shown(), QString());
        // By keys: the wave beside the plots, and plots without settings.
        window_->action(Command::page_tracks)->trigger();
        const int width = the<TrackView>().width();
        QTest::keyClick(window_.get(), Qt::Key_W);
        QCOMPARE(shown(), QStringLiteral("settings ledger overview wave"));
        // It fills its plots, and the ledger names its curves.
        const RoundView& pattern = childOf<RoundView>(*window_, QLatin1String("pattern"));
        const RoundView& ellipse = childOf<RoundView>(*window_, QLatin1String("ellipse"));
        const auto& radii = pattern.content().series.front().y;
        VYBEG_LESS(pattern.content().reach, 1.5 * *std::ranges::max_element(radii));
        QCOMPARE(ellipse.content().reach, pattern.content().reach);
        for (const RoundView* view : {&pattern, &ellipse}) {
            QVERIFY(!view->findChild<QLabel*>()->isVisible());
        }
        QTest::keyClick(window_.get(), Qt::Key_W);
        QTest::keyClick(window_.get(), Qt::Key_F9);
        QCOMPARE(shown(), QStringLiteral("ledger overview"));
        QTRY_VERIFY(the<TrackView>().width() > width + 200);
        QTest::keyClick(&fieldOf(*window_, "Time of cursor A"), Qt::Key_W);
        QCOMPARE(shown(), QStringLiteral("ledger overview"));  // a letter that is typed
        // What the user has put away stays so, in the next window, too.
        window_->action(Command::page_history)->trigger();
        QVERIFY(window_->close());
        window_ = std::make_unique<TestWindow>();
        window_->show();
        window_->document().open({home_.recording("demo.wav")});
        QTRY_VERIFY(!window_->document().busy() && window_->document().analyses().size() == 1);
        QCOMPARE(shown(), QStringLiteral("ledger overview"));
        QTest::keyClick(window_.get(), Qt::Key_F9);
        QCOMPARE(shown(), QStringLiteral("settings ledger overview"));
    }

    void the_context_menu_of_the_plots_acts_on_them() {
        window_ = shownWindow();
        const auto& tracks = the<TrackView>();
        QVERIFY(tracks.contextMenuPolicy() == Qt::ActionsContextMenu);
        QCOMPARE(tracks.actions().size(), 7);
        for (const Command command :
             {Command::zoom_fit, Command::axis_limits, Command::log_a_A, Command::copy_plot}) {
            QVERIFY(tracks.actions().contains(window_->action(command)));
        }
    }

    // In a wide window the wave has room beside the signals.
    void the_wave_stands_beside_the_signals_of_a_wide_window() {
        window_ = shownWindow();
        window_->document().open({home_.recording("demo.wav")});
        QTRY_VERIFY(!window_->document().busy() && window_->document().analyses().size() == 1);
        window_->action(Command::page_signals)->trigger();
        window_->resize(1500, 900);
        QTRY_VERIFY(!the<WavePanel>().isVisible());
        window_->resize(1600, 1000);
        QTRY_VERIFY(the<WavePanel>().isVisible());
        window_->action(Command::page_tracks)->trigger();
        QVERIFY(!the<WavePanel>().isVisible());
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

    void the_theme_that_was_chosen_is_ticked() {
        window_ = shownWindow();
        const auto titled = [](const auto& all, const QString& text) {
            return *std::ranges::find_if(all, [&text](const auto* each) {
                const auto* menu = qobject_cast<const QMenu*>(each);
                return (menu ? menu->title() : each->property("text").toString()).remove('&') ==
                       text;
            });
        };
        QMenu* themes = titled(the<QMenuBar>().findChildren<QMenu*>(), "Theme");
        for (const char* name : {"Dark", "Light", "As the system"}) {
            titled(themes->actions(), name)->trigger();
            emit themes->aboutToShow();
            for (const QAction* each : themes->actions()) {
                QCOMPARE(each->isChecked(), each == titled(themes->actions(), name));
            }
        }
    }

    void sections_of_the_settings_are_open_where_there_is_room() {
        window_ = shownWindow();
        document().open({home_.recording("sections.wav")});
        QVERIFY(idle(1));
        Section& calibration = *the<SettingsPanel>().findChildren<Section*>().last();
        const auto open_in = [&](int height) {
            window_->resize(1600, height);
            QCoreApplication::processEvents();
            return calibration.isOpen();
        };
        QVERIFY(!open_in(720));
        QVERIFY(open_in(1200));
        QVERIFY(!open_in(720));
        // What a person opens stays open.
        QTest::mouseClick(calibration.findChild<QToolButton*>(), Qt::LeftButton);
        QVERIFY(open_in(1200));
        QVERIFY(open_in(720));
    }

    void the_cursor_reads_nothing_where_a_run_has_no_windows() {
        window_ = shownWindow();
        window_->document().open(
            {home_.recording("short.wav", 1.0), home_.recording("long.wav", 3.0)});
        QTRY_VERIFY_WITH_TIMEOUT(
            !window_->document().busy() && window_->document().analyses().size() == 2, 20000);
        auto& ledger = the<Ledger>();
        ledger.setMouse(2.5);
        // Symbol, then value and deviation of each run.
        const QStringList cells = ledger.tableText().split('\n')[1].split('\t');
        QCOMPARE(cells[1], QString());
        QCOMPARE(cells[2], QString());
        QVERIFY2(!cells[3].isEmpty(), qPrintable(ledger.tableText()));
        ledger.setMouse(0.5);
        QVERIFY(!ledger.tableText().split('\n')[1].split('\t')[1].isEmpty());
    }

    // One row of a recording with its analysis; with more, a row each below the first.
    void recordings_and_analyses_are_rows_of_one_list() {
        window_ = shownWindow();
        Document& document = window_->document();
        document.open({home_.recording("first.wav"), home_.recording("second.wav")});
        QTRY_VERIFY(!document.busy() && document.analyses().size() == 2);
        auto& ledger = the<Ledger>();
        QCOMPARE(ledger.topLevelItemCount(), 2);
        // A click on a row chooses recording and analysis.
        const auto click = [&ledger](int row) {
            const QRect place = ledger.visualItemRect(ledger.topLevelItem(row));
            QTest::mouseClick(
                ledger.viewport(), Qt::LeftButton, {},
                {ledger.columnViewportPosition(Ledger::window) + 4, place.center().y()});
        };
        for (const int row : {0, 1, 0}) {
            click(row);
            const AnalysisEntry& entry = document.analyses()[static_cast<std::size_t>(row)];
            QCOMPARE(ledger.currentAnalysis(), entry.shown.id);
            QCOMPARE(document.currentRecording()->id, entry.recording_id);
        }
        Settings settings = document.settings();
        settings.window = 80;
        document.setSettings(settings);
        document.analyse();
        QTRY_VERIFY(!document.busy() && document.analyses().size() == 3);
        QCOMPARE(ledger.topLevelItemCount(), 3);
        // Below its sibling, chosen, and its recording's row is the bold one.
        QCOMPARE(ledger.topLevelItem(1)->text(Ledger::window), QStringLiteral("80"));
        QCOMPARE(ledger.currentItem(), ledger.topLevelItem(1));
        QVERIFY(ledger.topLevelItem(0)->font(Ledger::name).bold());
        QVERIFY(!ledger.topLevelItem(1)->font(Ledger::name).bold());
        // By keys: down to the other recording; without its analysis it keeps its row.
        ledger.setFocus();
        QTest::keyClick(&ledger, Qt::Key_Down);
        QCOMPARE(document.currentRecording()->id, document.recordings()[1].id);
        QTest::keyClick(&ledger, Qt::Key_Delete);
        QTRY_COMPARE(document.analyses().size(), std::size_t(2));
        QCOMPARE(ledger.topLevelItemCount(), 3);
        QCOMPARE(ledger.currentAnalysis(), AnalysisId::none);
        QTest::keyClick(&ledger, Qt::Key_Delete);
        QTRY_COMPARE(document.recordings().size(), std::size_t(1));
        QCOMPARE(ledger.topLevelItemCount(), 2);
    }
};

VYBEG_TEST(TestWindowLayout)

}  // namespace test_window_layout

#include "test_window_layout.moc"
