#pragma once

#include "core/recording/samples/open_options.h"

#include <QStringList>

#include <string>
#include <vector>

namespace vybeg::cli {

// `vybeg --screenshots DIR [FILE...]`: every page in both languages and themes, two sizes of the
// window, with no recording, one, and all of them, as PNG; without files with simulated
// recordings. The scale is that of QT_SCALE_FACTOR. Needs a QApplication; the engineer's own
// settings stay untouched. Returns the exit status (help, files.html).
struct ScreenshotRequest {
    std::string folder;
    std::vector<std::string> inputs;
    OpenOptions open;
};

int take_screenshots(const ScreenshotRequest& request);

}  // namespace vybeg::cli
