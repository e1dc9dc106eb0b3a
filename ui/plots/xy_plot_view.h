#pragma once

#include "ui/plots/plot_file.h"
#include "ui/plots/plot_view.h"
#include "ui/plots/xy_plot.h"

#include <functional>
#include <optional>
#include <utility>

class QCustomPlot;

namespace vybeg::ui {

// A plot of one quantity against another in a panel.
class XYPlotView : public PlotView {
    Q_OBJECT

public:
    explicit XYPlotView(QWidget* parent = nullptr);

    void setContent(const XYPlot& content);
    const XYPlot& content() const { return content_; }
    // As high as a panel shows it, unless the minimum height is set to another one.
    QSize sizeHint() const override { return {260, minimumHeight()}; }
    // A click near a point of this series, by its number in the content, emits pointClicked(), a
    // double click also pointActivated(); Left and Right emit stepWanted().
    void setPickable(std::optional<std::size_t> series);
    // Tooltips of the points of that series, rich text, made when one is shown.
    void setPointTips(std::function<QString(std::size_t)> tip) { tip_ = std::move(tip); }
    // Where a point of a series lies in the widget.
    QPointF positionOf(std::size_t series, std::size_t point) const;

    Figure figure() const override;

signals:
    void pointClicked(int point);
    void pointActivated(int point);
    void stepWanted(int by);

protected:
    bool event(QEvent* event) override;
    void mouseMoveEvent(QMouseEvent* event) override;
    void mouseReleaseEvent(QMouseEvent* event) override;
    void mouseDoubleClickEvent(QMouseEvent* event) override;
    void keyPressEvent(QKeyEvent* event) override;

private:
    // The pickable point at a position.
    std::optional<std::size_t> pointAt(const QPointF& position) const;
    void rebuild() override;

    QCustomPlot* plot_;
    XYPlot content_;
    std::optional<std::size_t> pickable_;
    std::function<QString(std::size_t)> tip_;  // empty text: none
};

// What is exported of plots: those that show something, by their accessible names.
FigureSource figuresOf(const std::vector<const XYPlotView*>& plots, const QString& name,
                       const QString& title);

}  // namespace vybeg::ui
