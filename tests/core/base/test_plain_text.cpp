#include "core/base/error.h"
#include "core/base/plain_text.h"
#include "tests/test_registry.h"

#include <QString>
#include <QTest>

#include <algorithm>
#include <cstdint>
#include <string>

namespace test_plain_text {

using namespace vybeg;

class TestPlainText : public QObject {
    Q_OBJECT

private slots:
    void what_is_plain_stays_as_it_is_data() {
        QTest::addColumn<QByteArray>("text");
        for (const char* text : {"", "run 7.wav", "Электрод C, мВ", "\xC3\xA9\xE2\x82\xAC",
                                 "\xF0\x9D\x9C\x83", "50 % of 1\\2 \"x\""}) {
            QTest::newRow(text) << QByteArray(text);
        }
    }

    void what_is_plain_stays_as_it_is() {
        QFETCH(QByteArray, text);
        QCOMPARE(QByteArray::fromStdString(plain_text(text.toStdString())), text);
    }

    void what_is_not_is_shown_as_an_escape_data() {
        QTest::addColumn<QByteArray>("text");
        QTest::addColumn<QByteArray>("shown");
        const auto add = [](const char* name, const QByteArray& text, const char* shown) {
            QTest::newRow(name) << text << QByteArray(shown);
        };
        add("colours", "\x1b[31mred\x1b[0m", "\\x1b[31mred\\x1b[0m");
        add("title of the terminal", "\x1b]0;x\x07", "\\x1b]0;x\\x07");
        add("lines", "a\nb\r\tc", "a\\x0ab\\x0d\\x09c");
        add("zero", QByteArray("a\0b", 3), "a\\x00b");
        add("delete", "\x7f", "\\x7f");
        add("C1", "\xC2\x9B 31m", "\\u009b 31m");
        add("turned round", "\xE2\x80\xAEvaw.nur", "\\u202evaw.nur");
        add("line separator",
            "a\xE2\x80\xA8"
            "b",
            "a\\u2028b");
        add("Latin 1", "\xB5V", "\\xb5V");
        add("cut", "ab\xE2\x82", "ab\\xe2\\x82");
        add("overlong", "\xC0\xAF\xE0\x80\xAF", "\\xc0\\xaf\\xe0\\x80\\xaf");
        add("surrogate", "\xED\xA0\x80", "\\xed\\xa0\\x80");
        add("beyond Unicode", "\xF4\x90\x80\x80", "\\xf4\\x90\\x80\\x80");
    }

    void what_is_not_is_shown_as_an_escape() {
        QFETCH(QByteArray, text);
        QFETCH(QByteArray, shown);
        QCOMPARE(QByteArray::fromStdString(plain_text(text.toStdString())), shown);
    }

    void any_bytes_become_one_line_of_valid_utf_8() {
        std::uint32_t state = 1;
        for (int i = 0; i < 20000; ++i) {
            std::string bytes;
            for (int k = 0; k < 12; ++k) {
                state = state * 1664525u + 1013904223u;
                bytes += static_cast<char>(state >> 24);
            }
            const std::string plain = plain_text(bytes);
            const QString text = QString::fromStdString(plain);
            QCOMPARE(QByteArray::fromStdString(plain), text.toUtf8());
            QVERIFY(!text.contains(QChar::ReplacementCharacter));
            QVERIFY(std::all_of(text.begin(), text.end(),
                                [](QChar c) { return c.category() != QChar::Other_Control; }));
            QCOMPARE(plain_text(plain), plain);
        }
    }

    void letters_of_western_europe_and_cyrillic_ones_become_small() {
        for (const auto& [first, last] : {std::pair(0x20, 0xFF), std::pair(0x400, 0x45F)}) {
            for (int code = first; code <= last; ++code) {
                const QString letter{QChar(code)};
                QCOMPARE(QString::fromStdString(lower_text(letter.toStdString())),
                         letter.toLower());
            }
        }
        for (const char* no_letters : {"\xD0", "\xC3z", "\xFF\xC0", "\xE2\x82\xAC"}) {
            QCOMPARE(lower_text(no_letters), std::string(no_letters));
        }
    }

    void a_message_shows_what_its_arguments_hide() {
        const Error error{ErrorCode::format_unsupported, "a\x1b[2J.mat", {"MAT 5", "x (\n\xff)"}};
        QCOMPARE(english(error),
                 std::string("a\\x1b[2J.mat: this MAT 5 file holds x (\\x0a\\xff), which is not "
                             "read here. Export the recording as WAV or CSV."));
    }
};

VYBEG_TEST(TestPlainText)

}  // namespace test_plain_text

#include "test_plain_text.moc"
