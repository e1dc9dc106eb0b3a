#include "core/output/quantity_text.h"
#include "tests/closeness.h"
#include "tests/test_registry.h"

#include <QTest>

#include <cmath>
#include <limits>
#include <string>

namespace test_quantity_text {

using namespace vybeg;

class TestQuantityText : public QObject {
    Q_OBJECT

private slots:
    void value_and_deviation_end_at_the_same_place_data() {
        QTest::addColumn<double>("value");
        QTest::addColumn<double>("sd");
        QTest::addColumn<QString>("text");
        QTest::addColumn<QString>("sd_text");
        QTest::addColumn<int>("exponent");
        QTest::newRow("one digit") << 1.0003412 << 5e-5 << "1.00034"
                                   << "0.00005" << 0;
        QTest::newRow("two digits from 1") << 1.0003412 << 1.26e-5 << "1.000341"
                                           << "0.000013" << 0;
        QTest::newRow("two digits to 2.9") << 0.5 << 0.0294 << "0.500"
                                           << "0.029" << 0;
        QTest::newRow("2.96 is 3") << 0.5 << 0.0296 << "0.50"
                                   << "0.03" << 0;
        QTest::newRow("9.6 becomes 10") << 0.5 << 0.00096 << "0.5000"
                                        << "0.0010" << 0;
        QTest::newRow("carrier") << 5300.00123 << 0.0008 << "5300.0012"
                                 << "0.0008" << 0;
        QTest::newRow("tens") << 5312.0 << 40.0 << "5310"
                              << "40" << 0;
        QTest::newRow("hundreds, two digits") << 53127.0 << 1200.0 << "53100"
                                              << "1200" << 0;
        QTest::newRow("negative") << -0.12345 << 0.004 << "-0.123"
                                  << "0.004" << 0;
        QTest::newRow("small") << 3.21e-7 << 1e-8 << "3.21"
                               << "0.10" << -7;
        QTest::newRow("deviation above value") << 1e-8 << 5e-6 << "0"
                                               << "5" << -6;
        QTest::newRow("rounded to nought from below") << -1e-8 << 5e-6 << "0"
                                                      << "5" << -6;
        QTest::newRow("nought with decimals") << -0.0004 << 0.005 << "0.000"
                                              << "0.005" << 0;
        QTest::newRow("large") << 1.5e9 << 2e7 << "1.500"
                               << "0.020" << 9;
        QTest::newRow("zero") << 0.0 << 0.005 << "0.000"
                              << "0.005" << 0;
    }
    void value_and_deviation_end_at_the_same_place() {
        QFETCH(double, value);
        QFETCH(double, sd);
        QFETCH(QString, text);
        QFETCH(QString, sd_text);
        QFETCH(int, exponent);
        const QuantityText quantity = quantity_text(value, sd);
        QCOMPARE(QString::fromStdString(quantity.value), text);
        QCOMPARE(QString::fromStdString(quantity.sd), sd_text);
        QCOMPARE(quantity.exponent, exponent);
    }

    void an_uncertainty_stands_beside_the_deviation_where_it_differs() {
        const QuantityText both = quantity_text(1.0003412, 5e-5, 3.2e-4);
        QCOMPARE(both.value, std::string("1.00034"));
        QCOMPARE(both.sd, std::string("0.00005"));
        QCOMPARE(both.u, std::string("0.0003"));
        QCOMPARE(quantity_text(3.21e-7, 1e-8, 1.5e-8).u, std::string("0.15"));
        QCOMPARE(quantity_text(3.21e-7, 1e-8, 1.5e-8).u_exponent, -7);
        // 5000·10^-5 and 80·10^-8 were such u.
        QCOMPARE(quantity_text(1e-5, 9e-5, 0.05).u, std::string("0.05"));
        QCOMPARE(quantity_text(1e-5, 9e-5, 0.05).u_exponent, 0);
        QCOMPARE(quantity_text(1e-8, 9e-8, 8e-7).u, std::string("8"));
        QCOMPARE(quantity_text(1e-8, 9e-8, 8e-7).u_exponent, -7);
        // One digit that rounds to ten.
        QCOMPARE(quantity_text(6.1e-6, 3e-9, 9.7e-8).u, std::string("0.10"));
        QCOMPARE(quantity_text(1e-12, 1e-13, 9.7e-8).u, std::string("1.0"));
        QCOMPARE(quantity_text(1e-12, 1e-13, 9.7e-8).u_exponent, -7);
        QCOMPARE(quantity_text(53127, 1200, 90000).u, std::string("90000"));
        // 100 000 000 000 000·10^-12 was such a u.
        const QuantityText apart = quantity_text(-6e-12, 3e-12, 100);
        QCOMPARE(apart.exponent, -12);
        QCOMPARE(apart.u, std::string("100"));
        QCOMPARE(apart.u_exponent, 0);
        QCOMPARE(quantity_text(-6e-12, 3e-12, 4e-5).u_exponent, -5);
        const double nan = std::numeric_limits<double>::quiet_NaN();
        for (const double same : {nan, 5e-5, 5.1e-5, 1e-5}) {
            QCOMPARE(quantity_text(1.0003412, 5e-5, same), quantity_text(1.0003412, 5e-5));
        }
    }

    void without_a_deviation_six_digits_stand_alone() {
        constexpr double nan = std::numeric_limits<double>::quiet_NaN();
        for (const double none : {nan, 0.0, -1.0, std::numeric_limits<double>::infinity()}) {
            const QuantityText quantity = quantity_text(1.23456789, none);
            QCOMPARE(quantity.value, std::string("1.23457"));
            QVERIFY(quantity.sd.empty());
        }
        QCOMPARE(quantity_text(nan, 1.0), (QuantityText{"nan", "", 0}));
    }

    void the_printed_deviation_is_within_a_fifth_of_the_true_one() {
        // Rounding to one digit from 3, two digits below: at worst 3.5 is printed as 4.
        for (double sd = 1.05e-4; sd < 1e6; sd *= 1.07) {
            const QuantityText quantity = quantity_text(1.0, sd);
            const double printed = std::stod(quantity.sd) * std::pow(10.0, quantity.exponent);
            VYBEG_CLOSE_RATIO(printed, sd, 0.2, quantity.sd.c_str());
        }
    }
};

VYBEG_TEST(TestQuantityText)

}  // namespace test_quantity_text

#include "test_quantity_text.moc"
