#pragma once

#include "ui/plots/plot_content.h"
#include "ui/plots/time_panel.h"
#include "ui/values/curve_data.h"
#include "ui/words/display_units.h"

#include <memory>
#include <utility>
#include <vector>

namespace vybeg::ui {

// The curve of one analysis in one plot: min/max per pixel column, drawn as independent segments
// (QCustomPlot's own graphs take seconds for dense data unless the pen is one pixel wide). Windows
// closer together than pixels that scatter by more than they move are a pale band from the least to
// the greatest with their running mean on it, so that curves over each other stay apart. Missing
// windows leave a gap and a mark at the foot of the plot, however narrow the gap is; values outside
// the axis leave a mark at the edge that they cross.
class DecimatedGraph : public TimeGraph {
public:
    struct Look {
        DisplayScale scale;
        bool band = true;
        // Offset of the pointers to values beyond the frame, 0 to 1 of their distance, so that
        // those of several curves are side by side.
        double pointers_begin = 0;
        QColor color;
        QColor missing;  // marks of missing windows
    };

    // `together`: all curves of the plot, which outlive this one: the first draws the bands of all
    // of them, the paler the more there are, so that no band covers a line.
    DecimatedGraph(QCPAxis* keyAxis, QCPAxis* valueAxis, std::shared_ptr<const CurveData> data,
                   const Look& look, const std::vector<DecimatedGraph*>& together)
        : TimeGraph(keyAxis, valueAxis), data_(std::move(data)), look_(look), all_(together) {}

    const CurveData& data() const { return *data_; }
    const DisplayScale& scale() const { return look_.scale; }
    const QColor& color() const { return look_.color; }

    // The columns of a time range over a width in pixels; cached for the last arguments.
    const std::vector<CurveColumn>& columns(const AxisRange& time, int width) const;

protected:
    void draw(QCPPainter* painter) override;

private:
    double pixelX(const CurveColumn& column) const;
    double pixelY(double displayed) const;
    const std::vector<CurveColumn>& visibleColumns() const;
    void drawBands(QCPPainter& painter) const;
    // From one value of the columns to another.
    void drawBand(QCPPainter& painter, const std::vector<CurveColumn>& columns,
                  double CurveColumn::*low, double CurveColumn::*high) const;
    void drawLine(QCPPainter& painter, const std::vector<CurveColumn>& columns) const;
    void drawMarks(QCPPainter& painter, const std::vector<CurveColumn>& columns) const;
    // Of neighbouring columns together, each with a few windows; empty without dense noise.
    std::vector<CurveColumn> noiseColumns() const;
    void drawMean(QCPPainter& painter, const std::vector<CurveColumn>& columns) const;
    QColor bandColor() const;

    std::shared_ptr<const CurveData> data_;
    Look look_;
    const std::vector<DecimatedGraph*>& all_;
    mutable AxisRange cached_time_;
    mutable int cached_width_ = 0;
    mutable std::vector<CurveColumn> cached_;
    mutable std::vector<CurveColumn> noise_;  // of the present drawing
};

// One plot: the curves of one slow variable of all visible analyses.
class PlotPanel : public TimePanel {
public:
    PlotPanel(QCustomPlot* plot, SlowVariable variable, PlotHead head);

    SlowVariable variable() const { return variable_; }
    const std::vector<DecimatedGraph*>& graphs() const { return graphs_; }

    // Sets curves, units and colours.
    void setContent(const PlotContent& content, const QFont& font);
    void removeGraphs();
    // Automatic value axis for the visible part of all curves; {0, 1} without curves.
    AxisRange automaticValues() const;

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
