#include "ui/plots/plot_stack.h"

#include "ui/plots/plot_panel.h"
#include "ui/plots/plot_strip.h"

#include <QCoreApplication>

#include <algorithm>

namespace vybeg::ui {
namespace {

constexpr int time_strip_height = 42;
constexpr int time_row_height = 20;  // ticks and name in one row
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

PlotStack::PlotStack(QCustomPlot& plot, int column, Head head)
    : plot_(plot), column_(column), head_(head) {
    QObject::connect(&plot_, &QCustomPlot::afterLayout, &context_, [this] { nameTime(); });
}

void PlotStack::setContent(const PlotContent& content) {
    const bool same_panels = std::equal(
        panels_.begin(), panels_.end(), content.variables.begin(), content.variables.end(),
        [](const PlotPanel* panel, SlowVariable v) { return panel->variable() == v; });
    content_ = content;
    if (!same_panels || panels_.empty()) {
        build(content);
    }
    const QFont font = plotFont(plot_);
    for (PlotPanel* panel : panels_) {
        panel->setContent(content, font);
    }
    time_strip_->setLook(font, content.theme.text);
    head_strip_->setLook(font, content.theme.text);
    if (head_ == Head::analysis_names) {
        std::vector<StripEntry> entries;
        for (const ShownAnalysis& shown : content.analyses) {
            if (shown.visible && shown.analysis) {
                entries.push_back({shown.name, true, true,
                                   readable(shown.color, content.theme, shown.shade),
                                   Qt::SolidLine});
                if (!content.trends.empty() && content.trends.front().of == shown.id) {
                    entries.push_back({QCoreApplication::translate("PlotStack", "and its trend"),
                                       false, true, content.theme.text, Qt::DashLine});
                }
            }
        }
        // A single curve needs no legend, nor does its trend.
        const bool shown = std::ranges::count(entries, true, &StripEntry::literal) > 1;
        head_strip_->setMinimumSize(10, shown ? head_strip_height : 4);
        head_strip_->setMaximumSize(QWIDGETSIZE_MAX, shown ? head_strip_height : 4);
        head_strip_->setEntries(shown ? std::move(entries) : std::vector<StripEntry>(),
                                Qt::AlignLeft);
    }
    setZoom(content.zoom);
}

void PlotStack::setMarks(const std::vector<double>& times_s) {
    content_.marks_s = times_s;
    for (PlotPanel* panel : panels_) {
        panel->setMarks(times_s);
    }
}

void PlotStack::removeElements() {
    QCPLayoutGrid& grid = *plot_.plotLayout();
    for (PlotPanel* panel : panels_) {
        panel->removeGraphs();
        grid.remove(panel);
    }
    panels_.clear();
    for (PlotStrip* strip : {head_strip_, time_strip_}) {
        if (strip) {
            grid.remove(strip);
        }
    }
    head_strip_ = time_strip_ = nullptr;
    grid.simplify();
    delete margins_;
}

void PlotStack::build(const PlotContent& content) {
    removeElements();
    QCPLayoutGrid& grid = *plot_.plotLayout();
    margins_ = new QCPMarginGroup(&plot_);
    int row = 0;
    head_strip_ = new PlotStrip(&plot_, head_ == Head::none ? top_gap : head_strip_height);
    head_strip_->setInset(8, frameRoom(plotHead()).right, 0);
    grid.addElement(row++, column_, head_strip_);
    for (const SlowVariable variable : content.variables) {
        auto* panel = new PlotPanel(&plot_, variable, plotHead());
        panel->setMarginGroup(QCP::msLeft, margins_);
        panel->setTimeLabels(variable == content.variables.back());
        grid.addElement(row++, column_, panel);
        panels_.push_back(panel);
    }
    time_strip_ = new PlotStrip(&plot_, head_ == Head::none ? time_row_height : time_strip_height);
    grid.addElement(row, column_, time_strip_);
}

PlotHead PlotStack::plotHead() const {
    return head_ == Head::none ? PlotHead::margin : PlotHead::line;
}

void PlotStack::setTitle(const QString& title) {
    head_strip_->setEntries({StripEntry{title, false, false, {}, Qt::SolidLine}}, Qt::AlignHCenter);
    head_strip_->setInset(frameRoom(plotHead()).right + 44, frameRoom(plotHead()).right, 0);
}

void PlotStack::setZoom(const ZoomState& zoom) {
    content_.zoom = zoom;
    for (PlotPanel* panel : panels_) {
        panel->setTime(zoom.time);
        const auto fixed = zoom.fixed.find(panel->variable());
        panel->setValues(fixed == zoom.fixed.end() ? panel->automaticValues() : fixed->second);
    }
}

void PlotStack::prepare(QSize size) {
    const int rows = static_cast<int>(panels_.size());
    const int strips = head_strip_ ? time_strip_->height() + head_strip_->height() : 0;
    const int each = rows > 0 ? (size.height() - strips) / rows : 0;
    for (PlotPanel* panel : panels_) {
        panel->setExpectedSize(
            {std::max(2, size.width() - panel->margins().left() - frameRoom(plotHead()).right),
             std::max(1, each - panel->room().head - panel->room().foot)});
    }
}

PlotPanel* PlotStack::panel(SlowVariable variable) const {
    const auto found = std::find_if(panels_.begin(), panels_.end(), [&](const PlotPanel* panel) {
        return panel->variable() == variable;
    });
    return found == panels_.end() ? nullptr : *found;
}

PlotPanel* PlotStack::panelAt(const QPointF& position) const {
    const auto found = std::find_if(panels_.begin(), panels_.end(), [&](const PlotPanel* panel) {
        return panel->outerRect().contains(position.toPoint());
    });
    return found == panels_.end() ? nullptr : *found;
}

void PlotStack::nameTime() {
    if (!time_strip_ || panels_.empty()) {
        return;
    }
    const QRect area = panels_.back()->rect();
    const bool beside = head_ == Head::none;
    time_strip_->setInset(area.left() - time_strip_->rect().left(), frameRoom(plotHead()).right,
                          beside ? 0 : tick_label_room);
    time_strip_->setEntries(
        {StripEntry{timeAxisName(panels_.back()->timeTicks()), false, false, {}, Qt::SolidLine}},
        beside ? Qt::AlignRight : Qt::AlignHCenter);
}

}  // namespace vybeg::ui
