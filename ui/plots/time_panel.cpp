#include "ui/plots/time_panel.h"

#include "ui/words/rich_text.h"

#include <algorithm>
#include <cmath>

namespace vybeg::ui {

void PanelTicker::setRoom(double length, const QFont& font, double beyond) {
    length_ = length;
    font_ = font;
    beyond_ = beyond;
}

void PanelTicker::generate(const QCPRange& range, const QLocale&, QChar, int,
                           QVector<double>& ticks, QVector<double>* subTicks,
                           QVector<QString>* tickLabels) {
    const QFontMetricsF metrics(font_);
    TickRoom room;
    room.length = length_;
    if (orientation_ == Qt::Horizontal) {
        room.spacing = 58;
        room.gap = 16;
        room.extent = [&](const QString& label) { return metrics.horizontalAdvance(label); };
    } else {
        room.spacing = 2.1 * metrics.height();
        room.gap = 1;
        room.extent = [&](const QString&) { return metrics.ascent() + metrics.descent(); };
    }
    const AxisRange shown{range.lower, range.upper};
    ticks_ = logarithmic_ ? logTicks(shown, room) : linearTicks(shown, room, steps_);
    ticks = QVector<double>(ticks_.positions.begin(), ticks_.positions.end());
    if (subTicks) {
        *subTicks = QVector<double>(ticks_.between.begin(), ticks_.between.end());
    }
    if (tickLabels) {
        *tickLabels = ticks_.labels;
        omitLabels(shown, *tickLabels);
    }
}

void PanelTicker::omitLabels(const AxisRange& range, QVector<QString>& labels) const {
    constexpr double gap = 8;
    const QFontMetricsF metrics(font_);
    const std::vector<double> texts = shared_ ? shared_(ticks_) : std::vector<double>();
    const auto part = [&](double position) {
        return logarithmic_ ? std::log(position / range.lower) / std::log(range.upper / range.lower)
                            : (position - range.lower) / range.span();
    };
    for (qsizetype k = 0; k < labels.size(); ++k) {
        const double at = part(ticks_.positions[static_cast<std::size_t>(k)]) * length_;
        const double width = metrics.horizontalAdvance(labels[k]);
        if (orientation_ == Qt::Horizontal) {
            const double end = texts.empty() ? length_ + beyond_ : length_ - texts.front() - gap;
            if (at + 0.5 * width > end) {
                labels[k].clear();  // it would be cut
            }
        } else if (shared_) {
            const double line = metrics.height();
            const double top = length_ - at - 0.5 * line;
            const double bottom = top + line;
            bool touches = top < -0.5 * line || bottom > length_ + 0.5 * line;
            for (std::size_t row = 0; row < texts.size(); ++row) {
                touches = touches || (static_cast<double>(row) *
                                          line<bottom&& static_cast<double>(row + 1) * line> top &&
                                      texts[row] + width + gap > shared_room_);
            }
            if (touches) {
                labels[k].clear();
            }
        }
    }
}

FramedPanel::FramedPanel(QCustomPlot* plot, const QMargins& around) : QCPAxisRect(plot, false) {
    setLayer(QStringLiteral("background"));  // below the grid
    for (const auto type : {QCPAxis::atLeft, QCPAxis::atBottom, QCPAxis::atRight, QCPAxis::atTop}) {
        QCPAxis* side = addAxis(type);
        side->setLayer(QStringLiteral("axes"));
        side->grid()->setLayer(QStringLiteral("grid"));
        side->setSubTicks(false);
        side->setTickLengthIn(0);
        const bool scale = type == QCPAxis::atLeft || type == QCPAxis::atBottom;
        side->grid()->setVisible(scale);
        side->setTicks(scale);
        side->setTickLabels(scale);
    }
    axis(QCPAxis::atBottom)->setTicker(x_);
    axis(QCPAxis::atLeft)->setTicker(y_);
    axis(QCPAxis::atBottom)->setTickLength(0, 4);
    axis(QCPAxis::atLeft)->setTickLength(0, 4);
    setAutoMargins(QCP::msLeft);
    setMinimumMargins({around.left(), 0, 0, 0});
    setMargins(around);
}

void FramedPanel::setLook(const Theme& theme, const QFont& font) {
    theme_ = theme;
    font_ = font;
    tick_font_ = font;
    tick_font_.setPixelSize(std::max(9, font.pixelSize() - 1));
    setBackground(QBrush(theme.panelBackground));
    for (QCPAxis* side : axes()) {
        side->setBasePen(QPen(theme.axis, 1));
        side->setTickPen(QPen(theme.axis, 1));
        side->setTickLabelColor(theme.text);
        side->setTickLabelFont(tick_font_);
        side->grid()->setPen(QPen(theme.grid, 1));
        side->grid()->setZeroLinePen(QPen(theme.zeroLine, 1));
    }
}

void FramedPanel::update(UpdatePhase phase) {
    if (phase == upPreparation) {
        y_->setRoom(expected_.height(), tick_font_);
        x_->setRoom(expected_.width(), tick_font_, margins().right() - 2);
    }
    QCPAxisRect::update(phase);
}

void FramedPanel::drawEmpty(QCPPainter& painter, const QString& text) const {
    painter.setPen(theme_.mutedText);
    painter.setFont(font_);
    painter.drawText(QRectF(rect()).adjusted(12, 4, -12, -4),
                     int(Qt::AlignCenter) | Qt::TextWordWrap, text);
}

namespace {

constexpr double margin_edge = 3;  // from the window's edge to a text in the margin
constexpr double unit_gap = 8;

}  // namespace

QMargins TimePanel::room(PlotHead head) {
    return head == PlotHead::line ? QMargins(60, 21, 16, 3) : QMargins(56, 0, 8, 4);
}

// The labels under the lowest panel have a separate row, so that all panels are equally high. On
// the screen tick labels leave room for the lines in the margin and the name of the time axis.
TimePanel::TimePanel(QCustomPlot* plot, PlotHead head)
    : FramedPanel(plot, room(head)), head_(head) {
    timeAxis()->setTickLabelPadding(5);
    valueAxis()->setTickLabelPadding(4);
    if (head == PlotHead::line) {
        return;
    }
    valueTicker().setShared(
        [this](const AxisTicks& ticks) {
            std::vector<double> widths;
            for (const MarginLine& line : marginLines(ticks)) {
                widths.push_back(line.width + margin_edge);
            }
            return widths;
        },
        room(head).left() - 4);
    ticker(QCPAxis::atBottom).setShared([this](const AxisTicks& ticks) {
        return std::vector<double>{indexTextWidth(timeAxisName(ticks), font())};
    });
}

void TimePanel::setLook(const Theme& theme, const QFont& font) {
    FramedPanel::setLook(theme, font);
    timeAxis()->grid()->setZeroLinePen(Qt::NoPen);
}

void TimePanel::setScaleShown(bool shown) {
    valueAxis()->setTickLabels(shown);
    valueAxis()->setTicks(shown);
}

void TimePanel::draw(QCPPainter* painter) {
    QCPAxisRect::draw(painter);
    if (head_ == PlotHead::line) {
        drawHead(*painter);
    } else {
        drawMarginLines(*painter);
    }
    if (!texts_.empty.isEmpty()) {
        drawEmpty(*painter, texts_.empty);
    }
}

void TimePanel::drawHead(QCPPainter& painter) const {
    const AxisTicks& ticks = valueTicker().ticks();
    const double base = rect().top() - 7;
    painter.setPen(theme().text);
    const double x = rect().left() + drawIndexText(painter, {double(rect().left()), base},
                                                   texts_.symbol + offset(ticks), font());
    painter.setPen(theme().mutedText);
    drawIndexText(painter, {x + unit_gap, base}, unit(ticks), font());
    if (!letter_.isEmpty()) {
        QFont italic(font());
        italic.setItalic(true);
        painter.setFont(italic);
        painter.setPen(theme().text);
        const int head = room(head_).top();
        painter.drawText(QRectF(rect().left(), rect().top() - head, rect().width(), head - 3),
                         int(Qt::AlignRight | Qt::AlignVCenter), letter_);
    }
}

void TimePanel::drawMarginLines(QCPPainter& painter) const {
    const QFontMetricsF metrics(tickFont());
    double base = rect().top() + metrics.ascent();
    for (const MarginLine& line : marginLines(valueTicker().ticks())) {
        painter.setPen(line.muted ? theme().mutedText : theme().text);
        drawIndexText(painter, {outerRect().left() + margin_edge, base}, line.text,
                      line.muted ? tickFont() : font());
        base += metrics.height();
    }
}

std::vector<TimePanel::MarginLine> TimePanel::marginLines(const AxisTicks& ticks) const {
    const auto line = [&](const QString& text, bool muted) {
        return MarginLine{text, muted, indexTextWidth(text, muted ? tickFont() : font())};
    };
    std::vector<MarginLine> lines{line(texts_.symbol, false)};
    const QString from = offset(ticks);
    const QString of = unit(ticks);
    if (!from.isEmpty()) {
        lines.push_back(line(from.trimmed(), true));
    } else if (const MarginLine both = line(texts_.symbol + QStringLiteral(", ") + of, false);
               !of.isEmpty() && both.width + margin_edge < room(PlotHead::margin).left()) {
        return {both};
    }
    if (!of.isEmpty()) {
        lines.push_back(line(of, true));
    }
    return lines;
}

int TimePanel::calculateAutoMargin(QCP::MarginSide side) {
    int margin = QCPAxisRect::calculateAutoMargin(side);
    if (head_ == PlotHead::margin && side == QCP::msLeft) {
        for (const MarginLine& line : marginLines(valueTicker().ticks())) {
            margin = std::max(margin, static_cast<int>(std::ceil(line.width + 2 * margin_edge)));
        }
    }
    return margin;
}

}  // namespace vybeg::ui
