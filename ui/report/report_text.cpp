#include "ui/report/report_text.h"

#include "ui/report/report_html.h"
#include "ui/report/report_sections.h"
#include "ui/resonator/parameter_text.h"
#include "ui/resonator/resonator_text.h"
#include "ui/words/number_label.h"
#include "ui/words/rich_text.h"
#include "ui/words/unit_text.h"

#include <QDateTime>

#include <algorithm>

namespace vybeg::ui {

namespace {

QString madeText(const QString& program, QDate made) {
    return QStringLiteral("%1, %2").arg(made.toString(Qt::ISODate), program);
}

// "Set, gyro" where they differ.
QString nameOf(const ReportContent& content) {
    const QString& gyro = content.title.gyro;
    return gyro.isEmpty() || gyro == content.set ? content.set
                                                 : QStringLiteral("%1, %2").arg(content.set, gyro);
}

QStringList lineOf(const ReportContent& content) {
    QStringList cells{nameOf(content).toHtmlEscaped(), chapterMark(content.chapter)};
    if (!content.outcome) {
        return cells << richText(absenceText(content));
    }
    const ResonatorEstimate& resonator = content.outcome->identification.fit.resonator;
    const auto add = [&cells](const Estimate& estimate, double factor) {
        cells << (estimate.given()
                      ? valueText(factor * estimate.value, factor * estimate.uncertainty())
                      : QStringLiteral("—"));
    };
    add(resonator.f_mean_hz, 1);
    add(resonator.split_hz, 1e3);
    add(resonator.theta_w_rad, angleFactor(content.units));
    add(resonator.q, 1);
    return cells;
}

}  // namespace

ReportText framedReport(const QString& report, const QString& about, const QString& program) {
    ReportText text;
    text.title = QStringLiteral("%1: %2").arg(report, about);
    text.program = program;
    text.head = text.title;
    text.foot = ReportWords::tr("Page %1 of %2");
    text.html = QStringLiteral("<h1>%1</h1>").arg(report.toHtmlEscaped());
    return text;
}

QDate reportDay() {
    bool told = false;
    const qint64 seconds = qEnvironmentVariable("SOURCE_DATE_EPOCH").toLongLong(&told);
    const QDate day = QDateTime::fromSecsSinceEpoch(seconds, Qt::UTC).date();
    return told && day.isValid() ? day : QDate::currentDate();
}

ReportText reportTextOf(const ReportContent& content, const QString& program, QDate made) {
    QString about = content.title.gyro;
    if (about.isEmpty() && !content.recordings.empty()) {
        about = content.recordings.front().name;
        if (content.recordings.size() > 1) {
            about += QStringLiteral(" … ") + content.recordings.back().name;
        }
    }
    if (about.isEmpty() && ofLogsAlone(content)) {
        const std::vector<WholeAngleLog>& logs = content.drift->logs;
        about = QString::fromStdString(logs.front().name);
        if (logs.size() > 1) {
            about += QStringLiteral(" … ") + QString::fromStdString(logs.back().name);
        }
    }
    ReportText text =
        framedReport(ofLogsAlone(content) ? ReportWords::tr("Report of whole-angle logs")
                                          : ReportWords::tr("Report of a free decay"),
                     about, program);
    text.author = content.title.engineer;
    text.html += titleBlock(content.title, madeText(program, made)) + reportSections(content);
    return text;
}

ReportChapter chapterOf(const ReportContent& content) {
    const bool assumed = content.outcome && anyAssumed(content.outcome->identification.settings);
    return {lineOf(content),
            QStringLiteral("<h1 style=\"page-break-before:always\">%1</h1>")
                    .arg(content.set.toHtmlEscaped()) +
                titleBlock(content.title, {}) + reportSections(content),
            assumed};
}

ReportText reportTextOf(const QString& about, const std::vector<ReportChapter>& chapters,
                        const DisplayUnits& units, const QString& program, QDate made) {
    const auto head = [](const QString& text, const QString& unit = {}) {
        return richText(withUnit(text, unit));
    };
    HtmlTable table{{head(ReportWords::tr("Set, gyro")), head(ReportWords::tr("Page")),
                     head(ReportWords::tr("Mean f"), unitText("Hz")),
                     head(ReportWords::tr("Split Δf"), siPrefix(-3) + unitText("Hz")),
                     head(ReportWords::tr("Axis θ_w"), angleUnit(units)),
                     head(ReportWords::tr("Quality factor Q"))},
                    {},
                    {17, 7, 25, 23, 14, 14},
                    true};
    const QString combined =
        std::ranges::any_of(chapters, &ReportChapter::assumed)
            ? ReportWords::tr(
                  "Values with their combined standard uncertainties u, with assumed tolerances of "
                  "the channels. A dash: the recordings do not show it; the page of the set gives "
                  "the reason.")
            : ReportWords::tr(
                  "Values with their combined standard uncertainties u. A dash: the recordings do "
                  "not show it; the page of the set gives the reason.");
    QString pages;
    for (const ReportChapter& chapter : chapters) {
        table.rows.push_back(chapter.line);
        pages += chapter.html;
    }
    ReportText text = framedReport(ReportWords::tr("Report of free decays"), about, program);
    text.html += paragraph(QStringLiteral("%1: %2").arg(ReportWords::tr("Report made"),
                                                        madeText(program, made))) +
                 heading(ReportWords::tr("All sets")) + paragraph(combined) + html(table) + pages;
    return text;
}

QString chapterMark(int number) {
    return QStringLiteral("⟦%1⟧").arg(number);
}

}  // namespace vybeg::ui
