#include "tests/test_registry.h"
#include "ui/plots/time_gestures.h"

#include <QtTest>

namespace test_zoom_navigator {

using namespace vybeg;
using namespace vybeg::ui;

namespace {

ZoomState at(double lower) {
    return {{lower, lower + 1}, {}};
}

// One that shows everything, with an entry of its own for each view.
class Zoom : public ZoomNavigator {
public:
    explicit Zoom(const ZoomState& home) : ZoomNavigator([](ZoomState state) { return state; }) {
        restart(home);
    }

    void visit(const ZoomState& state, Gesture gesture = Gesture::none) {
        ZoomNavigator::visit(state, gesture);
    }
};

}  // namespace

class TestZoomNavigator : public QObject {
    Q_OBJECT

private slots:
    void goes_back_and_forward_through_what_was_seen() {
        Zoom zoom(at(0));
        QVERIFY(!zoom.canBack() && !zoom.canForward());
        zoom.visit(at(1));
        zoom.visit(at(2));
        zoom.back();
        QCOMPARE(zoom.current(), at(1));
        zoom.back();
        QCOMPARE(zoom.current(), at(0));
        QVERIFY(!zoom.canBack());
        zoom.forward();
        zoom.forward();
        QCOMPARE(zoom.current(), at(2));
        QVERIFY(!zoom.canForward());
    }

    void stays_at_its_ends() {
        Zoom zoom(at(0));
        zoom.back();
        zoom.forward();
        QCOMPARE(zoom.current(), at(0));
    }

    void a_new_view_forgets_what_was_forward() {
        Zoom zoom(at(0));
        zoom.visit(at(1));
        zoom.back();
        zoom.visit(at(5));
        QVERIFY(!zoom.canForward());
        zoom.back();
        QCOMPARE(zoom.current(), at(0));
    }

    void a_gesture_is_one_step_back() {
        Zoom zoom(at(0));
        zoom.visit(at(1), Gesture::wheel_time);
        zoom.visit(at(2), Gesture::wheel_time);
        zoom.visit(at(3), Gesture::wheel_time);
        QCOMPARE(zoom.current(), at(3));
        zoom.back();
        QCOMPARE(zoom.current(), at(0));
    }

    void the_same_view_again_is_no_step() {
        Zoom zoom(at(0));
        zoom.visit(at(0));
        QVERIFY(!zoom.canBack());
    }

    void fixed_value_axes_are_part_of_a_view() {
        Zoom zoom(at(0));
        ZoomState fixed = at(0);
        fixed.fixed[SlowVariable::f] = {5299, 5301};
        zoom.visit(fixed);
        QVERIFY(zoom.canBack());
        zoom.back();
        QVERIFY(zoom.current().fixed.empty());
    }

    void a_long_history_loses_its_oldest_views_only() {
        Zoom zoom(at(0));
        for (int i = 1; i <= 1000; ++i) {
            zoom.visit(at(i));
        }
        QCOMPARE(zoom.current(), at(1000));
        int steps = 0;
        while (zoom.canBack()) {
            zoom.back();
            ++steps;
            QCOMPARE(zoom.current(), at(1000 - steps));
        }
        QCOMPARE(steps, 199);
    }
};

VYBEG_TEST(TestZoomNavigator)

}  // namespace test_zoom_navigator

#include "test_zoom_navigator.moc"
