#pragma once

#include "core/track/slow_variables.h"

#include <QColor>
#include <QWidget>

namespace vybeg::ui {

// Representative of a plot for keyboard and screen reader: an invisible widget over a panel with
// the focus, the accessible name and the focus frame. Transparent for the mouse.
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
