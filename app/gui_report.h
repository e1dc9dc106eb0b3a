#pragma once

#include "core/analysis/settings.h"
#include "core/analysis/tolerance.h"
#include "core/recording/samples/open_options.h"

#include <stop_token>
#include <string>
#include <vector>

namespace vybeg::cli {

// `vybeg FILE... --report REPORT.pdf`: the report of one recording, or of several as one set, in
// the language of the system. Gyro, operator and comment are lines to fill in by hand. Needs a
// QApplication, shows no window. Errors and warnings go to standard error; returns the exit status
// of INTERFACE.md. A resonator that cannot be identified is no failure: the report gives the
// reason.
struct ReportRequest {
    std::vector<std::string> inputs;
    std::string report;  // .pdf
    OpenOptions open;
    Settings settings;
    Tolerance tolerance;  // of the channels
};

int write_report(const ReportRequest& request, std::stop_token stop);

}  // namespace vybeg::cli
