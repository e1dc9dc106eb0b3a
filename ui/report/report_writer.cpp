#include "ui/report/report_writer.h"

#include "core/output/output_file.h"
#include "ui/report/report_figures.h"
#include "ui/report/report_pdf.h"
#include "ui/report/report_text.h"

#include <QCoreApplication>
#include <QTimer>

#include <algorithm>
#include <filesystem>
#include <iterator>
#include <utility>
#include <vector>

namespace vybeg::ui {

struct ReportWriter::Work {
    std::vector<ReportFigure> figures;
    std::vector<ReportPicture> pictures;  // as many as are drawn
    ReportText text;
    QString path;
    std::function<void(const Status&)> done;
};

namespace {

ReportText textOf(const std::vector<ReportContent>& contents, const QString& about) {
    const QString program = QStringLiteral("Vybeg ") + QCoreApplication::applicationVersion();
    const QDateTime made = QDateTime::currentDateTime();
    if (contents.size() == 1) {
        return reportTextOf(contents.front(), program, made);
    }
    std::vector<ReportChapter> chapters;
    std::ranges::transform(contents, std::back_inserter(chapters), chapterOf);
    return reportTextOf(about, chapters, contents.front().units, program, made);
}

}  // namespace

void ReportWriter::write(const std::vector<ReportContent>& contents, const QString& about,
                         const QString& path, std::function<void(const Status&)> done) {
    auto work = std::make_shared<Work>();
    for (const ReportContent& content : contents) {
        std::ranges::move(reportFigures(content), std::back_inserter(work->figures));
    }
    work->text = textOf(contents, about);
    work->path = path;
    work->done = std::move(done);
    drawNext(work);
}

void ReportWriter::drawNext(const std::shared_ptr<Work>& work) {
    if (work->pictures.size() < work->figures.size()) {
        work->pictures.push_back(drawn(work->figures[work->pictures.size()]));
        QTimer::singleShot(0, this, [this, work] { drawNext(work); });
        return;
    }
    job_.write(
        ++key_,
        [work](const JobControl& job) {
            const QByteArray pdf = reportPdf(work->text, work->pictures);
            return write_file(std::filesystem::path(work->path.toStdU16String()),
                              {pdf.constData(), static_cast<std::size_t>(pdf.size())}, job);
        },
        [work](const Status& status) { work->done(status); });
}

}  // namespace vybeg::ui
