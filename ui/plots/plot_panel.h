#pragma once

#include "ui/plots/panel_frame.h"
#include "ui/plots/plot_content.h"

#include <qcustomplot.h>

#include <vector>

namespace vybeg::ui {

class DecimatedGraph;

// One plot: the curves of one slow variable of all visible analyses, with its symbol and unit.
class PlotPanel : public QCPAxisRect {
    Q_OBJECT

public:
    PlotPanel(QCustomPlot* plot, SlowVariable variable, PlotHead head);

    SlowVariable variable() const { return variable_; }
    const std::vector<DecimatedGraph*>& graphs() const { return graphs_; }

    // Sets curves, units and colours.
    void setContent(const PlotContent& content, const QFont& font);
    // Instants marked by thin lines, s, in rising order.
    void setMarks(const std::vector<double>& times_s) { marks_s_ = times_s; }
    // Only the lowest panel has labels of the time axis.
    void setTimeLabels(bool shown);
    // A letter at the right end of the line above the plot, for figures.
    void setLetter(const QString& letter) { letter_ = letter; }
    // Size of the axis rectangle after the next layout, without exact left margin.
    void setExpectedSize(QSize size) { expected_ = size; }
    void removeGraphs();

    void setTime(const AxisRange& time);
    void setValues(const AxisRange& values);
    AxisRange time() const;
    AxisRange values() const;
    // Automatic value axis for the visible part of all curves; {0, 1} without curves.
    AxisRange automaticValues() const;

    QCPAxis* timeAxis() const { return axis(QCPAxis::atBottom); }
    QCPAxis* valueAxis() const { return axis(QCPAxis::atLeft); }
    const AxisTicks& timeTicks() const { return time_ticker_->ticks(); }

    // Symbol and unit above the plot, e.g. "ω_cp/2π − 5300 Hz" and "mHz".
    QString headSymbol() const;
    QString headUnit() const;
    const QFont& headFont() const { return font_; }

    FrameRoom room() const { return frameRoom(head_); }

    void update(UpdatePhase phase) override;

protected:
    void draw(QCPPainter* painter) override;
    int calculateAutoMargin(QCP::MarginSide side) override;

private:
    void setLook(const Theme& theme);
    void drawMarks(QCPPainter& painter) const;
    void drawHead(QCPPainter& painter) const;
    std::vector<MarginLine> marginTexts(const AxisTicks& ticks) const;
    QString emptyReason() const;
    // "−5300 Hz" of an axis that counts from an offset; empty without one.
    QString offsetText(const AxisTicks& ticks) const;

    SlowVariable variable_;
    PlotHead head_;
    QSharedPointer<PanelTicker> time_ticker_;
    QSharedPointer<PanelTicker> value_ticker_;
    std::vector<DecimatedGraph*> graphs_;
    QPointer<QCPGraph> trend_;
    DisplayUnits units_;
    Theme theme_;
    std::vector<double> marks_s_;
    QFont font_;
    QFont tick_font_;
    QString letter_;
    QSize expected_{400, 100};
};

}  // namespace vybeg::ui
