#pragma once

#include "ui/report/report_content.h"

#include <QString>

namespace vybeg::ui {

// What a report tells of one set or recording, as HTML.

// `made`: when and by which program, a last row; empty: none.
QString titleBlock(const ReportTitle& title, const QString& made);

// From the recordings to the warnings; figures stand in it by their names (report_figures.h).
QString reportSections(const ReportContent& content);

}  // namespace vybeg::ui
