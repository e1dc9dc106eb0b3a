#pragma once

#include "ui/plots/plot_file.h"
#include "ui/plots/time_stack.h"
#include "ui/signals/signal_picture.h"

#include <QCoreApplication>

#include <vector>

namespace vybeg::ui {

// Texts of the plots of the signals in the language of the window.
struct SignalWords {
    Q_DECLARE_TR_FUNCTIONS(SignalStack)
};

class SignalPanel;

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
