#include "ui/plots/plot_focus.h"

#include "ui/plots/plot_panel.h"
#include "ui/plots/plot_stack.h"
#include "ui/words/rich_text.h"

#include <QCoreApplication>
#include <QFocusEvent>
#include <QPainter>
#include <QWidget>

#include <algorithm>

namespace vybeg::ui {

// Representative of a plot for keyboard and screen reader: an invisible widget over a panel with
// the focus, the accessible name and the focus frame. Transparent for the mouse.
class PanelFocus : public QWidget {
public:
    PanelFocus(SlowVariable variable, QWidget* parent) : QWidget(parent), variable_(variable) {
        setAttribute(Qt::WA_TransparentForMouseEvents);
        setFocusPolicy(Qt::TabFocus);
    }

    SlowVariable variable() const { return variable_; }
    void setColor(const QColor& color) {
        color_ = color;
        update();
    }

protected:
    void paintEvent(QPaintEvent*) override {
        if (!framed_) {
            return;
        }
        QPainter painter(this);
        painter.setRenderHint(QPainter::Antialiasing);
        painter.setPen(QPen(color_, 1.5));
        painter.drawRoundedRect(QRectF(rect()).adjusted(1.5, 1.5, -1.5, -1.5), 4, 4);
    }

    // The frame is shown only for focus by keyboard.
    void focusInEvent(QFocusEvent* event) override {
        framed_ = event->reason() == Qt::TabFocusReason ||
                  event->reason() == Qt::BacktabFocusReason ||
                  event->reason() == Qt::ShortcutFocusReason;
        update();
    }

    void focusOutEvent(QFocusEvent*) override {
        framed_ = false;
        update();
    }

private:
    SlowVariable variable_;
    QColor color_;
    bool framed_ = false;
};

void PlotFocus::match(const PlotContent& content) {
    const bool same = std::ranges::equal(frames_, content.variables, {}, &PanelFocus::variable);
    if (!same) {
        for (PanelFocus* frame : frames_) {
            delete frame;
        }
        frames_.clear();
        for (const SlowVariable variable : content.variables) {
            frames_.push_back(new PanelFocus(variable, &view_));
            frames_.back()->show();
        }
    }
    for (PanelFocus* frame : frames_) {
        const SlowVariable variable = frame->variable();
        frame->setColor(content.theme.accent);
        frame->setAccessibleName(
            QCoreApplication::translate("PlotFocus", "Plot of %1, %2")
                .arg(indexPlain(displaySymbol(variable, content.units)), displayMeaning(variable)));
    }
}

void PlotFocus::place(const PlotStack& stack) {
    for (PanelFocus* frame : frames_) {
        if (const PlotPanel* panel = stack.panel(frame->variable())) {
            frame->setGeometry(panel->outerRect());
        }
    }
}

void PlotFocus::give(SlowVariable variable) {
    const auto found = std::ranges::find(frames_, variable, &PanelFocus::variable);
    if (found != frames_.end()) {
        (*found)->setFocus(Qt::MouseFocusReason);
    }
}

std::optional<SlowVariable> PlotFocus::focused() const {
    const auto found = std::ranges::find_if(frames_, &PanelFocus::hasFocus);
    return found == frames_.end() ? std::nullopt : std::optional((*found)->variable());
}

}  // namespace vybeg::ui
