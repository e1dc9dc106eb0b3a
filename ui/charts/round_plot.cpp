#include "ui/charts/round_plot.h"

#include "ui/plots/time_stack.h"
#include "ui/words/display_units.h"
#include "ui/words/rich_text.h"

#include <QAbstractTextDocumentLayout>
#include <QCategoryAxis>
#include <QChart>
#include <QChartView>
#include <QGraphicsLayout>
#include <QGraphicsScene>
#include <QLabel>
#include <QLayout>
#include <QLegend>
#include <QLineSeries>
#include <QPolarChart>
#include <QScatterSeries>
#include <QTextDocument>
#include <qcustomplot.h>

#include <algorithm>
#include <cmath>
#include <numbers>

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

QColor colorOf(const RoundSeries& series, const Theme& theme) {
    return series.ink == Ink::style ? readable(series.color, theme, series.shade)
                                    : inkColor(series.ink, 0, theme);
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

void paintAxis(QCategoryAxis& axis, const Theme& theme) {
    axis.setLinePen(QPen(theme.axis, 1));
    axis.setGridLinePen(QPen(theme.grid, 1));
    axis.setLabelsColor(theme.text);
    axis.setLabelsFont(chartFont());
    axis.setTitleFont(chartFont());
    axis.setTitleBrush(theme.text);
    // Qt counts the room of a number too small; numbers that would touch are left out anyway.
    axis.setTruncateLabels(false);
}

QCategoryAxis& axisOf(const QChart& chart, Qt::Orientation orientation) {
    return *qobject_cast<QCategoryAxis*>(chart.axes(orientation).front());
}

// Lines and numbers at multiples of `step`; those of Qt's own axes have no true minus.
void setTicks(QCategoryAxis& axis, double lower, double upper, double step, int decimals,
              const QString& unit = {}) {
    QStringList labels;
    std::vector<double> values;
    for (double value = lower; value < upper + 0.5 * step; value += step) {
        labels << numberLabel(value, decimals) + unit;
        values.push_back(value);
    }
    if (axis.categoriesLabels() != labels) {
        for (const QString& label : axis.categoriesLabels()) {
            axis.remove(label);
        }
        for (qsizetype k = 0; k < labels.size(); ++k) {
            axis.append(labels[k], values[static_cast<std::size_t>(k)]);
        }
    }
}

// The axes of a square plot in a chart of a size: room for numbers and names at the left and below.
QRectF squareIn(QSizeF size) {
    constexpr double left = 64;
    constexpr double below = 46;
    constexpr double edge = 18;  // for half a number
    const double side =
        std::max(20., std::min(size.width() - left - edge, size.height() - below - edge));
    const double x = left + (size.width() - left - edge - side) / 2;
    return {x, edge, side, side};
}

// Around a polar plot: Qt reckons with angles halfway between the lines, where they need less room
// than those at the sides, above and below.
QMargins marginsIn(QSizeF size) {
    const double halfway = std::sin(67.5 * std::numbers::pi / 180);
    const int margin =
        static_cast<int>(std::ceil((1 - halfway) * std::min(size.width(), size.height()) / 2));
    return {margin, margin, margin, margin};
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
        if (points != wanted.points || now->color() != colorOf(wanted, theme) ||
            (!points && (now->pen().style() != dash || now->pen().widthF() != wanted.width))) {
            return false;
        }
    }
    return true;
}

// The caller owns it.
QChart* makeRoundChart(bool polar) {
    QChart* chart = polar ? new QPolarChart : new QChart;
    chart->legend()->hide();
    chart->setMargins({});
    chart->setBackgroundRoundness(0);
    for (const Qt::Alignment side : {Qt::AlignBottom, Qt::AlignLeft}) {
        auto* axis = new QCategoryAxis;
        axis->setLabelsPosition(QCategoryAxis::AxisLabelsPositionOnValue);
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

// Makes a chart of makeRoundChart() show a plot at the chart's size. Curves that are there already
// are moved.
void fillRoundChart(QChart& chart, const RoundPlot& content, const Theme& theme) {
    chart.setBackgroundBrush(theme.plotBackground);
    QCategoryAxis& across = axisOf(chart, Qt::Horizontal);
    QCategoryAxis& up = axisOf(chart, Qt::Vertical);
    for (QCategoryAxis* axis : {&across, &up}) {
        paintAxis(*axis, theme);
        axis->setVisible(!content.series.empty());
    }
    const double half = 0.5 * content.reach;
    const int decimals = std::max(0, 1 - static_cast<int>(std::floor(std::log10(content.reach))));
    if (content.polar) {
        across.setRange(0, 360);
        setTicks(across, 0, 315, 45, 0, QStringLiteral("°"));
        up.setRange(0, content.reach);
        setTicks(up, half, content.reach, half, decimals);
        up.setLabelsVisible(content.scale);
    } else {
        for (QCategoryAxis* axis : {&across, &up}) {
            axis->setRange(-content.reach, content.reach);
            setTicks(*axis, -content.reach, content.reach, half, decimals);
        }
        across.setTitleText(content.x_name);
        up.setTitleText(content.y_name);
    }
    if (!showsAlready(chart, content, theme)) {
        chart.removeAllSeries();
        for (const RoundSeries& each : content.series) {
            QXYSeries* series = seriesOf(each, theme);
            chart.addSeries(series);
            series->attachAxis(&across);
            series->attachAxis(&up);
        }
    }
    const auto shown = chart.series();
    for (qsizetype k = 0; k < shown.size(); ++k) {
        qobject_cast<QXYSeries*>(shown[k])->replace(
            pointsOf(content.series[static_cast<std::size_t>(k)]));
    }
    if (content.polar) {
        chart.setMargins(marginsIn(chart.size()));
    } else {
        chart.setPlotArea(squareIn(chart.size()));
    }
    chart.setTitle(content.series.empty() ? content.empty : QString());
    chart.setTitleBrush(theme.mutedText);
    chart.setTitleFont(chartFont());
}

}  // namespace

QString legendOf(const RoundPlot& content, const Theme& theme) {
    QStringList names;
    for (const RoundSeries& series : content.series) {
        if (!series.name.isEmpty()) {
            names << QStringLiteral("<nobr><span style=\"color:%1\">%2</span> %3</nobr>")
                         .arg(colorOf(series, theme).name(),
                              series.points   ? QStringLiteral("●")
                              : series.dashed ? QStringLiteral("╍")
                                              : QStringLiteral("━"),
                              richText(series.name));
        }
    }
    return names.join(QStringLiteral(" &nbsp; "));
}

Drawing roundDrawing(const RoundPlot& content) {
    return [content](QCPPainter& painter, QSize size) {
        const Theme theme = lightTheme();
        QTextDocument legend;
        legend.setDocumentMargin(4);
        legend.setDefaultFont(chartFont());
        legend.setHtml(QStringLiteral("<center>%1</center>").arg(legendOf(content, theme)));
        legend.setTextWidth(size.width());
        const QRectF below(0, size.height() - legend.size().height(), size.width(),
                           legend.size().height());
        const QRectF above(0, 0, size.width(), below.top());
        QGraphicsScene scene;
        QChart* chart = makeRoundChart(content.polar);
        scene.addItem(chart);
        chart->resize(above.size());
        fillRoundChart(*chart, content, theme);
        // No event loop lays out the axes before they are drawn.
        chart->layout()->invalidate();
        chart->layout()->activate();
        scene.setSceneRect(above);
        scene.render(&painter, above, above);
        painter.fillRect(below, theme.plotBackground);
        painter.save();
        painter.translate(below.topLeft());
        QAbstractTextDocumentLayout::PaintContext look;
        look.palette.setColor(QPalette::Text, theme.text);
        legend.documentLayout()->draw(&painter, look);
        painter.restore();
    };
}

RoundView::RoundView(bool polar, QWidget* parent)
    : PlotView(parent),
      view_(new QChartView(makeRoundChart(polar), this)),
      legend_(new QLabel(this)) {
    content_.polar = polar;
    view_->setRenderHint(QPainter::Antialiasing);
    view_->setFrameShape(QFrame::NoFrame);
    // Later than that of this widget: its room and margins follow the size of the chart.
    connect(view_->chart(), &QChart::geometryChanged, this, &RoundView::rebuild);
    setMinimumSize(180, 180);
    addDrawing(view_);
    // Its hint is the size it has: a page that scrolls would not shrink with its window.
    view_->setSizePolicy(QSizePolicy::Ignored, QSizePolicy::Ignored);
    layout()->addWidget(legend_);
    legend_->setWordWrap(true);
    legend_->setAlignment(Qt::AlignHCenter);
    legend_->setAutoFillBackground(true);
    legend_->setContentsMargins(4, 0, 4, 4);
    rebuild();
}

void RoundView::setContent(const RoundPlot& content) {
    content_ = content;
    rebuild();
}

void RoundView::setLegendShown(bool shown) {
    legend_shown_ = shown;
    rebuild();
}

Figure RoundView::figure() const {
    return {roundDrawing(content_), round_paper_size, objectName()};
}

void RoundView::rebuild() {
    const QString legend = legendOf(content_, theme());
    legend_->setVisible(legend_shown_ && !legend.isEmpty());
    legend_->setText(legend);
    QPalette palette = legend_->palette();
    palette.setColor(QPalette::Window, theme().plotBackground);
    palette.setColor(QPalette::WindowText, theme().text);
    legend_->setPalette(palette);
    fillRoundChart(*view_->chart(), content_, theme());
    view_->setBackgroundBrush(theme().plotBackground);
    setDrawn(!content_.series.empty());
}

}  // namespace vybeg::ui

#include "moc_round_plot.cpp"
