#include "tests/closeness.h"
#include "tests/test_registry.h"
#include "tests/ui/synthetic_analysis.h"
#include "ui/plots/plot_stack.h"
#include "ui/plots/track_view.h"

#include <QSignalSpy>
#include <QWheelEvent>
#include <QtTest>
#include <qcustomplot.h>

#include <memory>
#include <numbers>

namespace test_track_view {

using namespace vybeg;
using namespace vybeg::ui;

namespace {

struct Bench {
    TrackView view;
    QCustomPlot* plot = nullptr;

    explicit Bench(std::vector<ShownAnalysis> analyses = {syntheticAnalysis(0, {.seconds = 10})}) {
        view.resize(900, 700);
        view.show();
        view.setAnalyses(std::move(analyses));
        plot = view.findChild<QCustomPlot*>();
        settle();
    }

    void settle() {
        QCoreApplication::processEvents();
        plot->replot();
    }

    QCPAxisRect* rect(int row) const { return plot->axisRects().at(row); }

    QPoint at(int row, double across, double up) const {
        const QRect area = rect(row)->rect();
        return {area.left() + qRound(across * area.width()),
                area.bottom() - qRound(up * area.height())};
    }

    double timeAt(const QPoint& p) const {
        return rect(0)->axis(QCPAxis::atBottom)->pixelToCoord(p.x());
    }

    AxisRange values(int row) const {
        const QCPRange range = rect(row)->axis(QCPAxis::atLeft)->range();
        return {range.lower, range.upper};
    }

    void wheel(const QPoint& position, int notches, Qt::KeyboardModifiers keys = Qt::NoModifier) {
        QWheelEvent event(position, view.mapToGlobal(position), {}, {0, 120 * notches},
                          Qt::NoButton, keys, Qt::NoScrollPhase, false);
        QCoreApplication::sendEvent(&view, &event);
        settle();
    }

    void drag(const QPoint& from, const QPoint& to, Qt::KeyboardModifiers keys = Qt::NoModifier) {
        QTest::mousePress(&view, Qt::LeftButton, keys, from);
        move((from + to) / 2);
        move(to);
        QTest::mouseRelease(&view, Qt::LeftButton, keys, to);
        settle();
    }

    // QTest::mouseMove() tells no buttons.
    void move(const QPoint& to) {
        QMouseEvent event(QEvent::MouseMove, to, view.mapToGlobal(to), Qt::NoButton, Qt::LeftButton,
                          Qt::NoModifier);
        QCoreApplication::sendEvent(&view, &event);
    }
};

}  // namespace

// The stacked plots as a user handles them: mouse, wheel and keys against the ranges that follow.
class TestTrackView : public QObject {
    Q_OBJECT

private slots:
    void shows_the_whole_recording_first() {
        Bench bench;
        QCOMPARE(bench.view.timeRange(), bench.view.fullTimeRange());
        // From the first sample; the windows fill 10 s to within one of them.
        VYBEG_WITHIN(bench.view.timeRange().lower, 0, 1e-9);
        VYBEG_WITHIN(bench.view.timeRange().upper, 10, 60 / 33333.);
        QCOMPARE(bench.plot->axisRectCount(), 5);
        QVERIFY(!bench.view.zoom().canBack());
    }

    void the_wheel_zooms_time_about_the_mouse() {
        Bench bench;
        const QPoint mouse = bench.at(1, 0.3, 0.5);
        const double held = bench.timeAt(mouse);
        const AxisRange before = bench.view.timeRange();
        const AxisRange values = bench.values(0);  // follow what is visible
        bench.wheel(mouse, 1);
        VYBEG_WITHIN(bench.view.timeRange().span(), 0.8 * before.span(), 1e-9);
        VYBEG_WITHIN(bench.timeAt(mouse), held, 1e-3 * before.span());
        QVERIFY(!(bench.values(0) == values));
        bench.wheel(mouse, -1);
        VYBEG_WITHIN(bench.view.timeRange().lower, before.lower, 1e-9);
        VYBEG_WITHIN(bench.view.timeRange().upper, before.upper, 1e-9);
    }

    void no_wheel_leads_out_of_the_recording() {
        Bench bench;
        bench.wheel(bench.at(0, 0.5, 0.5), -30);
        QCOMPARE(bench.view.timeRange(), bench.view.fullTimeRange());
        bench.wheel(bench.at(0, 0.5, 0.5), 400);
        VYBEG_MORE(bench.view.timeRange().span(), 1e-6);
    }

    void control_and_wheel_zoom_the_plot_under_the_mouse_alone() {
        Bench bench;
        const QPoint mouse = bench.at(3, 0.5, 0.25);
        const AxisRange before = bench.values(3);
        const AxisRange others = bench.values(1);
        const AxisRange time = bench.view.timeRange();
        bench.wheel(mouse, 1, Qt::ControlModifier);
        VYBEG_WITHIN(bench.values(3).span(), 0.8 * before.span(), 1e-9 * before.span());
        // A quarter of the height stays where it was, to a pixel.
        VYBEG_WITHIN(bench.values(3).lower + 0.25 * bench.values(3).span(),
                     before.lower + 0.25 * before.span(), 0.02 * before.span());
        QCOMPARE(bench.values(1), others);
        QCOMPARE(bench.view.timeRange(), time);
    }

    void a_drag_pans_time() {
        Bench bench;
        bench.view.setTimeRange({4, 5});
        bench.settle();
        const QPoint from = bench.at(2, 0.5, 0.5);
        const QPoint to = bench.at(2, 0.7, 0.5);
        const double held = bench.timeAt(from);
        bench.drag(from, to);
        VYBEG_WITHIN(bench.timeAt(to), held, 2e-3);
        VYBEG_WITHIN(bench.view.timeRange().span(), 1, 1e-9);
        VYBEG_LESS(bench.view.timeRange().lower, 4);
    }

    void a_drag_stops_at_the_ends_of_the_recording() {
        Bench bench;
        bench.view.setTimeRange({0.1, 1.1});
        bench.settle();
        bench.drag(bench.at(2, 0.1, 0.5), bench.at(2, 0.9, 0.5));
        QCOMPARE(bench.view.timeRange().lower, bench.view.fullTimeRange().lower);
        VYBEG_WITHIN(bench.view.timeRange().span(), 1, 1e-9);
    }

    void shift_and_drag_zoom_into_the_rectangle() {
        Bench bench;
        const QPoint from = bench.at(1, 0.2, 0.2);
        const QPoint to = bench.at(1, 0.6, 0.8);
        const AxisRange time = bench.view.timeRange();
        const AxisRange values = bench.values(1);
        bench.drag(from, to, Qt::ShiftModifier);
        // To a pixel of about 800 by 90.
        VYBEG_WITHIN(bench.view.timeRange().lower, time.lower + 0.2 * time.span(), 0.03);
        VYBEG_WITHIN(bench.view.timeRange().upper, time.lower + 0.6 * time.span(), 0.03);
        VYBEG_WITHIN(bench.values(1).lower, values.lower + 0.2 * values.span(),
                     0.03 * values.span());
        VYBEG_WITHIN(bench.values(1).upper, values.lower + 0.8 * values.span(),
                     0.03 * values.span());
    }

    void a_rectangle_too_small_to_be_meant_does_nothing() {
        Bench bench;
        const AxisRange before = bench.view.timeRange();
        bench.drag(bench.at(1, 0.5, 0.5), bench.at(1, 0.5, 0.5) + QPoint(2, 1), Qt::ShiftModifier);
        QCOMPARE(bench.view.timeRange(), before);
    }

    void a_double_click_fits_and_frees_the_value_axes() {
        Bench bench;
        const AxisRange values = bench.values(1);
        bench.drag(bench.at(1, 0.2, 0.2), bench.at(1, 0.6, 0.8), Qt::ShiftModifier);
        QTest::mouseDClick(&bench.view, Qt::LeftButton, Qt::NoModifier, bench.at(0, 0.5, 0.5));
        bench.settle();
        QCOMPARE(bench.view.timeRange(), bench.view.fullTimeRange());
        QCOMPARE(bench.values(1), values);
    }

    void keys_go_through_the_zoom_history() {
        Bench bench;
        const AxisRange home = bench.view.timeRange();
        bench.drag(bench.at(0, 0.2, 0.2), bench.at(0, 0.6, 0.8), Qt::ShiftModifier);
        const AxisRange first = bench.view.timeRange();
        bench.drag(bench.at(0, 0.2, 0.2), bench.at(0, 0.6, 0.8), Qt::ShiftModifier);
        const AxisRange second = bench.view.timeRange();
        QTest::keyClick(&bench.view, Qt::Key_R);
        QCOMPARE(bench.view.timeRange(), first);
        QTest::keyClick(&bench.view, Qt::Key_Left, Qt::AltModifier);
        QCOMPARE(bench.view.timeRange(), home);
        QTest::keyClick(&bench.view, Qt::Key_Right, Qt::AltModifier);
        QTest::keyClick(&bench.view, Qt::Key_Right, Qt::AltModifier);
        QCOMPARE(bench.view.timeRange(), second);
        QTest::keyClick(&bench.view, Qt::Key_Home);
        QCOMPARE(bench.view.timeRange(), home);
        QTest::keyClick(&bench.view, Qt::Key_R);
        QCOMPARE(bench.view.timeRange(), second);
    }

    void a_turn_of_the_wheel_is_one_step_of_the_history() {
        Bench bench;
        for (int i = 0; i < 6; ++i) {
            bench.wheel(bench.at(0, 0.5, 0.5), 1);
        }
        bench.view.zoom().back();
        QCOMPARE(bench.view.timeRange(), bench.view.fullTimeRange());
    }

    void keys_zoom_and_pan() {
        Bench bench;
        const AxisRange full = bench.view.timeRange();
        QTest::keyClick(&bench.view, Qt::Key_Plus);
        VYBEG_WITHIN(bench.view.timeRange().span(), 0.8 * full.span(), 1e-9);
        const AxisRange zoomed = bench.view.timeRange();
        QTest::keyClick(&bench.view, Qt::Key_Right);
        VYBEG_WITHIN(bench.view.timeRange().lower, zoomed.lower + 0.1 * zoomed.span(), 1e-9);
        QTest::keyClick(&bench.view, Qt::Key_Left);
        VYBEG_WITHIN(bench.view.timeRange().lower, zoomed.lower, 1e-9);
        QTest::keyClick(&bench.view, Qt::Key_Minus);
        VYBEG_WITHIN(bench.view.timeRange().span(), full.span(), 1e-9);
    }

    void the_keyboard_reaches_the_value_axis_of_the_focused_plot() {
        Bench bench;
        bench.view.activateWindow();
        QWidget* second = nullptr;
        for (QWidget* child : bench.view.findChildren<QWidget*>()) {
            if (child->accessibleName().contains(QStringLiteral("aB"))) {
                second = child;
            }
        }
        QVERIFY(second);
        QVERIFY(second->focusPolicy() & Qt::TabFocus);
        second->setFocus();
        QTRY_VERIFY(second->hasFocus());
        const AxisRange before = bench.values(1);
        QTest::keyClick(second, Qt::Key_Up);
        VYBEG_WITHIN(bench.values(1).lower, before.lower + 0.1 * before.span(),
                     1e-9 * before.span());
    }

    void every_plot_has_an_accessible_name() {
        Bench bench;
        int named = 0;
        for (QWidget* child :
             bench.view.findChildren<QWidget*>(QString(), Qt::FindDirectChildrenOnly)) {
            named += child->focusPolicy() == Qt::TabFocus && !child->accessibleName().isEmpty();
        }
        QCOMPARE(named, 5);
    }

    void the_mouse_moves_the_tracker() {
        Bench bench;
        QSignalSpy moved(&bench.view, &TrackView::trackerMoved);
        const QPoint mouse = bench.at(2, 0.5, 0.5);
        bench.move(mouse);
        QCOMPARE(moved.count(), 1);
        VYBEG_WITHIN(moved[0][0].toDouble(), bench.timeAt(mouse), 1e-9);
        QEvent leave(QEvent::Leave);
        QCoreApplication::sendEvent(&bench.view, &leave);
        QCOMPARE(moved.count(), 1);
        QVERIFY(!bench.view.tracker());
    }

    // The mark of the mouse's time hides a label of the axis or leaves it: no half of it stays.
    void no_label_of_the_axis_is_covered_in_part() {
        Bench bench;
        const QCPAxisRect& last = *bench.plot->axisRects().back();
        const double tick = last.axis(QCPAxis::atBottom)->coordToPixel(4);
        const int top = last.rect().bottom() + 6;
        const auto inked = [&](const QImage& image, int from, int to) {
            const double ratio = image.devicePixelRatio();
            const QRgb ground = image.pixel(qRound(ratio * (tick - 30)), qRound(ratio * (top + 4)));
            for (int x = qRound(ratio * from); x < qRound(ratio * to); ++x) {
                for (int y = qRound(ratio * top); y < qRound(ratio * (top + 10)); ++y) {
                    if (image.pixel(x, y) != ground) {
                        return true;
                    }
                }
            }
            return false;
        };
        const int left = qFloor(tick) - 5;
        const int right = qFloor(tick) - 1;
        QVERIFY(inked(bench.view.grab().toImage(), left, right));  // of "4"
        // The mark begins in the middle of the label.
        const QString time = QStringLiteral("4.00 s");
        const double half =
            0.5 * (QFontMetricsF(plotFont(bench.view)).horizontalAdvance(time) + 10);
        bench.view.setTracker(bench.timeAt(QPoint(qRound(tick + half), 0)));
        QVERIFY(!inked(bench.view.grab().toImage(), left, right));
    }

    void keys_place_cursors_and_the_mouse_drags_them() {
        Bench bench;
        QSignalSpy changed(&bench.view, &TrackView::cursorsChanged);
        bench.view.setTracker(3.);
        QTest::keyClick(&bench.view, Qt::Key_1);
        bench.view.setTracker(7.);
        QTest::keyClick(&bench.view, Qt::Key_2);
        QCOMPARE(bench.view.cursor(Cursor::a), std::optional(3.));
        QCOMPARE(bench.view.cursor(Cursor::b), std::optional(7.));
        QCOMPARE(changed.count(), 2);
        const AxisRange time = bench.view.timeRange();
        const QPoint to = bench.at(1, 0.5, 0.5);
        bench.drag(bench.at(1, (3 - time.lower) / time.span(), 0.5), to);
        VYBEG_WITHIN(*bench.view.cursor(Cursor::a), bench.timeAt(to), 1e-9);
        QCOMPARE(bench.view.timeRange(), time);
        // The one that was moved last goes by a pixel; without it, the other one.
        const double pixel = bench.timeAt(to + QPoint(1, 0)) - bench.timeAt(to);
        QTest::keyClick(&bench.view, Qt::Key_Right, Qt::ShiftModifier);
        VYBEG_WITHIN(*bench.view.cursor(Cursor::a), bench.timeAt(to) + pixel, 1e-9);
        bench.view.moveCursor(Cursor::a, std::nullopt);
        QTest::keyClick(&bench.view, Qt::Key_Left, Qt::ShiftModifier);
        VYBEG_WITHIN(*bench.view.cursor(Cursor::b), 7 - pixel, 1e-9);
        QCOMPARE(bench.view.timeRange(), time);
        QTest::keyClick(&bench.view, Qt::Key_0);
        QVERIFY(!bench.view.cursor(Cursor::a) && !bench.view.cursor(Cursor::b));
        QTest::keyClick(&bench.view, Qt::Key_Plus);
        const double lower = bench.view.timeRange().lower;
        QTest::keyClick(&bench.view, Qt::Key_Left, Qt::ShiftModifier);
        VYBEG_LESS(bench.view.timeRange().lower, lower);  // it pans, as without Shift
    }

    // Of another unit, or a fifth as long: one would be a pixel or flatten the other.
    void what_is_unlike_the_chosen_one_is_hidden() {
        std::vector<ShownAnalysis> analyses;
        for (int k = 0; k < 4; ++k) {
            analyses.push_back(syntheticAnalysis(k, {.seconds = 1}));
            analyses.back().unit = QStringLiteral("V");
            analyses.back().recorded_s = 100;
        }
        analyses[1].unit = QStringLiteral("mV");
        analyses[2].recorded_s = 499;
        analyses[3].recorded_s = 500;
        const auto hiddenBy = [&analyses](std::size_t chosen) {
            std::vector<ShownAnalysis> drawn = analyses;
            const int told = drawnWith(analyses[chosen].id, drawn);
            std::vector<int> hidden;
            for (int k = 0; k < 4; ++k) {
                if (!drawn[static_cast<std::size_t>(k)].visible) {
                    hidden.push_back(k);
                }
            }
            return told == static_cast<int>(hidden.size()) ? hidden : std::vector<int>{-1};
        };
        QCOMPARE(hiddenBy(0), (std::vector<int>{1, 3}));
        QCOMPARE(hiddenBy(1), (std::vector<int>{0, 2, 3}));
        QCOMPARE(hiddenBy(2), (std::vector<int>{1}));
        // One that is hidden itself does not choose.
        analyses[1].visible = false;
        std::vector<ShownAnalysis> drawn = analyses;
        QCOMPARE(drawnWith(analyses[1].id, drawn), 1);
        QVERIFY(drawn[0].visible && drawn[2].visible && !drawn[3].visible);
    }

    void a_range_set_from_outside_is_told_once_and_clipped() {
        Bench bench;
        QSignalSpy changed(&bench.view, &TrackView::timeRangeChanged);
        bench.view.setTimeRange({2, 3});
        bench.view.setTimeRange({2, 3});
        QCOMPARE(changed.count(), 1);
        bench.view.setTimeRange({-5, 2});
        QCOMPARE(bench.view.timeRange().lower, bench.view.fullTimeRange().lower);
        VYBEG_WITHIN(bench.view.timeRange().span(), 7, 1e-9);
    }

    void another_run_of_the_same_recording_keeps_the_view() {
        Bench bench;
        bench.view.setTimeRange({2, 3});
        std::vector<ShownAnalysis> analyses = bench.view.analyses();
        analyses.push_back(syntheticAnalysis(1, {.seconds = 10, .window = 6}));
        analyses[1].recording = analyses[0].recording;
        bench.view.setAnalyses(analyses);
        VYBEG_WITHIN(bench.view.timeRange().lower, 2, 1e-9);
        analyses[0].visible = analyses[1].visible = false;
        bench.view.setAnalyses(analyses);
        QCOMPARE(bench.view.fullTimeRange(), (AxisRange{0, 1}));
    }

    void a_change_of_unit_gives_up_ranges_in_the_old_one() {
        Bench bench;
        bench.view.setZoom(
            {bench.view.timeRange(),
             {{SlowVariable::f, AxisRange{5299, 5301}}, {SlowVariable::a_A, AxisRange{0, 2}}}});
        bench.settle();
        QCOMPARE(bench.values(3), (AxisRange{5299, 5301}));
        DisplayUnits units;
        units.frequency = FrequencyUnit::deviation_ppm;
        bench.view.setUnits(units);
        bench.settle();
        VYBEG_LESS(bench.values(3).upper, 1000);
        QCOMPARE(bench.values(0), (AxisRange{0, 2}));
    }

    void tick_labels_do_not_overlap_at_any_size() {
        for (const QSize size : {QSize(330, 360), QSize(700, 500), QSize(1900, 1100)}) {
            for (const AxisRange time :
                 {AxisRange{0, 10}, AxisRange{4, 4.01}, AxisRange{5, 5.0004}}) {
                Bench bench;
                bench.view.resize(size);
                bench.view.setTimeRange(time);
                bench.settle();
                bench.settle();
                for (const QCPAxisRect* panel : bench.plot->axisRects()) {
                    const QCPAxis& axis = *panel->axis(QCPAxis::atLeft);
                    const double height = QFontMetricsF(axis.tickLabelFont()).ascent();
                    double above = 1e9;
                    VYBEG_AT_LEAST(axis.tickVector().size(), 2);
                    for (qsizetype i = 0; i < axis.tickVector().size(); ++i) {
                        const double y = axis.coordToPixel(axis.tickVector()[i]);
                        VYBEG_AT_LEAST(above - y, height);
                        above = y;
                    }
                }
                const QCPAxis& axis = *bench.plot->axisRects().last()->axis(QCPAxis::atBottom);
                const QFontMetricsF metrics(axis.tickLabelFont());
                double left = -1e9;
                for (qsizetype i = 0; i < axis.tickVector().size(); ++i) {
                    const double half = 0.5 * metrics.horizontalAdvance(axis.tickVectorLabels()[i]);
                    const double x = axis.coordToPixel(axis.tickVector()[i]);
                    VYBEG_MORE(x - half, left + 2);
                    left = x + half;
                }
                // Nothing is cut at the right edge of the widget.
                VYBEG_AT_MOST(left, size.width());
            }
        }
    }

    void panels_are_equally_high_and_their_edges_line_up() {
        Bench bench;
        for (int row = 1; row < 5; ++row) {
            QCOMPARE(bench.rect(row)->left(), bench.rect(0)->left());
            QCOMPARE(bench.rect(row)->right(), bench.rect(0)->right());
            VYBEG_WITHIN(bench.rect(row)->height(), bench.rect(0)->height(), 1);
        }
    }

    // Windows on either side of half a turn are one curve.
    void a_trend_of_a_phase_lies_on_its_curve() {
        constexpr double pi = std::numbers::pi;
        ShownAnalysis shown = syntheticAnalysis(0, {.seconds = 10});
        const auto analysis = std::make_shared<Analysis>(*shown.analysis);
        const auto values = analysis->track.values(SlowVariable::delta_phi_CD);
        for (std::size_t row = 0; row < values.size(); ++row) {
            values[row] = row % 2 == 0 ? pi - 0.01 : 0.01 - pi;
        }
        shown.analysis = analysis;
        shown.curves.clear();
        Bench bench({shown});
        bench.view.setTrends({{shown.id, SlowVariable::delta_phi_CD, {2, 8}, {-3.15, -3.14}}});
        bench.settle();
        int trends = 0;
        for (int k = 0; k < bench.plot->graphCount(); ++k) {
            const QCPGraph* graph = bench.plot->graph(k);
            if (graph->dataCount() == 2 && graph->data()->at(0)->key == 2) {
                ++trends;
                VYBEG_WITHIN(graph->data()->at(0)->value, 2 * pi - 3.15, 1e-9);
                VYBEG_WITHIN(graph->data()->at(1)->value, 2 * pi - 3.14, 1e-9);
            }
        }
        QCOMPARE(trends, 1);
    }
};

VYBEG_TEST(TestTrackView)

}  // namespace test_track_view

#include "test_track_view.moc"
