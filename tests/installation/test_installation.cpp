// `cmake --install` into a folder of its own: the programs run from there, and the tools that look
// over such files find no fault in what a desktop reads.
#include "tests/app/cli_run.h"
#include "tests/closeness.h"
#include "tests/core/recording/python_script.h"
#include "tests/test_registry.h"

#include <QDirIterator>
#include <QMimeDatabase>
#include <QStandardPaths>
#include <QtTest>

namespace test_installation {

using namespace vybeg::test;

class TestInstallation : public QObject {
    Q_OBJECT

private slots:
    void initTestCase() {
        qputenv("DESTDIR", stage_.path().toUtf8());
        const Outcome outcome = run_program(
            VYBEG_CMAKE, {"--install", VYBEG_BUILD, "--component", "program"}, stage_.path());
        qunsetenv("DESTDIR");
        VYBEG_EQUAL(outcome.status, 0, outcome.err.constData());
    }

    void every_file_has_its_place() {
        QStringList files;
        for (QDirIterator found(installed(""), QDir::Files, QDirIterator::Subdirectories);
             found.hasNext();) {
            files += QDir(installed("")).relativeFilePath(found.next());
        }
        files.sort();
        const QString id = "io.github.vybeg.Vybeg";
        QStringList expected{"bin/vybeg",
                             "bin/vybeg-cli",
                             "libexec/vybeg/vybeg-reader",
                             "share/applications/" + id + ".desktop",
                             "share/bash-completion/completions/vybeg",
                             "share/bash-completion/completions/vybeg-cli",
                             "share/doc/vybeg/CHANGELOG.md",
                             "share/doc/vybeg/CITATION.cff",
                             "share/doc/vybeg/copyright",
                             "share/icons/hicolor/scalable/apps/" + id + ".svg",
                             "share/man/man1/vybeg-cli.1",
                             "share/man/man1/vybeg.1",
                             "share/man/ru/man1/vybeg-cli.1",
                             "share/man/ru/man1/vybeg.1",
                             "share/metainfo/" + id + ".metainfo.xml",
                             "share/mime/packages/" + id + ".xml"};
        // Each page of the help, for a browser, as the program has it inside.
        const QDir help(VYBEG_ROOT "/resources/help");
        for (QDirIterator found(help.path(), QDir::Files, QDirIterator::Subdirectories);
             found.hasNext();) {
            const QString path = found.next();
            const QString place = "share/doc/vybeg/help/" + help.relativeFilePath(path);
            expected += place;
            QCOMPARE(content(installed(place)), content(path));
        }
        QVERIFY(expected.contains("share/doc/vybeg/help/ru/files.html"));
        expected.sort();
        QCOMPARE(files, expected);
    }

    void the_package_names_no_invented_address() {
        const QByteArray package = content(VYBEG_ROOT "/packaging/CMakeLists.txt");
        QVERIFY(package.contains("VYBEG_MAINTAINER \"The Vybeg developers ("));
        QVERIFY(!package.contains('@'));
    }

    void nothing_installed_names_the_build() {
        for (const char* program : {"bin/vybeg", "bin/vybeg-cli", "libexec/vybeg/vybeg-reader"}) {
            const QByteArray bytes = content(installed(program));
            QVERIFY(
                bytes.startsWith("\x7f"
                                 "ELF"));
            QVERIFY2(!bytes.contains(VYBEG_BUILD), program);
        }
    }

    void the_programs_run_from_where_they_are() {
        const QString cli = installed("bin/vybeg-cli");
        const QTemporaryDir work;
        Outcome done = run_program(cli, {"simulate", "--demo", "--seconds", "2", "-o", "demo.wav"},
                                   work.path());
        VYBEG_EQUAL(done.status, 0, done.err.constData());
        done = run_program(cli, {"analyze", "demo.wav", "-o", "track.csv"}, work.path());
        VYBEG_EQUAL(done.status, 0, done.err.constData());
        QVERIFY(content(work.filePath("track.csv")).contains("\nt_s,a_A,a_B,"));
        done = run_program(installed("bin/vybeg"), {"demo.wav", "--figure", "figure.pdf"},
                           work.path());
        VYBEG_EQUAL(done.status, 0, done.err.constData());
        QVERIFY(content(work.filePath("figure.pdf")).startsWith("%PDF-"));
    }

    void the_helper_is_found() {
        const QTemporaryDir work;
        run_python(work.path().toStdString(),
                   "import h5py\n"
                   "t = np.arange(8000) / 33333\n"
                   "with h5py.File('decay.h5', 'w') as f:\n"
                   "    f['x'] = np.stack([np.cos(33300 * t), np.sin(33300 * t)], axis=1)\n"
                   "    f['rate'] = 33333.0\n");
        const Outcome done =
            run_program(installed("bin/vybeg-cli"), {"info", "decay.h5", "--json"}, work.path());
        VYBEG_EQUAL(done.status, 0, done.err.constData());
        QCOMPARE(object(done.out)["frames"].toInt(), 8000);
        QVERIFY(object(done.out)["format"].toString().contains("HDF5"));

        // It is this helper that reads: without it there is a sentence that names it.
        QVERIFY(QFile::remove(installed("libexec/vybeg/vybeg-reader")));
        const Outcome without =
            run_program(installed("bin/vybeg-cli"), {"info", "decay.h5"}, work.path());
        QCOMPARE(without.status, 3);
        QVERIFY2(without.err.contains("vybeg-reader"), without.err.constData());
    }

    void every_statement_of_the_version_is_the_same() {
        const QByteArray version = VYBEG_VERSION;
        const QByteArray metainfo =
            content(installed("share/metainfo/io.github.vybeg.Vybeg.metainfo.xml"));
        // The newest release comes first.
        QVERIFY(metainfo.mid(metainfo.indexOf("<release "))
                    .startsWith("<release version=\"" + version));
        const int date_at = static_cast<int>(metainfo.indexOf(" date=\"")) + 7;
        const QByteArray date = metainfo.mid(date_at, 10);
        const QByteArray citation = content(VYBEG_ROOT "/CITATION.cff");
        QVERIFY(citation.contains("\nversion: " + version + "\n"));
        QVERIFY(citation.contains("\ndate-released: \"" + date + "\"\n"));
        QVERIFY(content(VYBEG_ROOT "/CHANGELOG.md").contains(version));
        for (const char* program : {"vybeg", "vybeg-cli"}) {
            const QByteArray page = content(installed(QString("share/man/man1/%1.1").arg(program)));
            QVERIFY(page.contains("\"" + date + "\" \"vybeg " + version + "\""));
            const Outcome told = run_program(installed(QString("bin/%1").arg(program)),
                                             {"--version"}, stage_.path());
            QCOMPARE(told.out, program + QByteArray(" ") + version + "\n");
        }
    }

    void tools_find_no_fault_data() {
        QTest::addColumn<QString>("tool");
        QTest::addColumn<QStringList>("arguments");
        const auto row = [](const char* tool, const QStringList& arguments) {
            QTest::newRow(tool) << tool << arguments;
        };
        row("appstreamcli",
            {"validate", "--no-net", "share/metainfo/io.github.vybeg.Vybeg.metainfo.xml"});
        row("desktop-file-validate", {"share/applications/io.github.vybeg.Vybeg.desktop"});
        row("xmllint", {"--noout", "share/mime/packages/io.github.vybeg.Vybeg.xml"});
        row("bash", {"-n", "share/bash-completion/completions/vybeg-cli"});
    }

    void tools_find_no_fault() {
        QFETCH(QString, tool);
        QFETCH(QStringList, arguments);
        if (QStandardPaths::findExecutable(tool).isEmpty()) {
            QSKIP(qPrintable(tool + " is NOT INSTALLED: " + arguments.last() + " is not checked."));
        }
        const Outcome outcome = run_program(tool, arguments, installed(""));
        VYBEG_EQUAL(outcome.status, 0, (outcome.out + outcome.err).constData());
        if (tool == "desktop-file-validate") {  // a hint has no status of its own
            QCOMPARE(outcome.out + outcome.err, QByteArray());
        }
    }

    void the_desktop_entry_and_the_types_of_files_agree() {
        const QString entry = QString::fromUtf8(
            content(installed("share/applications/io.github.vybeg.Vybeg.desktop")));
        const QString types =
            QString::fromUtf8(content(installed("share/mime/packages/io.github.vybeg.Vybeg.xml")));
        const QString session = "application/x-vybeg-session+json";
        QVERIFY(types.contains("<mime-type type=\"" + session + "\">"));
        QVERIFY(entry.contains("\nMimeType=" + session + ";"));
        QVERIFY(entry.contains("\nExec=vybeg %F\n"));
        const QString icon = "io.github.vybeg.Vybeg";
        QVERIFY(entry.contains("\nIcon=" + icon + "\n"));
        QVERIFY(QFile::exists(installed("share/icons/hicolor/scalable/apps/" + icon + ".svg")));
    }

    void names_of_files_have_their_types() {
        const QString tool = QStandardPaths::findExecutable("update-mime-database");
        const QString system_types = "/usr/share/mime/packages/freedesktop.org.xml";
        if (tool.isEmpty() || !QFile::exists(system_types)) {
            QSKIP("shared-mime-info is NOT INSTALLED: the types of files are not checked.");
        }
        QVERIFY(QFile::copy(system_types, installed("share/mime/packages/freedesktop.org.xml")));
        // Where both the tool and QMimeDatabase look.
        qputenv("XDG_DATA_DIRS", installed("share").toUtf8());
        qputenv("XDG_DATA_HOME", stage_.filePath("home").toUtf8());
        const Outcome updated = run_program(tool, {installed("share/mime")}, stage_.path());
        VYBEG_EQUAL(updated.status, 0, updated.err.constData());
        QCOMPARE(updated.err, QByteArray());

        const QMimeDatabase database;
        const auto type = [&database](const char* name) {
            return database.mimeTypeForFile(name, QMimeDatabase::MatchExtension);
        };
        QCOMPARE(type("gyro.vybeg").name(), QString("application/x-vybeg-session+json"));
        QVERIFY(type("gyro.vybeg").inherits("application/json"));
        QCOMPARE(type("autumn.vybeg-list.csv").name(), QString("text/x-vybeg-list"));
        QVERIFY(type("autumn.vybeg-list.csv").inherits("text/csv"));
        QCOMPARE(type("autumn.csv").name(), QString("text/csv"));
        QCOMPARE(type("vybeg-list.csv").name(), QString("text/csv"));
    }

private:
    QString installed(const QString& path) const { return stage_.filePath(prefix_ + path); }

    QTemporaryDir stage_;
    const QString prefix_ = QString(VYBEG_PREFIX "/").mid(1);
};

VYBEG_TEST(TestInstallation)

}  // namespace test_installation

#include "test_installation.moc"
