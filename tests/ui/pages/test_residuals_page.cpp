// The page of the residuals as a person uses it: keys, mouse, menus.
#include "tests/closeness.h"
#include "tests/test_registry.h"
#include "tests/ui/gui_test.h"
#include "ui/panels/ledger.h"
#include "ui/plots/plot_view.h"
#include "ui/plots/track_view.h"
#include "ui/residuals/residuals_page.h"
#include "ui/words/display_units.h"

#include <QClipboard>
#include <QComboBox>
#include <QLabel>
#include <QPushButton>
#include <QTabBar>
#include <QTableWidget>
#include <QTest>

#include <cmath>

namespace test_residuals_page {

using namespace vybeg;
using namespace vybeg::ui;

class TestResidualsPage : public QObject, private WindowTest {
    Q_OBJECT

    ResidualsPage& page() { return the<ResidualsPage>(); }

    // 4 s at 8000 Hz, 1000 Hz, noise 1e-3, with hum at 50 Hz and a line of unknown origin at 2345
    // Hz, both of amplitude 1e-3; the noise of the second half is as large as the first's.
    QString disturbed(const QString& name) {
        const FreeDecay decay{.seconds = 4,
                              .rate_hz = 8000,
                              .f0_hz = 1000,
                              .a_B = 0.1,
                              .noise = 1e-3,
                              .hum = 1e-3,
                              .modes_beside = {{2345, 1e-3, 1e-3, 0, 0, 1e300}}};
        return home_.recording(name, decay);
    }

    void open(const QString& path) {
        document().open({path});
        QVERIFY(idle(1));
        QVERIFY(QTest::qWaitFor([&] { return document().carrier().has_value(); }));
    }

    void goToResiduals() {
        QTest::keyClick(window_.get(), Qt::Key_3, Qt::ControlModifier);
        QVERIFY(page().isVisible());
    }

    bool computed(std::int64_t samples) {
        return QTest::qWaitFor(
            [&] { return page().residuals() && page().residuals()->used() == samples; }, 20000);
    }

    // Number of the line near a frequency.
    std::size_t line(double f_hz) {
        const auto& lines = page().residuals()->lines;
        for (std::size_t k = 0; k < lines.size(); ++k) {
            if (std::abs(lines[k].f_hz - f_hz) < page().residuals()->bin_hz) {
                return k;
            }
        }
        qFatal("no line at %g Hz", f_hz);
    }

    void clickLine(double f_hz) {
        auto& spectrum = the<XYPlotView>("spectrum");
        const QPoint at = spectrum.positionOf(2, line(f_hz)).toPoint();
        QTest::mouseClick(&spectrum, Qt::LeftButton, {}, at);
    }

    QString sentence() { return the<QLabel>("residualState").text(); }
    QPushButton& filter() { return the<QPushButton>("residualFilter"); }

private slots:
    void init() { window_ = shownWindow(); }
    void cleanup() { window_.reset(); }

    void pages_have_keys_tabs_and_menu_entries() {
        auto& tabs = the<QTabBar>("pages");
        QVERIFY(!tabs.isVisible());
        QVERIFY(!window_->action(Command::page_residuals)->isEnabled());
        open(home_.recording("demo.wav"));
        QVERIFY(tabs.isVisible());
        QCOMPARE(tabs.count(), 7);
        goToResiduals();
        QCOMPARE(tabs.currentIndex(), 2);
        QVERIFY(!the<TrackView>().isVisible());
        QTest::keyClick(window_.get(), Qt::Key_1, Qt::ControlModifier);
        QVERIFY(the<TrackView>().isVisible() && !page().isVisible());
        QTest::mouseClick(&tabs, Qt::LeftButton, {}, tabs.tabRect(2).center());
        QVERIFY(page().isVisible());
        document().closeRecording(document().currentRecording()->id);
        QVERIFY(!tabs.isVisible() && !page().isVisible());
    }

    void the_residual_of_the_chosen_run_is_computed_when_the_page_is_shown() {
        open(home_.recording("demo.wav"));
        // The page computes 120 ms after a change; only time shows that it does not.
        QTest::qWait(300);
        QVERIFY(!page().residuals());  // nothing is computed for a hidden page
        goToResiduals();
        // 2 s at 8000 Hz are 266 windows of 60.
        QVERIFY(computed(266 * 60));
        const Residuals& found = *page().residuals();
        VYBEG_CLOSE_RATIO(found.c.noise_sd, 1e-3, 0.03);
        VYBEG_CLOSE_RATIO(found.d.noise_sd, 1e-3, 0.03);
        for (const char* name : {"spectrum", "histogram", "correlation"}) {
            const auto& plot = the<XYPlotView>(name);
            QVERIFY2(plot.isVisible(), name);
            VYBEG_AT_LEAST(plot.content().series.size(), 3, name);
            QVERIFY(!plot.accessibleName().isEmpty());
        }
        auto& numbers = the<QTableWidget>("residualNumbers");
        QVERIFY(numbers.isVisible());
        // A quantity is a column, C and D are rows.
        QCOMPARE(numbers.rowCount(), 2);
        QCOMPARE(numbers.columnCount(), 7);
        QVERIFY(the<QLabel>("residualState").text().contains(numberLabel(15960, 0)));
        QVERIFY(!the<QPushButton>("residualFilter").isVisible());
        // Without lines there is nothing to choose.
        QVERIFY(found.lines.empty());
        QVERIFY(!the<QComboBox>("residualLines").isVisible());
        QVERIFY(the<QLabel>("residualState").text().contains("No line above the noise."));
        QVERIFY(the<QLabel>("residualState").text().startsWith("<b>demo, n = 60.</b>"));
    }

    void range_and_cursor_change_the_numbers() {
        open(home_.recording("demo.wav"));
        goToResiduals();
        QVERIFY(computed(266 * 60));
        const double whole = page().residuals()->c.moments.sd;
        auto& range = the<QComboBox>("residualRange");
        range.setFocus();
        QTest::keyClick(&range, Qt::Key_Up);
        // The plots show what they showed: all.
        QCOMPARE(range.currentIndex(), static_cast<int>(ResidualsPage::Range::visible));
        the<TrackView>().setTimeRange({0.5, 0.75});
        QVERIFY(computed(2001));
        const double part = page().residuals()->c.moments.sd;
        QVERIFY(part != whole);
        VYBEG_CLOSE_RATIO(part, whole, 0.2);
        range.setFocus();
        QTest::keyClick(&range, Qt::Key_Up);
        QVERIFY(computed(60));
        const double first = page().residuals()->c.moments.sd;
        typeInto(fieldOf(*window_, "Time of the window"), "1,234");
        QVERIFY(QTest::qWaitFor(
            [&] { return page().residuals() && page().residuals()->c.moments.sd != first; }));
        QCOMPARE(page().residuals()->used(), std::int64_t(60));
        // Cursor A of the tracks is the same instant.
        const double second = page().residuals()->c.moments.sd;
        QTest::keyClick(window_.get(), Qt::Key_1, Qt::ControlModifier);
        auto& tracks = the<TrackView>();
        QTest::mouseMove(&tracks, QPoint(tracks.width() / 2, tracks.height() / 2));
        QVERIFY(QTest::qWaitFor([&] { return tracks.tracker().has_value(); }));
        tracks.setFocus();
        QTest::keyClick(&tracks, Qt::Key_1);
        QVERIFY(tracks.cursor(Cursor::a));
        goToResiduals();
        QVERIFY(QTest::qWaitFor(
            [&] { return page().residuals() && page().residuals()->c.moments.sd != second; }));
        VYBEG_CLOSE(*fieldOf(*window_, "Time of the window").value(), *tracks.cursor(Cursor::a),
                    1e-6);
    }

    void a_click_on_a_line_names_it_and_a_button_filters_it() {
        open(disturbed("disturbed.wav"));
        goToResiduals();
        QVERIFY(computed(533 * 60));
        VYBEG_AT_LEAST(page().residuals()->lines.size(), 2);
        // The page is laid out once its lines are there.
        const int two_lines = 2 * the<QLabel>("residualState").fontMetrics().lineSpacing();
        QTRY_VERIFY(the<QLabel>("residualState").height() >= two_lines);
        QCoreApplication::processEvents();
        const QRect place = the<XYPlotView>("spectrum").geometry();
        clickLine(50);
        QVERIFY2(sentence().startsWith("<b>50.00 Hz: supply of 50 Hz.</b>"),
                 qPrintable(sentence()));
        QCOMPARE(the<XYPlotView>("spectrum").geometry(), place);  // nothing moves under the mouse
        clickLine(2345);
        QVERIFY2(sentence().contains("2345.0"), qPrintable(sentence()));
        QVERIFY2(sentence().contains("unknown"), qPrintable(sentence()));
        QVERIFY(filter().isVisible());
        QTest::mouseClick(&filter(), Qt::LeftButton);
        const auto band = document().settings().filter;
        QVERIFY(band);
        VYBEG_LESS(band->low_hz, 1000);
        VYBEG_MORE(band->high_hz, 1000);
        VYBEG_LESS(band->high_hz, 2345);
        // Beside this page, too, the settings say that the plots are older.
        const auto& mark = the<QLabel>("stale");
        QTRY_VERIFY(mark.isVisible() && mark.text().contains("filter"));
        QTest::keyClick(window_.get(), Qt::Key_Z, Qt::ControlModifier);
        QVERIFY(!document().settings().filter);
        QTest::keyClick(window_.get(), Qt::Key_Z, Qt::ControlModifier | Qt::ShiftModifier);
        QCOMPARE(document().settings().filter, band);
        // The next run is without the line.
        QTest::keyClick(window_.get(), Qt::Key_F5);
        QVERIFY(idle(2));
        QVERIFY(QTest::qWaitFor(
            [&] { return page().residuals() && std::isnan(page().residuals()->c.noise_sd); }));
        for (const ResidualLine& left : page().residuals()->lines) {
            VYBEG_MORE(left.f_hz, band->low_hz);
            VYBEG_LESS(left.f_hz, band->high_hz);
        }
    }

    void the_filter_belongs_to_the_recording_of_the_run() {
        open(disturbed("first.wav"));
        goToResiduals();
        QVERIFY(computed(533 * 60));
        const auto first = document().currentRecording()->id;
        document().open({home_.recording("second.wav")});
        QVERIFY(idle(2));
        const auto second = document().currentRecording()->id;
        QVERIFY(second != first);
        // A row is an analysis and its recording.
        the<Ledger>().setCurrentAnalysis(document().analyses().front().shown.id);
        QCOMPARE(document().currentRecording()->id, first);
        QVERIFY(computed(533 * 60));
        clickLine(2345);
        QTest::mouseClick(&filter(), Qt::LeftButton);
        QCOMPARE(document().currentRecording()->id, first);
        QVERIFY(document().settings().filter.has_value());
    }

    void lines_are_chosen_by_keys() {
        open(disturbed("keys.wav"));
        goToResiduals();
        QVERIFY(computed(533 * 60));
        auto& spectrum = the<XYPlotView>("spectrum");
        auto& lines = the<QComboBox>("residualLines");
        QCOMPARE(lines.count(), static_cast<int>(page().residuals()->lines.size()) + 1);
        spectrum.setFocus();
        QTest::keyClick(&spectrum, Qt::Key_Right);
        QCOMPARE(lines.currentIndex(), 1);
        QVERIFY(sentence().contains(lines.currentText().section(':', 0, 0)));
        QTest::keyClick(&spectrum, Qt::Key_Left);
        QCOMPARE(lines.currentIndex(), 0);
        QVERIFY(sentence().contains("Samples per channel"));
        QTest::keyClick(&spectrum, Qt::Key_Left);
        QCOMPARE(lines.currentIndex(), lines.count() - 1);
        // A click beside all lines chooses none.
        const QString before = sentence();
        QTest::mouseClick(&spectrum, Qt::LeftButton, {}, QPoint(70, 30));
        QCOMPARE(sentence(), before);
        QTest::keyClick(&spectrum, Qt::Key_C, Qt::ControlModifier);
        QVERIFY(!QApplication::clipboard()->image().isNull());
    }

    void what_is_missing_is_said() {
        open(home_.recording("demo.wav"));
        document().removeAnalysis(document().analyses().front().shown.id);
        goToResiduals();
        QVERIFY(the<QLabel>("residualState").text().contains("No analysis is chosen"));
        QVERIFY(!the<QTableWidget>("residualNumbers").isVisible());
        QTest::keyClick(window_.get(), Qt::Key_F5);
        QVERIFY(idle(1));
        QVERIFY(computed(266 * 60));
        // The smallest window has too few samples for a spectrum, and says so.
        Settings settings = document().settings();
        settings.window = 8;
        document().setSettings(settings);
        QTest::keyClick(window_.get(), Qt::Key_F5);
        QVERIFY(idle(2));
        the<QComboBox>("residualRange").setCurrentIndex(0);
        QVERIFY(computed(8));
        QVERIFY(the<XYPlotView>("spectrum").content().empty.contains("too short"));
    }

    void the_page_speaks_the_language_of_the_window() {
        open(disturbed("russian.wav"));
        goToResiduals();
        QVERIFY(computed(533 * 60));
        clickLine(50);
        const auto& lines = page().residuals()->lines;
        window_->setLanguage("ru");
        QTRY_VERIFY2(sentence().contains("Гц"), qPrintable(sentence()));
        QCOMPARE(page().residuals()->lines.size(), lines.size());
        QTRY_COMPARE(the<QTabBar>("pages").tabText(2), QString("Невязки"));
        window_->setLanguage("en");
        QTRY_VERIFY(sentence().contains("Hz"));
    }
};

VYBEG_TEST(TestResidualsPage, threads)

}  // namespace test_residuals_page

#include "test_residuals_page.moc"
