// vybeg-pictures DIR [FILE...]: pictures of every page of the window, and their layout
// (../../README.md).
#include "app/command_line.h"
#include "core/recording/samples/open_table.h"
#include "tests/tools/pictures/pictures.h"

#include <QApplication>
#include <QFileInfo>
#include <QProcess>

#include <CLI/CLI.hpp>

#include <cstdio>
#include <exception>
#include <stdexcept>
#include <string>
#include <vector>

namespace {

using namespace vybeg;

constexpr const char* scale_variable = "QT_SCALE_FACTOR";
// Marks the process of one scale; a desktop may set the scale's own variable for all programs.
constexpr const char* child_variable = "VYBEG_PICTURES_OF_ONE_SCALE";

struct CommandLine {
    QString folder;
    std::vector<std::string> files;
    std::vector<std::string> sizes{"1280x720", "1600x1000", "1920x1080", "2560x1440"};
    std::vector<int> scales{1, 2};
    std::vector<std::string> pages;
    bool session = false;
    OpenOptions open;
};

// Absolute, as the pictures are made in a folder of their own.
QString absolute(const std::string& path) {
    return QFileInfo(QString::fromStdString(path)).absoluteFilePath();
}

QSize size_of(const std::string& text) {
    const QStringList sides = QString::fromStdString(text).split('x');
    const QSize size(sides.value(0).toInt(), sides.value(1).toInt());
    if (sides.size() != 2 || size.isEmpty()) {
        throw CLI::ValidationError("--size", text + " is not WIDTHxHEIGHT");
    }
    return size;
}

void describe(CLI::App& app, CommandLine& line) {
    app.name("vybeg-pictures");
    app.add_option_function<std::string>(
           "DIR", [&line](const std::string& path) { line.folder = absolute(path); },
           "Folder of the pictures and their layout.csv")
        ->required();
    app.add_option("FILE", line.files,
                   "Recordings to show; none: the demonstration, and a simulated set of four");
    app.add_option("--size", line.sizes, "Sizes of the window, WIDTHxHEIGHT,...")
        ->delimiter(',')
        ->allow_extra_args(false)
        ->capture_default_str();
    app.add_option("--pixel-ratio", line.scales,
                   "Pixels of the screen for each of the window, N,...")
        ->delimiter(',')
        ->allow_extra_args(false)
        ->capture_default_str();
    app.add_option("--page", line.pages, "Pages to show, NAME,...; all if none is named")
        ->delimiter(',')
        ->allow_extra_args(false);
    app.add_flag("--session", line.session,
                 "Write the session of the recordings into DIR, and no pictures");
    cli::add_settings(app, open_settings(), line.open);
}

// Qt reads the scale at its start: each scale is a process of its own.
int run_scales(const CommandLine& line, int argc, char** argv) {
    QStringList arguments;
    for (int i = 1; i < argc; ++i) {
        arguments << QString::fromLocal8Bit(argv[i]);
    }
    for (const int scale : line.scales) {
        QProcess process;
        QProcessEnvironment environment = QProcessEnvironment::systemEnvironment();
        environment.insert(QLatin1String(scale_variable), QString::number(scale));
        environment.insert(QLatin1String(child_variable), QStringLiteral("1"));
        process.setProcessEnvironment(environment);
        process.setProcessChannelMode(QProcess::ForwardedChannels);
        process.start(QFileInfo(QStringLiteral("/proc/self/exe")).canonicalFilePath(), arguments);
        process.waitForFinished(-1);
        if (process.exitStatus() != QProcess::NormalExit || process.exitCode() != 0) {
            return 1;
        }
    }
    return 0;
}

int run_one(const CommandLine& line, int argc, char** argv) {
    QApplication application(argc, argv);
    QCoreApplication::setApplicationVersion(QStringLiteral(VYBEG_VERSION));
    test::PictureRequest request{QDir(line.folder), {}, line.open, {}, {}};
    for (const std::string& file : line.files) {
        request.recordings << absolute(file);
    }
    for (const std::string& size : line.sizes) {
        request.sizes.push_back(size_of(size));
    }
    for (const std::string& page : line.pages) {
        request.pages << QString::fromStdString(page);
    }
    if (!QDir().mkpath(line.folder)) {
        throw std::runtime_error("The folder cannot be made: " + line.folder.toStdString());
    }
    if (line.session) {
        test::save_session(request);
    } else {
        test::make_pictures(request);
    }
    return 0;
}

}  // namespace

int main(int argc, char** argv) {
    CommandLine line;
    CLI::App app("Pictures of every page of the window, in both languages and themes.");
    describe(app, line);
    try {
        app.parse(argc, argv);
        for (const std::string& size : line.sizes) {
            size_of(size);
        }
        if (!qEnvironmentVariableIsSet("QT_QPA_PLATFORM")) {
            qputenv("QT_QPA_PLATFORM", "offscreen");
        }
        return line.session || qEnvironmentVariableIsSet(child_variable)
                   ? run_one(line, argc, argv)
                   : run_scales(line, argc, argv);
    } catch (const CLI::ParseError& error) {
        return app.exit(error) == 0 ? 0 : 2;
    } catch (const std::exception& error) {
        std::fprintf(stderr, "vybeg-pictures: %s\n", error.what());
        return 1;
    }
}
