#include "ui/history/history_export.h"

#include "core/base/number_text.h"
#include "core/output/batch_csv.h"
#include "ui/report/report_parts.h"
#include "ui/words/program_name.h"
#include "ui/words/rich_text.h"

#include <utility>

namespace vybeg::ui {

namespace {

// As a column of the view `history` of the database: "mode_0_f_hz".
std::string columnOf(const HistoryParameter& parameter) {
    return QString::fromStdString(parameter.name)
        .replace(QLatin1String("modes["), QLatin1String("mode_"))
        .replace(QLatin1String("]."), QLatin1String("_"))
        .toStdString();
}

// The charts in which a point lies outside.
std::string outsideCodes(const HistoryCharts& charts, std::size_t point) {
    std::string codes;
    for (const auto& [chart, code] : {std::pair{&charts.control.individuals, "value"},
                                      std::pair{&charts.control.ranges, "step"},
                                      std::pair{&charts.control.average, "average"}}) {
        if (chart->out[point]) {
            codes += codes.empty() ? "" : ";";
            codes += code;
        }
    }
    return codes;
}

std::string tableOf(const HistoryView& view, const std::vector<std::string>& header) {
    const StoredHistory& history = view.history;
    const std::string name = columnOf(view.parameter);
    std::string text = comment_lines(header);
    text += csv_row({"result", "set", "gyro", "date", name, "sd_" + name, "u_" + name, "reason",
                     "f_mean_hz", "sd_f_mean_hz", "u_f_mean_hz", "bias_v", "temperature_c",
                     "exchanged", "outside", "warnings", "program"});
    text += '\n';
    for (std::size_t k = 0; k < history.points.size(); ++k) {
        const HistoryPoint& at = history.points[k];
        text += csv_row(
            {integer_text(at.id), at.set, at.gyro, at.date.text, csv_number(at.value.value),
             csv_number(at.value.sd), csv_number(at.value.u),
             at.value.given() ? std::string() : english(at.value.reason),
             csv_number(at.f_mean_hz.value), csv_number(at.f_mean_hz.sd),
             csv_number(at.f_mean_hz.u), csv_number(at.bias_v), csv_number(at.temperature_c),
             at.exchanged ? "yes" : "no", outsideCodes(view.charts, k), at.warnings, at.program});
        text += '\n';
    }
    return text;
}

}  // namespace

HistoryExport historyExport(const HistoryView& view, const QString& database,
                            const std::optional<std::string>& gyro) {
    const QString parameter = shownIn(view).title;
    const QString whose = gyro ? QString::fromStdString(*gyro) : HistoryWords::tr("All gyros");
    HistoryExport all;
    all.table =
        tableOf(view, {programName().toStdString(), "database: " + database.toStdString(),
                       "gyro: " + gyro.value_or("all"), "parameter: " + columnOf(view.parameter),
                       "baseline: " + integer_text(static_cast<std::int64_t>(view.baseline))});
    const QString about = QStringLiteral("%1, %2").arg(whose, parameter);
    all.report = framedReport(HistoryWords::tr("History of a parameter"), about, programName());
    all.report.html += paragraph(about);
    all.report.html +=
        paragraph(HistoryWords::tr("Database: %1; %2, %3")
                      .arg(database, reportDay().toString(Qt::ISODate), programName()));
    all.report.html += paragraph(verdictText(view));
    constexpr double height = 0.28;  // of the width: all on one page
    std::vector<XYPlot> plots{valuesPlot(view).plot};
    if (view.charts.one_gyro) {
        plots.push_back(rangesPlot(view).plot);
        plots.push_back(averagePlot(view).plot);
    }
    plots.push_back(distributionPlot(view));
    for (const XYPlot& plot : plots) {
        const QString name = QStringLiteral("history-%1").arg(all.figures.size());
        all.figures.push_back(reportFigure(name, xyDrawing(plot),
                                           {report_page.width(), height * report_page.width()}));
        all.report.html += figureHtml(name);
    }
    HtmlTable results{{HistoryWords::tr("Results")}, {}, {100}, true};
    for (std::size_t k = 0; k < view.history.points.size(); ++k) {
        results.rows.push_back({richText(pointText(view, k))});
    }
    all.report.html += html(results);
    return all;
}

}  // namespace vybeg::ui
