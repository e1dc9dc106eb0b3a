#include "app/analysis_options.h"
#include "app/cli_interrupt.h"
#include "app/gui_figure.h"
#include "app/option_values.h"
#include "core/base/messages.h"
#include "ui/language.h"
#include "ui/main_window.h"

#include <QApplication>
#include <QIcon>

#include <CLI/CLI.hpp>

#include <algorithm>
#include <cmath>
#include <cstdio>

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
void describe(CLI::App& app, FigureRequest& request) {
    app.name("vybeg");
    app.set_version_flag("--version", "vybeg " VYBEG_VERSION);
    app.add_option("FILE", request.inputs, "Recordings to open")->type_name("");
    add_analysis_options(app, request.settings);
    add_open_options(app, request.open);
    app.add_option("--figure", request.figure,
                   "Draw the stacked plots into this file, without a window: .svg, .pdf or .png")
        ->type_name("FIGURE");
    add_value(app, "--windows", "N,N...",
              "With --figure: one column for each of these window lengths, samples",
              [&request](const std::string& option, const std::string& text) {
                  request.windows = window_list(option, text);
              });
    app.footer(
        "Without --figure the window opens, on the recordings named.\n"
        "Exit status: 0 done, 2 wrong usage, 3 the input cannot be read, 4 the analysis is "
        "impossible,\n5 the output cannot be written, 130 interrupted.");
}

int usage(std::string text) {
    std::ranges::replace(text, '\n', ' ');
    std::fprintf(stderr, "vybeg: %s\n", text.c_str());
    return 2;
}

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

int figure_mode(int argc, char** argv, const FigureRequest& request) {
    const InterruptGuard interrupt;
    if (!platform_chosen()) {
        qputenv("QT_QPA_PLATFORM", "offscreen");
    }
    QApplication application(argc, argv);
    name_application();
    ui::Language language;
    language.use(ui::Language::ofTheSystem());
    return draw_figure(request, interrupt.token());
}

int window_mode(int argc, char** argv, const FigureRequest& request) {
    QApplication application(argc, argv);
    name_application();
    QApplication::setWindowIcon(QIcon(QStringLiteral(":/icons/io.github.vybeg.Vybeg.svg")));
    ui::MainWindow window;
    QStringList files;
    for (const std::string& input : request.inputs) {
        files << QString::fromStdString(input);
    }
    window.document().startWith(request.settings);
    window.show();
    window.document().open(files, request.open);
    return QApplication::exec();
}

}  // namespace

int main(int argc, char** argv) {
    FigureRequest request;
    CLI::App app("Vybeg: standing waves in the free decay of a hemispherical resonator gyroscope.");
    describe(app, request);
    try {
        app.parse(argc, argv);
    } catch (const CLI::ParseError& error) {
        return error.get_exit_code() == 0 ? app.exit(error) : usage(error.what());
    }
    if (const Status valid = validate(request.settings); !valid) {
        return usage(english(valid.error()));
    }
    if (!request.figure.empty()) {
        return request.inputs.empty() ? usage("--figure needs a recording to draw.")
                                      : figure_mode(argc, argv, request);
    }
    if (!request.windows.empty()) {
        return usage("--windows needs --figure.");
    }
    if (!has_display()) {
        return usage(
            "There is no display to open a window on. Draw with --figure, or use vybeg-cli.");
    }
    return window_mode(argc, argv, request);
}
