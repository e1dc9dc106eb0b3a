#include "ui/plots/plot_focus.h"

#include "ui/plots/plot_panel.h"
#include "ui/plots/plot_stack.h"
#include "ui/widgets/panel_focus.h"
#include "ui/words/index_text.h"

#include <QCoreApplication>

#include <algorithm>

namespace vybeg::ui {

void PlotFocus::match(const PlotContent& content) {
    const bool same = std::ranges::equal(frames_, content.variables, {}, &PanelFocus::variable);
    if (!same) {
        for (PanelFocus* frame : frames_) {
            delete frame;
        }
        frames_.clear();
        for (const SlowVariable variable : content.variables) {
            frames_.push_back(new PanelFocus(variable, &view_));
            frames_.back()->show();
        }
    }
    for (PanelFocus* frame : frames_) {
        const SlowVariable variable = frame->variable();
        frame->setColor(content.theme.accent);
        frame->setAccessibleName(
            QCoreApplication::translate("PlotFocus", "Plot of %1, %2")
                .arg(indexPlain(displaySymbol(variable, content.units)), displayMeaning(variable)));
    }
}

void PlotFocus::place(const PlotStack& stack) {
    for (PanelFocus* frame : frames_) {
        if (const PlotPanel* panel = stack.panel(frame->variable())) {
            frame->setGeometry(panel->outerRect());
        }
    }
}

void PlotFocus::give(SlowVariable variable) {
    const auto found = std::ranges::find(frames_, variable, &PanelFocus::variable);
    if (found != frames_.end()) {
        (*found)->setFocus(Qt::MouseFocusReason);
    }
}

std::optional<SlowVariable> PlotFocus::focused() const {
    const auto found = std::ranges::find_if(frames_, &PanelFocus::hasFocus);
    return found == frames_.end() ? std::nullopt : std::optional((*found)->variable());
}

}  // namespace vybeg::ui
