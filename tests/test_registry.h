#pragma once

#include <QObject>

#include <memory>

namespace vybeg::test {

using MakeTest = std::unique_ptr<QObject> (*)();

// Adds a class to the test program that it is linked into; `name` has static storage.
bool register_test(const char* name, MakeTest make);

}  // namespace vybeg::test

// Registers a class of Qt Test; once a file, named as the file is: TestTextUnits in
// test_text_units.cpp. CTest runs each class in a process of its own. The words behind the class
// are its labels for CTest, which tests/CMakeLists.txt reads: a layer other than the folder's
// (statistical, long), `threads` for ThreadSanitizer, `alone` where nothing may run beside it.
#define VYBEG_TEST(Class, ...)                                         \
    static const bool registered_##Class = vybeg::test::register_test( \
        #Class, []() -> std::unique_ptr<QObject> { return std::make_unique<Class>(); });
