#include "ui/report/report_writer.h"

#include "core/output/output_file.h"
#include "ui/report/report_pdf.h"

#include <QCoreApplication>
#include <QTimer>

#include <algorithm>
#include <filesystem>
#include <iterator>
#include <utility>

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
    const QDate made = reportDay();
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
    std::vector<ReportFigure> figures;
    for (const ReportContent& content : contents) {
        std::ranges::move(reportFigures(content), std::back_inserter(figures));
    }
    write(textOf(contents, about), std::move(figures), path, std::move(done));
}

void ReportWriter::write(ReportText text, std::vector<ReportFigure> figures, const QString& path,
                         std::function<void(const Status&)> done) {
    auto work = std::make_shared<Work>();
    work->figures = std::move(figures);
    work->text = std::move(text);
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
