#include "tests/test_registry.h"
#include "ui/values/zoom_stack.h"

#include <QtTest>

namespace test_zoom_stack {

using namespace vybeg;
using namespace vybeg::ui;

namespace {

ZoomState at(double lower) {
    return {{lower, lower + 1}, {}};
}

}  // namespace

class TestZoomStack : public QObject {
    Q_OBJECT

private slots:
    void goes_back_and_forward_through_what_was_seen() {
        ZoomStack stack(at(0));
        QVERIFY(!stack.canBack() && !stack.canForward());
        stack.visit(at(1));
        stack.visit(at(2));
        stack.back();
        QCOMPARE(stack.current(), at(1));
        stack.back();
        QCOMPARE(stack.current(), at(0));
        QVERIFY(!stack.canBack());
        stack.forward();
        stack.forward();
        QCOMPARE(stack.current(), at(2));
        QVERIFY(!stack.canForward());
    }

    void stays_at_its_ends() {
        ZoomStack stack(at(0));
        stack.back();
        stack.forward();
        QCOMPARE(stack.current(), at(0));
    }

    void a_new_view_forgets_what_was_forward() {
        ZoomStack stack(at(0));
        stack.visit(at(1));
        stack.back();
        stack.visit(at(5));
        QVERIFY(!stack.canForward());
        stack.back();
        QCOMPARE(stack.current(), at(0));
    }

    void a_gesture_is_one_step_back() {
        ZoomStack stack(at(0));
        stack.visit(at(1));
        stack.visit(at(2), true);
        stack.visit(at(3), true);
        QCOMPARE(stack.current(), at(3));
        stack.back();
        QCOMPARE(stack.current(), at(0));
    }

    void the_same_view_again_is_no_step() {
        ZoomStack stack(at(0));
        stack.visit(at(0));
        QVERIFY(!stack.canBack());
    }

    void fixed_value_axes_are_part_of_a_view() {
        ZoomStack stack(at(0));
        ZoomState fixed = at(0);
        fixed.fixed[SlowVariable::f] = {5299, 5301};
        stack.visit(fixed);
        QVERIFY(stack.canBack());
        stack.back();
        QVERIFY(stack.current().fixed.empty());
    }

    void a_long_history_loses_its_oldest_views_only() {
        ZoomStack stack(at(0));
        for (int i = 1; i <= 1000; ++i) {
            stack.visit(at(i));
        }
        QCOMPARE(stack.current(), at(1000));
        int steps = 0;
        while (stack.canBack()) {
            stack.back();
            ++steps;
            QCOMPARE(stack.current(), at(1000 - steps));
        }
        QCOMPARE(steps, 199);
    }
};

VYBEG_TEST(TestZoomStack)

}  // namespace test_zoom_stack

#include "test_zoom_stack.moc"
