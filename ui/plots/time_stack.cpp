#include "ui/plots/time_stack.h"

#include "ui/plots/plot_strip.h"
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

}  // namespace vybeg::ui
