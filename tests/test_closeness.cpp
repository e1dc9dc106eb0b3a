#include "tests/closeness.h"
#include "tests/largest_of.h"
#include "tests/test_registry.h"

#include <QtTest>

#include <complex>
#include <limits>

namespace test_closeness {

using namespace vybeg::test;

namespace {

constexpr double no_number = std::numeric_limits<double>::quiet_NaN();
constexpr double infinity = std::numeric_limits<double>::infinity();

}  // namespace

class TestCloseness : public QObject {
    Q_OBJECT

private slots:
    void close_numbers_pass() {
        VYBEG_CLOSE(1.25, 1, 0.26);
        VYBEG_CLOSE(-1.25, -1, 0.26, "in row 3");
        VYBEG_CLOSE(1.25F, 1.25, 1e-300);
        VYBEG_CLOSE(1.25L, 1.25L, 1e-300L);
        VYBEG_CLOSE(std::complex<double>(3, 4), 0, 5.1);
        VYBEG_WITHIN(8001, 8000, 1);
        VYBEG_WITHIN(qint64{7}, 7, 0);
        VYBEG_CLOSE_RATIO(1010, 1000, 0.011);
        VYBEG_CLOSE_RATIO(-990, -1000, 0.011);
    }

    void numbers_too_far_apart_fail() {
        const auto fails = [] { QEXPECT_FAIL("", "It has to fail.", Continue); };
        fails();
        VYBEG_CLOSE(1.25, 1, 0.25);
        fails();
        VYBEG_CLOSE(0.75, 1, 0.25);
        fails();
        VYBEG_CLOSE(1, 1, 0);
        fails();
        VYBEG_CLOSE(std::complex<double>(3, 4), 0, 5);
        fails();
        VYBEG_WITHIN(8002, 8000, 1);
        fails();
        VYBEG_WITHIN(7998, 8000, 1);
        fails();
        VYBEG_CLOSE_RATIO(1010, 1000, 0.0099);
        fails();
        VYBEG_CLOSE_RATIO(1010, -1000, 0.011);
    }

    void nan_fails_as_any_of_the_three() {
        for (const Measure measure : {Measure::difference, Measure::ratio}) {
            for (const Bound bound : {Bound::below, Bound::reached}) {
                QCOMPARE(closeness_fault(measure, bound, 1., 1., 1.), QString());
                QVERIFY(!closeness_fault(measure, bound, no_number, 1., 1.).isEmpty());
                QVERIFY(!closeness_fault(measure, bound, 1., no_number, 1.).isEmpty());
                QVERIFY(!closeness_fault(measure, bound, 1., 1., no_number).isEmpty());
                QVERIFY(!closeness_fault(measure, bound, no_number, no_number, infinity).isEmpty());
                QVERIFY(!closeness_fault(measure, bound, infinity, infinity, 1.).isEmpty());
            }
        }
        QVERIFY(!closeness_fault(Measure::ratio, Bound::reached, 0, 0, infinity).isEmpty());
    }

    void the_text_shows_both_numbers_difference_and_tolerance() {
        QCOMPARE(closeness_fault(Measure::difference, Bound::below, 1.25, 1, 0.125),
                 QString("1.25 for 1: off by 0.25, tolerance 0.125"));
        QCOMPARE(closeness_fault(Measure::difference, Bound::reached, 8002, 8000, 1, "in row 3"),
                 QString("8002 for 8000: off by 2, tolerance 1, in row 3"));
        QCOMPARE(closeness_fault(Measure::ratio, Bound::below, 1.5, 1, 1e-12),
                 QString("1.5 for 1: relatively 0.5, tolerance 1e-12"));
        QCOMPARE(
            closeness_fault(Measure::difference, Bound::below, std::complex<double>(1, 2), 1, 0.1),
            QString("(1, 2) for 1: off by 2, tolerance 0.1"));
        QCOMPARE(closeness_fault(Measure::difference, Bound::below, no_number, 0.1, 1e-9),
                 QString("nan for 0.1: off by nan, tolerance 1e-09"));
    }

    void numbers_in_order_pass() {
        VYBEG_LESS(1, 1.25);
        VYBEG_LESS(-std::numeric_limits<double>::infinity(), std::int64_t{0}, "in row 3");
        VYBEG_AT_MOST(1, 1.0F);
        VYBEG_MORE(std::size_t{2}, -1);
        VYBEG_MORE(1.25L, 1);
        VYBEG_AT_LEAST(1, 1);
        VYBEG_AT_LEAST(infinity, infinity);
        VYBEG_EQUAL(std::size_t{130}, 130, "in row 3");
    }

    void numbers_out_of_order_fail() {
        const auto fails = [] { QEXPECT_FAIL("", "It has to fail.", Continue); };
        fails();
        VYBEG_LESS(1, 1);
        fails();
        VYBEG_AT_MOST(1.25, 1);
        fails();
        VYBEG_MORE(1, 1);
        fails();
        VYBEG_AT_LEAST(1, 1.25);
        fails();
        VYBEG_EQUAL(1, 1.25);
        for (const Order order :
             {Order::less, Order::at_most, Order::more, Order::at_least, Order::equal}) {
            QVERIFY(!order_fault(order, no_number, 1.).isEmpty());
            QVERIFY(!order_fault(order, 1., no_number).isEmpty());
            QVERIFY(!order_fault(order, no_number, no_number).isEmpty());
        }
    }

    void the_text_shows_both_numbers_out_of_order() {
        QCOMPARE(order_fault(Order::less, 1.25, 1), QString("1.25 is not less than 1"));
        QCOMPARE(order_fault(Order::at_most, 7, 5.5), QString("7 is not at most 5.5"));
        QCOMPARE(order_fault(Order::more, no_number, 5.5, "in row 3"),
                 QString("nan is not more than 5.5, in row 3"));
        QCOMPARE(order_fault(Order::at_least, -1, 0), QString("-1 is not at least 0"));
        QCOMPARE(order_fault(Order::equal, 5, 0, "no room"),
                 QString("5 is not equal to 0, no room"));
    }

    void the_largest_of_numbers_is_nan_where_one_of_them_is() {
        QCOMPARE(largest_of({1, 3, 2}), 3.0);
        QVERIFY(std::isnan(largest_of({no_number, 1})));
        QVERIFY(std::isnan(largest_of({1, no_number})));
    }
};

VYBEG_TEST(TestCloseness)

}  // namespace test_closeness

#include "test_closeness.moc"
