#include "app/analysis_options.h"
#include "app/cli_interrupt.h"
#include "app/gui_figure.h"
#include "app/gui_screenshots.h"
#include "app/option_values.h"
#include "app/process_guard.h"
#include "core/analysis/setting_table.h"
#include "core/base/messages.h"
#include "core/output/output_file.h"
#include "ui/document/document.h"
#include "ui/session/session_keeper.h"
#include "ui/window/file_commands.h"
#include "ui/window/main_window.h"
#include "ui/words/language.h"

#include <QApplication>
#include <QIcon>
#include <QProcess>

#include <CLI/CLI.hpp>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <exception>
#include <optional>
#include <sstream>
#include <unistd.h>
#include <utility>

namespace {

using namespace vybeg;
using namespace vybeg::cli;

std::vector<std::int64_t> window_list(const std::string& option, const std::string& text) {
    constexpr const char* allowed = "whole numbers of samples from 5, with commas between them";
    const auto count = static_cast<std::size_t>(std::ranges::count(text, ',')) + 1;
    std::vector<std::int64_t> windows;
    for (const double value : list_value(option, text, count, allowed)) {
        if (value < 5 || value > 1e15 || value != std::floor(value)) {
            reject(option, text, allowed);
        }
        windows.push_back(static_cast<std::int64_t>(value));
    }
    return windows;
}

// The line is read before anything of Qt exists: --help and a wrong line need no display.
void describe(CLI::App& app, FigureRequest& request, std::string& screenshots) {
    app.name("vybeg");
    app.set_version_flag("--version", "vybeg " VYBEG_VERSION);
    app.add_option("FILE", request.inputs, "Recordings, measurement lists or sessions to open")
        ->type_name("");
    add_analysis_options(app, request.settings);
    add_open_options(app, request.open);
    app.add_option("--figure", request.figure,
                   "Draw the stacked plots into this file, without a window: .svg, .pdf or .png")
        ->type_name("FIGURE");
    add_value(app, "--windows", "N,N...",
              "With --figure: one column for each of these window lengths, samples",
              [&request](const std::string& option, const std::string& text) {
                  request.windows = window_list(option, text);
              })
        ->excludes(app.get_option("--window"))
        ->excludes(app.get_option("--periods"));
    app.add_option("--screenshots", screenshots,
                   "Write a picture of every page into this folder, in both languages, themes and "
                   "scales; without FILE of simulated recordings")
        ->type_name("DIR")
        ->excludes(app.get_option("--figure"));
    app.footer(
        "Without --figure and --screenshots the window opens, on the recordings named.\n"
        "Exit status: 0 done, 2 wrong usage, 3 the input cannot be read, 4 the analysis is "
        "impossible,\n5 the output cannot be written, 130 interrupted.");
}

int fail(const Error& error) {
    std::fprintf(stderr, "vybeg: %s\n", english(error).c_str());
    return exit_status(error.code);
}

int usage(std::string text) {
    std::ranges::replace(text, '\n', ' ');
    std::fprintf(stderr, "vybeg: %s\n", text.c_str());
    return 2;
}

constexpr const char* no_display =
    "There is no display to open a window on. Draw with --figure, or use vybeg-cli.";

bool platform_chosen() {
    return qEnvironmentVariableIsSet("QT_QPA_PLATFORM");
}

bool has_display() {
    return platform_chosen() || !qEnvironmentVariableIsEmpty("DISPLAY") ||
           !qEnvironmentVariableIsEmpty("WAYLAND_DISPLAY");
}

void name_application() {
    QCoreApplication::setOrganizationName(QStringLiteral("vybeg"));
    QCoreApplication::setApplicationName(QStringLiteral("vybeg"));
    QCoreApplication::setApplicationVersion(QStringLiteral(VYBEG_VERSION));
    QGuiApplication::setApplicationDisplayName(QStringLiteral("Vybeg"));
    QGuiApplication::setDesktopFileName(QStringLiteral("io.github.vybeg.Vybeg"));
}

// While Qt looks for its platform it warns of each one that does not work, and then aborts: of both
// the program makes one sentence and a status.
class PlatformSearch {
public:
    explicit PlatformSearch(bool window) {
        qInstallMessageHandler(window ? no_window : no_platform);
    }
    PlatformSearch(const PlatformSearch&) = delete;
    PlatformSearch& operator=(const PlatformSearch&) = delete;
    ~PlatformSearch() { qInstallMessageHandler(nullptr); }

private:
    static void no_window(QtMsgType type, const QMessageLogContext&, const QString&) {
        if (type == QtFatalMsg) {
            std::_Exit(usage(no_display));
        }
    }
    static void no_platform(QtMsgType type, const QMessageLogContext&, const QString&) {
        if (type == QtFatalMsg) {
            std::_Exit(usage("Qt cannot start the platform that QT_QPA_PLATFORM names. Unset it."));
        }
    }
};

int figure_mode(int argc, char** argv, const FigureRequest& request) {
    const InterruptGuard interrupt;
    if (!platform_chosen()) {
        qputenv("QT_QPA_PLATFORM", "offscreen");
    }
    std::optional<PlatformSearch> search(std::in_place, false);
    QApplication application(argc, argv);
    search.reset();
    name_application();
    ui::Language language;
    language.use(ui::Language::ofTheSystem());
    return draw_figure(request, interrupt.token());
}

// Scale 1 in this program, scale 2, which Qt reads at its start, in another.
int screenshot_mode(int argc, char** argv, const ScreenshotRequest& request) {
    if (!platform_chosen()) {
        qputenv("QT_QPA_PLATFORM", "offscreen");
    }
    constexpr const char* scale = "QT_SCALE_FACTOR";
    const bool both_scales = !qEnvironmentVariableIsSet(scale);
    std::optional<PlatformSearch> search(std::in_place, false);
    QApplication application(argc, argv);
    search.reset();
    name_application();
    int status = take_screenshots(request);
    if (status == 0 && both_scales) {
        QProcess twice;
        QProcessEnvironment environment = QProcessEnvironment::systemEnvironment();
        environment.insert(QLatin1String(scale), QStringLiteral("2"));
        twice.setProcessEnvironment(environment);
        twice.setProcessChannelMode(QProcess::ForwardedChannels);
        twice.start(QCoreApplication::applicationFilePath(), QCoreApplication::arguments().mid(1));
        twice.waitForFinished(-1);
        status = twice.exitStatus() == QProcess::NormalExit ? twice.exitCode() : 1;
    }
    return status;
}

int window_mode(int argc, char** argv, const FigureRequest& request) {
    std::optional<PlatformSearch> search(std::in_place, true);
    QApplication application(argc, argv);
    search.reset();
    name_application();
    QApplication::setWindowIcon(QIcon(QStringLiteral(":/icons/io.github.vybeg.Vybeg.svg")));
    ui::Document document;
    ui::MainWindow window(document);
    QStringList files;
    for (const std::string& input : request.inputs) {
        files << QString::fromStdString(input);
    }
    document.startWith(request.settings);
    window.show();
    window.session().offerAbandoned();
    window.files().open(files, request.open);
    return QApplication::exec();
}

int printed(const CLI::App& app, const CLI::ParseError& asked) {
    std::ostringstream text;
    const int status = app.exit(asked, text, text);
    OutputFile output = OutputFile::onto(STDOUT_FILENO, "standard output", JobControl());
    Status written = output.write(text.str());
    written = written ? output.commit() : written;
    return written ? status : fail(written.error());
}

int run(int argc, char** argv) {
    FigureRequest request;
    std::string screenshots;
    CLI::App app("Vybeg: standing waves in the free decay of a hemispherical resonator gyroscope.");
    describe(app, request, screenshots);
    let_repeated_options_parse(app);
    try {
        app.parse(argc, argv);
    } catch (const CLI::ParseError& error) {
        return error.get_exit_code() == 0 ? printed(app, error) : usage(error.what());
    }
    if (const std::string fault = usage_fault(app); !fault.empty()) {
        return usage(fault);
    }
    if (const Status valid = validate(request.settings); !valid) {
        return usage(english(valid.error()));
    }
    if (!screenshots.empty()) {
        return screenshot_mode(argc, argv, {screenshots, request.inputs, request.open});
    }
    if (!request.figure.empty()) {
        return request.inputs.empty() ? usage("--figure needs a recording to draw.")
                                      : figure_mode(argc, argv, request);
    }
    if (!request.windows.empty()) {
        return usage("--windows needs --figure.");
    }
    return has_display() ? window_mode(argc, argv, request) : usage(no_display);
}

}  // namespace

int main(int argc, char** argv) {
    open_missing_descriptors();
    make_write_signals_errors();
    end_with_a_sentence();
    try {
        return run(argc, argv);
    } catch (...) {
        return fail(error_of(std::current_exception()));
    }
}
