#pragma once

#include <QDir>
#include <QFile>
#include <QTemporaryDir>

#include <clocale>
#include <string>

namespace vybeg::test {

// A C locale with decimal comma and thousands grouping while it lives, as QApplication sets one on
// a Russian or German desktop. It brings its own file, because a machine that builds need not have
// any such locale installed: glibc's compiled LC_NUMERIC, little-endian.
class CommaLocale {
public:
    CommaLocale() : before_(std::setlocale(LC_NUMERIC, nullptr)) {
        static constexpr unsigned char numeric[] = {
            0x14, 0x11, 0x03, 0x20, 6,    0,    0, 0,  // magic, fields
            0x20, 0,    0,    0,    0x22, 0,    0, 0,
            0x26, 0,    0,    0,  // where each field lies
            0x2c, 0,    0,    0,    0x30, 0,    0, 0,
            0x34, 0,    0,    0,  //
            ',',  0,    0xe2, 0x80, 0xaf, 0,    3, 3,
            0,    0,    0,    0,                       // comma, narrow space, groups of three
            ',',  0,    0,    0,    0x2f, 0x20, 0, 0,  // both as wide characters
            'U',  'T',  'F',  '-',  '8',  0};
        QDir(folder_.path()).mkdir("comma");
        QFile file(folder_.filePath("comma/LC_NUMERIC"));
        if (file.open(QIODevice::WriteOnly)) {
            file.write(reinterpret_cast<const char*>(numeric), sizeof numeric);
            file.close();
        }
        qputenv("LOCPATH", folder_.path().toLocal8Bit());
        std::setlocale(LC_NUMERIC, "comma");
        qunsetenv("LOCPATH");
    }
    ~CommaLocale() { std::setlocale(LC_NUMERIC, before_.c_str()); }
    CommaLocale(const CommaLocale&) = delete;
    CommaLocale& operator=(const CommaLocale&) = delete;

    // False where the system refused it: a test must then fail, not pass.
    bool active() const { return std::localeconv()->decimal_point == std::string(","); }

private:
    std::string before_;
    QTemporaryDir folder_;
};

}  // namespace vybeg::test
