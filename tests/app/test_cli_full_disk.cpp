// A disk that is full: exit status 5, the old files as they were, nothing left; with a limit of the
// file's size and on a real disk of that size. Two commands at five sizes; tests/core/output has
// every format at more sizes.
#include "tests/app/cli_run.h"
#include "tests/closeness.h"
#include "tests/test_registry.h"

#include <QtTest>

#include <algorithm>

namespace test_cli_full_disk {

using namespace vybeg::test;

namespace {

constexpr int sizes = 5;

}  // namespace

class TestCliFullDisk : public QObject, private CliFolder {
    Q_OBJECT

    // What the outputs of a command are called in its line, in the folder `out`.
    void rows() {
        QTest::addColumn<QString>("command");
        QTest::addColumn<QStringList>("outputs");
        const auto row = [](const char* name, const QString& command, const QStringList& outputs) {
            QTest::newRow(name) << command << outputs;
        };
        row("track", "analyze a.wav -o out/track.csv", {"track.csv"});
        row("result and passport",
            "identify a.wav b.wav -o out/result.json --passport out/passport.json",
            {"result.json", "passport.json"});
    }

    // Size of the largest output where nothing limits it; 0: the command failed.
    qint64 whole_size(const QString& command, const QStringList& outputs) {
        QDir(path("out")).removeRecursively();
        QDir(folder_.path()).mkdir("out");
        if (run(command).status != 0) {
            return 0;
        }
        qint64 largest = 0;
        for (const QString& output : outputs) {
            largest = std::max(largest, QFileInfo(path("out/" + output)).size());
        }
        return largest;
    }

private slots:
    void initTestCase() {
        QCOMPARE(run("simulate --demo --seconds 2 -o a.wav").status, 0);
        QCOMPARE(run("simulate --demo --seconds 2 --two-theta-A 1.2 -o b.wav").status, 0);
    }

    void a_file_that_may_not_grow_leaves_the_old_ones_data() { rows(); }

    void a_file_that_may_not_grow_leaves_the_old_ones() {
        QFETCH(QString, command);
        QFETCH(QStringList, outputs);
        const qint64 whole = whole_size(command, outputs);
        VYBEG_MORE(whole, sizes);
        for (int k = 0; k < sizes; ++k) {
            const qint64 most = whole * k / sizes;
            for (const QString& output : outputs) {
                QVERIFY(put(path("out/" + output), "old"));
            }
            const Outcome outcome = run_here(VYBEG_CLI, command.split(' '),
                                             limit(RLIMIT_FSIZE, static_cast<rlim_t>(most)));
            const QByteArray about = QByteArray::number(most) + " bytes: " + outcome.err;
            VYBEG_EQUAL(outcome.status, 5, about);
            QVERIFY2(outcome.err_lines().last().contains("cannot be written"), about);
            for (const QString& output : outputs) {
                QVERIFY2(file("out/" + output) == "old", about + output.toUtf8());
            }
            const QStringList left =
                QDir(path("out")).entryList(QDir::AllEntries | QDir::Hidden | QDir::NoDotAndDotDot);
            VYBEG_EQUAL(left.size(), outputs.size(), about + left.join(' ').toUtf8());
        }
    }

    void a_full_disk_leaves_the_old_files_data() { rows(); }

    // A disk in memory, mounted where only the child sees it. Its room comes in pages.
    void a_full_disk_leaves_the_old_files() {
        QFETCH(QString, command);
        QFETCH(QStringList, outputs);
        const qint64 page = 4096;
        qint64 whole = 0;
        VYBEG_MORE(whole_size(command, outputs), 0);
        if (run_here("unshare", {"-rm", "mount", "-t", "tmpfs", "none", path("out")}).status != 0) {
            QSKIP(
                "NOT TESTED: this system lets no disk of a chosen size be mounted (unshare -rm). "
                "The limit of the file's size was tested instead.");
        }
        for (const QString& output : outputs) {
            whole += (QFileInfo(path("out/" + output)).size() + page - 1) / page;
        }
        for (int k = 0; k < sizes; ++k) {
            // A page for each old file, and fewer than the new ones need.
            const qint64 room = outputs.size() + std::min((whole - 1) * k / (sizes - 1), whole - 1);
            const QString script =
                QString(
                    "mount -t tmpfs -o size=%1 none out && for f in %2; do printf old > "
                    "out/$f; done; %3 %4 2> err > /dev/null; echo $?; cd out; ls -A; cat *")
                    .arg(room * page)
                    .arg(outputs.join(' '), VYBEG_CLI, command);
            const Outcome outcome = run_here("unshare", {"-rm", "sh", "-c", script});
            QStringList sorted = outputs;
            sorted.sort();
            const QByteArray expected = "5\n" + sorted.join('\n').toUtf8() + "\n" +
                                        QByteArray("old").repeated(int(outputs.size()));
            QVERIFY2(outcome.out == expected,
                     QByteArray::number(room) + " pages: " + outcome.out.left(200) + file("err"));
            QVERIFY2(file("err").contains("No space left on device"), file("err"));
        }
    }

    void room_for_everything_is_enough() {
        const qint64 whole = whole_size("analyze a.wav -o out/track.csv", {"track.csv"});
        const Outcome outcome = run_here(VYBEG_CLI, {"analyze", "a.wav", "-o", "out/track.csv"},
                                         limit(RLIMIT_FSIZE, static_cast<rlim_t>(whole)));
        QCOMPARE(outcome.status, 0);
    }
};

VYBEG_TEST(TestCliFullDisk, unsanitized)

}  // namespace test_cli_full_disk

#include "test_cli_full_disk.moc"
