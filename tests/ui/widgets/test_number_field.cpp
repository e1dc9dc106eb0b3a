#include "tests/closeness.h"
#include "tests/test_registry.h"
#include "ui/widgets/number_field.h"

#include <QLocale>
#include <QSignalSpy>
#include <QTest>

namespace test_number_field {

using namespace vybeg::ui;

class TestNumberField : public QObject {
    Q_OBJECT

private slots:
    void a_placeholder_in_words_has_the_room_of_the_unit() {
        NumberField field;
        field.setUnit("samples");
        const int room = field.textMargins().right();
        VYBEG_MORE(room, field.fontMetrics().horizontalAdvance("samples"));
        field.setPlaceholderText("= window");
        QCOMPARE(field.textMargins().right(), 0);
        QTest::keyClicks(&field, "30");
        QCOMPARE(field.textMargins().right(), room);
        field.clear();
        QCOMPARE(field.textMargins().right(), 0);
        field.setPlaceholderText("60");
        QCOMPARE(field.textMargins().right(), room);
    }

    void init() { QLocale::setDefault(QLocale(QLocale::English)); }

    void reads_point_and_comma_in_every_language_data() {
        QTest::addColumn<QString>("text");
        QTest::addColumn<double>("value");
        QTest::newRow("point") << "1.5" << 1.5;
        QTest::newRow("comma") << "1,5" << 1.5;
        QTest::newRow("spaces") << " 33 333,25 " << 33333.25;
        QTest::newRow("no-break space") << QStringLiteral("33\u00a0333") << 33333.0;
        QTest::newRow("typographic minus") << QStringLiteral("\u22120,1") << -0.1;
        QTest::newRow("plus") << "+7" << 7.0;
        QTest::newRow("exponent") << "1e-3" << 1e-3;
    }
    void reads_point_and_comma_in_every_language() {
        QFETCH(QString, text);
        QFETCH(double, value);
        for (const auto language : {QLocale::English, QLocale::Russian}) {
            QLocale::setDefault(QLocale(language));
            const auto number = readNumber(text);
            QVERIFY(number.has_value());
            QCOMPARE(*number, value);
        }
    }

    void refuses_what_is_no_number_data() {
        QTest::addColumn<QString>("text");
        for (const char* text :
             {"", "abc", "1.5.2", "1,5,2", "nan", "inf", "12a", "--1", "1e999"}) {
            QTest::newRow(text) << QString::fromLatin1(text);
        }
    }
    void refuses_what_is_no_number() {
        QFETCH(QString, text);
        QVERIFY(!readNumber(text));
    }

    void tells_of_an_edit_once_and_only_when_it_changes_the_value() {
        NumberField field;
        field.setValue(60);
        QSignalSpy edits(&field, &NumberField::valueEdited);
        field.selectAll();
        QTest::keyClicks(&field, "61,5\r");
        QCOMPARE(edits.count(), 1);
        QCOMPARE(field.value(), std::optional(61.5));
        field.selectAll();
        QTest::keyClicks(&field, "61.5\r");
        QCOMPARE(edits.count(), 1);
    }

    void keeps_an_impossible_text_to_itself_and_escape_brings_the_value_back() {
        NumberField field;
        field.setInteger(true);
        field.setLimits(5, 100);
        field.setValue(60);
        QSignalSpy edits(&field, &NumberField::valueEdited);
        const std::pair<const char*, QString> refusals[]{{"4", "At least 5 is needed."},
                                                         {"101", "At most 100 is possible."},
                                                         {"6.5", "A whole number is needed."},
                                                         {"x", "“x” is no number."},
                                                         {"", "A number is needed."}};
        for (const auto& [text, refusal] : refusals) {
            field.selectAll();
            QTest::keyClick(&field, Qt::Key_Delete);
            QTest::keyClicks(&field, text);
            QVERIFY2(!field.isValid(), text);
            QTest::keyClick(&field, Qt::Key_Return);
            QCOMPARE(field.fault(), refusal);
        }
        QCOMPARE(edits.count(), 0);
        QTest::keyClick(&field, Qt::Key_Escape);
        QCOMPARE(field.text(), QStringLiteral("60"));
        QVERIFY(field.isValid() && field.fault().isEmpty());
    }

    void no_number_has_a_power_of_ten() {
        NumberField field;
        for (const auto& [value, text] :
             {std::pair{1e-5, "0.00001"}, std::pair{-1.25e-7, "-0.000000125"},
              std::pair{1e12, "1000000000000"}, std::pair{155555., "155555"}}) {
            field.setValue(value);
            QCOMPARE(field.text(), QLatin1String(text));
        }
    }

    void a_limit_has_no_power_of_ten() {
        NumberField field;
        field.setLimits(1e-6, 1e9);
        field.setValue(1);
        for (const auto& [text, refusal] : {std::pair{"1e10", "At most 1 000 000 000 is possible."},
                                            std::pair{"0", "At least 0.000 001 is needed."}}) {
            field.selectAll();
            QTest::keyClicks(&field, QLatin1String(text) + QLatin1Char('\r'));
            QCOMPARE(field.fault().replace(QChar(0x202f), ' '), QLatin1String(refusal));
        }
    }

    void what_is_being_typed_stays_as_long_as_the_value_is_the_same() {
        NumberField field;
        field.setValue(60);
        field.selectAll();
        QTest::keyClicks(&field, "7");
        field.setValue(60);
        QCOMPARE(field.text(), QStringLiteral("7"));
        field.setValue(61);
        QCOMPARE(field.text(), QStringLiteral("61"));
    }

    void empty_is_a_value_only_where_that_is_allowed() {
        NumberField field;
        field.setOptional(true);
        field.setValue(3);
        QSignalSpy edits(&field, &NumberField::valueEdited);
        field.selectAll();
        QTest::keyClick(&field, Qt::Key_Delete);
        QTest::keyClick(&field, Qt::Key_Return);
        QCOMPARE(edits.count(), 1);
        QVERIFY(!field.value());
    }

    void arrows_step_within_the_limits() {
        NumberField field;
        field.setInteger(true);
        field.setLimits(5, 7);
        field.setValue(6);
        QTest::keyClick(&field, Qt::Key_Up);
        QTest::keyClick(&field, Qt::Key_Up);
        QCOMPARE(field.value(), std::optional(7.0));
        QTest::keyClick(&field, Qt::Key_Down);
        QCOMPARE(field.value(), std::optional(6.0));
    }

    void shows_the_decimal_mark_of_the_language() {
        NumberField field;
        field.setValue(1.5);
        QCOMPARE(field.text(), QStringLiteral("1.5"));
        QLocale::setDefault(QLocale(QLocale::Russian));
        QEvent change(QEvent::LanguageChange);
        QCoreApplication::sendEvent(&field, &change);
        QCOMPARE(field.text(), QStringLiteral("1,5"));
    }
};

VYBEG_TEST(TestNumberField)

}  // namespace test_number_field

#include "test_number_field.moc"
