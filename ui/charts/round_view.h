#pragma once

#include "ui/charts/round_plot.h"

#include <QWidget>

class QAction;
class QChartView;
class QLabel;

namespace vybeg::ui {

// A round plot in a panel. Ctrl+C copies it; its context menu also exports.
class RoundView : public QWidget {
    Q_OBJECT

public:
    explicit RoundView(bool polar, QWidget* parent = nullptr);

    void setContent(const RoundPlot& content);
    void setTheme(const Theme& theme);
    // Hidden where the window names the curves already; a figure has a legend all the same.
    void setLegendShown(bool shown);
    const RoundPlot& content() const { return content_; }
    QSize sizeHint() const override { return {260, 260}; }

    // The plot, under the name of this widget.
    Figure figure() const;

signals:
    void exportWanted(const Figure& figure);

protected:
    void changeEvent(QEvent* event) override;
    void resizeEvent(QResizeEvent* event) override;

private:
    void rebuild();
    void retranslate();

    QChartView* view_;
    QLabel* legend_;
    bool legend_shown_ = true;
    QAction* copy_;
    QAction* export_;
    RoundPlot content_;
    Theme theme_;
};

}  // namespace vybeg::ui
