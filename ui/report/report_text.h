#pragma once

#include "ui/report/report_content.h"

#include <QDate>
#include <QString>
#include <QStringList>

#include <vector>

namespace vybeg::ui {

// A report as text in the interface's language; figures stand in it by their names
// (report_parts.h).
struct ReportText {
    QString title;   // of the document
    QString author;  // empty: not told
    QString program;
    QString head;  // of each page
    QString foot;  // of each page, with %1 for its number and %2 for that of all
    QString html;
};

// When a report is made: today, or as SOURCE_DATE_EPOCH says. A day, so that the same report made
// twice is the same bytes.
QDate reportDay();

// Title, head and foot of each page; its text begins with the title. `report`: what it is.
ReportText framedReport(const QString& report, const QString& about, const QString& program);

// Of one set or recording. `program`: name and version. `made`: reportDay().
ReportText reportTextOf(const ReportContent& content, const QString& program, QDate made);

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
                        const DisplayUnits& units, const QString& program, QDate made);

// Stands in the table for the page of a chapter, which the layout tells.
QString chapterMark(int number);

}  // namespace vybeg::ui
