// One recording in every combination of dialect, lines above the table and oddities of its rows,
// as laboratories have them; encodings and line ends take turns.
#include "tests/closeness.h"
#include "tests/core/recording/recording_files.h"
#include "tests/data/trade_files.h"
#include "tests/test_registry.h"

#include <QStringList>

namespace test_text_sweep {

using namespace vybeg;
using namespace vybeg::test;

namespace {

constexpr int rows = 60;
constexpr double rate_hz = 1e4;

struct Dialect {
    const char* name;
    QChar delimiter;
    QChar decimal;
};

const std::vector<Dialect> dialects = {
    {"comma", ',', '.'}, {"semicolon", ';', '.'},     {"semicolon, decimal", ';', ','},
    {"tab", '\t', '.'},  {"tab, decimal", '\t', ','}, {"bar", '|', '.'},
    {"blanks", ' ', '.'}};
const std::vector<const char*> headers = {"none",  "names",    "quoted", "units",   "unit line",
                                          "above", "Cyrillic", "sep",    "comment", "settings"};
const std::vector<const char*> oddities = {
    "plain",      "words last",    "words between", "words first",       "words unnamed",
    "remarks",    "remark column", "empty column",  "delimiters behind", "closing row",
    "empty rows", "blank lines",   "thousands"};

double value(int row, double phase, double size) {
    return std::round(1e3 * size * std::cos(0.7 * row + phase)) / 1e3;
}

// As a spreadsheet shows it: "-5 123,450".
QString grouped(QString number) {
    for (auto at = number.indexOf('.') - 3; at > (number.startsWith('-') ? 1 : 0); at -= 3) {
        number.insert(at, QChar(0xA0));
    }
    return number;
}

struct Layout {
    Dialect dialect;
    QString header;
    QString oddity;

    bool is(const char* name) const { return oddity == name; }
    bool has_words() const { return oddity.startsWith("words") || oddity.startsWith("remark"); }

    // Blanks cannot say which field is empty.
    bool is_possible() const {
        const bool blanks = dialect.delimiter == ' ';
        const bool fields_empty = is("remarks") || is("remark column") || is("empty column") ||
                                  is("delimiters behind") || is("closing row") || is("empty rows");
        return !(blanks && (fields_empty || header == "sep" || header == "Cyrillic")) &&
               !(is("thousands") && (blanks || dialect.decimal != ',')) &&
               !(header == "sep" && dialect.delimiter == '|') &&
               !(header == "Cyrillic" && dialect.delimiter == ',') &&
               !(header == "none" && is("remark column")) &&
               !(header == "unit line" && (blanks || dialect.delimiter == '|') &&
                 (is("words first") || is("words between")));
    }

    QString text() const {
        QStringList lines = above();
        for (int row = 0; row < rows; ++row) {
            lines << line(row);
        }
        const QString delimiters(4, dialect.delimiter);
        if (is("closing row")) {
            lines << delimiters;
        } else if (is("empty rows")) {
            lines << QStringList(300, delimiters);
        } else if (is("blank lines")) {
            lines << QStringList(3000, "");
            lines.insert(lines.size() - 3010, " ");
        }
        return lines.join('\n') + '\n';
    }

    double size() const { return is("thousands") ? 5e3 : 1; }

private:
    QString joined(QStringList fields) const { return fields.join(dialect.delimiter); }

    QStringList with_oddity(QStringList fields, const QString& word, int row) const {
        if (is("words last") || (is("words unnamed") && row >= 0)) {
            fields << word;
        } else if (is("words between")) {
            fields.insert(2, word);
        } else if (is("words first")) {
            fields.insert(0, word);
        } else if (is("remarks") && row >= 0 && row % 17 == 5) {
            fields << "knock, second"
                   << "sic";
        } else if (is("remark column")) {
            fields << (row < 0 || row % 17 == 0 ? word : QString());
        } else if (is("empty column")) {
            fields.insert(2, "");
        } else if (is("delimiters behind")) {
            fields << ""
                   << ""
                   << "";
        }
        return fields;
    }

    QStringList above() const {
        const auto names = [&](const QStringList& fields, const QString& word = "state") {
            return joined(with_oddity(fields, word, -1));
        };
        if (header == "names") {
            return {names({"t", "C", "D"})};
        }
        if (header == "quoted") {
            return {names({"\"t\"", "\"C\"", "\"D\""}, "\"state\"")};
        }
        if (header == "units") {
            return {names({"t [s]", "C [V]", "D [V]"})};
        }
        if (header == "unit line") {
            return {names({"t", "C", "D"}), names({"s", "V", "V"}, "")};
        }
        if (header == "above") {
            return {"Gyro 12", "", names({"t", "C", "D"})};
        }
        if (header == "settings") {
            return {joined({"Model:", "DS1000"}), joined({"Channels:", "2"}),
                    names({"t", "C", "D"})};
        }
        if (header == "Cyrillic") {
            return {names({u8"Время, с", u8"Канал C, В", u8"Канал D, В"}, u8"Состояние")};
        }
        if (header == "sep") {
            return {QString("sep=") + dialect.delimiter, names({"t", "C", "D"})};
        }
        return header == "comment" ? QStringList{"# " + names({"t", "C", "D"})} : QStringList{};
    }

    QString line(int row) const {
        static const char* const words[] = {"idle", "run", "run", "stop"};
        QStringList fields;
        fields << QString::number(row / rate_hz, 'f', 6);
        for (const double phase : {0.0, 1.0}) {
            const QString number = QString::number(value(row, phase, size()), 'f', 3);
            fields << (is("thousands") ? grouped(number) : number);
        }
        for (QString& field : fields) {
            field.replace('.', dialect.decimal);
        }
        QString word = words[row % 4];
        word = header == "quoted" ? '"' + word + '"' : word;
        return joined(with_oddity(fields, word, row));
    }
};

std::vector<Layout> layouts() {
    std::vector<Layout> all;
    for (const Dialect& dialect : dialects) {
        for (const char* header : headers) {
            for (const char* oddity : oddities) {
                const Layout layout{dialect, header, oddity};
                if (layout.is_possible()) {
                    all.push_back(layout);
                }
            }
        }
    }
    return all;
}

// `turn` chooses one of the encodings.
std::string encoded(const QString& text, std::size_t turn) {
    switch (turn % 5) {
        case 0: return text.toStdString();
        case 1: return "\xEF\xBB\xBF" + text.toStdString();
        case 2: return windows_1251(text);
        default: return utf16(text.toStdString(), turn % 5 == 4);
    }
}

}  // namespace

class TestTextSweep : public QObject {
    Q_OBJECT

private slots:
    void every_layout_gives_its_samples_and_rate_data() {
        QTest::addColumn<int>("index");
        const std::vector<Layout> all = layouts();
        VYBEG_AT_LEAST(all.size(), 300u);
        for (std::size_t i = 0; i < all.size(); ++i) {
            QTest::addRow("%s; %s; %s; %zu", all[i].dialect.name, qPrintable(all[i].header),
                          qPrintable(all[i].oddity), i)
                << static_cast<int>(i);
        }
    }

    void every_layout_gives_its_samples_and_rate() {
        QFETCH(int, index);
        const auto turn = static_cast<std::size_t>(index);
        const Layout layout = layouts()[turn];
        QString text = layout.text();
        text.replace('\n', turn % 3 == 0 ? "\n" : turn % 3 == 1 ? "\r\n" : "\r");
        const Folder folder;
        const auto recording = open(folder.write("run.csv", encoded(text, turn / 3)));
        QVERIFY2(recording, recording ? "" : english(recording.error()).c_str());

        Samples expected;
        for (int row = 0; row < rows; ++row) {
            expected.c.push_back(value(row, 0, layout.size()));
            expected.d.push_back(value(row, 1, layout.size()));
        }
        const Samples read = read_all(*recording);
        QCOMPARE(read, expected);
        QCOMPARE(recording->rate_from, RateOrigin::time_column);
        VYBEG_WITHIN(recording->rate_hz / rate_hz, 1, 2.001 * recording->rate_relative_sd + 1e-9);
        const bool cyrillic = layout.header == "Cyrillic";
        if (layout.header != "none") {
            QCOMPARE(recording->channels[0].name, std::string(cyrillic ? "Канал C" : "C"));
            QCOMPARE(recording->channels[1].name, std::string(cyrillic ? "Канал D" : "D"));
        }
        const Diagnostic* words = find(*recording, DiagnosticKind::words_passed_over);
        QCOMPARE(words != nullptr, layout.has_words());
        if (words && layout.header != "none" && !layout.is("words unnamed") &&
            !layout.is("remarks")) {
            QCOMPARE(words->args, std::vector<MessageArg>{cyrillic ? "Состояние" : "state"});
        }
        for (const Diagnostic& diagnostic : recording->diagnostics) {
            QVERIFY2(diagnostic.kind == DiagnosticKind::words_passed_over ||
                         diagnostic.kind == DiagnosticKind::text_lines_ignored,
                     kind_name(diagnostic.kind).c_str());
        }
    }
};

VYBEG_TEST(TestTextSweep)

}  // namespace test_text_sweep

#include "test_text_sweep.moc"
