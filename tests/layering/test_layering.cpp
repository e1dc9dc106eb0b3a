#include "tests/layering/layering.h"

#include <QTemporaryDir>
#include <QtTest>

using namespace vybeg::test;

namespace {

// A source tree with the folders base and windows in core/, and one file of the given content.
class Tree {
public:
    Tree(const QString& file, const QByteArray& content) {
        write("core/CMakeLists.txt",
              "# order\nadd_subdirectory(base)\nadd_subdirectory(windows)\n");
        write(file, content);
    }

    QStringList violations() const { return layeringViolations(QDir(dir_.path())); }

private:
    void write(const QString& file, const QByteArray& content) {
        const QString path = dir_.filePath(file);
        QVERIFY(QDir().mkpath(QFileInfo(path).path()));
        QFile out(path);
        QVERIFY(out.open(QIODevice::WriteOnly));
        QCOMPARE(out.write(content), content.size());
    }

    QTemporaryDir dir_;
};

}  // namespace

class TestLayering : public QObject {
    Q_OBJECT

private slots:
    void theProjectKeepsItsLayers();
    void theOrderOfTheFoldersIsReadFromTheBuild();
    void aBrokenRuleIsFound_data();
    void aBrokenRuleIsFound();
    void whatTheRulesAllowIsNotReported_data();
    void whatTheRulesAllowIsNotReported();
    void aFileMayHaveFourHundredLinesAndNoMore();
};

void TestLayering::theProjectKeepsItsLayers() {
    const QStringList found = layeringViolations(QDir(VYBEG_ROOT));
    QVERIFY2(found.isEmpty(), qPrintable('\n' + found.join('\n')));
}

void TestLayering::theOrderOfTheFoldersIsReadFromTheBuild() {
    const QStringList folders = coreFolders(QDir(VYBEG_ROOT));
    QCOMPARE(folders.first(), "base");
    QVERIFY(folders.indexOf("recording") < folders.indexOf("windows"));
    QVERIFY(folders.indexOf("windows") < folders.indexOf("estimators"));
    QVERIFY(folders.indexOf("estimators") < folders.indexOf("track"));
    QVERIFY(folders.contains("recording"));
}

void TestLayering::aBrokenRuleIsFound_data() {
    QTest::addColumn<QString>("file");
    QTest::addColumn<QByteArray>("content");
    QTest::addColumn<QString>("report");

    const auto row = [](const char* name, const char* file, const char* content,
                        const char* report) {
        QTest::newRow(name) << file << QByteArray(content) << report;
    };
    row("Qt class in core", "core/base/a.h", "\n#include <QString>\n",
        "core/base/a.h:2: Qt: QString");
    row("Qt module in core", "core/base/a.cpp", "#include <QtCore/QString>\n",
        "core/base/a.cpp:1: Qt: QtCore/QString");
    row("Qt file in core", "core/windows/a.cpp", "# include  <qglobal.h>\n",
        "core/windows/a.cpp:1: Qt: qglobal.h");
    row("plot library in core", "core/base/a.cpp", "#include <qcustomplot.h>\n",
        "core/base/a.cpp:1: Qt: qcustomplot.h");
    row("later folder", "core/base/a.cpp", "#include \"core/windows/carrier.h\"\n",
        "core/base/a.cpp:1: a later folder of core/: core/windows/carrier.h");
    row("unlisted folder", "core/other/a.h", "#include <vector>\n",
        "core/other/a.h:1: its folder is not in core/CMakeLists.txt");
    row("ui in core", "core/windows/a.cpp", "#include \"ui/values/run.h\"\n",
        "core/windows/a.cpp:1: core/ includes ui/values/run.h");
    row("app in core", "core/windows/a.cpp", "#include \"app/cli.h\"\n",
        "core/windows/a.cpp:1: core/ includes app/cli.h");
    row("tests in core", "core/windows/a.cpp", "#include \"tests/a.h\"\n",
        "core/windows/a.cpp:1: core/ includes tests/a.h");
    row("app in ui", "ui/a.cpp", "#include \"app/gui_main.h\"\n",
        "ui/a.cpp:1: ui/ includes app/gui_main.h");
    row("ui in the command line", "app/cli_main.cpp", "#include \"ui/values/run.h\"\n",
        "app/cli_main.cpp:1: the command line includes ui/values/run.h");
    row("Qt in the command line", "app/cli_main.cpp", "#include <QCoreApplication>\n",
        "app/cli_main.cpp:1: Qt: QCoreApplication");
    row("desktop in the command line", "app/analysis_options.cpp",
        "#include \"app/gui_figure.h\"\n",
        "app/analysis_options.cpp:1: the command line includes app/gui_figure.h");
    row("not from the root", "core/base/a.cpp", "#include \"a.h\"\n",
        "core/base/a.cpp:1: not included from the root: a.h");
    row("relative", "ui/a.cpp", "#include \"../core/base/a.h\"\n",
        "ui/a.cpp:1: not included from the root: ../core/base/a.h");
}

void TestLayering::aBrokenRuleIsFound() {
    QFETCH(QString, file);
    QFETCH(QByteArray, content);
    QFETCH(QString, report);
    QCOMPARE(Tree(file, content).violations(), QStringList{report});
}

void TestLayering::whatTheRulesAllowIsNotReported_data() {
    QTest::addColumn<QString>("file");
    QTest::addColumn<QByteArray>("content");

    QTest::newRow("earlier and own folder")
        << "core/windows/a.cpp"
        << QByteArray(
               "#include \"core/base/a.h\"\n#include \"core/windows/a.h\"\n#include <queue>\n");
    QTest::newRow("Qt in ui") << "ui/a.cpp"
                              << QByteArray("#include \"core/windows/a.h\"\n#include <QWidget>\n");
    QTest::newRow("generated by moc") << "ui/a.cpp" << QByteArray("#include \"a.moc\"\n");
    QTest::newRow("desktop") << "app/gui_main.cpp"
                             << QByteArray(
                                    "#include \"ui/values/run.h\"\n#include <QApplication>\n");
    QTest::newRow("named in a comment")
        << "core/base/a.h" << QByteArray("// as #include <QString> would\n");
}

void TestLayering::whatTheRulesAllowIsNotReported() {
    QFETCH(QString, file);
    QFETCH(QByteArray, content);
    QCOMPARE(Tree(file, content).violations(), QStringList{});
}

void TestLayering::aFileMayHaveFourHundredLinesAndNoMore() {
    QCOMPARE(Tree("tests/a.cpp", QByteArray("\n").repeated(400)).violations(), QStringList{});
    QCOMPARE(Tree("tests/a.cpp", QByteArray("\n").repeated(401)).violations(),
             QStringList{"tests/a.cpp:401: longer than 400 lines"});
}

QTEST_GUILESS_MAIN(TestLayering)
#include "test_layering.moc"
