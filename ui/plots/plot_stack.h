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

class PlotPanel;

// Over the slow variables: a dot on each curve at the tracker, and what an empty view says.
class PlotOverlay : public TimeOverlay {
public:
    PlotOverlay(const PlotStack& stack, std::function<HairLines()> hairs);

    // Text in the middle of an empty view.
    void setHint(const QString& hint) { hint_ = hint; }
    // Number of analyses that are not drawn, for the corner of the first plot.
    void setUnlike(int count) { unlike_ = count; }

protected:
    void draw(QCPPainter* painter) override;

private:
    void drawDots(QCPPainter& painter, const PlotPanel& panel, double time_s) const;

    const PlotStack& stack_;
    QString hint_;
    int unlike_ = 0;
};

}  // namespace vybeg::ui
