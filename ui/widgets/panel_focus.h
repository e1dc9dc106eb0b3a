#pragma once

#include "core/track/slow_variables.h"

#include <QColor>
#include <QWidget>

namespace vybeg::ui {

// A plot as the keyboard and a screen reader see it: an invisible widget over a panel that takes
// the focus, has the accessible name and draws the focus frame. The mouse passes through.
class PanelFocus : public QWidget {
public:
    PanelFocus(SlowVariable variable, QWidget* parent);

    SlowVariable variable() const { return variable_; }
    void setColor(const QColor& color);

protected:
    void paintEvent(QPaintEvent* event) override;
    void focusInEvent(QFocusEvent* event) override;
    void focusOutEvent(QFocusEvent* event) override;

private:
    SlowVariable variable_;
    QColor color_;
    bool framed_ = false;
};

}  // namespace vybeg::ui
