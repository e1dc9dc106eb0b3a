#pragma once

#include "ui/plots/time_overlay.h"

namespace vybeg::ui {

class SignalPanel;
class SignalStack;

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
