#pragma once

#include "app/gui_report_request.h"

#include <stop_token>

namespace vybeg::cli {

// `vybeg SESSION.vybeg --report REPORT.pdf`: the session is opened and computed without a window;
// its set, or all of its sets, are the report, without a set its current recording. What the
// request's title does not tell is that of the session's gyro. As write_report().
int write_session_report(const ReportRequest& request, std::stop_token stop);

}  // namespace vybeg::cli
