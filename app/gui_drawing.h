#pragma once

#include "app/cli_support.h"
#include "core/analysis/identify_settings.h"
#include "core/analysis/settings.h"
#include "core/base/diagnostic.h"
#include "core/base/result.h"
#include "ui/report/report_content.h"

#include <cstdint>
#include <stop_token>
#include <string>
#include <vector>

namespace vybeg::cli {

// What the desktop program draws without a window. Errors and warnings go to standard error, one
// line each.

// Returns the exit status (help, files.html).
int fail(const Error& error);
int ended(const Status& done);
void warn(const std::vector<Diagnostic>& diagnostics);

// What the command line asks for.
struct GuiRequest : NamedRecordings {
    Settings settings;          // of a list: where it has no others
    IdentifySettings identify;  // the tolerance of the channels alone, likewise

    std::string figure;                 // its ending chooses SVG, PDF or PNG
    std::vector<std::int64_t> windows;  // of it; empty: the window of the settings

    std::string report;     // .pdf
    ui::ReportTitle title;  // conditions of a list take precedence
    bool summary = false;   // one page a set
};

// `vybeg FILE... --figure FIGURE [--windows 6,60]`: the stacked plots, one column per recording and
// window length. Needs a QApplication, shows no window. Warnings go to standard error.
Status draw_figure(const GuiRequest& request, std::stop_token stop);

// `vybeg FILE... --report REPORT.pdf`: the report of one recording, or of several as one set, or of
// a session;
// `vybeg --list LIST.csv --report REPORT.pdf`: of the sets of a measurement list, a chapter each,
// or of one of them. In the language of the system. An empty field of the title is a line to fill
// in by hand. Needs a QApplication, shows no window. Errors and warnings go to standard error;
// returns the exit status (help, files.html). A resonator that cannot be identified is no failure,
// nor is one of several sets without a result: the report gives the reason.
int write_report(const GuiRequest& request, std::stop_token stop);

}  // namespace vybeg::cli
