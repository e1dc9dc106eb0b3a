#include "ui/signals/signal_stack.h"

#include "ui/plots/plot_stack.h"
#include "ui/plots/plot_strip.h"
#include "ui/signals/signal_panel.h"

#include <QCoreApplication>

#include <algorithm>

namespace vybeg::ui {
namespace {

constexpr int legend_height = 24;
constexpr int top_gap = 5;  // of the screen: a tick label at the first plot's top
constexpr int time_height = 42;
constexpr int time_row_height = 20;  // of the screen: ticks and name in one row
// From the foot of the lowest panel to the name of the time axis: ticks and their labels.
constexpr int tick_label_room = 20;

constexpr int paper_width = 900;
constexpr int paper_panel_height = 170;

}  // namespace

QString signalsText(const char* text) {
    return QCoreApplication::translate("SignalStack", text);
}

SignalStack::SignalStack(QCustomPlot& plot, const std::vector<SignalPart>& parts, PlotHead head)
    : plot_(plot),
      head_(head),
      legend_(new PlotStrip(&plot, head == PlotHead::line ? legend_height : top_gap)),
      time_name_(new PlotStrip(&plot, head == PlotHead::line ? time_height : time_row_height)) {
    QCPLayoutGrid& grid = *plot.plotLayout();
    auto* margins = new QCPMarginGroup(&plot);
    int row = 0;
    legend_->setInset(8, frameRoom(head).right, 0);
    grid.addElement(row++, 0, legend_);
    for (const SignalPart part : parts) {
        auto* panel = new SignalPanel(&plot, part, head);
        panel->setMarginGroup(QCP::msLeft, margins);
        panel->setTimeLabels(part == parts.back());
        grid.addElement(row++, 0, panel);
        panels_.push_back(panel);
    }
    grid.addElement(row, 0, time_name_);
    QObject::connect(&plot_, &QCustomPlot::afterLayout, &context_, [this] { nameTime(); });
}

int SignalStack::frameWidth(int width) const {
    return std::max(2, width - panels_.front()->margins().left() - frameRoom(head_).right);
}

void SignalStack::setContent(SignalContent content, QSize size) {
    content_ = std::move(content);
    const int width = frameWidth(size.width());
    const int rows = static_cast<int>(panels_.size());
    const int strips = time_name_->height() + legend_->height();
    const FrameRoom around = frameRoom(head_);
    const int each = (size.height() - strips) / rows;
    const QSize room(width, std::max(1, each - around.head - around.foot));
    picture_ = pictureOf(content_, width);
    const QFont font = plotFont(plot_);
    for (SignalPanel* panel : panels_) {
        panel->setPicture(content_, picture_, font, room);
    }
    time_name_->setLook(font, content_.theme.text);
    legend_->setLook(font, content_.theme.text);
    if (head_ == PlotHead::line) {
        showLegend();
    }
}

std::vector<QCPAxisRect*> SignalStack::frames() const {
    return {panels_.begin(), panels_.end()};
}

void SignalStack::showLegend() {
    const Theme& theme = content_.theme;
    std::vector<StripEntry> entries;
    const auto add = [&](const QString& text, const QColor& color) {
        entries.push_back({text, true, true, color, Qt::SolidLine});
    };
    const bool fitted = content_.analysis != nullptr;
    add(QStringLiteral("C"), theme.signalC);
    add(QStringLiteral("D"), theme.signalD);
    if (fitted && content_.wave) {
        add(picture_.smooth
                ? signalsText(QT_TRANSLATE_NOOP("SignalStack", "fitted wave"))
                : signalsText(QT_TRANSLATE_NOOP("SignalStack", "amplitude of the wave")),
            theme.text);
    }
    if (fitted && !picture_.samples) {
        add(signalsText(QT_TRANSLATE_NOOP("SignalStack", "rms of the residual")), theme.mutedText);
    }
    legend_->setEntries(std::move(entries), Qt::AlignLeft);
}

void SignalStack::nameTime() {
    const QRect area = panels_.back()->rect();
    const bool beside = head_ == PlotHead::margin;
    time_name_->setInset(area.left() - time_name_->rect().left(), frameRoom(head_).right,
                         beside ? 0 : tick_label_room);
    time_name_->setEntries(
        {StripEntry{timeAxisName(panels_.back()->timeTicks()), false, false, {}, Qt::SolidLine}},
        beside ? Qt::AlignRight : Qt::AlignHCenter);
}

Figure signalFigure(SignalContent content, const std::vector<SignalPart>& parts) {
    content.theme = lightTheme();
    const QSize proposed(paper_width, legend_height + time_height +
                                          paper_panel_height * static_cast<int>(parts.size()));
    const Drawing draw = [content, parts](QCPPainter& painter, QSize size) {
        QCustomPlot plot;
        preparePlot(plot, content.theme);
        SignalStack stack(plot, parts, PlotHead::line);
        stack.setContent(content, size);
        plot.toPainter(&painter, size.width(), size.height());
    };
    return {draw, proposed, QStringLiteral("signals")};
}

}  // namespace vybeg::ui
