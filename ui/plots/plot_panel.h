#pragma once

#include "ui/plots/panel_ticker.h"
#include "ui/plots/plot_content.h"

#include <qcustomplot.h>

#include <vector>

namespace vybeg::ui {

class DecimatedGraph;

// One plot: the curves of one slow variable of all visible analyses, and above them a line with its
// symbol and unit. The right end of that line is free for the readout (readoutArea()).
class PlotPanel : public QCPAxisRect {
    Q_OBJECT

public:
    PlotPanel(QCustomPlot* plot, SlowVariable variable);

    SlowVariable variable() const { return variable_; }
    const std::vector<DecimatedGraph*>& graphs() const { return graphs_; }

    // Sets curves, units and colours.
    void setContent(const PlotContent& content, const QFont& font);
    // Instants marked by thin lines, s, in rising order.
    void setMarks(const std::vector<double>& times_s) { marks_s_ = times_s; }
    // Only the lowest panel has labels of the time axis.
    void setTimeLabels(bool shown);
    // A letter at the right end of the head line, for figures.
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

    // Symbol and unit in the head line, e.g. "ω_cp/2π − 5300 Hz" and "mHz".
    QString headSymbol() const;
    QString headUnit() const;
    // Area for a readout: right of symbol and unit.
    QRectF readoutArea() const;
    const QFont& headFont() const { return font_; }

    static constexpr int head_height = 21;
    static constexpr int right_margin = 16;
    static constexpr int foot = 3;

    void update(UpdatePhase phase) override;

protected:
    void draw(QCPPainter* painter) override;

private:
    void setLook(const Theme& theme);
    void drawMarks(QCPPainter& painter) const;
    void drawHead(QCPPainter& painter) const;
    QString emptyReason() const;

    SlowVariable variable_;
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
