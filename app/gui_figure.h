#pragma once

#include "core/analysis/settings.h"
#include "core/base/result.h"
#include "core/recording/samples/open_options.h"

#include <cstdint>
#include <stop_token>
#include <string>
#include <vector>

namespace vybeg::cli {

// `vybeg FILE... --figure FIGURE [--windows 6,60]`: the stacked plots, one column per recording and
// window length. Needs a QApplication, shows no window. Warnings go to standard error.
struct FigureRequest {
    std::vector<std::string> inputs;
    std::string figure;                 // its ending chooses SVG, PDF or PNG
    std::vector<std::int64_t> windows;  // empty: the window of the settings
    OpenOptions open;
    Settings settings;
};

Status draw_figure(const FigureRequest& request, std::stop_token stop);

}  // namespace vybeg::cli
