// main() of every test program: TEST_PROGRAM CLASS [Qt Test's options] runs one class; without a
// class all of them, one after the other. VYBEG_TEST_WIDGETS: the classes need a QApplication.
#include "tests/test_registry.h"

#include <QtTest>

#include <algorithm>
#include <cstdio>
#include <string>
#include <string_view>
#include <vector>

#ifdef VYBEG_TEST_WIDGETS
#include <QApplication>
using Application = QApplication;
#else
#include <QCoreApplication>
using Application = QCoreApplication;
#endif

namespace vybeg::test {

namespace {

struct Registered {
    const char* name;
    MakeTest make;
};

std::vector<Registered>& registry() {
    static std::vector<Registered> classes;
    return classes;
}

}  // namespace

bool register_test(const char* name, MakeTest make) {
    registry().push_back({name, make});
    return true;
}

}  // namespace vybeg::test

int main(int argc, char** argv) {
    using namespace vybeg::test;
    std::ranges::sort(registry(), {},
                      [](const Registered& one) { return std::string_view(one.name); });
    std::vector<Registered> chosen = registry();
    if (argc > 1 && argv[1][0] != '-') {
        std::erase_if(chosen,
                      [&](const Registered& one) { return std::string_view(one.name) != argv[1]; });
        if (chosen.empty()) {
            std::fprintf(stderr, "%s has no class %s. It has:\n", argv[0], argv[1]);
            for (const Registered& one : registry()) {
                std::fprintf(stderr, "  %s\n", one.name);
            }
            return 2;
        }
        std::rotate(argv + 1, argv + 2, argv + argc);
        --argc;
    }
    Application application(argc, argv);
    QCoreApplication::setAttribute(Qt::AA_Use96Dpi);
    int failed = 0;
    for (const Registered& one : chosen) {
        failed += QTest::qExec(one.make().get(), argc, argv) != 0;
    }
    return failed;
}
