#include "ui/plots/plot_stack.h"

#include "ui/plots/plot_strip.h"

#include <QCoreApplication>

#include <algorithm>

namespace vybeg::ui {

void PlotStack::setContent(const PlotContent& content) {
    const bool same_panels =
        std::ranges::equal(panels_, content.variables, {}, &PlotPanel::variable);
    if (!same_panels || panels_.empty()) {
        for (PlotPanel* panel : panels_) {
            panel->removeGraphs();
        }
        panels_.clear();
        for (const SlowVariable variable : content.variables) {
            panels_.push_back(new PlotPanel(&plot(), variable, head()));
        }
        build({panels_.begin(), panels_.end()});
    }
    for (PlotPanel* panel : panels_) {
        panel->setContent(content, plotFont(plot()));
    }
    setLook(content.theme);
    if (!title_.isEmpty()) {
        showTitle();
    } else if (head() == PlotHead::line) {
        showNames(content);
    }
    setZoom(content.zoom);
}

void PlotStack::showTitle() {
    constexpr int beside = 44;
    const int right = TimePanel::room(head()).right();
    headStrip().setEntries({StripEntry{title_, false, false, {}, Qt::SolidLine}}, Qt::AlignHCenter);
    headStrip().setInset(right + beside, right, 0);
}

void PlotStack::showNames(const PlotContent& content) {
    std::vector<StripEntry> entries;
    for (const ShownAnalysis& shown : content.analyses) {
        if (shown.visible && shown.analysis) {
            entries.push_back({shown.name, true, true,
                               readable(shown.color, content.theme, shown.shade), Qt::SolidLine});
            if (!content.trends.empty() && content.trends.front().of == shown.id) {
                entries.push_back({QCoreApplication::translate("PlotStack", "and its trend"), false,
                                   true, content.theme.text, Qt::DashLine});
            }
        }
    }
    // A single curve needs no legend, nor does its trend.
    if (std::ranges::count(entries, true, &StripEntry::literal) <= 1) {
        entries.clear();
    }
    headStrip().setShown(!entries.empty());
    headStrip().setEntries(std::move(entries), Qt::AlignLeft);
}

void PlotStack::setMarks(const std::vector<double>& times_s) {
    for (PlotPanel* panel : panels_) {
        panel->setMarks(times_s);
    }
}

void PlotStack::setZoom(const ZoomState& zoom) {
    for (PlotPanel* panel : panels_) {
        panel->setTime(zoom.time);
        const auto fixed = zoom.fixed.find(panel->variable());
        panel->setValues(fixed == zoom.fixed.end() ? panel->automaticValues() : fixed->second);
    }
}

PlotPanel* PlotStack::panel(SlowVariable variable) const {
    const auto found = std::ranges::find(panels_, variable, &PlotPanel::variable);
    return found == panels_.end() ? nullptr : *found;
}

PlotPanel* PlotStack::panelAt(const QPointF& position) const {
    return static_cast<PlotPanel*>(frameAt(position));  // its frames are its panels
}

}  // namespace vybeg::ui
