#pragma once

#include "ui/plots/time_overlay.h"

namespace vybeg::ui {

class PlotPanel;
class PlotStack;

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
