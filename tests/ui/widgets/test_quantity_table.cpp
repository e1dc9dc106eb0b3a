// A table of quantities, by itself.
#include "tests/closeness.h"
#include "tests/test_registry.h"
#include "ui/widgets/quantity_table.h"
#include "ui/words/display_units.h"

#include <QApplication>
#include <QClipboard>
#include <QHeaderView>
#include <QtTest>

#include <cmath>
#include <cstdlib>

namespace test_quantity_table {

using namespace vybeg::ui;

class TestQuantityTable : public QObject {
    Q_OBJECT

private slots:
    // Two names of two words beside a cell of many: the cell wraps, not both names.
    void names_keep_a_line_where_a_cell_spares_it() {
        QuantityTable table;
        const auto cells = [](const QString& text) {
            const QuantityCell number{"5300.00017000", {}, {}, {}};
            return std::vector<QuantityCell>{{text, {}, {}, {}}, number, number};
        };
        const std::vector<QuantityRow> rows{{"Deviation of the frequency", {}, cells("0")},
                                            {"Frequency of that direction", {}, cells("0")},
                                            {"Windows", {}, cells("1866 of 1866, n = 500 each")}};
        table.setContent({}, rows);
        table.show();
        const auto height = [&](int width) {
            table.resize(width, 200);
            QCoreApplication::processEvents();
            return table.rowHeight(0) + table.rowHeight(1) + table.rowHeight(2);
        };
        const int wide = height(900);
        const int line = table.rowHeight(0);
        int widest = 0;
        for (int column = 0; column < 4; ++column) {
            widest += table.columnWidth(column);
        }
        VYBEG_AT_LEAST(widest, 300);
        VYBEG_AT_MOST(height(widest - 30), wide + line);
    }

    void headers_are_short_only_where_they_have_no_room() {
        QuantityTable table;
        const QuantityCell number{"5300.00017(7)", {}, {}, {}};
        const QStringList names{"HRG-17 after the second turn, first log",
                                "HRG-17 after the second turn, second log"};
        table.setContent(names, {{"Turn", {}, {number, number}}}, {"…first log", "…second log"});
        table.show();
        const auto heads = [&table](int width) {
            table.resize(width, 100);
            QCoreApplication::processEvents();
            return QStringList{table.horizontalHeaderItem(1)->text(),
                               table.horizontalHeaderItem(2)->text()};
        };
        QCOMPARE(heads(900), names);
        QCOMPARE(heads(400), (QStringList{"…first log", "…second log"}));
        QCOMPARE(heads(900), names);
    }

    // Where a column has nothing but numbers.
    void decimal_signs_stand_below_each_other() {
        QuantityTable table;
        const auto row = [](const QString& name, const QString& number, const QString& other) {
            return QuantityRow{
                name, {}, {{number, {}, {}}, {other, {}, {}}, {"✓ ≤ " + number, {}, {}}}};
        };
        table.setContent({}, {row("a", "5300.5(7)", "5300.5(7)"), row("b", "−0.012 ± 0.003", "—"),
                              row("c", "7", "taken as zero")});
        table.resize(600, 200);
        table.show();
        QCoreApplication::processEvents();
        // The place of the left edge of a cell's text.
        const auto left = [&table](int line, int column) {
            const QImage image =
                table.grab(table.visualItemRect(table.item(line, column))).toImage();
            for (int x = 0; x < image.width(); ++x) {
                for (int y = 0; y < image.height(); ++y) {
                    if (image.pixelColor(x, y).lightness() < 128) {
                        return x;
                    }
                }
            }
            return -1;
        };
        const auto wide = [&table](const char* text) {
            return table.fontMetrics().horizontalAdvance(QString::fromUtf8(text));
        };
        constexpr int bearing = 3;
        const int first = left(0, 1);
        VYBEG_AT_LEAST(first, 0);
        VYBEG_AT_MOST(std::abs(left(1, 1) - first - wide("5300") + wide("−0")), bearing);
        VYBEG_AT_MOST(std::abs(left(2, 1) - first - wide("5300") + wide("7")), bearing);
        VYBEG_AT_MOST(std::abs(left(2, 2) - left(0, 2)), bearing);
        VYBEG_AT_MOST(std::abs(left(2, 3) - left(0, 3)), bearing);
    }

    // A thing is a row, a quantity a column of one unit; the whole of a number is its tip.
    void quantities_are_columns_of_things() {
        QuantityTable table;
        const auto cell = [](const QString& text) {
            return QuantityCell{text, {text, "1"}, {}, {}, text + " in full"};
        };
        table.setColumns({{"a_B, V", "amplitude", {cell("1(1)"), cell("2(1)")}},
                          {"τ, s", "time", {cell("30(1)"), cell("31(1)")}}},
                         {{"first", "first.wav", {}, Qt::red}, {"second", {}, {}}});
        QCOMPARE(table.rowCount(), 2);
        QCOMPARE(table.horizontalHeaderItem(1)->text(), QStringLiteral("aB, V"));
        QVERIFY(table.horizontalHeaderItem(2)->toolTip().contains("time"));
        QCOMPARE(table.item(1, 2)->text(), QStringLiteral("31(1)"));
        QCOMPARE(table.item(0, 0)->text(), QStringLiteral("● first"));
        QVERIFY(table.item(0, 1)->toolTip().contains("1(1) in full"));
        QCOMPARE(table.item(0, 1)->data(Qt::AccessibleTextRole).toString(),
                 QStringLiteral("1(1) in full"));
        table.show();
        QVERIFY(QTest::qWaitForWindowExposed(&table));
        table.setFocus();
        QTest::keyClick(&table, Qt::Key_C, Qt::ControlModifier);
        QCOMPARE(QApplication::clipboard()->text(),
                 QStringLiteral("\taB, V\tsd\tτ, s\tsd\nfirst\t1(1)\t1\t30(1)\t1\n"
                                "second\t2(1)\t1\t31(1)\t1\n"));
    }

    void a_column_has_one_power_of_ten() {
        QCOMPARE(conciseText(22.50021, 0.0003, 0), QStringLiteral("22.5002(3)"));
        QCOMPARE(conciseText(1.2e-5, 9e-5, 0),
                 QStringLiteral("0.000 01(9)").replace(' ', QChar(0x202f)));
        QCOMPARE(conciseText(-6.24e-8, 2e-9, -9), QStringLiteral("−62.4(20)"));
        QCOMPARE(conciseText(499511, 22, 3), QStringLiteral("499.511(22)"));
        QCOMPARE(conciseText(1675.3, 40, 0), QStringLiteral("1680(40)"));
        QCOMPARE(conciseText(1675.3, 40, 3), QStringLiteral("1.680(40)"));
        QCOMPARE(conciseText(4.9951e8, 4e6, 6), QStringLiteral("500(4)"));
        QCOMPARE(conciseText(4.9951e8, 4e6, 3).right(6), QStringLiteral("(4000)"));
        QCOMPARE(conciseText(499511, 22, 0).right(4), QStringLiteral("(22)"));
        QCOMPARE(conciseText(std::nan(""), 1, 3), QStringLiteral("—"));
    }
};

VYBEG_TEST(TestQuantityTable)

}  // namespace test_quantity_table

#include "test_quantity_table.moc"
