#include "tests/test_registry.h"

#include <QDir>
#include <QFile>
#include <QProcess>
#include <QTemporaryDir>
#include <QtTest>

namespace test_golden {

// `golden compare` of two folders with a text and a binary file each.
class TestGolden : public QObject {
    Q_OBJECT

    struct Compared {
        int status = -1;
        QByteArray told;
    };

    QTemporaryDir folder_;

    void put(const QString& name, const QByteArray& bytes) const {
        QFile file(folder_.filePath(name));
        if (!file.open(QIODevice::WriteOnly) || file.write(bytes) != bytes.size()) {
            qFatal("the test's file cannot be written");
        }
    }

    Compared compared(const QString& with = "two") const {
        QProcess golden;
        golden.setWorkingDirectory(folder_.path());
        golden.start(VYBEG_GOLDEN, {"compare", "one", with});
        if (!golden.waitForFinished() || golden.exitStatus() != QProcess::NormalExit) {
            return {};
        }
        return {golden.exitCode(), golden.readAllStandardOutput()};
    }

private slots:
    void init() {
        for (const QString one : {"one", "two"}) {
            QDir(folder_.filePath(one)).removeRecursively();
            QVERIFY(QDir(folder_.path()).mkpath(one + "/out"));
            put(one + "/out/stdout", "length 2 s\nrate 8000 Hz\n");
            put(one + "/out/track.npz", QByteArray("PK\0\1\2\3", 6));
        }
    }

    void equalFoldersHaveStatusZero() {
        const Compared found = compared();
        QCOMPARE(found.told, "2 files are equal, 0 differ\n");
        QCOMPARE(found.status, 0);
    }

    void aLineThatDiffersIsShown() {
        put("two/out/stdout", "length 2 s\nrate 8001 Hz\n");
        const Compared found = compared();
        QCOMPARE(found.told,
                 "out/stdout: differs from line 2 on\n  < rate 8000 Hz\n  > rate 8001 Hz\n"
                 "1 files are equal, 1 differ\n");
        QCOMPARE(found.status, 1);
    }

    void aMissingEndOfALineIsADifference() {
        put("two/out/stdout", "length 2 s\nrate 8000 Hz");
        const Compared found = compared();
        QVERIFY2(found.told.startsWith("out/stdout: differs"), found.told);
        QCOMPARE(found.status, 1);
    }

    void aByteThatDiffersIsNamed() {
        put("two/out/track.npz", QByteArray("PK\0\1\7\3", 6));
        const Compared found = compared();
        QCOMPARE(found.told,
                 "out/track.npz: differs from byte 4 on, 6 and 6 bytes\n"
                 "1 files are equal, 1 differ\n");
        QCOMPARE(found.status, 1);
    }

    void aMissingFileIsNamedOnEitherSide() {
        put("one/status", "0\n");
        QVERIFY(QFile::remove(folder_.filePath("one/out/stdout")));
        const Compared found = compared();
        QCOMPARE(found.told,
                 "status: only in one\nout/stdout: only in two\n1 files are equal, 2 differ\n");
        QCOMPARE(found.status, 1);
    }

    void aMissingFolderIsAnError() {
        QVERIFY(QDir(folder_.filePath("two")).removeRecursively());
        QCOMPARE(compared().status, 2);
    }

    // Nothing compared is no equality.
    void oneFolderOrEmptyFoldersAreAnError() {
        QCOMPARE(compared("one").status, 2);
        for (const QString one : {"one", "two"}) {
            QVERIFY(QDir(folder_.filePath(one)).removeRecursively());
            QVERIFY(QDir(folder_.path()).mkpath(one));
        }
        QCOMPARE(compared().status, 2);
    }
};

VYBEG_TEST(TestGolden)

}  // namespace test_golden

#include "test_golden.moc"
