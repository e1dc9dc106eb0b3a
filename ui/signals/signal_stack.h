#pragma once

#include "ui/plots/plot_file.h"
#include "ui/plots/time_panel.h"
#include "ui/plots/time_stack.h"
#include "ui/signals/signal_picture.h"

#include <vector>

namespace vybeg::ui {

// What one plot of the signals draws: minima and maxima with the amplitude of the fitted wave, or
// samples as dots with thin lines between them and the wave itself; of the residual the rms of the
// windows or its samples.
class SignalGraph : public TimeGraph {
public:
    // Content and picture outlive its drawings.
    SignalGraph(QCPAxis* keyAxis, QCPAxis* valueAxis, SignalPart part, const SignalContent& content,
                const SignalPicture& picture)
        : TimeGraph(keyAxis, valueAxis), part_(part), content_(content), picture_(picture) {}

protected:
    void draw(QCPPainter* painter) override;

private:
    bool isD() const { return part_ == SignalPart::d; }
    double x(double time_s) const { return mKeyAxis->coordToPixel(time_s); }
    double y(double value) const { return mValueAxis->coordToPixel(value); }
    // Visible samples, by a value of the excerpt, as points of the plot.
    template <class Value>
    QPolygonF points(Value value) const;
    double samplesApart() const;  // pixels
    void drawColumns(QCPPainter& painter) const;
    void drawRms(QCPPainter& painter) const;
    void drawCurve(QCPPainter& painter, double sign) const;
    void drawLines(QCPPainter& painter, const QPolygonF& points, const QColor& color) const;
    void drawDots(QCPPainter& painter, const QPolygonF& points, const QColor& color) const;
    void drawLost(QCPPainter& painter) const;

    SignalPart part_;
    const SignalContent& content_;
    const SignalPicture& picture_;
};

// One plot of the signals.
class SignalPanel : public TimePanel {
public:
    // Content and picture outlive its drawings.
    SignalPanel(QCustomPlot* plot, SignalPart part, PlotHead head, const SignalContent& content,
                const SignalPicture& picture);

    SignalPart part() const { return part_; }
    // Content or picture are others.
    void refresh(const QFont& font);

protected:
    QString symbol() const override;
    QString unit(const AxisTicks& ticks) const override;
    QString emptyText() const override;

private:
    SignalPart part_;
    const SignalContent& content_;
    const SignalPicture& picture_;
};

// The plots of the signals, on paper with a legend above; on the screen the overlay says what the
// curves are.
class SignalStack : public TimeStack {
public:
    SignalStack(QCustomPlot& plot, const std::vector<SignalPart>& parts, PlotHead head);

    // Everything for a plot of that size, device-independent pixels.
    void setContent(SignalContent content, QSize size);

    const SignalContent& content() const { return content_; }
    const SignalPicture& picture() const { return picture_; }
    const std::vector<SignalPanel*>& panels() const { return panels_; }

private:
    void showLegend();

    SignalContent content_;
    SignalPicture picture_;
    std::vector<SignalPanel*> panels_;
};

// A figure of some plots in the light theme, with its proposed size.
Figure signalFigure(SignalContent content, const std::vector<SignalPart>& parts);

// Over the signals: the values of the sample nearest to the tracker.
class SignalOverlay : public TimeOverlay {
public:
    SignalOverlay(const SignalStack& stack, std::function<HairLines()> hairs);

protected:
    void draw(QCPPainter* painter) override;

private:
    QString note(const SignalPanel& panel) const;
    void drawNote(QCPPainter& painter, const SignalPanel& panel) const;

    const SignalStack& stack_;
};

}  // namespace vybeg::ui
