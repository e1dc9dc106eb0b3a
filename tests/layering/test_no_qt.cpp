#include "tests/closeness.h"
#include "tests/test_registry.h"

#include <QJsonArray>
#include <QJsonDocument>
#include <QJsonObject>
#include <QProcess>
#include <QTemporaryDir>
#include <QtTest>

namespace test_no_qt {

namespace {

struct Outcome {
    int status = -1;
    QString messages;
};

// The build's command for the first source, or batch of sources, of a folder, without the source
// and what comes of it.
QStringList commandOf(const QString& folder) {
    QFile file(VYBEG_COMPILE_COMMANDS);
    if (!file.open(QIODevice::ReadOnly)) {
        return {};
    }
    for (const QJsonValue& each : QJsonDocument::fromJson(file.readAll()).array()) {
        if (each["file"].toString().contains(folder)) {
            QStringList command = QProcess::splitCommand(each["command"].toString());
            for (const char* option : {"-o", "-c"}) {
                const auto at = command.indexOf(QLatin1String(option));
                if (at >= 0) {
                    command.remove(at, 2);
                }
            }
            return command;
        }
    }
    return {};
}

// Compiles a file of the given content as the build compiles core/: same compiler, same flags,
// and with Qt's include directories on top.
Outcome compileAsCore(const QByteArray& content) {
    const QTemporaryDir dir;
    const QString path = dir.filePath("sample.cpp");
    QFile source(path);
    if (!source.open(QIODevice::WriteOnly) || source.write(content) != content.size()) {
        return {};
    }
    source.close();

    QStringList arguments = commandOf("/core/base/");
    if (arguments.isEmpty()) {
        return {};
    }
    const QString program = arguments.takeFirst();
    // Not as precompiled, because Qt asks for -fPIC.
    arguments.removeAll(QStringLiteral("-Winvalid-pch"));
    for (const QString& folder : QString(VYBEG_QT_FOLDERS).split(':')) {
        arguments << "-I" + folder;
    }
    // The first error is the reason, and ends the compilation: what follows it is Qt's whole
    // header.
    arguments << "-fPIC"
              << "-Wfatal-errors"
              << "-fsyntax-only" << path;

    QProcess compiler;
    compiler.setProcessChannelMode(QProcess::MergedChannels);
    compiler.start(program, arguments);
    compiler.waitForFinished(120'000);
    return {compiler.exitStatus() == QProcess::NormalExit ? compiler.exitCode() : -1,
            QString::fromUtf8(compiler.readAll())};
}

QByteArray sample(const QByteArray& header) {
    return "#include \"core/base/result.h\"\n\n" +
           (header.isEmpty() ? "" : "#include <" + header + ">\n") +
           "namespace vybeg { int sample(); int sample() { return 1; } }\n";
}

}  // namespace

class TestNoQt : public QObject {
    Q_OBJECT

private slots:
    void aFileWithoutQtCompilesInCore() {
        const Outcome outcome = compileAsCore(sample(""));
        VYBEG_EQUAL(outcome.status, 0, qPrintable(outcome.messages));
    }

    void aQtIncludeDoesNotCompileInCore_data() {
        QTest::addColumn<QByteArray>("header");
        for (const char* header :
             {"QtGlobal", "qglobal.h", "QString", "QObject", "QList", "QtMath"}) {
            QTest::newRow(header) << QByteArray(header);
        }
    }

    void aQtIncludeDoesNotCompileInCore() {
        QFETCH(QByteArray, header);
        const Outcome outcome = compileAsCore(sample(header));
        VYBEG_MORE(outcome.status, 0);
        // For this reason and for no other, such as a header that was not found.
        QVERIFY2(outcome.messages.contains("poisoned"), qPrintable(outcome.messages));
        QVERIFY2(!outcome.messages.contains("No such file"), qPrintable(outcome.messages));
    }
};

VYBEG_TEST(TestNoQt)

}  // namespace test_no_qt

#include "test_no_qt.moc"
