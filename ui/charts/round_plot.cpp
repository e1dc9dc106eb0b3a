#include "ui/charts/round_plot.h"

#include "ui/plots/plot_stack.h"

#include <QChart>
#include <QGraphicsLayout>
#include <QGraphicsScene>
#include <QLegend>
#include <QLegendMarker>
#include <QLineSeries>
#include <QLocale>
#include <QPolarChart>
#include <QScatterSeries>
#include <QValueAxis>
#include <qcustomplot.h>

#include <algorithm>
#include <memory>

namespace vybeg::ui {

namespace {

QList<QPointF> pointsOf(const RoundSeries& series) {
    QList<QPointF> points;
    points.reserve(static_cast<qsizetype>(series.x.size()));
    for (std::size_t k = 0; k < series.x.size(); ++k) {
        points.append({series.x[k], series.y[k]});
    }
    return points;
}

QXYSeries* seriesOf(const RoundSeries& from, const Theme& theme) {
    const QColor color = colorOf(from, theme);
    if (from.points) {
        auto* points = new QScatterSeries;
        points->setMarkerSize(8);
        points->setColor(color);
        points->setBorderColor(color);
        return points;
    }
    auto* line = new QLineSeries;
    line->setPen(QPen(color, from.width, from.dashed ? Qt::DashLine : Qt::SolidLine));
    return line;
}

QFont chartFont() {
    QFont font = QGuiApplication::font();
    font.setPixelSize(11);
    return font;
}

void paintAxis(QValueAxis& axis, const Theme& theme) {
    axis.setLinePen(QPen(theme.axis, 1));
    axis.setGridLinePen(QPen(theme.grid, 1));
    axis.setLabelsColor(theme.text);
    axis.setLabelsFont(chartFont());
    axis.setTitleFont(chartFont());
    axis.setTitleBrush(theme.text);
}

QValueAxis& axisOf(const QChart& chart, Qt::Orientation orientation) {
    return *qobject_cast<QValueAxis*>(chart.axes(orientation).front());
}

constexpr double legend_height = 26;

// The axes of a square plot in a chart of a size: room for numbers and names at the left and below.
QRectF squareIn(QSizeF size, double legend) {
    constexpr double left = 64;
    constexpr double below = 46;
    constexpr double edge = 12;
    const double side =
        std::max(20., std::min(size.width() - left - edge, size.height() - below - edge - legend));
    const double x = left + (size.width() - left - edge - side) / 2;
    return {x, edge, side, side};
}

bool showsAlready(const QChart& chart, const RoundPlot& content, const Theme& theme) {
    const auto shown = chart.series();
    if (static_cast<std::size_t>(shown.size()) != content.series.size()) {
        return false;
    }
    for (qsizetype k = 0; k < shown.size(); ++k) {
        const RoundSeries& wanted = content.series[static_cast<std::size_t>(k)];
        const auto* now = qobject_cast<QXYSeries*>(shown[k]);
        const bool points = now->type() == QAbstractSeries::SeriesTypeScatter;
        const Qt::PenStyle dash = wanted.dashed ? Qt::DashLine : Qt::SolidLine;
        if (points != wanted.points || now->name() != wanted.name ||
            now->color() != colorOf(wanted, theme) ||
            (!points && (now->pen().style() != dash || now->pen().widthF() != wanted.width))) {
            return false;
        }
    }
    return true;
}

}  // namespace

QColor colorOf(const RoundSeries& series, const Theme& theme) {
    return series.ink == Ink::style ? readable(series.color, theme, series.shade)
                                    : inkColor(series.ink, 0, theme);
}

QChart* makeRoundChart(bool polar) {
    QChart* chart = polar ? new QPolarChart : new QChart;
    chart->setMargins({});
    chart->setBackgroundRoundness(0);
    chart->setLocalizeNumbers(true);
    for (const Qt::Alignment side : {Qt::AlignBottom, Qt::AlignLeft}) {
        auto* axis = new QValueAxis;
        // Without a range there are no labels, and Qt Charts lays out the first of them.
        axis->setRange(0, 1);
        if (polar) {
            static_cast<QPolarChart*>(chart)->addAxis(
                axis, side == Qt::AlignBottom ? QPolarChart::PolarOrientationAngular
                                              : QPolarChart::PolarOrientationRadial);
        } else {
            chart->addAxis(axis, side);
        }
    }
    return chart;
}

void fillRoundChart(QChart& chart, const RoundPlot& content, const Theme& theme) {
    chart.setLocale(QLocale());
    chart.setBackgroundBrush(theme.plotBackground);
    QValueAxis& across = axisOf(chart, Qt::Horizontal);
    QValueAxis& up = axisOf(chart, Qt::Vertical);
    for (QValueAxis* axis : {&across, &up}) {
        paintAxis(*axis, theme);
        axis->setVisible(!content.series.empty());
    }
    if (content.polar) {
        across.setRange(0, 360);
        across.setTickCount(9);
        across.setLabelFormat(QStringLiteral("%.0f°"));
        up.setRange(0, content.reach);
        up.setTickCount(3);
        up.setLabelsVisible(content.scale);
    } else {
        for (QValueAxis* axis : {&across, &up}) {
            axis->setRange(-content.reach, content.reach);
            axis->setTickCount(5);
        }
        across.setTitleText(content.x_name);
        up.setTitleText(content.y_name);
    }
    if (!showsAlready(chart, content, theme)) {
        chart.removeAllSeries();
        for (const RoundSeries& each : content.series) {
            QXYSeries* series = seriesOf(each, theme);
            series->setName(each.name);
            chart.addSeries(series);
            series->attachAxis(&across);
            series->attachAxis(&up);
        }
    }
    const auto shown = chart.series();
    for (qsizetype k = 0; k < shown.size(); ++k) {
        const RoundSeries& from = content.series[static_cast<std::size_t>(k)];
        qobject_cast<QXYSeries*>(shown[k])->replace(pointsOf(from));
        for (QLegendMarker* marker : chart.legend()->markers(shown[k])) {
            marker->setVisible(!from.name.isEmpty());
        }
    }
    const bool named =
        std::ranges::any_of(content.series, [](const auto& each) { return !each.name.isEmpty(); });
    chart.legend()->setVisible(named);
    chart.legend()->setAlignment(Qt::AlignBottom);
    chart.legend()->setFont(chartFont());
    chart.legend()->setLabelColor(theme.text);
    if (!content.polar) {
        chart.setPlotArea(squareIn(chart.size(), named ? legend_height : 0));
    }
    chart.setTitle(content.series.empty() ? content.empty : QString());
    chart.setTitleBrush(theme.mutedText);
    chart.setTitleFont(chartFont());
}

Drawing roundDrawing(const RoundPlot& content) {
    return [content](QCPPainter& painter, QSize size) {
        QGraphicsScene scene;
        QChart* chart = makeRoundChart(content.polar);
        scene.addItem(chart);
        chart->resize(size);
        fillRoundChart(*chart, content, lightTheme());
        // No event loop lays out the legend before it is drawn.
        chart->layout()->invalidate();
        chart->layout()->activate();
        scene.setSceneRect(QRectF(QPointF(), QSizeF(size)));
        scene.render(&painter, QRectF(QPointF(), QSizeF(size)), scene.sceneRect());
    };
}

}  // namespace vybeg::ui
