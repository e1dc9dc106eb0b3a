#pragma once

#include "ui/report/report_content.h"

#include <QDateTime>
#include <QString>

namespace vybeg::ui {

// A report as text in the interface's language; figures stand in it by their names
// (report_figures.h).
struct ReportText {
    QString title;   // of the document
    QString author;  // empty: not told
    QString program;
    QString head;  // of each page
    QString foot;  // of each page, with %1 for its number and %2 for that of all
    QString html;
};

// `program`: name and version. `made`: when.
ReportText reportTextOf(const ReportContent& content, const QString& program,
                        const QDateTime& made);

}  // namespace vybeg::ui
