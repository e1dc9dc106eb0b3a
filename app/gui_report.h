#pragma once

#include "core/analysis/identify_settings.h"
#include "core/analysis/settings.h"
#include "core/recording/samples/open_options.h"
#include "ui/report/report_content.h"

#include <stop_token>
#include <string>
#include <vector>

namespace vybeg::cli {

// What a report without a window is about, and where it goes.
struct ReportRequest {
    std::vector<std::string> inputs;
    std::string list;       // measurement list in place of inputs; empty: none
    std::string set;        // of the list alone; empty: all
    std::string report;     // .pdf
    ui::ReportTitle title;  // conditions of a list take precedence
    bool summary = false;   // one page a set
    OpenOptions open;
    Settings settings;    // of the list: where it has no others
    Tolerance tolerance;  // of the channels, likewise
};

// `vybeg FILE... --report REPORT.pdf`: the report of one recording, or of several as one set, or of
// a session;
// `vybeg --list LIST.csv --report REPORT.pdf`: of the sets of a measurement list, a chapter each,
// or of one of them. In the language of the system. What the title does not tell is a line to fill
// in by hand. Needs a QApplication, shows no window. Errors and warnings go to standard error;
// returns the exit status (help, files.html). A resonator that cannot be identified is no failure,
// nor is one of several sets without a result: the report gives the reason.
int write_report(const ReportRequest& request, std::stop_token stop);

}  // namespace vybeg::cli
