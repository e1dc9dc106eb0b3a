#pragma once

#include "core/analysis/settings.h"
#include "core/analysis/tolerance.h"
#include "core/recording/samples/open_options.h"
#include "ui/report/report_content.h"

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

}  // namespace vybeg::cli
