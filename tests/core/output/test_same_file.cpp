#include "core/output/same_file.h"
#include "tests/test_registry.h"

#include <QtTest>

#include <filesystem>
#include <fstream>
#include <unistd.h>

namespace test_same_file {

using namespace vybeg;

class TestSameFile : public QObject {
    Q_OBJECT

    QTemporaryDir folder_;
    std::filesystem::path path(const char* name) const {
        return std::filesystem::path(folder_.path().toStdString()) / name;
    }

private slots:
    void initTestCase() {
        std::ofstream(path("there")) << "x";
        std::ofstream(path("copy")) << "x";
        std::filesystem::create_directory(path("sub"));
        std::filesystem::create_symlink(path("there"), path("soft"));
        std::filesystem::create_hard_link(path("there"), path("hard"));
        std::filesystem::create_directory_symlink(path(""), path("sub/back"));
    }

    void paths_to_one_file_are_one_data() {
        QTest::addColumn<QString>("one");
        QTest::addColumn<QString>("other");
        QTest::addColumn<bool>("same");
        const auto row = [](const char* one, const char* other, bool same) {
            QTest::addRow("%s %s", one, other) << one << other << same;
        };
        row("there", "there", true);
        row("there", "./there", true);
        row("there", "sub/../there", true);
        row("there", "sub/back/there", true);
        row("there", "soft", true);
        row("there", "hard", true);
        row("soft", "hard", true);
        row("there", "copy", false);
        row("there", "new", false);
        row("new", "new", true);
        row("new", "./new", true);
        row("new", "sub/../new", true);
        row("new", "sub/back/new", true);
        row("new", "other", false);
        row("new", "sub/new", false);
    }

    void paths_to_one_file_are_one() {
        QFETCH(QString, one);
        QFETCH(QString, other);
        QFETCH(bool, same);
        const auto first = path(qPrintable(one));
        const auto second = path(qPrintable(other));
        QCOMPARE(same_file(first, second), same);
        QCOMPARE(same_file(second, first), same);
    }

    void a_relative_path_is_one_in_the_current_folder() {
        const auto before = std::filesystem::current_path();
        std::filesystem::current_path(path(""));
        const bool same = same_file("new", path("new")) && same_file("there", path("there"));
        std::filesystem::current_path(before);
        QVERIFY(same);
    }

    void the_null_device_and_an_empty_path_are_no_file() {
        QVERIFY(!same_file("/dev/null", "/dev/null"));
        QVERIFY(same_file("/dev/full", "/dev/full"));
        QVERIFY(!same_file("", ""));
        QVERIFY(!same_file(path("there"), ""));
    }

    void a_dash_is_standard_output() {
        QVERIFY(!same_file("-", path("there")));
        const int kept = dup(STDOUT_FILENO);
        QVERIFY(std::freopen(path("there").c_str(), "a", stdout) != nullptr);
        const bool same = same_file("-", path("there")) && same_file("-", "/dev/stdout");
        std::fflush(stdout);
        dup2(kept, STDOUT_FILENO);
        close(kept);
        QVERIFY(same);
    }
};

VYBEG_TEST(TestSameFile)

}  // namespace test_same_file

#include "test_same_file.moc"
