#include "core/output/output_file.h"
#include "tests/test_registry.h"

#include <QtTest>

#include <csignal>
#include <fcntl.h>
#include <sys/file.h>
#include <sys/wait.h>
#include <unistd.h>

namespace test_temporary_file {

using namespace vybeg;

class TestTemporaryFile : public QObject {
    Q_OBJECT

    QTemporaryDir folder_;

    std::filesystem::path folder() const { return folder_.path().toStdString(); }
    QStringList entries() const {
        return QDir(folder_.path())
            .entryList(QDir::AllEntries | QDir::Hidden | QDir::NoDotAndDotDot);
    }
    void put(const QString& name) const {
        QFile file(folder_.filePath(name));
        QVERIFY(file.open(QIODevice::WriteOnly));
    }

private slots:
    void cleanup() {
        for (const QString& name : entries()) {
            QFile::remove(folder_.filePath(name));
        }
    }

    void names_tell_the_process_and_differ() {
        const TemporaryFile one = make_temporary(folder());
        const TemporaryFile other = make_temporary(folder());
        QVERIFY(one.descriptor);
        QVERIFY(other.descriptor);
        QVERIFY(one.path != other.path);
        const QRegularExpression form(
            QStringLiteral("^\\.vybeg-%1-[1-9][0-9]*-[0-9]+\\.part$").arg(getpid()));
        for (const QString& name : entries()) {
            QVERIFY2(form.match(name).hasMatch(), qPrintable(name));
        }
        QCOMPARE(entries().size(), 2);
        const TemporaryFile none = make_temporary(folder() / "missing");
        QVERIFY(!none.descriptor);
        QCOMPARE(none.error, ENOENT);
    }

    void what_a_killed_process_leaves_is_removed_and_not_before() {
        int ready[2];
        QCOMPARE(pipe(ready), 0);
        const pid_t child = fork();
        if (child == 0) {
            const TemporaryFile file = make_temporary(folder());
            const char sign = file.descriptor ? 'y' : 'n';
            [[maybe_unused]] const auto told = write(ready[1], &sign, 1);
            pause();
            _exit(0);
        }
        char sign = 0;
        QCOMPARE(read(ready[0], &sign, 1), ssize_t{1});
        QCOMPARE(sign, 'y');
        QCOMPARE(entries().size(), 1);
        remove_abandoned(folder());
        QCOMPARE(entries().size(), 1);
        QCOMPARE(kill(child, SIGKILL), 0);
        QCOMPARE(waitpid(child, nullptr, 0), child);
        QCOMPARE(entries().size(), 1);
        remove_abandoned(folder());
        QCOMPARE(entries(), QStringList());
        close(ready[0]);
        close(ready[1]);
    }

    void only_our_names_of_processes_that_are_gone_are_removed() {
        // No process has such a number: the system's largest is 2^22.
        const QStringList gone{".vybeg-4194305-7-0.part", ".vybeg-4194305-0.part",
                               ".vybeg-1-999999999999-0.part"};
        const QStringList others{".vybeg-4194305-7-0.csv", ".vybeg-4194305-7-x.part",
                                 ".vybeg-.part",           ".vybeg--1-2-3.part",
                                 "vybeg-4194305-7-0.part", ".vybeg-4194305-7-0-1.part",
                                 ".vybeg-1-0.part"};
        for (const QString& name : gone + others) {
            put(name);
        }
        QCOMPARE(entries().size(), gone.size() + others.size());
        remove_abandoned(folder());
        QStringList expected = others;
        expected.sort();
        QStringList left = entries();
        left.sort();
        QCOMPARE(left, expected);
    }

    void a_locked_file_stays_whoever_holds_it() {
        // As of a process of another machine or container that shares the folder.
        const QString name = QStringLiteral(".vybeg-4194305-7-0.part");
        put(name);
        const int descriptor = open(qPrintable(folder_.filePath(name)), O_RDWR | O_CLOEXEC);
        QCOMPARE(flock(descriptor, LOCK_EX), 0);
        remove_abandoned(folder());
        QCOMPARE(entries(), QStringList{name});
        close(descriptor);
        remove_abandoned(folder());
        QCOMPARE(entries(), QStringList());
    }

    void a_link_is_not_followed() {
        put("precious");
        QVERIFY(
            QFile::link(folder_.filePath("precious"), folder_.filePath(".vybeg-4194305-7-0.part")));
        remove_abandoned(folder());
        QVERIFY(entries().contains("precious"));
    }
};

VYBEG_TEST(TestTemporaryFile)

}  // namespace test_temporary_file

#include "test_temporary_file.moc"
