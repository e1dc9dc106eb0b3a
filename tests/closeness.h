#pragma once

#include <QString>
#include <QtTest>

#include <cmath>
#include <complex>
#include <type_traits>

// Comparisons of numbers whose failure shows both numbers and, where there is one, their difference
// and the tolerance. NaN, as any of them, fails. Numbers are real or, where their difference is
// compared, complex. A text may follow that says where in the data the comparison stands, for a
// loop over rows.

// |actual - expected| < tolerance
#define VYBEG_CLOSE(actual, expected, tolerance, ...)               \
    VYBEG_CLOSENESS(difference, below, actual, expected, tolerance, \
                    #actual " is close to " #expected __VA_OPT__(, ) __VA_ARGS__)

// |actual - expected| <= tolerance, for whole numbers and for bounds that a difference may reach.
#define VYBEG_WITHIN(actual, expected, tolerance, ...)                \
    VYBEG_CLOSENESS(difference, reached, actual, expected, tolerance, \
                    #actual " is within reach of " #expected __VA_OPT__(, ) __VA_ARGS__)

// |actual / expected - 1| < tolerance
#define VYBEG_CLOSE_RATIO(actual, expected, tolerance, ...)    \
    VYBEG_CLOSENESS(ratio, below, actual, expected, tolerance, \
                    #actual " is relatively close to " #expected __VA_OPT__(, ) __VA_ARGS__)

// actual < bound, actual <= bound, actual > bound, actual >= bound; actual == bound exactly, where
// QCOMPARE has no place for a text.
#define VYBEG_LESS(actual, bound, ...) VYBEG_ORDER(less, actual, <, bound, __VA_ARGS__)
#define VYBEG_AT_MOST(actual, bound, ...) VYBEG_ORDER(at_most, actual, <=, bound, __VA_ARGS__)
#define VYBEG_MORE(actual, bound, ...) VYBEG_ORDER(more, actual, >, bound, __VA_ARGS__)
#define VYBEG_AT_LEAST(actual, bound, ...) VYBEG_ORDER(at_least, actual, >=, bound, __VA_ARGS__)
#define VYBEG_EQUAL(actual, bound, ...) VYBEG_ORDER(equal, actual, ==, bound, __VA_ARGS__)

#define VYBEG_CLOSENESS(measure, bound, actual, expected, tolerance, statement, ...)               \
    VYBEG_NO_FAULT(                                                                                \
        vybeg::test::closeness_fault(vybeg::test::Measure::measure, vybeg::test::Bound::bound,     \
                                     (actual), (expected), (tolerance)__VA_OPT__(, ) __VA_ARGS__), \
        statement)

#define VYBEG_ORDER(order, actual, sign, bound, ...)                             \
    VYBEG_NO_FAULT(vybeg::test::order_fault(vybeg::test::Order::order, (actual), \
                                            (bound)__VA_OPT__(, ) __VA_ARGS__),  \
                   #actual " " #sign " " #bound)

#define VYBEG_NO_FAULT(found, statement)                                                         \
    do {                                                                                         \
        const QString vybeg_fault = found;                                                       \
        if (!QTest::qVerify(vybeg_fault.isEmpty(), statement, qPrintable(vybeg_fault), __FILE__, \
                            __LINE__)) {                                                         \
            return;                                                                              \
        }                                                                                        \
    } while (false)

namespace vybeg::test {

enum class Measure { difference, ratio };
enum class Bound { below, reached };
enum class Order { less, at_most, more, at_least, equal };

// A number in the type in which it is compared: integers and float as double.
template <class Number>
auto compared(const Number& number) {
    if constexpr (std::is_arithmetic_v<Number> && !std::is_same_v<Number, long double>) {
        return static_cast<double>(number);
    } else {
        return number;
    }
}

inline QString number_text(double number) {
    return QString::number(number, 'g', QLocale::FloatingPointShortest);
}

inline QString number_text(long double number) {
    return number_text(static_cast<double>(number));
}

inline QString number_text(const std::complex<double>& number) {
    return QString("(%1, %2)").arg(number_text(number.real()), number_text(number.imag()));
}

// Empty where two numbers are as close as the bound says, otherwise both with their difference, the
// tolerance and the place.
template <class Actual, class Expected, class Tolerance>
QString closeness_fault(Measure measure, Bound bound, const Actual& actual,
                        const Expected& expected, const Tolerance& tolerance,
                        const char* where = "") {
    const auto a = compared(actual);
    const auto b = compared(expected);
    const auto most = compared(tolerance);
    const auto off = measure == Measure::ratio ? std::abs(a / b - 1.0) : std::abs(a - b);
    if (bound == Bound::below ? off < most : off <= most) {
        return {};
    }
    QString fault = QString("%1 for %2: %3 %4, tolerance %5")
                        .arg(number_text(a), number_text(b),
                             measure == Measure::ratio ? "relatively" : "off by", number_text(off),
                             number_text(most));
    return *where == '\0' ? fault : fault + ", " + where;
}

// Empty where two numbers stand in the order, otherwise both and the place.
template <class Actual, class Limit>
QString order_fault(Order order, const Actual& actual, const Limit& limit, const char* where = "") {
    const auto a = compared(actual);
    const auto b = compared(limit);
    const auto fault = [&](bool in_order, const char* words) {
        const QString text =
            in_order ? QString()
                     : QString("%1 is not %2 %3").arg(number_text(a), words, number_text(b));
        return in_order || *where == '\0' ? text : text + ", " + where;
    };
    switch (order) {
        case Order::less: return fault(a < b, "less than");
        case Order::at_most: return fault(a <= b, "at most");
        case Order::more: return fault(a > b, "more than");
        case Order::at_least: return fault(a >= b, "at least");
        case Order::equal: return fault(a == b, "equal to");
    }
    return "no such order";
}

}  // namespace vybeg::test
