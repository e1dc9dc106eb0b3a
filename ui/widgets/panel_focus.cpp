#include "ui/widgets/panel_focus.h"

#include <QFocusEvent>
#include <QPainter>

namespace vybeg::ui {

PanelFocus::PanelFocus(SlowVariable variable, QWidget* parent)
    : QWidget(parent), variable_(variable) {
    setAttribute(Qt::WA_TransparentForMouseEvents);
    setFocusPolicy(Qt::TabFocus);
}

void PanelFocus::setColor(const QColor& color) {
    color_ = color;
    update();
}

void PanelFocus::paintEvent(QPaintEvent*) {
    if (!framed_) {
        return;
    }
    QPainter painter(this);
    painter.setRenderHint(QPainter::Antialiasing);
    painter.setPen(QPen(color_, 1.5));
    painter.drawRoundedRect(QRectF(rect()).adjusted(1.5, 1.5, -1.5, -1.5), 4, 4);
}

void PanelFocus::focusInEvent(QFocusEvent* event) {
    // The frame is shown only for focus by keyboard.
    framed_ = event->reason() == Qt::TabFocusReason || event->reason() == Qt::BacktabFocusReason ||
              event->reason() == Qt::ShortcutFocusReason;
    update();
}

void PanelFocus::focusOutEvent(QFocusEvent*) {
    framed_ = false;
    update();
}

}  // namespace vybeg::ui
