#pragma once

#include "ui/plots/plot_content.h"

#include <optional>
#include <vector>

class QWidget;

namespace vybeg::ui {

class PanelFocus;
class PlotStack;

// Frames of keyboard focus about the plots of a view, one per plot in the tab order.
class PlotFocus {
public:
    explicit PlotFocus(QWidget& view) : view_(view) {}

    void match(const PlotContent& content);
    void place(const PlotStack& stack);
    void give(SlowVariable variable);
    std::optional<SlowVariable> focused() const;

private:
    QWidget& view_;
    std::vector<PanelFocus*> frames_;  // children of the view
};

}  // namespace vybeg::ui
