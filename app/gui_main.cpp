#include "app/cli_support.h"
#include "app/command_line.h"
#include "app/gui_drawing.h"
#include "app/process_guard.h"
#include "core/analysis/setting_table.h"
#include "core/base/diagnostic.h"
#include "core/base/error.h"
#include "core/base/result.h"
#include "core/recording/samples/open_options.h"
#include "core/recording/samples/open_table.h"
#include "ui/document/document.h"
#include "ui/session/session_keeper.h"
#include "ui/window/file_commands.h"
#include "ui/window/main_window.h"
#include "ui/words/language.h"

#include <QApplication>
#include <QIcon>

#include <CLI/CLI.hpp>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <exception>
#include <functional>
#include <span>
#include <stop_token>
#include <string>
#include <utility>
#include <vector>

namespace {

using namespace vybeg;
using namespace vybeg::cli;

std::vector<std::int64_t> window_list(const std::string& option, const std::string& text) {
    constexpr const char* allowed = "whole numbers of samples from 5, with commas between them";
    const auto count = static_cast<std::size_t>(std::ranges::count(text, ',')) + 1;
    std::vector<std::int64_t> windows;
    for (const double value : accepted(read_numbers(option, text, count, allowed))) {
        if (!within(bounds_of("window"), option, value) || value != std::floor(value)) {
            reject(option, text, allowed);
        }
        windows.push_back(static_cast<std::int64_t>(value));
    }
    return windows;
}

void add_report_options(CLI::App& app, GuiRequest& request) {
    CLI::Option* const report =
        add_text(app, "--report", "REPORT", request.report,
                 "Write a report of the recordings, as one set, into this file, without a window: "
                 ".pdf")
            ->excludes(app.get_option("--figure"));
    CLI::Option* const list =
        add_text(app, "--list", "LIST.csv", request.list,
                 "With --report: of the sets of this measurement list, a chapter each")
            ->needs(report)
            ->excludes(app.get_option("FILE"));
    add_text(app, "--set", "NAME", request.set, "Of this set of the list alone")->needs(list);
    app.add_flag("--summary", request.summary, "With --report: one page a set, to be signed")
        ->needs(report);
    for (const ui::TitleField& field : ui::title_fields) {
        const auto take = [&request, text = field.text](const std::string& told) {
            request.title.*text = QString::fromStdString(told);
        };
        app.add_option_function<std::string>("--" + std::string(field.option), take,
                                             "With --report: " + std::string(field.help))
            ->type_name("TEXT")
            ->needs(report);
    }
}

// The line is read before anything of Qt exists: --help and a wrong line need no display.
void describe(CLI::App& app, GuiRequest& request) {
    app.name("vybeg");
    app.set_version_flag("--version", "vybeg " VYBEG_VERSION);
    app.add_option("FILE", request.inputs, "Recordings, measurement lists or sessions to open")
        ->type_name("");
    add_analysis_options(app, analysis_settings(), request.settings);
    add_setting(app, *row_named(identify_settings(), "tolerance"), request.identify);
    add_settings(app, open_settings(), request.open);
    add_text(app, "--figure", "FIGURE", request.figure,
             "Draw the stacked plots into this file, without a window: .svg, .pdf or .png");
    add_value(app, "--windows", "N,N...",
              "With --figure: one column for each of these window lengths, samples",
              [&request](const std::string& option, const std::string& text) {
                  request.windows = window_list(option, text);
              })
        ->excludes(app.get_option("--window"))
        ->excludes(app.get_option("--periods"));
    add_report_options(app, request);
    app.footer(
        "Without --figure and --report the window opens, on the recordings named.\n"
        "Exit status: 0 done, 2 wrong usage, 3 the input cannot be read, 4 the analysis is "
        "impossible,\n5 the output cannot be written, 130 interrupted.");
}

int usage(std::string text) {
    std::ranges::replace(text, '\n', ' ');
    std::fprintf(stderr, "vybeg: %s\n", text.c_str());
    return 2;
}

constexpr const char* no_display =
    "There is no display to open a window on. Draw with --figure or --report, or use vybeg-cli.";
constexpr const char* no_platform =
    "Qt cannot start the platform that QT_QPA_PLATFORM names. Unset it.";

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
// the program makes this sentence and a status, until it takes the handler back.
void expect_platform(const char* sentence) {
    static const char* told = nullptr;
    told = sentence;
    qInstallMessageHandler([](QtMsgType type, const QMessageLogContext&, const QString&) {
        if (type == QtFatalMsg) {
            std::_Exit(usage(told));
        }
    });
}

// Without a window, on any platform of Qt.
int drawing_mode(int argc, char** argv, const std::function<int(std::stop_token)>& work) {
    const InterruptGuard interrupt;
    if (!platform_chosen()) {
        qputenv("QT_QPA_PLATFORM", "offscreen");
    }
    expect_platform(no_platform);
    QApplication application(argc, argv);
    qInstallMessageHandler(nullptr);
    name_application();
    ui::Language language;
    language.use(ui::Language::ofTheSystem());
    return work(interrupt.token());
}

int figure_mode(int argc, char** argv, const GuiRequest& request) {
    if (request.inputs.empty()) {
        return usage("--figure needs a recording to draw.");
    }
    if (request.identify.tolerance != Tolerance{}) {
        warn({{DiagnosticKind::option_without_effect,
               {"--tolerance", "a figure shows no resonator"}}});
    }
    return drawing_mode(argc, argv, [&](auto stop) { return ended(draw_figure(request, stop)); });
}

int report_mode(int argc, char** argv, const GuiRequest& request) {
    if (request.inputs.empty() && request.list.empty()) {
        return usage("--report needs a recording, or a --list of them.");
    }
    return drawing_mode(argc, argv, [&](auto stop) { return write_report(request, stop); });
}

int window_mode(int argc, char** argv, const GuiRequest& request) {
    expect_platform(no_display);
    QApplication application(argc, argv);
    qInstallMessageHandler(nullptr);
    name_application();
    QApplication::setWindowIcon(QIcon(QStringLiteral(":/icons/io.github.vybeg.Vybeg.svg")));
    ui::Document document;
    ui::MainWindow window(document);
    QStringList files;
    for (const std::string& input : request.inputs) {
        files << QString::fromStdString(input);
    }
    document.startWith(request.settings, request.identify.tolerance);
    window.show();
    window.session().offerAbandoned();
    window.files().open(files, request.open);
    return QApplication::exec();
}

int run(int argc, char** argv) {
    const std::span words(argv, static_cast<std::size_t>(argc));
    GuiRequest request;
    CLI::App app("Vybeg: standing waves in the free decay of a hemispherical resonator gyroscope.");
    describe(app, request);
    let_repeated_options_parse(app);
    try {
        app.parse(argc, argv);
    } catch (const CLI::ParseError& error) {
        return error.get_exit_code() == 0 ? ended(write_answer(app, error))
                                          : usage(parse_fault(app, error, words));
    }
    if (const std::string fault = usage_fault(app, words); !fault.empty()) {
        return usage(fault);
    }
    if (const Status valid = validate(request.settings); !valid) {
        return usage(english(valid.error()));
    }
    if (!request.figure.empty()) {
        return figure_mode(argc, argv, request);
    }
    if (!request.windows.empty()) {
        return usage("--windows needs --figure.");
    }
    if (!request.report.empty()) {
        return report_mode(argc, argv, request);
    }
    return has_display() ? window_mode(argc, argv, request) : usage(no_display);
}

}  // namespace

int main(int argc, char** argv) {
    open_missing_descriptors();
    make_write_signals_errors();
    end_with_a_sentence();
    // Qt writes the fonts of a PDF in the order of a hash: the same document is the same bytes.
    QHashSeed::setDeterministicGlobalSeed();
    try {
        if (const Status enough = check_stack(); !enough) {
            return fail(enough.error());
        }
        return run(argc, argv);
    } catch (...) {
        return fail(error_of(std::current_exception()));
    }
}
