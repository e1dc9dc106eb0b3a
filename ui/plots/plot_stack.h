#pragma once

#include "ui/plots/plot_content.h"
#include "ui/plots/plot_panel.h"
#include "ui/plots/time_stack.h"

#include <vector>

namespace vybeg::ui {

// The plots of the slow variables: part of the track view, its exports and the article's figure. On
// paper with the names of the analyses above, if they are several, or with a title.
class PlotStack : public TimeStack {
public:
    using TimeStack::TimeStack;

    // Instead of the names of the analyses.
    void setTitle(const QString& title) { title_ = title; }
    // Rebuilds the panels if the variables have changed; sets zoom and value axes.
    void setContent(const PlotContent& content);
    // Instants marked in all plots, s, in rising order.
    void setMarks(const std::vector<double>& times_s);
    // Sets time and value axes, after prepare(); value axes that are not fixed follow the visible
    // data.
    void setZoom(const ZoomState& zoom);

    const std::vector<PlotPanel*>& panels() const { return panels_; }
    PlotPanel* panel(SlowVariable variable) const;
    // Plot at a position, including its head line.
    PlotPanel* panelAt(const QPointF& position) const;

private:
    void showTitle();
    void showNames(const PlotContent& content);

    QString title_;
    std::vector<PlotPanel*> panels_;
};

}  // namespace vybeg::ui
