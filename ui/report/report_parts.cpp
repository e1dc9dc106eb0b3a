#include "ui/report/report_parts.h"

#include "ui/drift/drift_text.h"
#include "ui/plots/plot_stack.h"
#include "ui/resonator/resonator_plots.h"
#include "ui/words/rich_text.h"

#include <QRegularExpression>

#include <algorithm>
#include <utility>

namespace vybeg::ui {

namespace {

// A number with its deviation, u and unit, which stays on one line; a column takes the width of its
// longest. Words may be wrapped.
bool isNumber(const QString& cell) {
    static const QRegularExpression number(
        QStringLiteral("^(?:[^\\p{L}<]|u|ppm)*\\d(?:[^\\p{L}<]|u|ppm)*$"));
    return number.match(cell).hasMatch();
}

constexpr double reduced = 0.8;

PlotContent plotsOf(const ReportContent& content, std::size_t recording) {
    PlotContent plots;
    plots.variables = content.variables;
    plots.units = content.units;
    plots.units.wave_angle = WaveAngle::doubled;  // as files have it
    for (const AnalysisEntry& each : content.recordings[recording].analyses) {
        plots.analyses.push_back(each.shown);
        plots.analyses.back().visible = true;
    }
    plots.zoom.time = coveredTime(plots.analyses).value_or(AxisRange{0, 1});
    return plots;
}

}  // namespace

QString heading(const QString& text, bool new_page) {
    return QStringLiteral("<h2%1>%2</h2>")
        .arg(new_page ? QStringLiteral(" style=\"page-break-before:always\"") : QString(),
             richText(text));
}

QString smallHeading(const QString& text) {
    return QStringLiteral("<h3>%1</h3>").arg(richText(text));
}

QString paragraph(const QString& text) {
    return QStringLiteral("<p>%1</p>").arg(richText(text));
}

QString monospaced(const QString& text) {
    return QStringLiteral("<span class=\"mono\">%1</span>").arg(text.toHtmlEscaped());
}

QString items(const QStringList& sentences) {
    QString list;
    for (const QString& sentence : sentences) {
        list += QStringLiteral("<li>%1</li>").arg(richText(sentence));
    }
    return list.isEmpty() ? list : QStringLiteral("<ul>%1</ul>").arg(list);
}

QString html(const HtmlTable& table) {
    const auto line = [&table](const QStringList& cells, const QString& tag) {
        QString text = QStringLiteral("<tr>");
        // A row of fewer cells: the last one takes the rest.
        for (qsizetype k = 0; k < cells.size(); ++k) {
            const qsizetype rest = qsizetype(table.columns.size()) - k;
            const bool last = k + 1 == cells.size();
            text += QStringLiteral("<%1 width=\"%2%\" colspan=\"%3\"%4>%5</%1>")
                        .arg(tag)
                        .arg(table.columns[static_cast<std::size_t>(k)])
                        .arg(last ? rest : 1)
                        .arg(isNumber(cells[k]) ? QStringLiteral(" class=\"number\"") : QString(),
                             cells[k]);
        }
        return text + QStringLiteral("</tr>");
    };
    QString text = QStringLiteral("<table width=\"100%\" cellspacing=\"0\" cellpadding=\"3\"%1>")
                       .arg(table.small ? QStringLiteral(" class=\"small\"") : QString());
    if (!table.head.isEmpty()) {
        text += QStringLiteral("<thead>%1</thead>").arg(line(table.head, QStringLiteral("th")));
    }
    for (const QStringList& row : table.rows) {
        text += line(row, QStringLiteral("td"));
    }
    return text + QStringLiteral("</table>");
}

QString quantityTables(const QStringList& headers, const std::vector<QuantityRow>& rows,
                       qsizetype most, bool small) {
    QString text;
    const qsizetype values = rows.empty() ? 0 : qsizetype(rows.front().cells.size());
    const qsizetype tables = (values + most - 1) / most;
    const qsizetype each = tables == 0 ? 0 : (values + tables - 1) / tables;
    for (qsizetype from = 0; from < values; from += each) {
        const qsizetype count = std::min(each, values - from);
        // Names of quantities are about as long as two values.
        const int columns = static_cast<int>(count);
        const int value =
            (100 - std::max(22, 100 / (1 + columns) + (columns == 1 ? 8 : 0))) / columns;
        HtmlTable table{{}, {}, {100 - columns * value}, small};
        table.columns.insert(table.columns.end(), static_cast<std::size_t>(count), value);
        if (!headers.isEmpty()) {
            table.head << QString();
            for (qsizetype k = from; k < from + count; ++k) {
                table.head << richText(headers[k]);
            }
        }
        for (const QuantityRow& row : rows) {
            QStringList cells{richText(row.name)};
            for (qsizetype k = from; k < from + count; ++k) {
                cells << richText(row.cells[static_cast<std::size_t>(k)].text);
            }
            table.rows.push_back(cells);
        }
        text += html(table);
    }
    return text;
}

QString figureHtml(const QString& name) {
    return QStringLiteral("<p class=\"figure\"><img src=\"%1\"></p>").arg(name);
}

QString sideBySide(const QString& left, const QString& right) {
    return QStringLiteral(
               "<table width=\"100%\" cellspacing=\"0\" cellpadding=\"0\" class=\"figures\"><tr>"
               "<td width=\"50%\"><img src=\"%1\"></td><td width=\"50%\"><img src=\"%2\"></td>"
               "</tr></table>")
        .arg(left, right);
}

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
            figures.push_back(reportFigure(plotsName(content, k), plotsFigure(plots).draw,
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

ReportFigure drawn(ReportFigure figure) {
    figure.picture = toPicture(std::exchange(figure.draw, {}), figure.drawn);
    return figure;
}

std::vector<ReportFigure> drawnFigures(const ReportContent& content) {
    std::vector<ReportFigure> figures = reportFigures(content);
    std::ranges::transform(figures, figures.begin(), drawn);
    return figures;
}

}  // namespace vybeg::ui
