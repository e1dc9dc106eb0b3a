#include "tests/closeness.h"
#include "tests/test_registry.h"
#include "tests/ui/gui_test.h"
#include "tests/ui/heartbeat.h"
#include "ui/document/document.h"
#include "ui/plots/plot_view.h"
#include "ui/sweep/sweep_page.h"
#include "ui/words/display_units.h"

#include <QApplication>
#include <QClipboard>
#include <QComboBox>
#include <QHelpEvent>
#include <QLabel>
#include <QPicture>
#include <QPushButton>
#include <QTabBar>
#include <QTableWidget>
#include <QToolTip>
#include <QtTest>
#include <qcustomplot.h>

#include <numbers>

namespace test_sweep_page {

using namespace vybeg;
using namespace vybeg::ui;

class TestSweepPage : public QObject, private WindowTest {
    Q_OBJECT

    SweepPage& page() { return the<SweepPage>(); }

    void open(const QString& path) {
        document().open({path});
        QVERIFY(QTest::qWaitFor(
            [&] { return !document().busy() && !document().analyses().empty(); }, 20000));
    }

    void goToSweep() {
        QTest::keyClick(window_.get(), Qt::Key_4, Qt::ControlModifier);
        QVERIFY(page().isVisible());
    }

    QPushButton& button(const char* name) { return the<QPushButton>(QLatin1String(name)); }
    QString text(const char* name) { return the<QLabel>(QLatin1String(name)).text(); }

    void type(const char* lengths) {
        auto& field = the<LengthField>();
        field.setFocus();
        field.selectAll();
        QTest::keyClicks(&field, lengths);
    }

    // Runs the list and waits for its result.
    void sweep(const char* lengths, std::size_t count) {
        type(lengths);
        QTest::mouseClick(&button("computeSweep"), Qt::LeftButton);
        QVERIFY(page().running());
        QVERIFY(QTest::qWaitFor([&] { return !page().running(); }, 30000));
        QVERIFY(page().sweep());
        QCOMPARE(page().sweep()->lengths.size(), count);
    }

    static QRect frameOf(const QCustomPlot& plot) {
        return const_cast<QCustomPlot&>(plot).axisRects().front()->rect();
    }

    // Each curve has its name, whole, beside the frame and apart from the others.
    static void checkNames(QCustomPlot& plot, const XYPlot& content) {
        plot.replot();
        QStringList wanted;
        for (const XYSeries& series : content.series) {
            if (!series.name.isEmpty()) {
                wanted << series.name;
            }
        }
        QStringList named;
        std::vector<QRectF> places;
        for (int k = 0; k < plot.itemCount(); ++k) {
            if (const auto* name = qobject_cast<QCPItemText*>(plot.item(k))) {
                named << name->text();
                places.emplace_back(name->topLeft->pixelPosition(),
                                    name->bottomRight->pixelPosition());
                const QString where = name->text();
                VYBEG_AT_LEAST(places.back().left(), frameOf(plot).right(), qPrintable(where));
                VYBEG_AT_LEAST(places.back().width(),
                               QFontMetrics(name->font()).horizontalAdvance(name->text()),
                               qPrintable(where));
                QVERIFY2(QRectF(plot.viewport()).contains(places.back()), qPrintable(where));
            }
        }
        wanted.sort();
        named.sort();
        QCOMPARE(named, wanted);
        VYBEG_AT_LEAST(named.size(), 4);
        for (std::size_t k = 0; k < places.size(); ++k) {
            for (std::size_t other = 0; other < k; ++other) {
                QVERIFY(!places[k].adjusted(0, 1, 0, -1).intersects(places[other]));
            }
        }
    }

private slots:
    void init() { window_ = shownWindow(); }
    void cleanup() { window_.reset(); }

    void lists_of_lengths_are_read() {
        QCOMPARE(readLengthList("6,12; 60 600").lengths,
                 (std::vector<std::int64_t>{6, 12, 60, 600}));
        QCOMPARE(readLengthList("600, 6, 6").lengths, (std::vector<std::int64_t>{6, 600}));
        const auto range = readLengthList("6 .. 600").lengths;
        QCOMPARE(range.size(), std::size_t(15));
        QCOMPARE(range.front(), 6);
        QCOMPARE(range.back(), 600);
        QCOMPARE(readLengthList("600..6").lengths, range);
        QCOMPARE(readLengthList("5..7, 1000").lengths, (std::vector<std::int64_t>{5, 6, 7, 1000}));
        for (const char* wrong :
             {"", " , ", "six", "6..", "..6", "6..60..600", "4", "6.5", "-6", "1e9", "99999999999",
              "6..600, 1000..2000, 3000..4000, "
              "5000..6000, 7000..9000"}) {
            const LengthList list = readLengthList(wrong);
            QVERIFY2(list.lengths.empty() && !list.refusal.isEmpty(), wrong);
        }
    }

    // Open, go to the page by its key, run, look at the points, use the window, take it back.
    void a_journey_to_the_recommended_window() {
        QVERIFY(!window_->action(Command::page_windows)->isEnabled());
        open(home_.recording("demo.wav"));
        goToSweep();
        QCOMPARE(the<QTabBar>("pages").tabText(3), QString("Windows"));
        QVERIFY(!page().sweep());
        QVERIFY(!the<QTableWidget>("sweepTable").isVisible());
        QVERIFY(text("sweepState").contains("Compute estimates"));
        sweep("6..600", 15);
        const WindowSweep& found = *page().sweep();
        auto& plot = the<XYPlotView>("sweepScatter");
        QVERIFY(plot.isVisible());
        QCOMPARE(plot.content().series.front().x.size(), std::size_t(15));
        QVERIFY(plot.content().x_logarithmic && plot.content().y_logarithmic);
        auto& table = the<QTableWidget>("sweepTable");
        QCOMPARE(table.rowCount(), 15);
        // Maximum likelihood has no leakage of its own.
        QStringList titles;
        for (int column = 1; column < table.columnCount(); ++column) {
            titles << table.horizontalHeaderItem(column)->text();
        }
        QVERIFY2(titles.contains("Cramér-Rao bound, ×10⁻³\u00a0°"), qPrintable(titles.join('|')));
        QVERIFY2(!titles.join('|').contains("own leakage"), qPrintable(titles.join('|')));
        QVERIFY2(titles.back() == "noise, ×10⁻³", qPrintable(titles.back()));
        QCOMPARE(table.horizontalHeaderItem(0)->text(), QString("n"));
        // A deviation has three digits, its zeros among them.
        for (int row = 0; row < table.rowCount(); ++row) {
            QString digits = table.item(row, table.columnCount() - 1)->text();
            digits.remove(QRegularExpression("^0\\.[0\u202f]*|\\D"));
            QVERIFY2(digits.size() == 3, qPrintable(digits));
        }
        VYBEG_CLOSE_RATIO(found.white_noise, 1e-3, 0.03);
        // A still wave in white noise: the longest window, and the bound is reached.
        QVERIFY(found.advice);
        VYBEG_MORE(found.lengths[found.advice->best].length, 300);
        QVERIFY2(text("sweepAdvice").contains("Recommended"), qPrintable(text("sweepAdvice")));
        const SweepValue& at60 = found.lengths[7].values[2];
        VYBEG_CLOSE(at60.scatter, at60.bound, 5 * at60.sd_scatter);

        const Settings before = document().settings();
        QTest::mouseClick(&button("sweepUse"), Qt::LeftButton);
        QCOMPARE(document().settings().window, found.lengths[found.advice->best].length);
        QTest::keyClick(window_.get(), Qt::Key_Z, Qt::ControlModifier);
        QCOMPARE(document().settings(), before);
        QVERIFY(page().sweep());
        QVERIFY2(!text("sweepState").contains("older"), qPrintable(text("sweepState")));
    }

    // At the ends of the curves, beside each other's plot, on the screen and in an export; in a low
    // plot in a legend.
    void the_curves_are_named_at_their_ends() {
        open(home_.recording("names.wav"));
        goToSweep();
        sweep("6..600", 15);
        for (const char* language : {"en", "ru"}) {
            window_->setLanguage(language);
            for (const QSize size : {QSize(1280, 720), QSize(1920, 1080)}) {
                window_->resize(size);
                for (int v = 0; v < the<QComboBox>("sweepVariable").count(); ++v) {
                    the<QComboBox>("sweepVariable").setCurrentIndex(v);
                    QCoreApplication::processEvents();
                    const auto& scatter = the<XYPlotView>("sweepScatter");
                    const auto& residual = the<XYPlotView>("sweepResidual");
                    checkNames(childOf<QCustomPlot>(scatter), scatter.content());
                    checkNames(childOf<QCustomPlot>(residual), residual.content());
                    const QRect above = frameOf(childOf<QCustomPlot>(scatter));
                    const QRect below = frameOf(childOf<QCustomPlot>(residual));
                    QCOMPARE(above.right(), below.right());
                    // The table is beside the plots, and no wider than its numbers need.
                    VYBEG_MORE(the<QTableWidget>("sweepTable").mapTo(&page(), QPoint()).x(),
                               scatter.mapTo(&page(), QPoint(scatter.width() - 1, 0)).x());
                    VYBEG_AT_LEAST(scatter.width(), (size.width() > 1300 ? 900 : 440));
                }
            }
        }
        window_->setLanguage("en");
        XYPlot plot = the<XYPlotView>("sweepScatter").content();
        const auto drawn = [&plot](QCustomPlot& into, const QSize& size) {
            into.resize(size);
            layOutXYPlot(into, plot, lightTheme(), size);
            into.toPixmap(size.width(), size.height());
        };
        QCustomPlot exported;
        drawn(exported, the<XYPlotView>("sweepScatter").figure().size);
        checkNames(exported, plot);
        for (const QSize& small : {QSize(640, 110), QSize(200, 420)}) {
            QCustomPlot low;
            drawn(low, small);
            QCOMPARE(low.itemCount(), 0);
            VYBEG_MORE(low.plotLayout()->rowCount(), 1);
        }
        // The plot alone names the axis that it shares on the page.
        QVERIFY(plot.x_below);
        QPicture picture;
        QCPPainter painter(&picture);
        the<XYPlotView>("sweepScatter").figure().draw(painter, {640, 420});
        QVERIFY(!picture.isNull());
    }

    void in_a_narrow_window_the_table_is_below_the_plots() {
        open(home_.recording("narrow.wav"));
        goToSweep();
        sweep("6..600", 15);
        window_->resize(1050, 720);
        QCoreApplication::processEvents();
        QCOMPARE(window_->width(), 1050);
        const auto& residual = the<XYPlotView>("sweepResidual");
        QTRY_VERIFY(the<QTableWidget>("sweepTable").mapTo(&page(), QPoint()).y() >
                    residual.mapTo(&page(), QPoint(0, residual.height() - 1)).y());
    }

    void an_advice_tells_of_the_warning_of_an_analysis() {
        WindowSweep found;
        for (const std::int64_t length : {60, 120, 240}) {
            auto& each = found.lengths.emplace_back();
            each.length = length;
            each.windows = 6000 / length;
        }
        found.advice = WindowAdvice{.best = 2};
        QVERIFY(!adviceText(found, {}).contains("warns"));
        found.lengths[2].moving = 7;
        QVERIFY2(adviceText(found, {}).contains("inside 7 of its 25 windows"),
                 qPrintable(adviceText(found, {})));
        QVERIFY(!adviceText(found, {}).contains("Without the warning"));
        found.advice->quiet = 1;
        found.advice->quiet_loss = 2.8;
        QVERIFY2(adviceText(found, {}).contains("Without the warning n = 120"),
                 qPrintable(adviceText(found, {})));
        QVERIFY(adviceText(found, {}).contains("2.8 times"));
    }

    void a_point_is_chosen_by_mouse_and_keys() {
        open(home_.recording("points.wav"));
        goToSweep();
        sweep("6, 24, 96", 3);
        auto& plot = the<XYPlotView>("sweepScatter");
        QVERIFY(!the<QLabel>("sweepPoint").isVisible());
        QTest::mouseClick(&plot, Qt::LeftButton, {}, plot.positionOf(0, 1).toPoint());
        QVERIFY(the<QLabel>("sweepPoint").isVisible());
        QVERIFY2(text("sweepPoint").contains("n = 24"), qPrintable(text("sweepPoint")));
        QCOMPARE(button("sweepUse").text(), QString("Use n = 24"));
        plot.setFocus();
        QTest::keyClick(&plot, Qt::Key_Left);
        QVERIFY2(text("sweepPoint").contains("n = 6,"), qPrintable(text("sweepPoint")));
        QTest::keyClick(&plot, Qt::Key_Left);
        QVERIFY(text("sweepPoint").contains("n = 6,"));
        QTest::keyClick(&plot, Qt::Key_Right);
        QTest::keyClick(&plot, Qt::Key_Right);
        button("sweepUse").setFocus();
        QTest::keyClick(&button("sweepUse"), Qt::Key_Space);
        QCOMPARE(document().settings().window, 96);
        const QPoint at = plot.positionOf(0, 1).toPoint();
        QHelpEvent help(QEvent::ToolTip, at, plot.mapToGlobal(at));
        QApplication::sendEvent(&plot, &help);
        QTRY_VERIFY(QToolTip::text().contains("n = 24"));
        QToolTip::hideText();
    }

    void a_wrong_list_is_refused_with_a_sentence() {
        open(home_.recording("wrong.wav"));
        goToSweep();
        type("6, sixty");
        QVERIFY(!button("computeSweep").isEnabled());
        QVERIFY2(text("sweepState").contains("sixty"), qPrintable(text("sweepState")));
        QTest::keyClick(&the<LengthField>(), Qt::Key_Return);
        QVERIFY(!page().running());
        // Windows that the recording does not hold are named; the others are estimated.
        sweep("5, 24, 96, 1000000", 2);
        QVERIFY2(text("sweepState").contains("n = " + numberLabel(1000000, 0)),
                 qPrintable(text("sweepState")));
        QVERIFY(text("sweepState").contains("n = 5"));
        type("1000000");
        QTest::keyClick(&the<LengthField>(), Qt::Key_Return);
        QVERIFY(QTest::qWaitFor([&] { return !page().running(); }, 20000));
        QVERIFY(!page().sweep());
        QVERIFY(!text("sweepState").isEmpty());
    }

    void results_stay_with_their_recording_and_grow_old_with_the_settings() {
        open(home_.recording("first.wav"));
        goToSweep();
        sweep("24, 96", 2);
        QTest::keyClick(window_.get(), Qt::Key_1, Qt::ControlModifier);
        goToSweep();
        QVERIFY(page().sweep() && the<QTableWidget>("sweepTable").isVisible());
        Settings settings = document().settings();
        settings.window = 123;  // no matter to a sweep
        document().setSettings(settings);
        QVERIFY(!the<QLabel>("sweepState").isVisible());
        settings.from_s = 0.5;
        document().setSettings(settings);
        QVERIFY(the<QLabel>("sweepState").isVisible());
        QVERIFY(text("sweepState").contains("older"));
        QTest::keyClick(window_.get(), Qt::Key_Z, Qt::ControlModifier);
        QVERIFY(!the<QLabel>("sweepState").isVisible());
        // The algorithm follows the panel; here it may be another one.
        settings = document().settings();
        settings.algorithm = Algorithm::demodulation;
        document().setSettings(settings);
        auto& algorithm = the<QComboBox>("sweepAlgorithm");
        QCOMPARE(algorithm.currentIndex(), static_cast<int>(Algorithm::demodulation));
        QVERIFY(text("sweepState").contains("older"));
        algorithm.setFocus();
        QTest::keyClick(&algorithm, Qt::Key_Up);
        sweep("24, 96", 2);
        QCOMPARE(page().sweep()->settings.algorithm, Algorithm::moving_axes);
        QTest::mouseClick(&button("sweepUse"), Qt::LeftButton);
        QCOMPARE(document().settings().algorithm, Algorithm::moving_axes);

        const auto first = document().currentRecording()->id;
        document().open({home_.recording("second.wav")});
        QVERIFY(QTest::qWaitFor([&] { return document().recordings().size() == 2; }));
        document().setCurrentRecording(document().recordings()[1].id);
        QTRY_VERIFY(!page().sweep());
        document().setCurrentRecording(first);
        QTRY_VERIFY(page().sweep());
        document().closeRecording(first);
        QTRY_VERIFY(!page().sweep());
    }

    void a_sweep_is_cancelled_and_never_blocks_the_window() {
        open(home_.recording("long.wav", 120));
        goToSweep();
        type("5..10, 6..600, 7..700");
        Heartbeat heartbeat;
        QTest::mouseClick(&button("computeSweep"), Qt::LeftButton);
        QVERIFY(button("sweepCancel").isVisible() && !button("computeSweep").isEnabled());
        QTest::mouseClick(&button("sweepCancel"), Qt::LeftButton);
        QVERIFY(!page().running() && button("computeSweep").isEnabled());
        QVERIFY(!button("sweepCancel").isVisible());
        QVERIFY(!page().sweep());
        sweep("8..600", 15);
        VYBEG_LESS(heartbeat.longestMs(), 200, qPrintable(heartbeat.text()));
        document().closeRecording(document().currentRecording()->id);
        QVERIFY(!page().sweep());
    }

    void the_table_is_copied_for_a_spreadsheet() {
        open(home_.recording("copy.wav"));
        goToSweep();
        sweep("24, 96", 2);
        QTest::mouseClick(&button("sweepCopy"), Qt::LeftButton);
        const QStringList lines = QApplication::clipboard()->text().split('\n', Qt::SkipEmptyParts);
        QCOMPARE(lines.size(), 3);
        const QStringList head = lines[0].split('\t');
        const QStringList row = lines[2].split('\t');
        QCOMPARE(row.size(), head.size());
        QCOMPARE(row[0], QString("96"));
        const auto column = head.indexOf("2θA: scatter, °");
        VYBEG_MORE(column, 0, qPrintable(lines[0]));
        VYBEG_CLOSE_RATIO(QLocale().toDouble(row[column]),
                          page().sweep()->lengths[1].values[2].scatter * 180 / std::numbers::pi,
                          1e-9);
        auto& table = the<QTableWidget>("sweepTable");
        table.setFocus();
        QTest::keyClick(&table, Qt::Key_C, Qt::ControlModifier);
        QVERIFY(QApplication::clipboard()->text().startsWith('\t'));
    }

    void the_variable_changes_plot_and_table() {
        open(home_.recording("variable.wav"));
        goToSweep();
        sweep("24, 96", 2);
        auto& plot = the<XYPlotView>("sweepScatter");
        auto& variable = the<QComboBox>("sweepVariable");
        for (int v = 0; v < variable.count(); ++v) {
            const bool angle = v == 2 || v == 4;
            variable.setCurrentIndex(v);
            VYBEG_CLOSE_RATIO(
                plot.content().series.front().y[1],
                page().sweep()->lengths[1].values[static_cast<std::size_t>(v)].scatter *
                    (angle ? 180 / std::numbers::pi : 1),
                1e-12);
        }
    }

    void the_page_speaks_the_language_of_the_window() {
        open(home_.recording("russian.wav"));
        goToSweep();
        sweep("24, 96", 2);
        window_->setLanguage("ru");
        QTRY_COMPARE(the<QTabBar>("pages").tabText(3), QString("Окна"));
        QTRY_VERIFY2(text("sweepAdvice").contains("мс"), qPrintable(text("sweepAdvice")));
        window_->setLanguage("en");
        QTRY_VERIFY(text("sweepAdvice").contains("ms"));
    }
};

VYBEG_TEST(TestSweepPage, threads)

}  // namespace test_sweep_page

#include "test_sweep_page.moc"
