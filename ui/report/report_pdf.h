#pragma once

#include "core/base/result.h"
#include "ui/document/background_jobs.h"
#include "ui/report/report_parts.h"
#include "ui/report/report_text.h"

#include <QByteArray>
#include <QObject>
#include <QString>

#include <functional>
#include <memory>
#include <vector>

namespace vybeg::ui {

// A report as a PDF of A4 pages with head and page numbers: figures as vectors, text as text, fonts
// embedded, title and author in its metadata. Any thread may call it.
QByteArray reportPdf(const ReportText& text, const std::vector<ReportPicture>& pictures);

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
