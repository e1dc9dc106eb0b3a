#include "ui/report/report_writer.h"

#include "core/output/output_file.h"
#include "ui/report/report_figures.h"
#include "ui/report/report_pdf.h"
#include "ui/report/report_text.h"

#include <QCoreApplication>
#include <QTimer>

#include <filesystem>
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

void ReportWriter::write(const ReportContent& content, const QString& path,
                         std::function<void(const Status&)> done) {
    auto work = std::make_shared<Work>();
    work->figures = reportFigures(content);
    work->text =
        reportTextOf(content, QStringLiteral("Vybeg ") + QCoreApplication::applicationVersion(),
                     QDateTime::currentDateTime());
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
