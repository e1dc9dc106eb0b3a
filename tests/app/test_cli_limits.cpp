// Too little memory and too few threads: a sentence and a status, and nothing is left.
#include "tests/app/cli_run.h"
#include "tests/closeness.h"
#include "tests/test_registry.h"

#include <QtTest>

#include <sys/resource.h>
#include <unistd.h>

namespace test_cli_limits {

using namespace vybeg::test;

namespace {

// Copies of a program and its helper that anyone may run, where the superuser's limits do not hold.
QString copy_for_anyone(const QString& folder) {
    for (const char* name : {"vybeg-cli", "vybeg-reader"}) {
        const QString copy = folder + "/" + name;
        const QString source = QFileInfo(VYBEG_CLI).absolutePath() + "/" + name;
        if (!QFile::exists(copy) && (!QFile::copy(source, copy) ||
                                     !QFile::setPermissions(copy, QFile::Permissions(0x5555)))) {
            return {};
        }
    }
    return folder + "/vybeg-cli";
}

}  // namespace

class TestCliLimits : public QObject, private CliFolder {
    Q_OBJECT

private slots:
    void initTestCase() { QCOMPARE(run("simulate --demo --seconds 2 -o a.wav").status, 0); }

    void too_little_memory_has_a_sentence_and_leaves_nothing() {
        const QStringList command = words("analyze a.wav -o old.csv");
        QVERIFY(put(path("old.csv"), "old"));
        int refused = 0;
        int done = 0;
        // From where not even the libraries load to where there is enough.
        for (rlim_t megabytes = 40; done == 0 && megabytes < 1000; megabytes += 2) {
            const Outcome outcome =
                run_here(VYBEG_CLI, command, limit(RLIMIT_AS, megabytes * 1'000'000));
            const QByteArray about = QByteArray::number(qulonglong(megabytes)) +
                                     " MB: " + QByteArray::number(outcome.status) + " " +
                                     outcome.err;
            done += outcome.status == 0 ? 1 : 0;
            if (outcome.status != 0 && outcome.status != 127) {
                ++refused;
                VYBEG_EQUAL(outcome.status, 4, about);
                QVERIFY2(outcome.err.startsWith("vybeg-cli: There is not enough memory") ||
                             outcome.err.startsWith("vybeg-cli: The system starts no more"),
                         about);
                QCOMPARE(outcome.err_lines().size(), 1);
            }
            QCOMPARE(file("old.csv") == "old", outcome.status != 0);
            QVERIFY2(temporaries().isEmpty(), about);
        }
        QCOMPARE(done, 1);
        VYBEG_MORE(refused, 0, "no limit between loading and enough was met");
    }

    void too_small_a_stack_has_a_sentence_and_no_signal_data() {
        QTest::addColumn<QStringList>("command");
        QTest::addColumn<bool>("works");
        for (const char* name : {"a.wav", "a.csv", "a.npy", "a.mat", "a.flac"}) {
            QTest::newRow(name) << QStringList{"info", name} << false;
        }
        QTest::newRow("analyze") << words("analyze a.wav -o new.csv") << false;
        QTest::newRow("identify") << QStringList{"identify", "a.wav"} << false;
        QTest::newRow("batch") << words("batch . -o new.csv") << false;
        QTest::newRow("simulate") << words("simulate --demo -o new.wav") << false;
        QTest::newRow("help") << QStringList{"--help"} << true;
        QTest::newRow("wrong call") << QStringList{"analyze"} << false;
    }

    void too_small_a_stack_has_a_sentence_and_no_signal() {
        QFETCH(QStringList, command);
        QFETCH(bool, works);
        const Outcome outcome = run_here(VYBEG_CLI, command, limit(RLIMIT_STACK, 64 << 10));
        QCOMPARE(outcome.status, works ? 0 : 2);
        QCOMPARE(outcome.err_lines().size(), works ? 0 : 1);
        if (command.size() > 1) {
            QCOMPARE(
                outcome.err_lines()[0],
                QByteArray("vybeg-cli: the limit of the stack (ulimit -s) cannot be \"64 kB\": "
                           "the program needs 512 kB or more."));
        }
    }

    void the_least_stack_is_enough() {
        for (const QStringList& command :
             {QStringList{"info", "a.wav"}, words("analyze a.wav -o enough.csv"),
              QStringList{"identify", "a.wav"}}) {
            const Outcome outcome = run_here(VYBEG_CLI, command, limit(RLIMIT_STACK, 512 << 10));
            VYBEG_EQUAL(outcome.status, 0, outcome.err);
        }
    }

    void too_few_threads_have_a_sentence_and_leave_nothing() {
        const QString program = copy_for_anyone(folder_.path());
        QVERIFY(!program.isEmpty());
        QVERIFY(QFile::setPermissions(folder_.path(), QFile::Permissions(0x7777)));
        QVERIFY(put(path("threads.csv"), "old"));
        QVERIFY(QFile::setPermissions(path("threads.csv"), QFile::Permissions(0x6666)));
        // The limit counts the processes of a user, and the superuser has none: a user without any.
        const uid_t user = geteuid() == 0 ? 61234 : geteuid();
        int refused = 0;
        bool done = false;
        for (rlim_t most = 1; !done && most < 64; ++most) {
            const Outcome outcome =
                run_here(program, {"analyze", "a.wav", "-o", "threads.csv"}, [user, most] {
                    limit(RLIMIT_NPROC, most)();
                    if (geteuid() == 0 && (setgid(user) != 0 || setuid(user) != 0)) {
                        _exit(99);
                    }
                });
            const QByteArray about = QByteArray::number(qulonglong(most)) + ": " +
                                     QByteArray::number(outcome.status) + " " + outcome.err;
            done = outcome.status == 0;
            if (!done) {
                ++refused;
                VYBEG_EQUAL(outcome.status, 4, about);
                QVERIFY2(outcome.err.startsWith("vybeg-cli: The system starts no more threads"),
                         about);
                QCOMPARE(file("threads.csv"), QByteArray("old"));
            }
            QVERIFY2(temporaries().isEmpty(), about);
            if (geteuid() != 0 && refused > 8) {
                break;  // of a user with other processes
            }
        }
        VYBEG_MORE(refused, 0);
    }
};

VYBEG_TEST(TestCliLimits, unsanitized)

}  // namespace test_cli_limits

#include "test_cli_limits.moc"
