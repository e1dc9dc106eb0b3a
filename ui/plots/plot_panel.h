#pragma once

#include "ui/plots/plot_content.h"
#include "ui/plots/time_panel.h"

#include <vector>

namespace vybeg::ui {

class DecimatedGraph;

// One plot: the curves of one slow variable of all visible analyses.
class PlotPanel : public TimePanel {
public:
    PlotPanel(QCustomPlot* plot, SlowVariable variable, PlotHead head);

    SlowVariable variable() const { return variable_; }
    const std::vector<DecimatedGraph*>& graphs() const { return graphs_; }

    // Sets curves, units and colours.
    void setContent(const PlotContent& content, const QFont& font);
    // Instants marked by thin lines, s, in rising order.
    void setMarks(const std::vector<double>& times_s) { marks_s_ = times_s; }
    void removeGraphs();
    // Automatic value axis for the visible part of all curves; {0, 1} without curves.
    AxisRange automaticValues() const;

protected:
    QString symbol() const override { return displaySymbol(variable_, units_); }
    QString offset(const AxisTicks& ticks) const override;
    QString unit(const AxisTicks& ticks) const override;
    QString emptyText() const override;
    void draw(QCPPainter* painter) override;

private:
    void drawMarks(QCPPainter& painter) const;

    SlowVariable variable_;
    std::vector<DecimatedGraph*> graphs_;
    QPointer<QCPGraph> trend_;
    DisplayUnits units_;
    std::vector<double> marks_s_;
};

}  // namespace vybeg::ui
