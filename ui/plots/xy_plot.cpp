#include "ui/plots/xy_plot.h"

#include "ui/plots/plot_strip.h"
#include "ui/plots/time_panel.h"
#include "ui/plots/time_stack.h"
#include "ui/words/rich_text.h"

#include <qcustomplot.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <iterator>
#include <numbers>
#include <numeric>

namespace vybeg::ui {

namespace {

constexpr int head_height = 22;  // of a name or a row of the legend
constexpr int foot_height = 40;
constexpr int bare_foot_height = 8;
constexpr int left_margin = 60;
constexpr int right_margin = 16;
constexpr std::size_t most_shapes = 2000;  // of points in a series
constexpr int legend_inset = 8;
constexpr double day_s = 86400;
constexpr double around_date_s = 3 * day_s;  // on both sides of a single one

// Range of all values with a margin of a twentieth at both ends; of values at a single place with
// one of their whole deviations, as their bars would fill the plot from edge to edge.
AxisRange rangeOf(const XYPlot& content, bool of_y) {
    const bool logarithmic = of_y ? content.y_logarithmic : content.x_logarithmic;
    Extent values;
    Extent places;
    for (const XYSeries& series : content.series) {
        for (std::size_t k = 0; k < series.x.size(); ++k) {
            const double sd = of_y && !series.sd.empty() ? series.sd[k] : 0;
            const double value = of_y ? series.y[k] : series.x[k];
            if (std::isfinite(value) && std::isfinite(sd) && (!logarithmic || value - sd > 0)) {
                values.add(value - sd);
                values.add(value + sd);
                places.add(series.x[k]);
            }
        }
    }
    const auto [low, high] = values;
    if (low > high) {
        return logarithmic ? AxisRange{0.1, 10} : AxisRange{0, 1};
    }
    if (logarithmic) {
        const double spare = high > low ? std::pow(high / low, 0.05) : 2;
        return {low / spare, high * spare};
    }
    const double part = of_y && places.low == places.high ? 1 : 0.05;
    const double alone =
        !of_y && content.x_is_date ? around_date_s : std::max(0.05 * std::abs(high), 1e-12);
    const double spare = high > low ? part * (high - low) : alone;
    return {low - spare, high + spare};
}

int footOf(const XYPlot& content) {
    return content.x_below ? bare_foot_height : foot_height;
}

QCPAxis::AxisType sideOf(const XYPlot& content, bool y) {
    return y == content.turned ? QCPAxis::atBottom : QCPAxis::atLeft;
}

// Axis rectangle with names in the style of the track's plots.
class XYPanel : public FramedPanel {
public:
    XYPanel(QCustomPlot* plot, const XYPlot& content, const Theme& theme, const QMargins& around,
            QSize room)
        : FramedPanel(plot, around), content_(content) {
        setExpectedSize(room);
        setLook(theme, plotFont(*plot));
        for (QCPAxis* side : {axis(QCPAxis::atBottom), axis(QCPAxis::atLeft)}) {
            side->grid()->setVisible(!content.series.empty());
            side->setTicks(!content.series.empty());
            side->setTickLabels(!content.series.empty());
        }
        if (content.x_below) {
            axis(sideOf(content, false))->setTickLabels(false);
        }
        ticker(sideOf(content, false))
            .setSteps(content.x_in_degrees ? TickSteps::degrees : TickSteps::decimal);
        makeLogarithmic(sideOf(content, false), content.x_logarithmic);
        if (content.x_is_date && !content.series.empty()) {
            showDates();
        }
        makeLogarithmic(sideOf(content, true), content.y_logarithmic);
    }

protected:
    void draw(QCPPainter* painter) override {
        QCPAxisRect::draw(painter);
        if (content_.series.empty()) {
            drawEmpty(*painter, content_.empty);
        }
        if (!content_.x_below) {
            nameSide(*painter, false);
        }
        nameSide(*painter, true);
    }

private:
    void makeLogarithmic(QCPAxis::AxisType side, bool logarithmic) {
        axis(side)->setScaleType(logarithmic ? QCPAxis::stLogarithmic : QCPAxis::stLinear);
        ticker(side).setLogarithmic(logarithmic);
    }

    // ISO dates, which read the same in every language; with the time where days are too coarse.
    void showDates() {
        constexpr int label_width = 140;  // the ticker takes up to half as many more
        const AxisRange range = shownPlaces(content_);
        const QSharedPointer<QCPAxisTickerDateTime> dates(new QCPAxisTickerDateTime);
        dates->setDateTimeSpec(Qt::UTC);
        dates->setDateTimeFormat(range.span() > 3 * day_s ? QStringLiteral("yyyy-MM-dd")
                                                          : QStringLiteral("MM-dd HH:mm"));
        // No day twice.
        const int days = static_cast<int>(range.span() / day_s);
        const int most = range.span() > 3 * day_s ? 2 * days / 3 : expectedSize().width();
        dates->setTickCount(std::max(2, std::min(most, expectedSize().width() / label_width)));
        axis(QCPAxis::atBottom)->setTicker(dates);
    }

    // At the left end above the plot, or centred below it; in a narrow plot aside, as far as it
    // needs.
    void nameSide(QCPPainter& painter, bool y) const {
        const bool centred = sideOf(content_, y) == QCPAxis::atBottom;
        const double base = centred ? rect().bottom() + foot_height - 6 : rect().top() - 7;
        const QString& symbol = y ? content_.y_name : content_.x_name;
        const QString& unit = y ? content_.y_unit : content_.x_unit;
        const bool takes_prefix = y && content_.y_takes_prefix;
        const AxisTicks& ticks = ticker(sideOf(content_, y)).ticks();
        const QString scaled = scaledUnit(unit, takes_prefix, ticks.exponent);
        constexpr double gap = 8;
        constexpr double edge = 4;
        const double room = outerRect().width() - 2 * edge;
        const double behind = gap + indexTextWidth(scaled, font());
        const QString offset = ticks.offsetText();
        const QFontMetricsF metrics(font());
        const QString text = metrics.elidedText(symbol, Qt::ElideRight,
                                                room - behind - metrics.horizontalAdvance(offset)) +
                             offset;
        const double width = indexTextWidth(text, font()) + behind;
        const double wish = rect().left() + (centred ? (rect().width() - width) / 2 : 0);
        const double most = outerRect().right() + 1 - edge - width;
        double x = std::max(std::min(wish, most), outerRect().left() + edge);
        painter.setPen(theme().text);
        x += drawIndexText(painter, {x, base}, text, font());
        painter.setPen(theme().mutedText);
        drawIndexText(painter, {x + gap, base}, scaled, font());
    }

    XYPlot content_;
};

QVector<double> vectorOf(const std::vector<double>& values) {
    return {values.begin(), values.end()};
}

QPen penOf(const XYSeries& series, const Theme& theme) {
    const Qt::PenStyle dash = series.dashed ? Qt::DashLine : Qt::SolidLine;
    return {inkColor(series.ink, series.style, theme, series.shades), series.thin ? 1 : 1.6, dash};
}

// Shapes in addition to colours, for colour-blind users.
QCPScatterStyle shapeOf(const XYSeries& series, const QPen& pen) {
    static constexpr std::array<QCPScatterStyle::ScatterShape, 6> shapes{
        QCPScatterStyle::ssCircle,           QCPScatterStyle::ssSquare,
        QCPScatterStyle::ssTriangle,         QCPScatterStyle::ssDiamond,
        QCPScatterStyle::ssTriangleInverted, QCPScatterStyle::ssCross};
    const auto shape = static_cast<std::size_t>(series.style) % shapes.size();
    return {shapes[shape], QPen(pen.color(), 1.2), QBrush(pen.color()), 5};
}

// x along the first axis.
using Axes = std::pair<QCPAxis*, QCPAxis*>;

void addPoints(QCustomPlot& plot, const Axes& axes, const XYSeries& series, const QPen& pen) {
    QCPGraph* graph = plot.addGraph(axes.first, axes.second);
    graph->setData(vectorOf(series.x), vectorOf(series.y));
    graph->setLineStyle(QCPGraph::lsNone);
    // Thousands of shapes hide each other, and take half a second to draw.
    const bool many = series.x.size() > most_shapes;
    graph->setAntialiasedScatters(!many);
    graph->setScatterStyle(
        many ? QCPScatterStyle(QCPScatterStyle::ssDot, QPen(pen.color(), 2), Qt::NoBrush, 2)
             : shapeOf(series, pen));
    if (!series.sd.empty()) {
        auto* bars = new QCPErrorBars(graph->keyAxis(), graph->valueAxis());
        bars->setDataPlottable(graph);
        bars->setData(vectorOf(series.sd));
        bars->setPen(QPen(pen.color(), 1));
        bars->setWhiskerWidth(many ? 0 : 4);
        bars->setAntialiased(!many);
        bars->setSymbolGap(0);
    }
}

void addLine(QCustomPlot& plot, const Axes& axes, const XYSeries& series, const QPen& pen) {
    const auto line = [&](double deviations) {
        QVector<double> y = vectorOf(series.y);
        for (std::size_t k = 0; k < series.sd.size(); ++k) {
            y[static_cast<qsizetype>(k)] += deviations * series.sd[k];
        }
        QCPGraph* graph = plot.addGraph(axes.first, axes.second);
        graph->setData(vectorOf(series.x), y);
        graph->setPen(deviations == 0 ? pen : QPen(Qt::NoPen));
        graph->setLineStyle(series.steps ? QCPGraph::lsStepCenter : QCPGraph::lsLine);
        return graph;
    };
    if (!series.sd.empty()) {
        QCPGraph* upper = line(1);
        upper->setBrush(translucent(pen.color(), 0.18));
        upper->setChannelFillGraph(line(-1));
    }
    line(0);
}

// The rows of a legend and where they begin.
struct Legend {
    std::vector<std::vector<StripEntry>> rows;
    int left = legend_inset;

    bool besideName() const { return left != legend_inset; }
    int height() const { return head_height * static_cast<int>(rows.size()); }
};

// After the name of the axis where all of it has room there; otherwise above it.
Legend legendOf(const XYPlot& content, const Theme& theme, const QFont& font, int width) {
    std::vector<StripEntry> entries;
    for (const XYSeries& series : content.series) {
        if (!series.name.isEmpty()) {
            const QPen pen = penOf(series, theme);
            entries.push_back({series.name, true, true, pen.color(), pen.style(),
                               series.points ? shapeOf(series, pen) : QCPScatterStyle()});
        }
    }
    // A single curve needs no legend.
    if (entries.size() <= 1) {
        return {};
    }
    constexpr int gap = 24;
    constexpr double far = 1e3;  // from zero: labels count from an offset, which the name has
    const bool y = !content.turned;
    const AxisRange shown = y ? shownValues(content) : shownPlaces(content);
    const bool offset = std::max(std::abs(shown.lower), std::abs(shown.upper)) > far * shown.span();
    const QString name =
        (y ? content.y_name : content.x_name) + QLatin1Char(' ') +
        (offset ? QStringLiteral(" − 5300.000 000, ×10⁻³ ") : QStringLiteral("×10⁻³ ")) +
        (y ? content.y_unit : content.x_unit);
    const int left = left_margin + gap + static_cast<int>(indexTextWidth(name, font));
    Legend legend{PlotStrip::rows(entries, font, width - left - right_margin), left};
    if (legend.rows.size() > 1) {
        legend = {PlotStrip::rows(entries, font, width - legend_inset - right_margin)};
    }
    return legend;
}

constexpr int leader_length = 14;  // from the frame to a name, at least

// Pixels right of the frame.
int tailOf(const XYPlot& content, const QFont& font, int width) {
    int widest = 0;
    for (const QString& name : content.names_at_ends) {
        widest = std::max(widest, QFontMetrics(font).horizontalAdvance(name));
    }
    return 0 < widest && widest <= width / 3 ? leader_length + widest + 4 : right_margin;
}

// Middles of lines of a height, as near to the ascending `wishes` as the lines can be without
// touching each other, between two limits.
std::vector<double> apart(std::vector<double> wishes, double height, double low, double high) {
    // The nearest ascending values to the wishes less the lines before them (isotonic regression).
    const auto count = static_cast<std::ptrdiff_t>(wishes.size());
    for (std::ptrdiff_t k = 0; k < count; ++k) {
        wishes[static_cast<std::size_t>(k)] -= static_cast<double>(k) * height;
    }
    const double last = high - static_cast<double>(count - 1) * height;
    std::vector<double> middles;
    for (std::ptrdiff_t k = 0; k < count; ++k) {
        double highest = low;
        for (std::ptrdiff_t from = 0; from <= k; ++from) {
            double lowest = last;
            for (std::ptrdiff_t to = k; to < count; ++to) {
                const double sum =
                    std::accumulate(wishes.begin() + from, wishes.begin() + to + 1, 0.0);
                lowest = std::min(lowest, sum / static_cast<double>(to - from + 1));
            }
            highest = std::max(highest, lowest);
        }
        middles.push_back(highest + static_cast<double>(k) * height);
    }
    return middles;
}

// Names right of the frame, each at the height of the end of its curve, to which a pale line leads.
void nameEnds(QCustomPlot& plot, const Axes& axes, const XYPlot& content, const Theme& theme,
              const QRect& frame) {
    struct End {
        const XYSeries* series;
        std::size_t point;
        double height;
    };
    const AxisRange x = shownPlaces(content);
    const AxisRange y = shownValues(content);
    const auto scaled = [&](double value) {
        return content.y_logarithmic ? std::log(value) : value;
    };
    std::vector<End> ends;
    for (const XYSeries& series : content.series) {
        for (std::size_t k = series.name.isEmpty() ? 0 : series.x.size(); k-- > 0;) {
            const double share =
                (scaled(series.y[k]) - scaled(y.lower)) / (scaled(y.upper) - scaled(y.lower));
            if (x.lower <= series.x[k] && series.x[k] <= x.upper && std::isfinite(share)) {
                ends.push_back(
                    {&series, k, frame.bottom() - std::clamp(share, 0.0, 1.0) * frame.height()});
                break;
            }
        }
    }
    std::ranges::stable_sort(ends, {}, &End::height);
    std::vector<double> heights;
    std::ranges::transform(ends, std::back_inserter(heights), &End::height);
    const QFont font = plotFont(plot);
    heights = apart(heights, QFontMetrics(font).height(), frame.top(), frame.bottom());
    for (std::size_t k = 0; k < ends.size(); ++k) {
        const XYSeries& series = *ends[k].series;
        const QColor color = penOf(series, theme).color();
        const QPointF at(frame.right() + leader_length, heights[k]);
        auto* leader = new QCPItemLine(&plot);
        leader->setClipToAxisRect(false);
        leader->setPen(QPen(translucent(color, 0.5), 1));
        leader->start->setAxes(axes.first, axes.second);
        leader->start->setCoords(series.x[ends[k].point],
                                 std::clamp(series.y[ends[k].point], y.lower, y.upper));
        auto* name = new QCPItemText(&plot);
        name->setClipToAxisRect(false);
        name->setPositionAlignment(Qt::AlignLeft | Qt::AlignVCenter);
        name->setFont(font);
        name->setColor(color);
        name->setText(series.name);
        for (QCPItemPosition* place : {leader->end, name->position}) {
            place->setType(QCPItemPosition::ptAbsolute);
            place->setCoords(at);
        }
    }
}

int headOf(const XYPlot& content, const Legend& legend) {
    return std::max(content.least_head, legend.height() + (legend.besideName() ? 0 : head_height));
}

}  // namespace

XYSeries dashedLine(const QString& name, Ink ink, std::vector<double> x, std::vector<double> y) {
    return {.name = name, .ink = ink, .dashed = true, .x = std::move(x), .y = std::move(y)};
}

XYSeries histogramSteps(const Histogram& histogram, const QString& name, Ink ink) {
    XYSeries steps{.name = name, .ink = ink, .steps = true};
    const auto add = [&](double bin, double count) {
        steps.x.push_back(histogram.low + (bin + 0.5) * histogram.width);
        steps.y.push_back(count);
    };
    add(-1, 0);
    for (std::size_t k = 0; k < histogram.counts.size(); ++k) {
        add(static_cast<double>(k), static_cast<double>(histogram.counts[k]));
    }
    add(static_cast<double>(histogram.counts.size()), 0);
    return steps;
}

XYSeries normalCurve(const QString& name, double area, int points) {
    constexpr double reach = 4;
    XYSeries curve = dashedLine(name, Ink::text);
    for (int k = 0; k < points; ++k) {
        const double z = reach * (2.0 * k / (points - 1) - 1);
        curve.x.push_back(z);
        curve.y.push_back(area * std::exp(-0.5 * z * z) / std::sqrt(2 * std::numbers::pi));
    }
    return curve;
}

XYSeries markOn(const XYSeries& points, std::size_t point, Ink ink) {
    return {.style = 1, .ink = ink, .points = true, .x = {points.x[point]}, .y = {points.y[point]}};
}

void layOutXYPlot(QCustomPlot& plot, const XYPlot& content, const Theme& theme, QSize size) {
    plot.clearPlottables();
    plot.clearItems();
    preparePlot(plot, theme);
    const QFont font = plotFont(plot);
    const int tail = tailOf(content, font, size.width());
    const int foot = footOf(content);
    const auto names = std::ranges::count_if(
        content.series, [](const XYSeries& series) { return !series.name.isEmpty(); });
    const bool at_ends = tail != right_margin && (names - 1) * QFontMetrics(font).height() <=
                                                     size.height() - head_height - foot;
    const Legend legend = at_ends ? Legend() : legendOf(content, theme, font, size.width());
    int row = 0;
    for (const auto& entries : legend.rows) {
        auto* strip = new PlotStrip(&plot, head_height);
        strip->setInset(legend.left, right_margin, 0);
        strip->setLook(font, theme.text);
        strip->setEntries(entries, Qt::AlignLeft);
        plot.plotLayout()->addElement(row++, 0, strip);
    }
    // The panel draws the name of its axis over a row of the legend that leaves room for it.
    const int head = headOf(content, legend);
    const QSize room(size.width() - left_margin - tail, size.height() - head - foot);
    auto* panel =
        new XYPanel(&plot, content, theme, {left_margin, head - legend.height(), tail, foot}, room);
    plot.plotLayout()->addElement(row, 0, panel);
    const Axes axes{panel->axis(sideOf(content, false)), panel->axis(sideOf(content, true))};
    for (const XYSeries& series : content.series) {
        const QPen pen = penOf(series, theme);
        if (series.points) {
            addPoints(plot, axes, series, pen);
        } else {
            addLine(plot, axes, series, pen);
        }
    }
    const AxisRange x = shownPlaces(content);
    const AxisRange y = shownValues(content);
    axes.first->setRange(x.lower, x.upper);
    axes.second->setRange(y.lower, y.upper);
    if (at_ends) {
        nameEnds(plot, axes, content, theme, QRect(QPoint(left_margin, head), room));
    }
}

int headOf(const XYPlot& content, const QFont& font, int width) {
    return headOf(content, legendOf(content, lightTheme(), font, width));
}

AxisRange shownPlaces(const XYPlot& content) {
    return content.x_range.value_or(rangeOf(content, false));
}

AxisRange shownValues(const XYPlot& content) {
    return content.y_range.value_or(rangeOf(content, true));
}

Drawing xyDrawing(const XYPlot& content) {
    return [content](QCPPainter& painter, QSize size) {
        QCustomPlot plot;
        layOutXYPlot(plot, content, lightTheme(), size);
        plot.toPainter(&painter, size.width(), size.height());
    };
}

}  // namespace vybeg::ui
