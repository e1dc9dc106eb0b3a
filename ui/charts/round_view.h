#pragma once

#include "ui/charts/round_plot.h"
#include "ui/plots/plot_view.h"

class QChartView;
class QLabel;

namespace vybeg::ui {

// A round plot in a panel.
class RoundView : public PlotView {
    Q_OBJECT

public:
    explicit RoundView(bool polar, QWidget* parent = nullptr);

    void setContent(const RoundPlot& content);
    // Hidden where the window names the curves already; a figure has a legend all the same.
    void setLegendShown(bool shown);
    const RoundPlot& content() const { return content_; }
    QSize sizeHint() const override { return {260, 260}; }
    Figure figure() const override;

private:
    void rebuild() override;

    QChartView* view_;
    QLabel* legend_;
    bool legend_shown_ = true;
    RoundPlot content_;
};

}  // namespace vybeg::ui
