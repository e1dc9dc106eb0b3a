#pragma once

#include "ui/plots/panel_frame.h"
#include "ui/values/zoom_state.h"
#include "ui/widgets/theme.h"

#include <qcustomplot.h>

#include <vector>

namespace vybeg::ui {

// Where symbol and unit of a plot stand: on the screen in the left margin, on paper above it.
enum class PlotHead { margin, line };

// A curve that its panel scales and a strip names: QCustomPlot looks for no ranges of it.
class TimeGraph : public QCPAbstractPlottable {
public:
    TimeGraph(QCPAxis* keyAxis, QCPAxis* valueAxis) : QCPAbstractPlottable(keyAxis, valueAxis) {
        setSelectable(QCP::stNone);
    }

    double selectTest(const QPointF&, bool, QVariant*) const override { return -1; }
    QCPRange getKeyRange(bool& foundRange, QCP::SignDomain) const override {
        foundRange = false;
        return {};
    }
    QCPRange getValueRange(bool& foundRange, QCP::SignDomain, const QCPRange&) const override {
        foundRange = false;
        return {};
    }

protected:
    void drawLegendIcon(QCPPainter*, const QRectF&) const override {}
};

// One of the plots over one time axis, with its symbol and unit.
class TimePanel : public FramedPanel {
public:
    TimePanel(QCustomPlot* plot, PlotHead head);

    // Only the lowest panel has labels of the time axis.
    void setTimeLabels(bool shown) { timeAxis()->setTickLabels(shown); }
    // A letter at the right end of the line above the plot, for figures.
    void setLetter(const QString& letter) { letter_ = letter; }

    void setTime(const AxisRange& time) { timeAxis()->setRange(time.lower, time.upper); }
    void setValues(const AxisRange& values) { valueAxis()->setRange(values.lower, values.upper); }
    AxisRange time() const { return {timeAxis()->range().lower, timeAxis()->range().upper}; }
    AxisRange values() const { return {valueAxis()->range().lower, valueAxis()->range().upper}; }

    QCPAxis* timeAxis() const { return axis(QCPAxis::atBottom); }
    QCPAxis* valueAxis() const { return axis(QCPAxis::atLeft); }
    const AxisTicks& timeTicks() const { return ticker(QCPAxis::atBottom).ticks(); }

    // Pixels around the frame; left: at least.
    static QMargins room(PlotHead head);

protected:
    void setLook(const Theme& theme, const QFont& font);
    // Without values no scale is shown.
    void setScaleShown(bool shown);
    PanelTicker& valueTicker() const { return ticker(QCPAxis::atLeft); }

    // An underscore introduces an index.
    virtual QString symbol() const = 0;
    // "−5300 Hz" of an axis that counts from an offset; empty without one.
    virtual QString offset(const AxisTicks& ticks) const { return ticks.offsetText(); }
    virtual QString unit(const AxisTicks& ticks) const = 0;
    // What stands in the frame where no curve does.
    virtual QString emptyText() const = 0;

    void draw(QCPPainter* painter) override;
    int calculateAutoMargin(QCP::MarginSide side) override;

private:
    // A line in the left margin: symbol, offset of the axis, unit.
    struct MarginLine {
        QString text;
        bool muted = false;
        double width = 0;
    };

    std::vector<MarginLine> marginLines(const AxisTicks& ticks) const;
    void drawMarginLines(QCPPainter& painter) const;
    void drawHead(QCPPainter& painter) const;

    PlotHead head_;
    QString letter_;
};

}  // namespace vybeg::ui
