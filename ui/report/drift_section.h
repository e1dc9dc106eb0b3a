#pragma once

#include "ui/report/report_content.h"

#include <QString>

namespace vybeg::ui {

// The drift of the whole-angle logs, as HTML: logs, settings, the drift against the angle, its
// harmonics, and what they say of the resonator. Empty without logs.
QString wholeAngleSection(const ReportContent& content, bool new_page);

}  // namespace vybeg::ui
