#pragma once

#include "ui/plots/axis_ticks.h"
#include "ui/values/zoom_state.h"
#include "ui/widgets/theme.h"

#include <qcustomplot.h>

#include <functional>
#include <utility>
#include <vector>

namespace vybeg::ui {

// Passes the ticks of axis_ticks.h to a QCPAxis. Precondition of each layout: setRoom() with the
// length and font of the axis.
class PanelTicker : public QCPAxisTicker {
public:
    explicit PanelTicker(Qt::Orientation orientation) : orientation_(orientation) {}

    // `beyond`: pixels after the upper end of a horizontal axis that a label may use.
    void setRoom(double length, const QFont& font, double beyond = 0);
    void setSteps(TickSteps steps) { steps_ = steps; }
    void setLogarithmic(bool logarithmic) { logarithmic_ = logarithmic; }

    // Widths of the texts that share the labels' room, for the ticks of the coming layout: lines
    // from the top of a vertical axis, or one at the end of a horizontal one. Labels that would
    // touch them are omitted, and those of a vertical axis that would leave its length.
    using Texts = std::function<std::vector<double>(const AxisTicks&)>;
    void setShared(Texts texts, double room = 0) {
        shared_ = std::move(texts);
        shared_room_ = room;
    }

    // As of the latest layout.
    const AxisTicks& ticks() const { return ticks_; }

    void generate(const QCPRange& range, const QLocale& locale, QChar formatChar, int precision,
                  QVector<double>& ticks, QVector<double>* subTicks,
                  QVector<QString>* tickLabels) override;

private:
    void omitLabels(const AxisRange& range, QVector<QString>& labels) const;

    Qt::Orientation orientation_;
    double length_ = 100;
    double beyond_ = 0;
    QFont font_;
    TickSteps steps_ = TickSteps::decimal;
    bool logarithmic_ = false;
    Texts shared_;
    double shared_room_ = 0;  // beside a vertical axis
    AxisTicks ticks_;
};

// A panel in a full frame with ticks at the left and bottom only, on the layers of preparePlot().
// Labels under the frame lie outside its margins.
class FramedPanel : public QCPAxisRect {
public:
    // `around`: pixels around the frame; left: at least.
    FramedPanel(QCustomPlot* plot, const QMargins& around);

    // Size of the frame after the next layout, without exact left margin.
    void setExpectedSize(QSize size) { expected_ = size; }
    QSize expectedSize() const { return expected_; }
    const Theme& theme() const { return theme_; }
    const QFont& font() const { return font_; }

    void update(UpdatePhase phase) override;

protected:
    void setLook(const Theme& theme, const QFont& font);
    PanelTicker& ticker(QCPAxis::AxisType side) const {
        return side == QCPAxis::atBottom ? *x_ : *y_;
    }
    // Tick labels are smaller than other texts.
    const QFont& tickFont() const { return tick_font_; }
    // In the middle, where no curve is.
    void drawEmpty(QCPPainter& painter, const QString& text) const;

private:
    QSharedPointer<PanelTicker> x_{new PanelTicker(Qt::Horizontal)};
    QSharedPointer<PanelTicker> y_{new PanelTicker(Qt::Vertical)};
    Theme theme_;
    QFont font_;
    QFont tick_font_;
    QSize expected_{400, 100};
};

// The place of symbol and unit of a plot: on the screen the left margin, on paper above it.
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

// The name of a panel, and the text in its frame where it has no curve.
struct PanelTexts {
    QString symbol;  // an underscore introduces an index
    QString unit;
    bool takes_prefix = false;
    QString offset_unit{};  // after the number that the axis counts from
    QString empty{};
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

    void setLook(const Theme& theme, const QFont& font);
    void setTexts(const PanelTexts& texts) { texts_ = texts; }
    // Without values no scale is shown.
    void setScaleShown(bool shown);

protected:
    PanelTicker& valueTicker() const { return ticker(QCPAxis::atLeft); }

    void draw(QCPPainter* painter) override;
    int calculateAutoMargin(QCP::MarginSide side) override;

private:
    // A line in the left margin: symbol, offset of the axis, unit.
    struct MarginLine {
        QString text;
        bool muted = false;
        double width = 0;
    };

    // "−5300 Hz" of an axis that counts from an offset; empty without one.
    QString offset(const AxisTicks& ticks) const {
        return ticks.offset == 0 ? QString() : ticks.offsetText() + texts_.offset_unit;
    }
    QString unit(const AxisTicks& ticks) const {
        return scaledUnit(texts_.unit, texts_.takes_prefix, ticks.exponent);
    }
    std::vector<MarginLine> marginLines(const AxisTicks& ticks) const;
    void drawMarginLines(QCPPainter& painter) const;
    void drawHead(QCPPainter& painter) const;

    PlotHead head_;
    QString letter_;
    PanelTexts texts_;
};

}  // namespace vybeg::ui
