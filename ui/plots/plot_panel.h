#pragma once

#include "ui/plots/plot_content.h"
#include "ui/plots/time_panel.h"
#include "ui/words/display_units.h"

#include <vector>

namespace vybeg::ui {

class DecimatedGraph;

// One plot: the curves of one slow variable of all visible analyses.
class PlotPanel : public TimePanel {
public:
    PlotPanel(QCustomPlot* plot, SlowVariable variable, PlotHead head);

    SlowVariable variable() const { return variable_; }

    // Sets curves, units and colours.
    void setContent(const PlotContent& content, const QFont& font);
    // Without a new content: with the next replot.
    void setMarks(const std::vector<double>& times_s) { marks_s_ = times_s; }
    void removeGraphs();
    // Automatic value axis for the visible part of all curves; {0, 1} without curves.
    AxisRange automaticValues() const;
    // A dot on each curve at an instant, in the colour of the panel's ground at its rim.
    void drawDots(QCPPainter& painter, double time_s) const;

protected:
    void draw(QCPPainter* painter) override;

private:
    void addTrend(const PlotContent& content, const DisplayScale& scale);
    // Why the graphs have no values; empty where some do.
    QString emptyText() const;

    SlowVariable variable_;
    std::vector<DecimatedGraph*> graphs_;
    QPointer<QCPGraph> trend_;
    bool bands_ = false;           // of standard deviations
    std::vector<double> marks_s_;  // rising
};

}  // namespace vybeg::ui
