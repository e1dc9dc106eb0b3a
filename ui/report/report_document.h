#pragma once

#include "core/base/result.h"
#include "ui/document/background_jobs.h"
#include "ui/report/report_content.h"
#include "ui/report/report_parts.h"

#include <QByteArray>
#include <QDate>
#include <QObject>
#include <QString>
#include <QStringList>

#include <functional>
#include <memory>
#include <vector>

namespace vybeg::ui {

// A report as text in the interface's language; figures are in it by their names
// (report_parts.h).
struct ReportText {
    QString title;   // of the document, and the head of each page
    QString author;  // empty: not stated
    QString program;
    QString foot;  // of each page, with %1 for its number and %2 for that of all
    QString html;
};

// Which program makes a report: name and version.
QString reportProgram();

// When a report is made: today, or as SOURCE_DATE_EPOCH says. A day, so that the same report made
// twice is the same bytes.
QDate reportDay();

// Head and foot of each page; its text begins with the title. `report`: its kind.
ReportText framedReport(const QString& report, const QString& about, const QString& program);

// Of one set or recording.
ReportText reportTextOf(const ReportContent& content, const QString& program = reportProgram(),
                        QDate made = reportDay());

// One set in a report of several.
struct ReportChapter {
    QStringList line;      // in the table of all sets: cells, each an HTML text
    QString html;          // its pages
    bool assumed = false;  // u holds tolerances that are not stated
};

// Of a content with a number.
ReportChapter chapterOf(const ReportContent& content);

// Of several sets: a table of all, then a chapter for each. `about`: what they are.
ReportText reportTextOf(const QString& about, const std::vector<ReportChapter>& chapters,
                        const DisplayUnits& units, const QString& program = reportProgram(),
                        QDate made = reportDay());

// A report as a PDF of A4 pages with head and page numbers: figures as vectors, text as text, fonts
// embedded, title and author in its metadata. Any thread may call it.
QByteArray reportPdf(const ReportText& text, const std::vector<ReportFigure>& figures);

// Writes reports while the window is in use: one figure in each turn of the event loop, because
// they need the window's thread; pages and file in the background.
class ReportWriter : public QObject {
    Q_OBJECT

public:
    // `done` is called in this thread. Errors: those of write_file().
    // A content is a report of its own, several are its chapters; `about` says of what.
    void write(const std::vector<ReportContent>& contents, const QString& about,
               const QString& path, std::function<void(const Status&)> done);

    // A text with its figures.
    void write(ReportText text, std::vector<ReportFigure> figures, const QString& path,
               std::function<void(const Status&)> done);

private:
    struct Work;
    void drawNext(const std::shared_ptr<Work>& work);

    BackgroundJobs job_;
    int key_ = 0;
};

}  // namespace vybeg::ui
