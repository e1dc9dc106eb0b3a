#pragma once

#include "ui/plots/xy_plot.h"

#include <QWidget>

class QAction;

namespace vybeg::ui {

// A plot of one quantity against another in a panel. Ctrl+C copies it; its context menu also
// exports.
class XYPlotView : public QWidget {
    Q_OBJECT

public:
    explicit XYPlotView(QWidget* parent = nullptr);

    void setContent(const XYPlot& content);
    void setTheme(const Theme& theme);
    const XYPlot& content() const { return content_; }
    QSize sizeHint() const override { return {260, 250}; }

signals:
    void exportWanted();

protected:
    void resizeEvent(QResizeEvent* event) override;
    void changeEvent(QEvent* event) override;
    void focusInEvent(QFocusEvent* event) override;
    void focusOutEvent(QFocusEvent* event) override;
    void paintEvent(QPaintEvent* event) override;

private:
    void rebuild();
    void retranslate();

    QCustomPlot* plot_;
    QAction* copy_;
    QAction* export_;
    XYPlot content_;
    Theme theme_;
};

}  // namespace vybeg::ui
