// CSV tables as spreadsheets write them.
#include "core/recording/text/csv_rows.h"
#include "tests/closeness.h"
#include "tests/core/recording/recording_files.h"
#include "tests/needed.h"
#include "tests/test_registry.h"

#include <QTest>

namespace test_csv_rows {

using namespace vybeg;
using namespace vybeg::test;

namespace {

using Texts = std::vector<std::string>;

}  // namespace

class TestCsvRows : public QObject {
    Q_OBJECT

    Folder folder_;

    CsvRows table(std::string_view text) const {
        return needed(read_csv(folder_.write("list.csv", text), "file"));
    }

    QString fault(std::string_view text) const {
        const auto path = folder_.write("list.csv", text);
        const auto table = read_csv(path, "file");
        return table ? QString()
                     : QString::fromStdString(english(table.error()))
                           .remove(QString::fromStdString(path.string()));
    }

private slots:
    void a_field_with_a_zero_byte_and_a_line_without_end_are_refused() {
        QVERIFY(fault(std::string("file,set\na.wav\0x,A\n", 19))
                    .contains("line 2, column \"file\": it holds a zero byte"));
        const std::string endless(3 << 20, 'x');
        QVERIFY(fault("file,set\na.wav,A\n" + endless).contains("line 3"));
        QVERIFY(fault("file,set\na.wav,A\n" + endless).contains("the line is longer than 1 MiB"));
        std::string many = "set";
        for (int k = 0; k < 2000; ++k) {
            many += ",column" + std::to_string(k);
        }
        const QString named = fault(many + "\n");
        QVERIFY2(named.contains("column10, ...") && named.size() < 300, qPrintable(named));
    }

    void the_dialects_of_spreadsheets_read_alike_data() {
        QTest::addColumn<QByteArray>("text");
        const auto row = [](const char* name, const QByteArray& text) {
            QTest::newRow(name) << text;
        };
        row("commas", "file,set\na.wav,A\nb.wav,B\n");
        row("semicolons", "file;set\na.wav;A\nb.wav;B\n");
        row("tabulators", "file\tset\na.wav\tA\nb.wav\tB\n");
        row("separator told", "sep=;\r\nfile;set\r\na.wav;A\r\nb.wav;B\r\n");
        row("comments before", "# March, bench 2\n#\nfile,set\na.wav,A\nb.wav,B\n");
        row("byte order mark",
            "\xEF\xBB\xBF"
            "file,set\na.wav,A\nb.wav,B\n");
        row("mark and quotes", "\xEF\xBB\xBF\"file\";\"set\"\n\"a.wav\";\"A\"\nb.wav;B\n");
        row("CRLF", "file,set\r\na.wav,A\r\nb.wav,B\r\n");
        row("no line end", "file,set\na.wav,A\nb.wav,B");
        row("blanks", " file , set \n a.wav , A\n\"b.wav\" , \"B\" \n");
        row("empty rows", "file,set\n\na.wav,A\n,\n\"\",\nb.wav,B\n\n");
        row("empty fields at the end", "file,set,,\na.wav,A,,\nb.wav,B\n");
        row("semicolon in a quoted name", "file,set,\"x;y\"\na.wav,A\nb.wav,B\n");
        QByteArray wide("\xFF\xFE");
        for (const char letter : QByteArray("file;set\na.wav;A\nb.wav;B\n")) {
            wide += letter;
            wide += '\0';
        }
        row("UTF-16", wide);
    }

    void the_dialects_of_spreadsheets_read_alike() {
        QFETCH(QByteArray, text);
        const CsvRows read = table(text.toStdString());
        VYBEG_AT_LEAST(read.names.size(), 2);
        QCOMPARE(read.names[0], "file");
        QCOMPARE(read.names[1], "set");
        QCOMPARE(read.rows.size(), std::size_t{2});
        for (const CsvRow& row : read.rows) {
            QCOMPARE(row.fields.size(), read.names.size());
        }
        QCOMPARE(read.rows[0].fields[0], "a.wav");
        QCOMPARE(read.rows[0].fields[1], "A");
        QCOMPARE(read.rows[1].fields[0], "b.wav");
        QCOMPARE(read.rows[1].fields[1], "B");
    }

    void quoted_fields_hold_anything() {
        const CsvRows read = table(
            "file,note\n\"a, b.wav\",\"says \"\"no\"\"\"\n"
            "c.wav,\"two\nlines, \r\none field\"\nd.wav,5\" disk\n");
        QVERIFY((read.rows[0].fields == Texts{"a, b.wav", "says \"no\""}));
        QVERIFY((read.rows[1].fields == Texts{"c.wav", "two\nlines, \none field"}));
        QVERIFY((read.rows[2].fields == Texts{"d.wav", "5\" disk"}));
        QCOMPARE(read.rows[0].line, std::int64_t{2});
        QCOMPARE(read.rows[1].line, std::int64_t{3});
        QCOMPARE(read.rows[2].line, std::int64_t{6});
    }

    void russian_instruments_write_windows_1251() {
        const CsvRows read = table("file;\xCF\xE0\xF0\xF2\xE8\xFF\na.wav;\xC0\n");
        QCOMPARE(read.names[1], "Партия");
        QCOMPARE(read.rows[0].fields[1], "А");
        // Number, quotes, dashes, degree; the letters of Belarusian and Ukrainian.
        QCOMPARE(table("file;\xB9\xAB\xBB\x96\x97\xB0\xB1;\xA8\xB8\xA1\xB2\xAF\xA5\na;1;2\n").names,
                 (Texts{"file", "№«»–—°±", "ЁёЎІЇҐ"}));
    }

    void a_fault_names_its_line_and_column_data() {
        QTest::addColumn<QByteArray>("text");
        QTest::addColumn<QString>("sentence");
        const auto row = [](const char* name, const QByteArray& text, const QString& sentence) {
            QTest::newRow(name) << text << sentence;
        };
        row("no column", "name,set\na.wav,A\n",
            ", line 1, column \"file\": the list needs this column; its columns are name, set.");
        row("no names", "# nothing\n", ", line 1, column \"file\": the list needs this column.");
        row("a name twice", "file,set,set\na.wav,A,B\n",
            ", line 1, column \"set\": two columns have this name.");
        row("a field too many", "file,set\na.wav,A\nb.wav,B,C\n",
            ", line 3, column \"3\": \"C\" stands below no name.");
        row("below an empty name", "file,,set\na.wav,A\n",
            ", line 2, column \"2\": \"A\" stands below no name.");
        row("open quote", "file,set\na.wav,A\n\nb.wav,\"B\nc.wav,C\n",
            ", line 4, column \"set\": its quotation mark does not close.");
        row("text after a quote", "file,set\n\"a\"b.wav,A\n",
            ", line 2, column \"file\": text follows its closing quotation mark.");
    }

    void a_fault_names_its_line_and_column() {
        QFETCH(QByteArray, text);
        QFETCH(QString, sentence);
        QCOMPARE(fault(text.toStdString()), sentence);
    }

    void a_quote_that_never_closes_ends_soon() {
        std::string text = "file,set\na.wav,\"open\n";
        for (int k = 0; k < 200000; ++k) {
            text += "b.wav,B\n";
        }
        QElapsedTimer timer;
        timer.start();
        QVERIFY(fault(text).contains("line 2, column \"set\""));
        VYBEG_LESS(timer.elapsed(), 5000);
    }

    void what_is_no_file_has_the_sentence_of_any_file() {
        QCOMPARE(read_csv(folder_.file("none.csv"), "file").error().code, ErrorCode::file_missing);
        QCOMPARE(read_csv(folder_.write("empty.csv", ""), "file").error().code,
                 ErrorCode::file_empty);
    }
};

VYBEG_TEST(TestCsvRows)

}  // namespace test_csv_rows

#include "test_csv_rows.moc"
