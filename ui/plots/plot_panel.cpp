#include "ui/plots/plot_panel.h"

#include "core/numerics/phase.h"
#include "core/numerics/statistics.h"
#include "ui/values/curve_data.h"

#include <QCoreApplication>

#include <algorithm>
#include <cmath>
#include <limits>
#include <memory>
#include <numbers>
#include <utility>
#include <vector>

namespace vybeg::ui {

namespace {

constexpr double line_width = 1.4;
// Distance of windows above which each gets a dot, pixels.
constexpr double dot_spacing = 9;
// Distance of the pointers to parts of the curve beyond the frame, pixels; closer ones would merge
// into a bar.
constexpr double pointer_spacing = 24;

// Dense noise: windows in a pixel at least, those of a column of the band, the band's least height
// in pixels, and columns on either side that the running mean takes in.
constexpr double least_density = 1;
constexpr double windows_in_column = 4;
constexpr std::size_t least_noise_columns = 20;
constexpr double least_noise_height = 4;
constexpr std::size_t mean_reach = 4;

// A small triangle whose tip touches the frame; `inwards` is +1 at the top and -1 at the foot.
QPolygonF pointer(const QPointF& tip, double inwards) {
    constexpr double half = 3.5;
    return {{tip, tip + QPointF(half, 5 * inwards), tip + QPointF(-half, 5 * inwards)}};
}

// A band, as its vertical line from the top down at each column.
using Band = std::vector<QLineF>;

void drawBandShape(QCPPainter& painter, const Band& piece) {
    QPolygonF shape;
    for (const QLineF& at : piece) {
        shape.append(at.p1());
    }
    for (auto at = piece.rbegin(); at != piece.rend(); ++at) {
        shape.append(at->p2());
    }
    if (!shape.isEmpty()) {
        painter.drawPolygon(shape);
    }
}

// Draws the band pixel column by pixel column. A polygon with a noisy outline takes a raster
// painter 20 ms and more per plot, this a fraction of 1 ms.
void drawBandPixels(QCPPainter& painter, const Band& piece, const QColor& fill) {
    painter.setAntialiasing(false);
    // Single rectangles, because filling one with a colour needs no rasteriser. Limited height,
    // because from 96 rows on Qt starts threads for translucent fills and waits for them, which
    // takes ten times as long as the filling (Qt 6.4, qdrawhelper.cpp).
    const double tallest = 64 / painter.deviceTransform().m22();
    const auto add = [&](double x, double top, double bottom) {
        const double end = std::max(top + 1, bottom);
        for (double from = top; from < end; from += tallest) {
            // QCPPainter shifts everything without antialiasing by half a pixel.
            painter.fillRect(QRectF(x, from + 0.5, 1, std::min(tallest, end - from)), fill);
        }
    };
    if (piece.size() == 1) {
        add(std::floor(piece[0].x1()), piece[0].y1(), piece[0].y2());
    }
    for (std::size_t i = 1; i < piece.size(); ++i) {
        const QLineF& from = piece[i - 1];
        const QLineF& to = piece[i];
        for (double x = std::ceil(from.x1()); x < to.x1(); x += 1) {
            const double part = (x - from.x1()) / (to.x1() - from.x1());
            add(x, std::lerp(from.y1(), to.y1(), part), std::lerp(from.y2(), to.y2(), part));
        }
    }
}

void fillBand(QCPPainter& painter, const Band& piece, const QColor& fill) {
    painter.setPen(Qt::NoPen);
    painter.setBrush(fill);
    painter.modes().testFlag(QCPPainter::pmVectorized) ? drawBandShape(painter, piece)
                                                       : drawBandPixels(painter, piece, fill);
    painter.setBrush(Qt::NoBrush);
}

void stroke(QCPPainter& painter, const QVector<QLineF>& lines, const QVector<QPointF>& dots,
            const QColor& color) {
    painter.setAntialiasing(true);
    painter.setPen(QPen(color, line_width, Qt::SolidLine, Qt::FlatCap));
    painter.drawLines(lines);
    painter.setPen(QPen(color, 4, Qt::SolidLine, Qt::RoundCap));
    painter.drawPoints(dots.constData(), static_cast<int>(dots.size()));
}

double mean(const CurveColumn& column) {
    return column.sum / static_cast<double>(column.count);
}

// Calls `draw(begin, end)` for each stretch of columns between gaps.
template <class Draw>
void forPieces(const std::vector<CurveColumn>& columns, Draw draw) {
    for (std::size_t begin = 0; begin < columns.size();) {
        std::size_t end = begin + 1;
        while (end < columns.size() && columns[end].joined) {
            ++end;
        }
        if (!columns[begin].empty()) {
            draw(begin, end);
        }
        begin = end;
    }
}

constexpr double least_mark_spacing = 4;

// Reference of frequency deviations: the carrier of the first visible analysis, or 0.
double referenceFrequency(const std::vector<ShownAnalysis>& analyses) {
    const auto first =
        std::find_if(analyses.begin(), analyses.end(), [](const ShownAnalysis& shown) {
            return shown.visible && shown.analysis && shown.analysis->settings.f0_hz &&
                   std::isfinite(shown.analysis->f0_hz());
        });
    return first == analyses.end() ? 0 : first->analysis->f0_hz();
}

}  // namespace

// The curve of one analysis in one plot: min/max per pixel column, drawn as independent segments
// (QCustomPlot's own graphs take seconds for dense data unless the pen is one pixel wide). Windows
// closer together than pixels that scatter by more than they move are a pale band from the least to
// the greatest with their running mean on it, so that curves over each other stay apart. Missing
// windows leave a gap and a mark at the foot of the plot, however narrow the gap is; values outside
// the axis leave a mark at the edge that they cross.
class DecimatedGraph : public TimeGraph {
public:
    struct Look {
        DisplayScale scale;
        bool band = true;
        // Offset of the pointers to values beyond the frame, 0 to 1 of their distance, so that
        // those of several curves are side by side.
        double pointers_begin = 0;
        QColor color;
        QColor missing;  // marks of missing windows
    };

    // `together`: all curves of the plot, which outlive this one: the first draws the bands of all
    // of them, the paler the more there are, so that no band covers a line.
    DecimatedGraph(QCPAxis* keyAxis, QCPAxis* valueAxis, std::shared_ptr<const CurveData> data,
                   const Look& look, const std::vector<DecimatedGraph*>& together)
        : TimeGraph(keyAxis, valueAxis), data_(std::move(data)), look_(look), all_(together) {}

    const CurveData& data() const { return *data_; }
    const DisplayScale& scale() const { return look_.scale; }
    const QColor& color() const { return look_.color; }

    // The columns of a time range over a width in pixels; cached for the last arguments.
    const std::vector<CurveColumn>& columns(const AxisRange& time, int width) const {
        if (!(time == cached_time_) || width != cached_width_) {
            cached_ = data_->columns(time, std::max(1, width));
            cached_time_ = time;
            cached_width_ = width;
        }
        return cached_;
    }

protected:
    void draw(QCPPainter* painter) override {
        if (keyAxis()->axisRect()->width() < 2) {
            return;
        }
        for (const DecimatedGraph* each : all_) {
            if (all_.front() == this) {
                each->drawBands(*painter);
            }
        }
        if (!noise_.empty()) {
            drawMean(*painter, noise_);
        } else {
            drawLine(*painter, visibleColumns());
        }
        drawMarks(*painter, visibleColumns());
    }

private:
    double pixelX(const CurveColumn& column) const {
        return keyAxis()->coordToPixel(0.5 * (column.time_first + column.time_last));
    }

    double pixelY(double displayed) const {
        const QCPAxis& axis = *valueAxis();
        const QRect rect = axis.axisRect()->rect();
        // Limits coordinates to the range of a painter; values without a logarithm get the lower
        // limit.
        const double beyond = 3.0 * rect.height();
        if (look_.scale.logarithmic && !(displayed > 0)) {
            return rect.bottom() + beyond;
        }
        return std::clamp(axis.coordToPixel(displayed), rect.top() - beyond,
                          rect.bottom() + beyond);
    }

    const std::vector<CurveColumn>& visibleColumns() const {
        const QCPRange key = keyAxis()->range();
        return columns({key.lower, key.upper}, keyAxis()->axisRect()->width());
    }

    // Under dense noise the scatter itself; otherwise a standard deviation. The bands of all graphs
    // are drawn before the first line.
    void drawBands(QCPPainter& painter) const {
        noise_ = noiseColumns();
        if (!noise_.empty()) {
            drawBand(painter, noise_, &CurveColumn::min, &CurveColumn::max);
        } else if (look_.band) {
            drawBand(painter, visibleColumns(), &CurveColumn::band_min, &CurveColumn::band_max);
        }
    }

    QColor bandColor() const {
        return translucent(look_.color, 0.3 / std::sqrt(static_cast<double>(all_.size())));
    }

    // From one value of the columns to another.
    void drawBand(QCPPainter& painter, const std::vector<CurveColumn>& columns,
                  double CurveColumn::*low, double CurveColumn::*high) const {
        Band piece;
        const auto flush = [&] {
            fillBand(painter, piece, bandColor());
            piece.clear();
        };
        for (const CurveColumn& column : columns) {
            if (column.empty() || !column.joined || column.wraps) {
                flush();
            }
            if (column.empty() || column.wraps) {
                continue;
            }
            const AxisRange band = displayedInterval(look_.scale, column.*low, column.*high);
            const double x = pixelX(column);
            piece.emplace_back(x, pixelY(band.upper), x, pixelY(band.lower));
        }
        flush();
    }

    void drawLine(QCPPainter& painter, const std::vector<CurveColumn>& columns) const {
        QVector<QLineF> lines;
        QVector<QPointF> dots;
        lines.reserve(2 * static_cast<qsizetype>(columns.size()));
        QPointF before;
        double last_dot = -1e9;
        for (std::size_t i = 0; i < columns.size(); ++i) {
            const CurveColumn& column = columns[i];
            if (column.empty()) {
                continue;
            }
            const double x = pixelX(column);
            const QPointF first(x, pixelY(look_.scale.value(column.first)));
            if (column.joined) {
                lines.append({before, first});
            }
            const auto vertical = [&](double low, double high) {
                const AxisRange shown = displayedInterval(look_.scale, low, high);
                lines.append({x, pixelY(shown.lower), x, pixelY(shown.upper)});
            };
            if (column.wraps) {
                vertical(column.min, column.negative_max);
                vertical(column.positive_min, column.max);
            } else if (column.min < column.max) {
                vertical(column.min, column.max);
            }
            // Dots for windows far apart, and for a single window between two missing ones.
            const bool alone =
                !column.joined && (i + 1 == columns.size() || !columns[i + 1].joined);
            if (alone || (column.time_first == column.time_last && x - last_dot > dot_spacing &&
                          i + 1 < columns.size() &&
                          keyAxis()->coordToPixel(columns[i + 1].time_first) - x > dot_spacing)) {
                dots.append(first);
            }
            last_dot = x;
            before = {x, pixelY(look_.scale.value(column.last))};
        }
        stroke(painter, lines, dots, look_.color);
    }

    // The columns, joined where they are so narrow that they hold too few windows; empty without
    // dense noise. They begin at whole multiples of their width, as those of the curve do.
    std::vector<CurveColumn> noiseColumns() const {
        const std::vector<CurveColumn>& fine = visibleColumns();
        std::size_t windows = 0;
        std::size_t filled = 0;
        for (const CurveColumn& column : fine) {
            windows += column.count;
            filled += column.empty() ? 0 : 1;
        }
        const double pixel_s = keyAxis()->range().size() / keyAxis()->axisRect()->width();
        const double covered =
            fine.empty() ? 0 : (fine.back().time_last - fine.front().time_first) / pixel_s;
        const double density = static_cast<double>(windows) / std::max(1.0, covered);
        if (filled < least_noise_columns || density < least_density) {
            return {};
        }
        const double joined_s = pixel_s * std::ceil(windows_in_column / density);
        const auto place = [joined_s](const CurveColumn& column) {
            return std::floor(column.time_first / joined_s);
        };
        std::vector<CurveColumn> joined;
        for (const CurveColumn& column : fine) {
            if (column.wraps) {
                return {};  // an angle all around has no mean
            }
            const bool same = !joined.empty() && !joined.back().empty() && !column.empty() &&
                              column.joined && place(joined.back()) == place(column);
            same ? append(joined.back(), column) : joined.push_back(column);
            joined.back().wraps = false;  // numbers more than pi apart are no angle
        }
        // Noise: within a column the values differ by more than the means of columns do.
        std::vector<double> heights;
        std::vector<double> steps;
        for (std::size_t k = 0; k < joined.size(); ++k) {
            const CurveColumn& column = joined[k];
            if (column.count > 1) {
                const AxisRange shown = displayedInterval(look_.scale, column.min, column.max);
                heights.push_back(pixelY(shown.lower) - pixelY(shown.upper));
            }
            if (k > 0 && column.joined && !joined[k - 1].empty()) {
                steps.push_back(std::abs(pixelY(look_.scale.value(mean(column))) -
                                         pixelY(look_.scale.value(mean(joined[k - 1])))));
            }
        }
        const double height = median(std::move(heights));
        // Without a step between two columns there is nothing against it: its median is NaN.
        const bool noise = height > least_noise_height && !(2 * median(std::move(steps)) >= height);
        return noise ? joined : std::vector<CurveColumn>();
    }

    void drawMean(QCPPainter& painter, const std::vector<CurveColumn>& columns) const {
        QVector<QLineF> lines;
        QVector<QPointF> dots;
        forPieces(columns, [&](std::size_t begin, std::size_t end) {
            QPointF before;
            for (std::size_t k = begin; k < end; ++k) {
                // As far to the left as to the right, so that a slope does not shift the mean.
                const std::size_t reach = std::min({mean_reach, k - begin, end - 1 - k});
                CurveColumn around;
                for (std::size_t i = k - reach; i <= k + reach; ++i) {
                    append(around, columns[i]);
                }
                const QPointF now(pixelX(columns[k]), pixelY(look_.scale.value(mean(around))));
                if (k > begin) {
                    lines.append({before, now});
                } else if (end - begin == 1) {
                    dots.append(now);
                }
                before = now;
            }
        });
        stroke(painter, lines, dots, look_.color);
    }

    void drawMarks(QCPPainter& painter, const std::vector<CurveColumn>& columns) const {
        if (data_->empty()) {
            return;  // the algorithm does not estimate it; the plot shows a text
        }
        const QRect rect = keyAxis()->axisRect()->rect();
        const QCPRange shown = valueAxis()->range();
        painter.setAntialiasing(false);
        painter.setPen(Qt::NoPen);
        QVector<QPolygonF> pointers;
        // Position of the last one.
        double above = rect.left() + (look_.pointers_begin - 1) * pointer_spacing;
        double below = above;
        for (const CurveColumn& column : columns) {
            const double from = keyAxis()->coordToPixel(column.time_first);
            const double to = keyAxis()->coordToPixel(column.time_last);
            const QRectF place(from, 0, std::max(1.0, to - from), 3);
            if (column.missing) {
                painter.fillRect(QRectF(place.translated(0, rect.bottom() - 3)), look_.missing);
            }
            if (column.empty()) {
                continue;
            }
            const AxisRange values = displayedInterval(look_.scale, column.min, column.max);
            if (values.upper > shown.upper && from - above >= pointer_spacing) {
                above = from;
                pointers.append(pointer({from, rect.top() + 1.0}, 1));
            }
            if (values.lower < shown.lower && from - below >= pointer_spacing) {
                below = from;
                pointers.append(pointer({from, double(rect.bottom())}, -1));
            }
        }
        painter.setAntialiasing(true);
        painter.setBrush(look_.color);
        for (const QPolygonF& each : pointers) {
            painter.drawPolygon(each);
        }
        painter.setBrush(Qt::NoBrush);
    }

    std::shared_ptr<const CurveData> data_;
    Look look_;
    const std::vector<DecimatedGraph*>& all_;
    mutable AxisRange cached_time_;
    mutable int cached_width_ = 0;
    mutable std::vector<CurveColumn> cached_;
    mutable std::vector<CurveColumn> noise_;  // of the present drawing
};

PlotPanel::PlotPanel(QCustomPlot* plot, SlowVariable variable, PlotHead head)
    : TimePanel(plot, head), variable_(variable) {}

void PlotPanel::setContent(const PlotContent& content, const QFont& font) {
    const DisplayUnits& units = content.units;
    bands_ = units.sigma_bands && info(variable_).has_sd;
    marks_s_ = content.marks_s;
    setLook(content.theme, font);
    removeGraphs();
    const DisplayScale scale = displayScale(variable_, units, referenceFrequency(content.analyses));
    DisplayScale drawn = scale;  // of values that are on their branch, and of their bands
    drawn.period = 0;
    QStringList file_units;
    for (const ShownAnalysis& shown : content.analyses) {
        if (!shown.visible || !shown.analysis || shown.analysis->track.rows() == 0) {
            continue;
        }
        file_units << shown.unit;
        const DecimatedGraph::Look look{
            drawn, bands_,
            static_cast<double>(graphs_.size()) / static_cast<double>(content.analyses.size()),
            readable(shown.color, theme(), shown.shade), theme().warning};
        graphs_.push_back(new DecimatedGraph(timeAxis(), valueAxis(), shown.curve(variable_, scale),
                                             look, graphs_));
    }
    addTrend(content, scale);
    const bool degrees =
        info(variable_).quantity == Quantity::angle && units.angle == AngleUnit::degrees;
    valueTicker().setSteps(degrees ? TickSteps::degrees : TickSteps::decimal);
    valueTicker().setLogarithmic(scale.logarithmic);
    valueAxis()->setScaleType(scale.logarithmic ? QCPAxis::stLogarithmic : QCPAxis::stLinear);
    const QString empty = emptyText();
    setScaleShown(!graphs_.empty() && empty.isEmpty());
    const QString of_file = commonUnit(file_units);
    const QString unit = displayUnit(variable_, units, of_file);
    setTexts({displaySymbol(variable_, units), unit, takesPrefix(variable_, units, of_file),
              unit.isEmpty() || unit == QStringLiteral("°") ? unit : ' ' + unit, empty});
}

void PlotPanel::addTrend(const PlotContent& content, const DisplayScale& scale) {
    const auto found = std::ranges::find(content.trends, variable_, &TrendCurve::variable);
    if (found == content.trends.end()) {
        return;
    }
    trend_ = mParentPlot->addGraph(timeAxis(), valueAxis());
    QVector<double> times(found->time_s.begin(), found->time_s.end());
    QVector<double> values(found->value.begin(), found->value.end());
    const auto of = std::ranges::find(content.analyses, found->of, &ShownAnalysis::id);
    const double turn =
        (isWrapped(variable_) ? 2 * std::numbers::pi : scale.period) * std::abs(scale.factor);
    if (isWrapped(variable_) && of != content.analyses.end()) {
        // Onto the branch of its curve.
        const auto curve = of->curve(variable_);
        for (qsizetype k = 0; k < values.size(); ++k) {
            const double on_curve = scale.value(curve->value(curve->nearest(times[k])));
            values[k] =
                std::isfinite(on_curve) ? nearest_branch(values[k], on_curve, turn) : values[k];
        }
    }
    for (qsizetype k = values.size() - 1; turn > 0 && k > 0; --k) {
        if (std::abs(values[k] - values[k - 1]) > turn / 2) {
            values.insert(k, std::nan(""));  // from one end of the branch to the other
            times.insert(k, times[k]);
        }
    }
    trend_->setData(times, values, true);
    trend_->setPen(QPen(theme().text, 1.6, Qt::DashLine));
    trend_->setSelectable(QCP::stNone);
}

void PlotPanel::removeGraphs() {
    for (DecimatedGraph* graph : graphs_) {
        mParentPlot->removePlottable(graph);
    }
    graphs_.clear();
    if (trend_) {
        mParentPlot->removeGraph(trend_);
    }
}

AxisRange PlotPanel::automaticValues() const {
    ValueRange range;
    bool logarithmic = false;
    for (const DecimatedGraph* graph : graphs_) {
        logarithmic = graph->scale().logarithmic;
        range.add(graph->columns(time(), expectedSize().width()), graph->scale(), bands_);
    }
    return range.range(logarithmic).value_or(logarithmic ? AxisRange{0.1, 1} : AxisRange{0, 1});
}

void PlotPanel::drawDots(QCPPainter& painter, double time_s) const {
    painter.setAntialiasing(true);
    for (const DecimatedGraph* graph : graphs_) {
        const CurveData& data = graph->data();
        if (!covers(data.analysis(), time_s)) {
            continue;
        }
        const std::size_t row = data.nearest(time_s);
        const double value = graph->scale().value(data.value(row));
        if (std::isfinite(value) && values().contains(value) && time().contains(data.time(row))) {
            painter.setPen(QPen(theme().panelBackground, 1));
            painter.setBrush(graph->color());
            painter.drawEllipse(
                QPointF(timeAxis()->coordToPixel(data.time(row)), valueAxis()->coordToPixel(value)),
                3.5, 3.5);
        }
    }
    painter.setBrush(Qt::NoBrush);
}

QString PlotPanel::emptyText() const {
    const bool some = std::ranges::any_of(
        graphs_, [](const DecimatedGraph* graph) { return !graph->data().empty(); });
    if (graphs_.empty() || some) {
        return {};
    }
    const bool by_design = std::ranges::all_of(graphs_, [](const DecimatedGraph* graph) {
        return std::ranges::all_of(graph->data().analysis().track.flags(),
                                   [](Flags f) { return has(f, Flag::no_quadrature); });
    });
    return by_design && variable_ == SlowVariable::a_B
               ? QCoreApplication::translate("PlotPanel", "not estimated by this algorithm")
               : QCoreApplication::translate("PlotPanel", "no window has a value");
}

void PlotPanel::draw(QCPPainter* painter) {
    TimePanel::draw(painter);
    painter->setAntialiasing(false);
    painter->setPen(QPen(theme().mutedText, 1, Qt::DotLine));
    double last = -std::numeric_limits<double>::infinity();
    for (auto mark = std::ranges::lower_bound(marks_s_, time().lower);
         mark != marks_s_.end() && *mark <= time().upper; ++mark) {
        const double x = timeAxis()->coordToPixel(*mark);
        // Indistinguishable marks are drawn once.
        if (x - last >= least_mark_spacing) {
            painter->drawLine(QLineF(x, rect().top(), x, rect().bottom()));
            last = x;
        }
    }
}

}  // namespace vybeg::ui
