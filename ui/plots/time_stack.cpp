#include "ui/plots/time_stack.h"

#include "ui/plots/plot_strip.h"
#include "ui/plots/time_gestures.h"
#include "ui/words/display_units.h"

#include <QCoreApplication>

#include <algorithm>
#include <cmath>
#include <utility>

namespace vybeg::ui {

namespace {

constexpr int time_strip_height = 42;
constexpr int time_row_height = 20;  // of the screen: ticks and name in one row
constexpr int head_strip_height = 24;
constexpr int top_gap = 5;  // of the screen: a tick label at the first plot's top
// From the foot of the lowest panel to the name of the time axis: ticks and their labels.
constexpr int tick_label_room = 20;

// The instant with the resolution of a pixel.
QString timeText(const TimePanel& panel, double time_s) {
    const double pixel = panel.time().span() / std::max(1, panel.width());
    const int decimals = std::clamp(static_cast<int>(std::ceil(-std::log10(pixel))), 0, 9);
    return numberLabel(time_s, decimals) + ' ' + QCoreApplication::translate("DisplayUnits", "s");
}

// Clears the labels of ticks that a label over them leaves in part: "2" of "20". Below what the
// layer holds already.
void clearTouched(QCPPainter& painter, const TimePanel& panel, const QRectF& label) {
    const QFontMetricsF metrics(panel.timeAxis()->tickLabelFont());
    const AxisTicks& ticks = panel.timeTicks();
    painter.setCompositionMode(QPainter::CompositionMode_DestinationOver);
    for (std::size_t k = 0; k < ticks.positions.size(); ++k) {
        const double width = metrics.horizontalAdvance(ticks.labels[static_cast<qsizetype>(k)]) + 2;
        const double left = panel.timeAxis()->coordToPixel(ticks.positions[k]) - 0.5 * width;
        if (left < label.right() && left + width > label.left()) {
            painter.fillRect(QRectF(left, label.top(), width, label.height()),
                             panel.theme().plotBackground);
        }
    }
    painter.setCompositionMode(QPainter::CompositionMode_SourceOver);
}

}  // namespace

void preparePlot(QCustomPlot& plot, const Theme& theme) {
    plot.plotLayout()->clear();
    plot.plotLayout()->setRowSpacing(0);
    plot.plotLayout()->setColumnSpacing(0);
    plot.setAutoAddPlottableToLegend(false);
    plot.setInteractions(QCP::iNone);
    plot.setBackground(QBrush(theme.plotBackground));
}

QFont plotFont(const QWidget& widget) {
    QFont font = widget.font();
    font.setPixelSize(QFontInfo(font).pixelSize());
    return font;
}

TimeStack::TimeStack(QCustomPlot& plot, int column, PlotHead head)
    : plot_(plot), column_(column), head_(head) {
    QObject::connect(&plot_, &QCustomPlot::afterLayout, &context_, [this] { nameTime(); });
}

void TimeStack::build(std::vector<TimePanel*> frames) {
    QCPLayoutGrid& grid = *plot_.plotLayout();
    for (TimePanel* frame : std::exchange(frames_, std::move(frames))) {
        grid.remove(frame);
    }
    if (head_strip_) {
        grid.remove(head_strip_);
        grid.remove(time_strip_);
    }
    grid.simplify();
    delete margins_;
    margins_ = new QCPMarginGroup(&plot_);
    const bool line = head_ == PlotHead::line;
    int row = 0;
    head_strip_ = new PlotStrip(&plot_, line ? head_strip_height : top_gap);
    head_strip_->setInset(8, TimePanel::room(head_).right(), 0);
    grid.addElement(row++, column_, head_strip_);
    for (TimePanel* frame : frames_) {
        frame->setMarginGroup(QCP::msLeft, margins_);
        frame->setTimeLabels(frame == frames_.back());
        grid.addElement(row++, column_, frame);
    }
    time_strip_ = new PlotStrip(&plot_, line ? time_strip_height : time_row_height);
    grid.addElement(row, column_, time_strip_);
}

void TimeStack::setLook(const Theme& theme) {
    theme_ = theme;
    const QFont font = plotFont(plot_);
    time_strip_->setLook(font, theme.text);
    head_strip_->setLook(font, theme.text);
}

TimePanel* TimeStack::frameAt(const QPointF& position) const {
    const auto found = std::ranges::find_if(frames_, [&](const TimePanel* frame) {
        return frame->outerRect().contains(position.toPoint());
    });
    return found == frames_.end() ? nullptr : *found;
}

int TimeStack::frameWidth(int width) const {
    const int left = frames_.empty() ? 0 : frames_.front()->margins().left();
    return std::max(2, width - left - TimePanel::room(head_).right());
}

void TimeStack::prepare(QSize size) {
    if (frames_.empty()) {
        return;
    }
    const int strips = time_strip_->height() + head_strip_->height();
    const int each = (size.height() - strips) / static_cast<int>(frames_.size());
    const QMargins around = TimePanel::room(head_);
    for (TimePanel* frame : frames_) {
        frame->setExpectedSize(
            {frameWidth(size.width()), std::max(1, each - around.top() - around.bottom())});
    }
}

void TimeStack::nameTime() {
    if (frames_.empty()) {
        return;
    }
    const QRect area = frames_.back()->rect();
    const bool beside = head_ == PlotHead::margin;
    time_strip_->setInset(area.left() - time_strip_->rect().left(), TimePanel::room(head_).right(),
                          beside ? 0 : tick_label_room);
    time_strip_->setEntries({StripEntry{timeAxisName(frames_.back()->timeTicks())}},
                            beside ? Qt::AlignRight : Qt::AlignHCenter);
}

TimeOverlay::TimeOverlay(const TimeStack& stack, const TimeGestures& gestures)
    : QCPLayerable(&stack.plot(), QStringLiteral("overlay")), stack_(stack), gestures_(gestures) {
    stack.plot().layer(QStringLiteral("overlay"))->setMode(QCPLayer::lmBuffered);
}

void TimeOverlay::applyDefaultAntialiasingHint(QCPPainter* painter) const {
    painter->setAntialiasing(false);
}

void TimeOverlay::draw(QCPPainter* painter) {
    const Theme& theme = stack_.theme();
    drawHair(*painter, gestures_.cursor(Cursor::a), theme.cursorA, QStringLiteral("A"));
    drawHair(*painter, gestures_.cursor(Cursor::b), theme.cursorB, QStringLiteral("B"));
    drawHair(*painter, gestures_.tracker(), theme.tracker, QString());
    if (band_) {
        painter->setAntialiasing(false);
        painter->setPen(QPen(theme.accent, 1));
        painter->setBrush(translucent(theme.accent, 0.15));
        painter->drawRect(*band_);
        painter->setBrush(Qt::NoBrush);
    }
}

// Solid with a name below, or dashed with its time below.
void TimeOverlay::drawHair(QCPPainter& painter, std::optional<double> time_s, const QColor& color,
                           const QString& name) const {
    if (!time_s || stack_.frames().empty() || !stack_.frames().front()->time().contains(*time_s)) {
        return;
    }
    const TimePanel& first = *stack_.frames().front();
    const TimePanel& last = *stack_.frames().back();
    const double x = std::round(first.timeAxis()->coordToPixel(*time_s));
    painter.setAntialiasing(false);
    painter.setPen(QPen(color, 1, name.isEmpty() ? Qt::DashLine : Qt::SolidLine));
    for (const TimePanel* frame : stack_.frames()) {
        painter.drawLine(QLineF(x, frame->rect().top(), x, frame->rect().bottom()));
    }
    // Instead of tick labels, not over curves.
    const QFontMetricsF metrics(first.font());
    const QString text = name.isEmpty() ? timeText(first, *time_s) : name;
    const double width = metrics.horizontalAdvance(text) + 10;
    const QRectF area(first.rect());
    const double left = std::clamp(x - 0.5 * width, area.left(),
                                   std::max(area.left(), first.rect().right() - width));
    const QRectF label(left, last.rect().bottom() + 4, width, metrics.height() + 2);
    clearTouched(painter, last, label);
    painter.setAntialiasing(true);
    painter.setPen(Qt::NoPen);
    painter.setBrush(color);
    painter.drawRoundedRect(label, 3, 3);
    painter.setBrush(Qt::NoBrush);
    painter.setPen(stack_.theme().plotBackground);
    painter.setFont(first.font());
    painter.drawText(label, int(Qt::AlignCenter), text);
}

}  // namespace vybeg::ui
