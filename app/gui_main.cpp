#include "app/cli_support.h"
#include "app/command_line.h"
#include "app/gui_analysis.h"
#include "app/gui_report.h"
#include "app/process_guard.h"
#include "core/analysis/idle_options.h"
#include "core/analysis/setting_table.h"
#include "core/analysis/settings.h"
#include "core/base/diagnostic.h"
#include "core/base/error.h"
#include "core/base/result.h"
#include "core/recording/samples/open_options.h"
#include "core/recording/samples/open_table.h"
#include "ui/document/document.h"
#include "ui/plots/figure.h"
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
#include <optional>
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
    for (const double value : list_value(option, text, count, allowed)) {
        if (!within(bounds_of("window"), option, value) || value != std::floor(value)) {
            reject(option, text, allowed);
        }
        windows.push_back(static_cast<std::int64_t>(value));
    }
    return windows;
}

// `vybeg FILE... --figure FIGURE [--windows 6,60]`: the stacked plots, one column per recording and
// window length. Needs a QApplication, shows no window. Warnings go to standard error.
struct FigureRequest {
    std::vector<std::string> inputs;
    std::string figure;                 // its ending chooses SVG, PDF or PNG
    std::vector<std::int64_t> windows;  // empty: the window of the settings
    OpenOptions open;
    Settings settings;
};

// The settings of the columns of one recording.
std::vector<Settings> columns_of(const FigureRequest& request) {
    if (request.windows.empty()) {
        return {request.settings};
    }
    std::vector<Settings> wanted;
    for (const std::int64_t window : request.windows) {
        Settings settings = request.settings;
        settings.window = window;
        settings.periods.reset();
        wanted.push_back(settings);
    }
    return wanted;
}

Status draw_figure(const FigureRequest& request, std::stop_token stop) {
    TRY(check_request("--figure", request.figure, request.inputs, request.settings));
    const JobControl job(stop);
    std::vector<ui::FigureColumn> columns;
    for (const std::string& input : request.inputs) {
        const auto recording = TRY(open_warned(input, request.open, job));
        for (const Settings& settings : columns_of(request)) {
            auto analysis = TRY(analyse_warned(recording, settings, job));
            ui::ShownAnalysis shown =
                shown_analysis(recording, std::move(analysis), static_cast<int>(columns.size()));
            const QString title = request.inputs.size() > 1
                                      ? QStringLiteral("%1, %2").arg(shown.recording, shown.name)
                                      : shown.name;
            columns.push_back({title, std::move(shown)});
        }
    }
    if (stop.stop_requested()) {
        return Error{ErrorCode::interrupted, {}, {}};
    }
    return ui::writeDrawing(ui::figureDrawing(columns), {ui::figureSize(columns.size(), {})},
                            QString::fromStdString(request.figure));
}

// What the command line asks for.
struct Requested {
    FigureRequest figure;
    ReportRequest report;       // its own part
    IdentifySettings identify;  // its tolerances
};

void add_report_options(CLI::App& app, Requested& requested) {
    CLI::Option* const report =
        app.add_option(
               "--report", requested.report.report,
               "Write a report of the recordings, as one set, into this file, without a window: "
               ".pdf")
            ->type_name("REPORT")
            ->excludes(app.get_option("--figure"));
    CLI::Option* const list =
        app.add_option("--list", requested.report.list,
                       "With --report: of the sets of this measurement list, a chapter each")
            ->type_name("LIST.csv")
            ->needs(report)
            ->excludes(app.get_option("FILE"));
    app.add_option("--set", requested.report.set, "Of this set of the list alone")
        ->type_name("NAME")
        ->needs(list);
    app.add_flag("--summary", requested.report.summary,
                 "With --report: one page a set, to be signed")
        ->needs(report);
    for (const ui::TitleField& field : ui::title_fields) {
        const auto take = [&requested, text = field.text](const std::string& told) {
            requested.report.title.*text = QString::fromStdString(told);
        };
        app.add_option_function<std::string>("--" + std::string(field.option), take,
                                             "With --report: " + std::string(field.help))
            ->type_name("TEXT")
            ->needs(report);
    }
}

// The line is read before anything of Qt exists: --help and a wrong line need no display.
void describe(CLI::App& app, Requested& requested) {
    FigureRequest& request = requested.figure;
    app.name("vybeg");
    app.set_version_flag("--version", "vybeg " VYBEG_VERSION);
    app.add_option("FILE", request.inputs, "Recordings, measurement lists or sessions to open")
        ->type_name("");
    add_analysis_options(app, request.settings);
    add_setting(app, *row_named(identify_settings(), "tolerance"), requested.identify);
    add_settings(app, open_settings(), request.open);
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
    add_report_options(app, requested);
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

// Without a window, on any platform of Qt.
int drawing_mode(int argc, char** argv, const std::function<int(std::stop_token)>& work) {
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
    return work(interrupt.token());
}

int figure_mode(int argc, char** argv, const Requested& requested) {
    if (requested.figure.inputs.empty()) {
        return usage("--figure needs a recording to draw.");
    }
    if (requested.identify.tolerance != Tolerance{}) {
        warn({{DiagnosticKind::option_without_effect,
               {"--tolerance", "a figure shows no resonator"}}});
    }
    return drawing_mode(argc, argv,
                        [&](auto stop) { return ended(draw_figure(requested.figure, stop)); });
}

int report_mode(int argc, char** argv, const Requested& requested) {
    const FigureRequest& request = requested.figure;
    if (request.inputs.empty() && requested.report.list.empty()) {
        return usage("--report needs a recording, or a --list of them.");
    }
    ReportRequest report = requested.report;
    report.inputs = request.inputs;
    report.open = request.open;
    report.settings = request.settings;
    report.tolerance = requested.identify.tolerance;
    return drawing_mode(argc, argv, [&](auto stop) { return write_report(report, stop); });
}

int window_mode(int argc, char** argv, const FigureRequest& request, const Tolerance& tolerance) {
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
    document.startWith(request.settings, tolerance);
    window.show();
    window.session().offerAbandoned();
    window.files().open(files, request.open);
    return QApplication::exec();
}

int run(int argc, char** argv) {
    const std::span words(argv, static_cast<std::size_t>(argc));
    Requested requested;
    CLI::App app("Vybeg: standing waves in the free decay of a hemispherical resonator gyroscope.");
    describe(app, requested);
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
    const FigureRequest& request = requested.figure;
    if (const Status valid = validate(request.settings); !valid) {
        return usage(english(valid.error()));
    }
    if (!request.figure.empty()) {
        return figure_mode(argc, argv, requested);
    }
    if (!request.windows.empty()) {
        return usage("--windows needs --figure.");
    }
    if (!requested.report.report.empty()) {
        return report_mode(argc, argv, requested);
    }
    return has_display() ? window_mode(argc, argv, request, requested.identify.tolerance)
                         : usage(no_display);
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
