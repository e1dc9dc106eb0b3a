#include "ui/report/report_figures.h"

#include "ui/drift/drift_text.h"
#include "ui/plots/figure.h"
#include "ui/resonator/resonator_plots.h"

namespace vybeg::ui {

namespace {

constexpr double reduced = 0.8;

PlotContent plotsOf(const ReportContent& content, std::size_t recording) {
    PlotContent plots;
    plots.variables = content.variables;
    plots.units = content.units;
    for (const ReportAnalysis& each : content.analyses) {
        if (each.recording == recording) {
            plots.analyses.push_back(each.shown);
            plots.analyses.back().visible = true;
        }
    }
    plots.zoom.time = coveredTime(plots.analyses).value_or(AxisRange{0, 1});
    return plots;
}

}  // namespace

ReportFigure reportFigure(const QString& name, Drawing draw, QSizeF paper) {
    return {name, std::move(draw), (paper / reduced).toSize(), paper};
}

QString figureName(const ReportContent& content, const char* figure) {
    return QStringLiteral("%1-%2").arg(content.chapter).arg(QLatin1String(figure));
}

QString plotsName(const ReportContent& content, std::size_t recording) {
    return figureName(content, "plots") + QString::number(recording);
}

std::vector<ReportFigure> reportFigures(const ReportContent& content) {
    // Room for the heading of the page.
    constexpr double heading = 60;
    constexpr double half = 0.49;
    std::vector<ReportFigure> figures;
    if (content.summary) {
        return figures;
    }
    for (std::size_t k = 0; k < content.recordings.size(); ++k) {
        const PlotContent plots = plotsOf(content, k);
        if (!plots.analyses.empty()) {
            figures.push_back(reportFigure(plotsName(content, k), plotsDrawing(plots),
                                           {report_page.width(), report_page.height() - heading}));
        }
    }
    if (content.outcome &&
        content.outcome->identification.fit.model == ResonatorModel::structured) {
        const QSizeF side(half * report_page.width(), half * report_page.width());
        figures.push_back(reportFigure(figureName(content, rim_figure),
                                       roundDrawing(rimPlot(*content.outcome)), side));
        figures.push_back(reportFigure(figureName(content, drift_figure),
                                       xyDrawing(driftPlot(*content.outcome, content.units)),
                                       side));
        figures.push_back(
            reportFigure(figureName(content, balance_figure),
                         xyDrawing(balancePlot(*content.outcome, BalanceAxis::time, content.units)),
                         {report_page.width(), 0.33 * report_page.width()}));
    }
    if (content.drift) {
        figures.push_back(
            reportFigure(figureName(content, whole_angle_figure),
                         xyDrawing(wholeAnglePlot(content.drift->drift, content.units)),
                         {report_page.width(), 0.45 * report_page.width()}));
    }
    return figures;
}

ReportPicture drawn(const ReportFigure& figure) {
    return {figure.name, toPicture(figure.draw, figure.drawn), QSizeF(figure.drawn), figure.paper};
}

std::vector<ReportPicture> drawnFigures(const ReportContent& content) {
    std::vector<ReportPicture> pictures;
    for (const ReportFigure& figure : reportFigures(content)) {
        pictures.push_back(drawn(figure));
    }
    return pictures;
}

}  // namespace vybeg::ui
