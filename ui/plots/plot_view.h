#pragma once

#include "ui/plots/plot_file.h"
#include "ui/widgets/theme.h"

#include <QWidget>

class QAction;

namespace vybeg::ui {

// A plot in a panel. Ctrl+C copies it; its context menu also exports; its frame shows the keyboard
// focus.
class PlotView : public QWidget {
    Q_OBJECT

public:
    void setTheme(const Theme& theme);
    // The plot, under the name of this widget.
    virtual Figure figure() const = 0;

signals:
    void exportWanted(const Figure& figure);

protected:
    explicit PlotView(QWidget* parent);

    const Theme& theme() const { return theme_; }
    // Puts the drawing into the widget, which leaves room for the frame. It ignores the mouse, so
    // that the wheel scrolls the panel around it.
    void addDrawing(QWidget* drawing);
    // Draws anew: of another content, theme, size or language.
    virtual void rebuild() = 0;
    // Whether there is something to copy and export.
    void setDrawn(bool drawn);

    void paintEvent(QPaintEvent* event) override;

private:
    void retranslate();

    QAction* copy_;
    QAction* export_;
    Theme theme_ = lightTheme();
};

}  // namespace vybeg::ui
