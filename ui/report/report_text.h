#pragma once

#include "ui/report/report_content.h"

#include <QDateTime>
#include <QString>
#include <QStringList>

#include <vector>

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

// Of one set or recording. `program`: name and version. `made`: when.
ReportText reportTextOf(const ReportContent& content, const QString& program,
                        const QDateTime& made);

// One set in a report of several.
struct ReportChapter {
    QStringList line;      // in the table of all sets: cells, each an HTML text
    QString html;          // its pages
    bool assumed = false;  // u holds tolerances that are not told
};

// Of a content with a number.
ReportChapter chapterOf(const ReportContent& content);

// Of several sets: a table of all, then a chapter for each. `about`: what they are.
ReportText reportTextOf(const QString& about, const std::vector<ReportChapter>& chapters,
                        const DisplayUnits& units, const QString& program, const QDateTime& made);

// Stands in the table for the page of a chapter, which the layout tells.
QString chapterMark(int number);

}  // namespace vybeg::ui
