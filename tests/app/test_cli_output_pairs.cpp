// Every output of every command that leads, by whatever name, to one of its inputs or to another of
// its outputs: refused, and no file is touched.
#include "tests/app/batch_run.h"
#include "tests/closeness.h"
#include "tests/test_registry.h"

#include <QtTest>

#include <unistd.h>

namespace test_cli_output_pairs {

using namespace vybeg::test;

// Ways to name the file NAME of the folder; those that need it there make it a link.
enum class Way {
    plain,
    dot,
    up_and_down,
    linked_folder,
    absolute,
    process_folder,
    soft_link,
    chained_links,
    hard_link,
    descriptor,
    bind_mount
};
constexpr std::array all_ways{Way::plain,         Way::dot,       Way::up_and_down,
                              Way::linked_folder, Way::absolute,  Way::process_folder,
                              Way::soft_link,     Way::hard_link, Way::chained_links,
                              Way::descriptor,    Way::bind_mount};

// A command with two places: one is the file as it is called, other is what leads to it.
struct Pair {
    const char* command;  // with %1 for the file and %2 for its other name
    const char* file;
    bool is_new;  // an output that is not there yet
};

constexpr std::array pairs{
    // Two outputs.
    Pair{"identify a.wav b.wav -o %1 --passport %2", "new.json", true},
    Pair{"identify a.wav b.wav -o %1 --database %2", "new.json", true},
    Pair{"identify a.wav b.wav --passport %1 --database %2", "new.json", true},
    Pair{"simulate --seconds 0.01 -o %1 --truth %2", "new.csv", true},
    Pair{"batch list.csv -o %1 --database %2", "new.csv", true},
    Pair{"batch list.csv -o t.csv --json %1 --passports-out %2", "made", true},
    // An output and an input.
    Pair{"analyze %1 -o %2", "a.csv", false},
    Pair{"analyze --raw samples.bin --rate 8000 --f0 1000 -o %2 %1", "a.csv", false},
    // A recording in several files.
    Pair{"analyze twin.csv --channel-d %1 -o %2", "a.csv", false},
    Pair{"analyze twin.csv --time-column none --rate 33333 --channels 2,3 --join %1 -o %2", "a.csv",
         false},
    Pair{"identify twin.csv --channel-d %1 --database %2", "a.csv", false},
    Pair{"batch parts.csv -o %2 --only %1", "a.csv", false},
    Pair{"identify a.wav %1 -o %2", "a.csv", false},
    Pair{"identify a.wav %1 --passport %2", "a.csv", false},
    Pair{"identify a.wav %1 --database %2", "a.csv", false},
    Pair{"identify --list %1 --set s2 -o %2", "list.csv", false},
    Pair{"identify --list %1 --set s2 --passport %2", "list.csv", false},
    Pair{"identify --list %1 --set s2 --database %2", "list.csv", false},
    Pair{"compare %1 a.wav b.wav -o %2", "passport.json", false},
    Pair{"compare passport.json a.wav %1 -o %2", "a.csv", false},
    Pair{"batch %1 -o %2", "list.csv", false},
    Pair{"batch %1 -o t.csv --database %2", "list.csv", false},
    Pair{"batch list.csv -o t.csv --limits %1 --database %2", "limits.csv", false},
    Pair{"batch list.csv --limits %1 -o %2", "limits.csv", false},
    Pair{"batch csv-list.csv -o %2 --only %1", "a.csv", false},
    Pair{"batch csv-list.csv -o t.csv --only %1 --database %2", "a.csv", false},
};

class TestCliOutputPairs : public QObject, private CliFolder {
    Q_OBJECT

    // Every file of the folder but the links that a way makes.
    QMap<QString, QByteArray> snapshot() {
        QMap<QString, QByteArray> files;
        QDirIterator each(folder_.path(), QDir::Files | QDir::Hidden | QDir::NoSymLinks,
                          QDirIterator::Subdirectories);
        while (each.hasNext()) {
            const QString path = each.next();
            if (!each.fileName().startsWith("other.")) {
                files[path] = content(path);
            }
        }
        return files;
    }

    // The file's other name; empty: it cannot be made for a file that is not there.
    QString otherName(Way way, const Pair& pair) {
        const QString name = pair.file;
        const QString link = "other." + name.section('.', -1);
        switch (way) {
            case Way::plain: return name;
            case Way::dot: return "./" + name;
            case Way::up_and_down: return "sub/../" + name;
            case Way::linked_folder: return "sub/back/" + name;
            case Way::absolute: return path(name);
            case Way::process_folder: return "/proc/self/cwd/" + name;
            case Way::soft_link:
                // Of a new output it leads nowhere yet.
                return QFile::link(path(name), path(link)) ? link : QString();
            case Way::chained_links:
                return QFile::link(path(name), path("sub/other.link")) &&
                               QFile::link("sub/other.link", path(link))
                           ? link
                           : QString();
            case Way::hard_link:
                return !pair.is_new && ::link(qPrintable(path(name)), qPrintable(path(link))) == 0
                           ? link
                           : QString();
            case Way::descriptor: return pair.is_new ? QString() : "/proc/self/fd/9";
            case Way::bind_mount: return "bound/" + name;
        }
        return {};
    }

    Outcome runAs(Way way, const QString& command, const QString& name) {
        if (way == Way::descriptor) {
            return run_here(
                "sh", {"-c", QString("exec 9<>%1; exec %2 %3").arg(name, VYBEG_CLI, command)});
        }
        if (way == Way::bind_mount) {
            return run_here(
                "unshare", {"-rm", "sh", "-c",
                            QString("mount --bind . bound && exec %1 %2").arg(VYBEG_CLI, command)});
        }
        return run(command);
    }

private slots:
    void initTestCase() {
        QVERIFY(make_twelve_sets(folder_.path()));
        QCOMPARE(run("simulate --seconds 2 --two-theta-A 0.6 -o a.csv").status, 0);
        QCOMPARE(run("identify a.wav b.wav --passport passport.json").status, 0);
        QVERIFY(put(path("limits.csv"), "parameter,least,greatest\ntau,1,1000\n"));
        QVERIFY(put(path("csv-list.csv"), "set,file\na.csv,a.csv\n"));
        QVERIFY(put(path("parts.csv"), "set,file,channel-d\na.csv,twin.csv,a.csv\n"));
        QVERIFY(QFile::copy(path("a.csv"), path("twin.csv")));
        QVERIFY(put(path("samples.bin"), QByteArray(64000, '\1')));
        QVERIFY(QDir(folder_.path()).mkdir("sub"));
        QVERIFY(QDir(folder_.path()).mkdir("bound"));
        QVERIFY(QFile::link(folder_.path(), path("sub/back")));
    }

    void no_output_leads_to_an_input_or_another_output() {
        const QMap<QString, QByteArray> before = snapshot();
        const bool mounts =
            run_here("unshare", {"-rm", "mount", "--bind", ".", "bound"}).status == 0;
        if (!mounts) {
            qWarning("NOT TESTED: this system lets no folder be mounted twice (unshare -rm).");
        }
        int tried = 0;
        for (const Pair& pair : pairs) {
            for (const Way way : all_ways) {
                const QString other =
                    way == Way::bind_mount && !mounts ? QString() : otherName(way, pair);
                if (other.isEmpty()) {
                    continue;
                }
                // Once the output has the other name, once what it must not replace has it.
                for (const bool swapped : {false, true}) {
                    const QString file = pair.file;
                    if (swapped && QString(pair.command).contains("--only %1")) {
                        continue;  // a name of a set, not of a file
                    }
                    const QString command =
                        QString(pair.command).arg(swapped ? other : file, swapped ? file : other);
                    const Outcome outcome = runAs(way, command, file);
                    QVERIFY2(outcome.status == 2 || outcome.status == 3 || outcome.status == 5,
                             qPrintable(command + ": " + QString::number(outcome.status) + " " +
                                        outcome.err));
                    QVERIFY2(snapshot() == before, qPrintable(command));
                    ++tried;
                }
                QFile::remove(path("sub/other.link"));
                QFile::remove(path("other." + QString(pair.file).section('.', -1)));
            }
        }
        VYBEG_AT_LEAST(tried, 300, "every pair by every way that this system has");
    }
};

VYBEG_TEST(TestCliOutputPairs)

}  // namespace test_cli_output_pairs

#include "test_cli_output_pairs.moc"
