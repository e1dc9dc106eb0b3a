#include "ui/plots/decimated_graph.h"

#include "ui/plots/value_range.h"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace vybeg::ui {
namespace {

constexpr double line_width = 1.4;
// Distance of windows above which each gets a dot, pixels.
constexpr double dot_spacing = 9;
// Distance of the pointers to parts of the curve beyond the frame, pixels; closer ones would merge
// into a bar.
constexpr double pointer_spacing = 24;

// The band of one standard deviation at one column, pixels.
struct BandPoint {
    double x = 0;
    double top = 0;
    double bottom = 0;
};

// A small triangle whose tip touches the frame; `inwards` is +1 at the top and -1 at the foot.
QPolygonF pointer(const QPointF& tip, double inwards) {
    constexpr double half = 3.5;
    return {{tip, tip + QPointF(half, 5 * inwards), tip + QPointF(-half, 5 * inwards)}};
}

void drawBandShape(QCPPainter& painter, const std::vector<BandPoint>& piece) {
    QPolygonF shape;
    for (const BandPoint& point : piece) {
        shape.append({point.x, point.top});
    }
    for (auto point = piece.rbegin(); point != piece.rend(); ++point) {
        shape.append({point->x, point->bottom});
    }
    if (!shape.isEmpty()) {
        painter.drawPolygon(shape);
    }
}

// Draws the band pixel column by pixel column. A polygon with a noisy outline takes a raster
// painter 20 ms and more per plot, this a fraction of 1 ms.
void drawBandPixels(QCPPainter& painter, const std::vector<BandPoint>& piece, const QColor& fill) {
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
        add(std::floor(piece[0].x), piece[0].top, piece[0].bottom);
    }
    for (std::size_t i = 1; i < piece.size(); ++i) {
        const BandPoint& from = piece[i - 1];
        const BandPoint& to = piece[i];
        for (double x = std::ceil(from.x); x < to.x; x += 1) {
            const double part = (x - from.x) / (to.x - from.x);
            add(x, std::lerp(from.top, to.top, part), std::lerp(from.bottom, to.bottom, part));
        }
    }
}

}  // namespace

QVector<double> dashPattern(Qt::PenStyle dash) {
    switch (dash) {
        case Qt::DashLine: return {14, 5};
        case Qt::DashDotLine: return {14, 4, 3, 4};
        case Qt::DotLine: return {4, 4};
        case Qt::DashDotDotLine: return {14, 4, 3, 4, 3, 4};
        default: return {};
    }
}

DecimatedGraph::DecimatedGraph(QCPAxis* keyAxis, QCPAxis* valueAxis,
                               std::shared_ptr<const CurveData> data)
    : QCPAbstractPlottable(keyAxis, valueAxis), data_(std::move(data)) {
    setSelectable(QCP::stNone);
}

void DecimatedGraph::setLook(const QColor& color, Qt::PenStyle dash, const QColor& missing) {
    color_ = color;
    missing_ = missing;
    pattern_ = dashPattern(dash);
}

const std::vector<CurveColumn>& DecimatedGraph::columns(const AxisRange& time, int width) const {
    if (!(time == cached_time_) || width != cached_width_) {
        cached_ = data_->columns(time, std::max(1, width));
        cached_time_ = time;
        cached_width_ = width;
    }
    return cached_;
}

double DecimatedGraph::selectTest(const QPointF&, bool, QVariant*) const {
    return -1;
}

QCPRange DecimatedGraph::getKeyRange(bool& foundRange, QCP::SignDomain) const {
    foundRange = data_->rows() > 0;
    return foundRange ? QCPRange(data_->time(0), data_->time(data_->rows() - 1)) : QCPRange();
}

QCPRange DecimatedGraph::getValueRange(bool& foundRange, QCP::SignDomain,
                                       const QCPRange& inKeyRange) const {
    bool has_time = false;
    const QCPRange all = getKeyRange(has_time, QCP::sdBoth);
    const QCPRange time = inKeyRange == QCPRange() ? all : inKeyRange;
    ValueRange range;
    if (has_time && time.size() > 0) {
        range.add(data_->columns({time.lower, time.upper}, 1000), scale_, false);
    }
    const auto found = range.range(scale_.logarithmic);
    foundRange = found.has_value();
    return found ? QCPRange(found->lower, found->upper) : QCPRange();
}

double DecimatedGraph::pixelY(double displayed) const {
    const QCPAxis& axis = *valueAxis();
    const QRect rect = axis.axisRect()->rect();
    // Limits coordinates to the range of a painter; values without a logarithm get the lower limit.
    const double beyond = 3.0 * rect.height();
    if (scale_.logarithmic && !(displayed > 0)) {
        return rect.bottom() + beyond;
    }
    return std::clamp(axis.coordToPixel(displayed), rect.top() - beyond, rect.bottom() + beyond);
}

void DecimatedGraph::draw(QCPPainter* painter) {
    const QCPRange key = keyAxis()->range();
    const int width = keyAxis()->axisRect()->width();
    if (width < 2 || data_->rows() == 0) {
        return;
    }
    const auto& visible = columns({key.lower, key.upper}, width);
    if (band_) {
        drawBand(*painter, visible);
    }
    drawLine(*painter, visible);
    drawMarks(*painter, visible);
}

void DecimatedGraph::drawBand(QCPPainter& painter, const std::vector<CurveColumn>& columns) const {
    QColor fill = color_;
    fill.setAlphaF(0.22f);
    painter.setPen(Qt::NoPen);
    painter.setBrush(fill);
    std::vector<BandPoint> piece;
    const auto flush = [&] {
        painter.modes().testFlag(QCPPainter::pmVectorized) ? drawBandShape(painter, piece)
                                                           : drawBandPixels(painter, piece, fill);
        piece.clear();
    };
    for (const CurveColumn& column : columns) {
        if (column.empty() || !column.joined || column.wraps) {
            flush();
        }
        if (column.empty() || column.wraps) {
            continue;
        }
        const AxisRange band = displayedInterval(scale_, column.band_min, column.band_max);
        const double x = keyAxis()->coordToPixel(0.5 * (column.time_first + column.time_last));
        piece.push_back({x, pixelY(band.upper), pixelY(band.lower)});
    }
    flush();
    painter.setBrush(Qt::NoBrush);
}

void DecimatedGraph::drawLine(QCPPainter& painter, const std::vector<CurveColumn>& columns) const {
    QVector<QLineF> lines;
    QVector<QPointF> dots;
    lines.reserve(2 * static_cast<qsizetype>(columns.size()));
    // The origin of the pattern is t = 0, so that it moves with the curve.
    const double origin = keyAxis()->coordToPixel(0);
    QPointF before;
    double last_dot = -1e9;
    for (std::size_t i = 0; i < columns.size(); ++i) {
        const CurveColumn& column = columns[i];
        if (column.empty()) {
            continue;
        }
        const double x = keyAxis()->coordToPixel(0.5 * (column.time_first + column.time_last));
        const QPointF first(x, pixelY(scale_.value(column.first)));
        if (column.joined) {
            addDashed(lines, {before, first}, origin);
        }
        const auto vertical = [&](double low, double high) {
            const AxisRange shown = displayedInterval(scale_, low, high);
            addDashed(lines, {x, pixelY(shown.lower), x, pixelY(shown.upper)}, origin);
        };
        if (column.wraps) {
            vertical(column.min, column.negative_max);
            vertical(column.positive_min, column.max);
        } else if (column.min < column.max) {
            vertical(column.min, column.max);
        }
        // Dots for windows far apart, and for a single window between two missing ones.
        const bool alone = !column.joined && (i + 1 == columns.size() || !columns[i + 1].joined);
        if (alone || (column.time_first == column.time_last && x - last_dot > dot_spacing &&
                      i + 1 < columns.size() &&
                      keyAxis()->coordToPixel(columns[i + 1].time_first) - x > dot_spacing)) {
            dots.append(first);
        }
        last_dot = x;
        before = {x, pixelY(scale_.value(column.last))};
    }
    painter.setAntialiasing(true);
    painter.setPen(QPen(color_, line_width, Qt::SolidLine, Qt::FlatCap));
    painter.drawLines(lines);
    painter.setPen(QPen(color_, 4, Qt::SolidLine, Qt::RoundCap));
    painter.drawPoints(dots.constData(), static_cast<int>(dots.size()));
}

void DecimatedGraph::addDashed(QVector<QLineF>& lines, const QLineF& segment, double origin) const {
    if (pattern_.isEmpty()) {
        lines.append(segment);
        return;
    }
    const double period = std::accumulate(pattern_.begin(), pattern_.end(), 0.0);
    const double left = std::max(segment.x1(), double(keyAxis()->axisRect()->left()) - 1);
    const double right = std::min(segment.x2(), double(keyAxis()->axisRect()->right()) + 1);
    const bool upright = segment.dx() < 0.5;  // drawn completely if it starts in a dash
    double dash = origin + std::floor((left - origin) / period) * period;
    for (qsizetype i = 0; dash <= right; i = (i + 2) % pattern_.size()) {
        const double begin = std::max(left, dash);
        const double end = std::min(right, dash + pattern_[i]);
        if (upright && dash <= left && left < dash + pattern_[i]) {
            lines.append(segment);
            return;
        }
        if (!upright && begin < end) {
            lines.append({segment.pointAt((begin - segment.x1()) / segment.dx()),
                          segment.pointAt((end - segment.x1()) / segment.dx())});
        }
        dash += pattern_[i] + pattern_[i + 1];
    }
}

void DecimatedGraph::drawMarks(QCPPainter& painter, const std::vector<CurveColumn>& columns) const {
    if (data_->empty()) {
        return;  // the algorithm does not estimate it; the plot shows a text
    }
    const QRect rect = keyAxis()->axisRect()->rect();
    const QCPRange shown = valueAxis()->range();
    painter.setAntialiasing(false);
    painter.setPen(Qt::NoPen);
    QVector<QPolygonF> pointers;
    // Position of the last one.
    double above = rect.left() + (pointers_begin_ - 1) * pointer_spacing;
    double below = above;
    for (const CurveColumn& column : columns) {
        const double from = keyAxis()->coordToPixel(column.time_first);
        const double to = keyAxis()->coordToPixel(column.time_last);
        const QRectF place(from, 0, std::max(1.0, to - from), 3);
        if (column.missing) {
            painter.fillRect(QRectF(place.translated(0, rect.bottom() - 3)), missing_);
        }
        if (column.empty()) {
            continue;
        }
        const AxisRange values = displayedInterval(scale_, column.min, column.max);
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
    painter.setBrush(color_);
    for (const QPolygonF& each : pointers) {
        painter.drawPolygon(each);
    }
    painter.setBrush(Qt::NoBrush);
}

void DecimatedGraph::drawLegendIcon(QCPPainter* painter, const QRectF& rect) const {
    painter->setPen(QPen(color_, line_width));
    painter->drawLine(QLineF(rect.left(), rect.center().y(), rect.right(), rect.center().y()));
}

}  // namespace vybeg::ui
