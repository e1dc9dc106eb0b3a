// The window's room, as layout.csv of vybeg-pictures measures it: the plots own the page of the
// tracks, with one recording and with a set of four, in both languages and themes.
#include "tests/closeness.h"
#include "tests/test_registry.h"

#include <QFile>
#include <QProcess>
#include <QRegularExpression>
#include <QTemporaryDir>
#include <QtTest>

#include <map>

namespace test_desk {

namespace {

struct Shares {
    double least_of_frames;
    double most_blank;
};

// Of the frames of the five plots, and what nothing is drawn in, by the size of the window.
const std::map<QString, Shares> bounds{{"1280x720", {0.50, 0.08}},
                                       {"1600x1000", {0.52, 0.08}},
                                       {"1920x1080", {0.55, 0.08}},
                                       {"2560x1440", {0.60, 0.08}}};

}  // namespace

class TestDesk : public QObject {
    Q_OBJECT

    QTemporaryDir folder_;

    // Rows of layout.csv, split at their commas.
    QList<QStringList> layout(const QStringList& options) {
        QProcess pictures;
        pictures.start(VYBEG_PICTURES, QStringList{folder_.path(), "--page", "tracks"} + options);
        if (!pictures.waitForFinished(600'000) || pictures.exitCode() != 0) {
            qWarning("%s", pictures.readAllStandardError().constData());
            return {};
        }
        QFile file(folder_.filePath("layout.csv"));
        if (!file.open(QIODevice::ReadOnly)) {
            return {};
        }
        QList<QStringList> rows;
        for (const QByteArray& line : file.readAll().trimmed().split('\n').mid(1)) {
            rows << QString::fromUtf8(line).split(',');
        }
        return rows;
    }

    static void compare(const QList<QStringList>& rows) {
        for (const QStringList& row : rows) {
            const Shares& bound = bounds.at(row[1] + 'x' + row[2]);
            QCOMPARE(row[3], QStringLiteral("5"));
            VYBEG_AT_LEAST(row[4].toDouble(), bound.least_of_frames, qPrintable(row[0]));
            VYBEG_AT_MOST(row[6].toDouble(), bound.most_blank, qPrintable(row[0]));
        }
    }

private slots:
    // One recording and four, two languages, two themes, four sizes.
    void the_plots_have_most_of_the_window() {
        const auto rows = layout({"--pixel-ratio", "1"});
        QCOMPARE(rows.size(), 2 * 2 * 2 * 4);
        compare(rows);
    }

    void they_do_on_a_screen_of_twice_the_pixels() {
        const auto rows = layout({"--pixel-ratio", "2"});
        const auto is_double = [](const QStringList& row) { return row[0].contains("@2"); };
        QCOMPARE(std::ranges::count_if(rows, is_double), 2 * 2 * 2 * 4);
        compare(rows);
    }
};

VYBEG_TEST(TestDesk)

}  // namespace test_desk

#include "test_desk.moc"
