#include "tests/closeness.h"
#include "tests/layering/class_sizes.h"
#include "tests/layering/layering.h"
#include "tests/layering/source_tree.h"
#include "tests/test_registry.h"

#include <QTemporaryDir>
#include <QtTest>

namespace test_layering {

using namespace vybeg::test;

namespace {

// Classes that have grown too large, with their size. They may only shrink: lower a number with its
// class, take it out below largest_class, and add none.
const ClassCeilings ceilings{};

// A source tree with the folders base, recording/bytes, recording/text and windows in core/, words
// and window in ui/, and one file or several of the given content.
class Tree {
public:
    Tree() {
        write("core/CMakeLists.txt",
              "# order\nadd_subdirectory(base)\nadd_subdirectory(recording)\n"
              "add_subdirectory(windows)\n");
        write("core/recording/CMakeLists.txt", "add_subdirectory(bytes)\nadd_subdirectory(text)\n");
        write("ui/CMakeLists.txt", "add_subdirectory(words)\nadd_subdirectory(window)\n");
    }
    Tree(const QString& file, const QByteArray& content) : Tree() { write(file, content); }

    Tree& with(const QString& file, const QByteArray& content) {
        write(file, content);
        return *this;
    }

    QStringList violations(const ClassCeilings& of_classes = {}) const {
        return layeringViolations(QDir(dir_.path()), of_classes);
    }
    QMap<QString, int> sizes() const { return classSizes(readSources(QDir(dir_.path()))); }

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
    void theProjectKeepsItsLayers() {
        const QStringList found = layeringViolations(QDir(VYBEG_ROOT), ceilings);
        QVERIFY2(found.isEmpty(), qPrintable('\n' + found.join('\n')));
    }

    void theOrderOfTheFoldersIsReadFromTheBuild() {
        const QStringList core = foldersInOrder(QDir(VYBEG_ROOT), "core");
        const QStringList way{"core/base",
                              "core/recording/bytes",
                              "core/recording/samples",
                              "core/recording/text",
                              "core/recording/open",
                              "core/windows",
                              "core/estimators/wave",
                              "core/estimators/algorithms",
                              "core/track",
                              "core/resonator/results",
                              "core/analysis",
                              "core/output"};
        QCOMPARE(core.first(), way.first());
        for (qsizetype i = 1; i < way.size(); ++i) {
            QVERIFY2(core.contains(way[i]), qPrintable(way[i]));
            VYBEG_LESS(core.indexOf(way[i - 1]), core.indexOf(way[i]), qPrintable(way[i]));
        }
        const QStringList ui = foldersInOrder(QDir(VYBEG_ROOT), "ui");
        QCOMPARE(ui.first(), "ui/words");
        QVERIFY(ui.contains("ui/document"));
        VYBEG_LESS(ui.indexOf("ui/document"), ui.indexOf("ui/plots"));
        QCOMPARE(ui.last(), "ui/window");
    }

    void aBrokenRuleIsFound_data() {
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
        row("libhdf5 in the programs", "core/windows/a.cpp", "#include <hdf5.h>\n",
            "core/windows/a.cpp:1: libhdf5: hdf5.h");
        row("later folder", "core/base/a.cpp", "#include \"core/windows/carrier_search.h\"\n",
            "core/base/a.cpp:1: a later folder of core/: core/windows/carrier_search.h");
        row("later sub-folder", "core/recording/bytes/a.cpp",
            "#include \"core/recording/text/text_lines.h\"\n",
            "core/recording/bytes/a.cpp:1: a later folder of core/: "
            "core/recording/text/text_lines.h");
        row("later folder from a sub-folder", "core/recording/text/a.cpp",
            "#include \"core/windows/carrier_search.h\"\n",
            "core/recording/text/a.cpp:1: a later folder of core/: core/windows/carrier_search.h");
        row("beside the sub-folders", "core/recording/a.h", "#include <vector>\n",
            "core/recording/a.h:1: its folder is not in core/CMakeLists.txt");
        row("later folder of ui", "ui/words/a.cpp", "#include \"ui/window/main_window.h\"\n",
            "ui/words/a.cpp:1: a later folder of ui/: ui/window/main_window.h");
        row("beside the folders of ui", "ui/a.cpp", "#include <vector>\n",
            "ui/a.cpp:1: its folder is not in ui/CMakeLists.txt");
        row("unlisted folder", "core/other/a.h", "#include <vector>\n",
            "core/other/a.h:1: its folder is not in core/CMakeLists.txt");
        row("ui in core", "core/windows/a.cpp", "#include \"ui/values/run.h\"\n",
            "core/windows/a.cpp:1: core/ includes ui/values/run.h");
        row("app in core", "core/windows/a.cpp", "#include \"app/cli.h\"\n",
            "core/windows/a.cpp:1: core/ includes app/cli.h");
        row("tests in core", "core/windows/a.cpp", "#include \"tests/a.h\"\n",
            "core/windows/a.cpp:1: core/ includes tests/a.h");
        row("app in ui", "ui/words/a.cpp", "#include \"app/gui_main.h\"\n",
            "ui/words/a.cpp:1: ui/ includes app/gui_main.h");
        row("ui in the command line", "app/cli_main.cpp", "#include \"ui/values/run.h\"\n",
            "app/cli_main.cpp:1: the command line includes ui/values/run.h");
        row("Qt in the command line", "app/cli_main.cpp", "#include <QCoreApplication>\n",
            "app/cli_main.cpp:1: Qt: QCoreApplication");
        row("desktop in the command line", "app/command_line.cpp",
            "#include \"app/gui_drawing.h\"\n",
            "app/command_line.cpp:1: the command line includes app/gui_drawing.h");
        row("not from the root", "core/base/a.cpp", "#include \"a.h\"\n",
            "core/base/a.cpp:1: not included from the root: a.h");
        row("relative", "ui/words/a.cpp", "#include \"../../core/base/a.h\"\n",
            "ui/words/a.cpp:1: not included from the root: ../../core/base/a.h");
    }

    void aBrokenRuleIsFound() {
        QFETCH(QString, file);
        QFETCH(QByteArray, content);
        QFETCH(QString, report);
        QCOMPARE(Tree(file, content).violations(), QStringList{report});
    }

    void whatTheRulesAllowIsNotReported_data() {
        QTest::addColumn<QString>("file");
        QTest::addColumn<QByteArray>("content");

        QTest::newRow("earlier and own folder")
            << "core/windows/a.cpp"
            << QByteArray(
                   "#include \"core/base/a.h\"\n#include \"core/windows/a.h\"\n#include <queue>\n");
        QTest::newRow("earlier folder from and of a sub-folder")
            << "core/recording/text/a.cpp"
            << QByteArray("#include \"core/base/a.h\"\n#include \"core/recording/bytes/a.h\"\n");
        QTest::newRow("a sub-folder from a later folder")
            << "core/windows/a.cpp" << QByteArray("#include \"core/recording/text/a.h\"\n");
        QTest::newRow("earlier folder of ui")
            << "ui/window/a.cpp" << QByteArray("#include \"ui/words/a.h\"\n");
        QTest::newRow("Qt in ui") << "ui/words/a.cpp"
                                  << QByteArray(
                                         "#include \"core/windows/a.h\"\n#include <QWidget>\n");
        QTest::newRow("generated by moc")
            << "ui/words/a.cpp" << QByteArray("#include \"a.moc\"\n#include \"moc_a.cpp\"\n");
        QTest::newRow("desktop") << "app/gui_main.cpp"
                                 << QByteArray(
                                        "#include \"ui/values/run.h\"\n#include <QApplication>\n");
        QTest::newRow("named in a comment")
            << "core/base/a.h" << QByteArray("// as #include <QString> would\n");
    }

    void whatTheRulesAllowIsNotReported() {
        QFETCH(QString, file);
        QFETCH(QByteArray, content);
        QCOMPARE(Tree(file, content).violations(), QStringList{});
    }

    void aFileMayHaveSixHundredLinesAndNoMore() {
        QCOMPARE(Tree("tests/a.cpp", QByteArray("\n").repeated(600)).violations(), QStringList{});
        QCOMPARE(Tree("tests/a.cpp", QByteArray("\n").repeated(601)).violations(),
                 QStringList{"tests/a.cpp:601: longer than 600 lines"});
    }

    void aCircleOfUnitsIsFound() {
        // a -> b -> c -> a, where b closes it with its source.
        Tree tree("core/base/a.h", "#include \"core/base/b.h\"\n");
        tree.with("core/base/b.h", "\n")
            .with("core/base/b.cpp", "#include \"core/base/b.h\"\n#include \"core/base/c.h\"\n")
            .with("core/base/c.h", "#include \"core/base/a.h\"\n");
        QCOMPARE(tree.violations(),
                 QStringList{"circle of units: core/base/a <-> core/base/b <-> core/base/c"});
    }

    void aUnitThatTwoIncludeIsNoCircle() {
        Tree tree("core/base/a.h", "#include \"core/base/b.h\"\n#include \"core/base/c.h\"\n");
        tree.with("core/base/b.h", "#include \"core/base/c.h\"\n")
            .with("core/base/c.h", "\n")
            .with("core/base/c.cpp", "#include \"core/base/c.h\"\n");
        QCOMPARE(tree.violations(), QStringList{});
    }

    void aFolderMayHoldThirtyUnitsAndNoMore() {
        Tree tree;
        for (int unit = 0; unit < 30; ++unit) {
            tree.with(QString("core/base/a%1.h").arg(unit), "\n")
                .with(QString("core/base/a%1.cpp").arg(unit), "\n");
        }
        QCOMPARE(tree.violations(), QStringList{});
        tree.with("core/base/b.cpp", "\n");
        QCOMPARE(tree.violations(), QStringList{"core/base: 31 units, more than 30"});
    }

    void aClassIsCountedOverAllItsFiles() {
        Tree tree("ui/words/a.h",
                  "class A final : public B {\n"
                  "public:\n"
                  "    A();\n"
                  "    struct Inner {\n"
                  "        int size() const;\n"
                  "        std::vector<int> all{};\n"
                  "    };\n"
                  "};\n"
                  "\n"
                  "class Later;\n"
                  "struct Empty {};\n");
        tree.with("ui/words/a.cpp",
                  "#include \"ui/words/a.h\"\n"
                  "\n"
                  "struct Local {\n"
                  "    int x = 0;  // two\n"
                  "};\n"
                  "\n"
                  "int size() {\n"
                  "    return 1;\n"
                  "}\n"
                  "\n"
                  "A::A()\n"
                  "    : x_{1},\n"
                  "      y_(2) {}\n")
            .with("ui/words/a_more.cpp",
                  "#include \"ui/words/a.h\"\n"
                  "\n"
                  "std::optional<std::vector<int>> A::find(int x,\n"
                  "                                        int y) const {  // why\n"
                  "    if (x < y) {\n"
                  "        return B::find();\n"
                  "    }\n"
                  "    return {};\n"
                  "}\n"
                  "\n"
                  "int A::Inner::size() const {\n"
                  "    return 1;\n"
                  "}\n"
                  "\n"
                  "bool A::operator==(const A&) const = default;\n"
                  "const int A::most = std::max(1, 2);\n");
        const QMap<QString, int> sizes{{"ui/words/a.h: A", 8 + 3 + 7 + 3},
                                       {"ui/words/a.h: Empty", 1},
                                       {"ui/words/a.cpp: Local", 3}};
        QCOMPARE(tree.sizes(), sizes);
    }

    void aMemberCountsForTheClassThatItsSourceIncludes() {
        // Two classes of one name: a member belongs to the one whose header its source includes.
        Tree tree("ui/words/a.h", "class A {\n};\n");
        tree.with("ui/window/a.h", "class A {\n};\n")
            .with("ui/window/a.cpp", "#include \"ui/window/a.h\"\n\nvoid A::run() {\n}\n");
        const QMap<QString, int> sizes{{"ui/words/a.h: A", 2}, {"ui/window/a.h: A", 4}};
        QCOMPARE(tree.sizes(), sizes);
    }

    void aClassMayHaveFiveHundredLinesOrItsCeiling() {
        Tree tree("core/base/a.h", "struct A {\n" + QByteArray("\n").repeated(298) + "};\n");
        const auto withMember = [&tree](int lines) {
            tree.with("core/base/a.cpp", "#include \"core/base/a.h\"\nvoid A::run() {\n" +
                                             QByteArray("\n").repeated(lines - 2) + "}\n");
        };
        const QString a = "core/base/a.h: A";
        withMember(200);
        QCOMPARE(tree.violations(), QStringList{});
        QCOMPARE(tree.violations({{a, 600}}), QStringList{a + " needs no ceiling"});
        withMember(300);
        QCOMPARE(tree.violations(), QStringList{a + " has 600 lines, more than 500"});
        QCOMPARE(tree.violations({{a, 600}}), QStringList{});
        QCOMPARE(tree.violations({{a, 599}}), QStringList{a + " has 600 lines, more than 599"});
    }
};

VYBEG_TEST(TestLayering)

}  // namespace test_layering

#include "test_layering.moc"
