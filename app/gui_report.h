#pragma once

#include "app/gui_report_request.h"

#include <stop_token>

namespace vybeg::cli {

// `vybeg FILE... --report REPORT.pdf`: the report of one recording, or of several as one set, or of
// a session (gui_report_session.h);
// `vybeg --list LIST.csv --report REPORT.pdf`: of the sets of a measurement list, a chapter each,
// or of one of them. In the language of the system. What the title does not tell is a line to fill
// in by hand. Needs a QApplication, shows no window. Errors and warnings go to standard error;
// returns the exit status (help, files.html). A resonator that cannot be identified is no failure,
// nor is one of several sets without a result: the report gives the reason.
int write_report(const ReportRequest& request, std::stop_token stop);

}  // namespace vybeg::cli
