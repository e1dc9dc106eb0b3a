#include "ui/signals/signal_graph.h"

#include "ui/plots/envelope_paint.h"

#include <algorithm>
#include <cmath>

namespace vybeg::ui {
namespace {

constexpr double dots_apart = 4;  // pixels from which on samples are dots
constexpr double large_dots_apart = 10;
constexpr int most_antialiased = 6000;  // points of a line

// Draws each run of finite points.
template <class Draw>
void eachRun(const QPolygonF& points, Draw draw) {
    qsizetype from = 0;
    while (from < points.size()) {
        qsizetype to = from;
        while (to < points.size() && std::isfinite(points[to].y())) {
            ++to;
        }
        if (to > from) {
            draw(points.constData() + from, static_cast<int>(to - from));
        }
        from = to + 1;
    }
}

}  // namespace

SignalGraph::SignalGraph(QCPAxis* keyAxis, QCPAxis* valueAxis, SignalPart part)
    : QCPAbstractPlottable(keyAxis, valueAxis), part_(part) {
    setSelectable(QCP::stNone);
}

double SignalGraph::selectTest(const QPointF&, bool, QVariant*) const {
    return -1;
}

QCPRange SignalGraph::getKeyRange(bool& foundRange, QCP::SignDomain) const {
    foundRange = false;
    return {};
}

QCPRange SignalGraph::getValueRange(bool& foundRange, QCP::SignDomain, const QCPRange&) const {
    foundRange = false;
    return {};
}

void SignalGraph::drawLegendIcon(QCPPainter*, const QRectF&) const {}

template <class Value>
QPolygonF SignalGraph::points(Value value) const {
    QPolygonF list;
    list.reserve(static_cast<qsizetype>(picture_->to - picture_->from));
    for (std::size_t k = picture_->from; k < picture_->to; ++k) {
        const double stored = value(*content_->excerpt, k);
        list.append(
            {x(content_->excerpt->time_s(k)), std::isfinite(stored) ? y(stored) : std::nan("")});
    }
    return list;
}

double SignalGraph::samplesApart() const {
    return std::abs(x(1 / content_->rate_hz) - x(0));
}

void SignalGraph::draw(QCPPainter* painter) {
    if (!content_ || !picture_) {
        return;
    }
    const bool some = picture_->samples && content_->excerpt && picture_->to > picture_->from;
    if (!picture_->columns.empty() || !picture_->rms.empty()) {
        painter->save();
        if (some) {
            // Beside the samples that are there already.
            const QRectF all(clipRect());
            const double from = x(content_->excerpt->time_s(picture_->from));
            const double to = x(content_->excerpt->time_s(picture_->to - 1));
            QRegion beside(clipRect());
            beside -= QRectF(from, all.top(), to - from, all.height()).toAlignedRect();
            painter->setClipRegion(beside, Qt::IntersectClip);
        }
        part_ == SignalPart::residual ? drawRms(*painter) : drawColumns(*painter);
        painter->restore();
    }
    if (part_ == SignalPart::residual) {
        if (some && content_->analysis) {
            drawDots(*painter, points([](const auto& e, auto k) { return e.residual_c(k); }),
                     content_->theme.signalC);
            drawDots(*painter, points([](const auto& e, auto k) { return e.residual_d(k); }),
                     content_->theme.signalD);
        }
        return;
    }
    const QColor ink = isD() ? content_->theme.signalD : content_->theme.signalC;
    QPolygonF samples;
    if (some) {
        samples = points([d = isD()](const auto& e, auto k) { return d ? e.d[k] : e.c[k]; });
        const bool dotted = samplesApart() >= dots_apart;
        QColor line = ink;
        line.setAlphaF(dotted ? 0.45F : 1.0F);
        drawLines(*painter, samples, line);
        drawLost(*painter);
    }
    drawCurve(*painter, 1);
    if (!picture_->samples) {
        drawCurve(*painter, -1);
    }
    if (some && samplesApart() >= dots_apart) {
        drawDots(*painter, samples, ink);
    }
}

void SignalGraph::drawColumns(QCPPainter& painter) const {
    if (picture_->columns.empty()) {
        return;
    }
    const double from = x(picture_->columns_from_s);
    const double to = x(picture_->columns_to_s);
    const QRectF area(from, clipRect().top(), to - from, clipRect().height());
    const ColumnRow row{area, (to - from) / static_cast<double>(picture_->columns.size())};
    const Calibration& calibration = content_->calibration;
    const double gain = isD() ? calibration.kappa : 1;
    const double offset = isD() ? calibration.offset_d : calibration.offset_c;
    const double scale = gain * (y(0) - y(1));
    const EnvelopeLane lane =
        isD() ? EnvelopeLane{content_->theme.signalD, y(0) + scale * offset, scale,
                             &EnvelopeBucket::d_min, &EnvelopeBucket::d_max}
              : EnvelopeLane{content_->theme.signalC, y(0) + scale * offset, scale,
                             &EnvelopeBucket::c_min, &EnvelopeBucket::c_max};
    painter.setAntialiasing(false);
    paintUnread(painter, row, picture_->columns, content_->theme);
    paintLane(painter, row, picture_->columns, lane);
    paintMissing(painter, row, picture_->columns, content_->theme);
}

// Between minus and plus the rms a pale band, and what lies between the least and the largest rms
// of a column in full.
void SignalGraph::drawRms(QCPPainter& painter) const {
    QVector<QLineF> band;
    QVector<QLineF> rims;
    // Windows may be wider than a pixel.
    const double half = 0.5 * static_cast<double>(content_->analysis->plan.hop) / content_->rate_hz;
    double next = clipRect().left();  // the first pixel that is not drawn yet
    for (const CurveColumn& column : picture_->rms) {
        if (column.empty()) {
            continue;
        }
        const double from = std::floor(x(column.time_first - half));
        const double to = std::min(std::max(from, x(column.time_last + half) - 1),
                                   static_cast<double>(clipRect().right()));
        for (next = std::max(next, from); next <= to; ++next) {
            band.append({next, y(-column.min), next, y(column.min)});
            for (const double sign : {-1, 1}) {
                rims.append({next, y(sign * column.min) - 0.5, next, y(sign * column.max) + 0.5});
            }
        }
    }
    QColor pale = content_->theme.text;
    pale.setAlphaF(0.16F);
    painter.setAntialiasing(false);
    painter.setPen(QPen(pale, 1, Qt::SolidLine, Qt::FlatCap));
    painter.drawLines(band);
    painter.setPen(QPen(content_->theme.mutedText, 1, Qt::SolidLine, Qt::FlatCap));
    painter.drawLines(rims);
}

void SignalGraph::drawLines(QCPPainter& painter, const QPolygonF& points,
                            const QColor& color) const {
    const bool smooth = points.size() <= most_antialiased;
    painter.setAntialiasing(smooth);
    painter.setPen(QPen(color, 1));
    eachRun(points, [&](const QPointF* run, int count) { painter.drawPolyline(run, count); });
}

void SignalGraph::drawCurve(QCPPainter& painter, double sign) const {
    const SignalCurve& curve = picture_->wave;
    const std::vector<double>& values = isD() ? curve.d : curve.c;
    QPolygonF points;
    points.reserve(static_cast<qsizetype>(values.size()));
    for (std::size_t k = 0; k < values.size(); ++k) {
        points.append(
            {x(curve.time_s[k]), std::isfinite(values[k]) ? y(sign * values[k]) : std::nan("")});
    }
    const bool smooth = points.size() <= most_antialiased;
    painter.setAntialiasing(smooth);
    painter.setPen(QPen(content_->theme.text, smooth ? 1.4 : 1));
    eachRun(points, [&](const QPointF* run, int count) { painter.drawPolyline(run, count); });
}

void SignalGraph::drawDots(QCPPainter& painter, const QPolygonF& points,
                           const QColor& color) const {
    const double apart = samplesApart();
    if (apart < dots_apart) {
        QPolygonF finite;
        finite.reserve(points.size());
        std::ranges::copy_if(points, std::back_inserter(finite),
                             [](const QPointF& point) { return std::isfinite(point.y()); });
        painter.setAntialiasing(false);
        painter.setPen(QPen(color, apart < 1 ? 1 : 2));
        painter.drawPoints(finite);
        return;
    }
    const double radius = apart < large_dots_apart ? 1.8 : 2.8;
    painter.setAntialiasing(true);
    painter.setPen(Qt::NoPen);
    painter.setBrush(color);
    for (const QPointF& point : points) {
        if (std::isfinite(point.y())) {
            painter.drawEllipse(point, radius, radius);
        }
    }
    painter.setBrush(Qt::NoBrush);
}

// Missing samples, as in the columns.
void SignalGraph::drawLost(QCPPainter& painter) const {
    const std::vector<double>& values = isD() ? content_->excerpt->d : content_->excerpt->c;
    QColor veil = content_->theme.warning;
    veil.setAlphaF(0.35F);
    const double width = std::max(1., samplesApart());
    for (std::size_t k = picture_->from; k < picture_->to; ++k) {
        if (!std::isfinite(values[k])) {
            painter.fillRect(QRectF(x(content_->excerpt->time_s(k)) - 0.5 * width, clipRect().top(),
                                    width, clipRect().height()),
                             veil);
        }
    }
}

}  // namespace vybeg::ui
