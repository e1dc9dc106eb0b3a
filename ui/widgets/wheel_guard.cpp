#include "ui/widgets/wheel_guard.h"

#include <QAbstractSpinBox>
#include <QComboBox>
#include <QEvent>

namespace vybeg::ui {

namespace {

class WheelGuard : public QObject {
public:
    using QObject::QObject;

    bool eventFilter(QObject* watched, QEvent* event) override {
        if (event->type() != QEvent::Wheel || static_cast<QWidget*>(watched)->hasFocus()) {
            return QObject::eventFilter(watched, event);
        }
        event->ignore();  // passed on to the parent
        return true;
    }
};

}  // namespace

void guardFromWheel(QWidget& panel) {
    auto* guard = new WheelGuard(&panel);
    for (QWidget* field : panel.findChildren<QWidget*>()) {
        if (qobject_cast<QComboBox*>(field) || qobject_cast<QAbstractSpinBox*>(field)) {
            // Qt's default also takes the focus by the wheel.
            field->setFocusPolicy(Qt::StrongFocus);
            field->installEventFilter(guard);
        }
    }
}

}  // namespace vybeg::ui
