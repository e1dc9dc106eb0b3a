// Cursors that measure: set by key, mouse and typing, read in the table, drawn, copied.
#include "core/track/beat.h"
#include "core/track/trend.h"
#include "tests/closeness.h"
#include "tests/test_registry.h"
#include "tests/ui/gui_test.h"
#include "ui/panels/analysis_list.h"
#include "ui/panels/measure_panel.h"
#include "ui/plots/track_view.h"
#include "ui/window/main_window.h"

#include <QClipboard>
#include <QComboBox>
#include <QGuiApplication>
#include <QLabel>
#include <QTableWidget>
#include <QTest>
#include <qcustomplot.h>

namespace test_measuring {

using namespace vybeg;
using namespace vybeg::ui;

class TestMeasuring : public QObject {
    Q_OBJECT

    GuiTestHome home_;
    std::unique_ptr<MainWindow> window_;

    template <class Widget>
    Widget& the() {
        return childOf<Widget>(*window_);
    }
    MeasurePanel& panel() { return the<MeasurePanel>(); }
    QTableWidget& table() { return childOf<QTableWidget>(panel()); }
    const Analysis& analysis() { return *window_->document().analyses().front().shown.analysis; }
    QString cell(int row, int column) { return table().item(row, column)->text(); }
    // "1.234 ± 0.005" as its two numbers.
    static std::pair<double, double> number(QString text) {
        const QStringList parts = text.replace(QChar(0x2212), '-').split(QStringLiteral("±"));
        const auto value = readNumber(parts.value(0).trimmed());
        const auto sd = readNumber(parts.value(1).trimmed());
        return {value.value_or(std::nan("")), sd.value_or(std::nan(""))};
    }
    void setCursors(double a_s, double b_s) {
        TrackView& tracks = the<TrackView>();
        tracks.setFocus();
        tracks.setTracker(a_s);
        QTest::keyClick(&tracks, Qt::Key_1);
        tracks.setTracker(b_s);
        QTest::keyClick(&tracks, Qt::Key_2);
    }
    Trend expected(SlowVariable variable, double from_s, double to_s, TrendOf of = TrendOf::value) {
        return *line_trend(analysis().track, variable, from_s, to_s,
                           windows_apart(analysis().plan.length, analysis().plan.hop), of);
    }

private slots:
    void init() {
        window_ = shownWindow();
        window_->document().open({home_.recording("demo.wav")});
        QTRY_VERIFY(!window_->document().busy() && window_->document().analyses().size() == 1);
    }

    void keys_place_cursors_and_the_table_reads_them() {
        QVERIFY(panel().isVisibleTo(window_.get()));
        QVERIFY(!table().isVisibleTo(&panel()));
        setCursors(0.5, 1.5);
        QVERIFY(table().isVisibleTo(&panel()));
        QCOMPARE(fieldOf(panel(), "Time of cursor A").value(), std::optional(0.5));
        QCOMPARE(fieldOf(panel(), "Time of cursor B").value(), std::optional(1.5));
        // a_A: its values, their difference and its rate.
        const Track& track = analysis().track;
        const auto times = track.time_s();
        const auto row = [&](double time_s) {
            return static_cast<std::size_t>(
                std::ranges::min_element(times, {},
                                         [&](double t) { return std::abs(t - time_s); }) -
                times.begin());
        };
        const auto values = track.values(SlowVariable::a_A);
        VYBEG_WITHIN(number(cell(0, 1)).first, values[row(0.5)], number(cell(0, 1)).second);
        VYBEG_WITHIN(number(cell(0, 2)).first, values[row(1.5)], number(cell(0, 2)).second);
        VYBEG_WITHIN(number(cell(0, 3)).first, values[row(1.5)] - values[row(0.5)],
                     number(cell(0, 3)).second);
        constexpr double degrees = 180 / std::numbers::pi;  // the unit of the first start
        const Trend angle = expected(SlowVariable::two_theta_A, 0.5, 1.5);
        QCOMPARE(cell(2, 4).replace('\n', ' '),
                 valueText(angle.slope_per_s * degrees, angle.sd_slope_per_s * degrees));
        QVERIFY(the<AnalysisList>().currentAnalysis() != AnalysisId::none);
    }

    void trends_are_drawn_and_go_with_the_cursors() {
        TrackView& tracks = the<TrackView>();
        QVERIFY(tracks.content().trends.empty());
        setCursors(1.6, 0.4);  // in any order
        const std::vector<TrendCurve> curves = tracks.content().trends;
        VYBEG_AT_LEAST(curves.size(), 5);
        const Trend f = expected(SlowVariable::f, 0.4, 1.6);
        const auto drawn = std::ranges::find(curves, SlowVariable::f, &TrendCurve::variable);
        QVERIFY(drawn != curves.end());
        QCOMPARE(drawn->time_s.front(), 0.4);
        VYBEG_CLOSE(drawn->time_s.back(), 1.6, 1e-9);
        VYBEG_CLOSE(drawn->value.back(), f.at(1.6), 1e-9);
        QTest::keyClick(&tracks, Qt::Key_0);
        QVERIFY(tracks.content().trends.empty());
        QVERIFY(!table().isVisibleTo(&panel()));
    }

    // The readings name their analysis, and the trends know it.
    void readings_and_trends_say_whose_they_are() {
        setCursors(0.5, 1.5);
        const ShownAnalysis& first = window_->document().analyses().front().shown;
        const auto& owner = childOf<QLabel>(panel(), "owner");
        QVERIFY2(owner.text().contains(first.name), qPrintable(owner.text()));
        for (const TrendCurve& curve : the<TrackView>().content().trends) {
            QCOMPARE(curve.of, first.id);
        }
        window_->document().renameAnalysis(first.id, QStringLiteral("warm"));
        QTRY_VERIFY(owner.text().contains("warm"));
    }

    void typed_times_place_cursors() {
        typeInto(fieldOf(panel(), "Time of cursor A"), "0,25");
        typeInto(fieldOf(panel(), "Time of cursor B"), "1.75");
        const TrackView& tracks = the<TrackView>();
        QCOMPARE(tracks.cursor(Cursor::a), std::optional(0.25));
        QCOMPARE(tracks.cursor(Cursor::b), std::optional(1.75));
        QVERIFY(!tracks.content().trends.empty());
        NumberField& b = fieldOf(panel(), "Time of cursor B");
        b.clear();
        b.commit();
        QVERIFY(!tracks.cursor(Cursor::b));
        QVERIFY(tracks.content().trends.empty());
        QVERIFY(table().isColumnHidden(2));
        QVERIFY(!table().isColumnHidden(1));
    }

    void a_dragged_cursor_measures() {
        setCursors(0.5, 1.0);
        TrackView& tracks = the<TrackView>();
        const QString before = cell(3, 4);
        const auto rect = childOf<QCustomPlot>(tracks).axisRects().front()->rect();
        const auto pixel = [&](double time_s) {
            const AxisRange shown = tracks.timeRange();
            return QPoint(
                qRound(rect.left() + (time_s - shown.lower) / shown.span() * rect.width()),
                rect.center().y());
        };
        QTest::mousePress(&tracks, Qt::LeftButton, {}, pixel(1.0));
        QTest::mouseMove(&tracks, pixel(1.5));
        QTest::mouseRelease(&tracks, Qt::LeftButton, {}, pixel(1.5));
        VYBEG_CLOSE(*tracks.cursor(Cursor::b), 1.5, 0.02);
        QTRY_VERIFY(cell(3, 4) != before);
    }

    void the_table_is_copied_with_all_digits() {
        setCursors(0.5, 1.5);
        QTest::keyClick(window_.get(), Qt::Key_T, Qt::ControlModifier | Qt::ShiftModifier);
        const QStringList lines = QGuiApplication::clipboard()->text().split('\n');
        const auto head = std::ranges::find_if(
            lines, [](const QString& line) { return line.contains("A = 0.5 s\t"); });
        QVERIFY(head != lines.end());
        const QStringList first = (head + 1)->split('\t');
        QCOMPARE(first.size(), 9);
        const Trend a_A = expected(SlowVariable::a_A, 0.5, 1.5, TrendOf::logarithm);
        const double rate = a_A.slope_per_s * std::exp(a_A.value);
        VYBEG_CLOSE_RATIO(first[7].toDouble(), rate, 1e-9);
        VYBEG_CLOSE_RATIO(first[8].toDouble(), a_A.sd_slope_per_s * std::exp(a_A.value), 1e-9);
    }

    void a_beat_is_offered() {
        auto& kind = childOf<QComboBox>(panel());
        constexpr double nan = std::numeric_limits<double>::quiet_NaN();
        setCursors(0.5, 1.5);
        kind.setFocus();
        QTest::keyClick(&kind, Qt::Key_End);
        QCOMPARE(panel().trendKind(), TrendKind::beat);
        QTRY_COMPARE(table().horizontalHeaderItem(4)->text(), QStringLiteral("Beat, Hz"));
        for (int row = 0; row < table().rowCount(); ++row) {
            const SlowVariable variable = main_slow_variables[static_cast<std::size_t>(row)];
            const auto beat = find_beat(analysis().track, variable, 0.5, 1.5,
                                        windows_apart(analysis().plan.length, analysis().plan.hop));
            QCOMPARE(
                cell(row, 4).replace('\n', ' '),
                beat ? valueText(beat->frequency_hz, beat->sd_frequency_hz) : valueText(nan, nan));
        }
    }

    void a_polynomial_is_offered_data() {
        QTest::addColumn<int>("steps");
        QTest::addColumn<int>("degree");
        QTest::newRow("parabola") << 1 << 2;
        QTest::newRow("cubic") << 2 << 3;
    }
    void a_polynomial_is_offered() {
        QFETCH(int, steps);
        QFETCH(int, degree);
        auto& kind = childOf<QComboBox>(panel());
        setCursors(0.5, 1.5);
        kind.setFocus();
        for (int k = 0; k < steps; ++k) {
            QTest::keyClick(&kind, Qt::Key_Down);
        }
        const auto f =
            polynomial_trend(analysis().track, SlowVariable::f, 0.5, 1.5,
                             windows_apart(analysis().plan.length, analysis().plan.hop), degree);
        QVERIFY(f);
        QCOMPARE(cell(3, 4).replace('\n', ' '), valueText(f->coefficient[1], f->sd[1]));
        const std::vector<TrendCurve> curves = the<TrackView>().content().trends;
        const auto drawn = std::ranges::find(curves, SlowVariable::f, &TrendCurve::variable);
        QVERIFY(drawn != curves.end());
        VYBEG_CLOSE(drawn->value[50], f->at(drawn->time_s[50]), 1e-9);
        // The second derivative is said in words.
        const auto labels = panel().findChildren<QLabel*>();
        const QString second = valueText(2 * f->coefficient[2], 2 * f->sd[2]);
        QVERIFY2(std::ranges::any_of(
                     labels, [&](const QLabel* label) { return label->text().contains(second); }),
                 qPrintable(second));
    }

    void a_cursor_outside_the_run_reads_nothing() {
        setCursors(0.5, 1.5);
        const QString inside = cell(0, 1);
        typeInto(fieldOf(panel(), "Time of cursor B"), "7");  // the recording ends at 2 s
        QCOMPARE(cell(0, 1), inside);
        for (const int column : {2, 3, 4}) {
            QVERIFY2(std::isnan(number(cell(0, column)).first), qPrintable(cell(0, column)));
        }
        const auto labels = panel().findChildren<QLabel*>();
        QVERIFY(std::ranges::any_of(labels, [](const QLabel* label) {
            return label->isVisible() && label->text().contains("no windows");
        }));
        QVERIFY(the<TrackView>().content().trends.empty());
        QVERIFY(panel().tableText().isEmpty());
    }

    void a_hidden_run_is_not_measured() {
        setCursors(0.5, 1.5);
        window_->document().setAnalysisVisible(window_->document().analyses().front().shown.id,
                                               false);
        QVERIFY(!panel().isVisibleTo(window_.get()));
        QVERIFY(the<TrackView>().content().trends.empty());
    }
};

VYBEG_TEST(TestMeasuring)

}  // namespace test_measuring

#include "test_measuring.moc"
