#pragma once

#include "ui/plots/figure_source.h"
#include "ui/plots/xy_plot.h"

#include <QStringList>
#include <QWidget>

#include <functional>
#include <optional>
#include <utility>

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
    // As high as a panel shows it, unless the minimum height is set to another one.
    QSize sizeHint() const override { return {260, minimumHeight()}; }
    // A click near a point of this series, by its number in the content, emits pointClicked(), a
    // double click also pointActivated(); Left and Right emit stepWanted().
    void setPickable(std::optional<std::size_t> series);
    // Tooltips of the points of that series, rich text.
    void setPointTips(const QStringList& tips);
    // The same, made when one is shown: for thousands of points.
    void setPointTips(std::function<QString(std::size_t)> tip) { tip_ = std::move(tip); }
    // Where a point of a series lies in the widget.
    QPointF positionOf(std::size_t series, std::size_t point) const;

    // The plot, under the name of this widget.
    Figure figure() const;

signals:
    void exportWanted(const Figure& figure);
    void pointClicked(int point);
    void pointActivated(int point);
    void stepWanted(int by);

protected:
    bool event(QEvent* event) override;
    void resizeEvent(QResizeEvent* event) override;
    void changeEvent(QEvent* event) override;
    void focusInEvent(QFocusEvent* event) override;
    void focusOutEvent(QFocusEvent* event) override;
    void paintEvent(QPaintEvent* event) override;
    void mouseMoveEvent(QMouseEvent* event) override;
    void mouseReleaseEvent(QMouseEvent* event) override;
    void mouseDoubleClickEvent(QMouseEvent* event) override;
    void keyPressEvent(QKeyEvent* event) override;

private:
    // The pickable point at a position.
    std::optional<std::size_t> pointAt(const QPointF& position) const;
    void rebuild();
    void retranslate();

    QCustomPlot* plot_;
    QAction* copy_;
    QAction* export_;
    XYPlot content_;
    Theme theme_;
    std::optional<std::size_t> pickable_;
    std::function<QString(std::size_t)> tip_;  // empty text: none
};

// What is exported of plots: those that show something, by their accessible names.
FigureSource figuresOf(const std::vector<const XYPlotView*>& plots, const QString& name,
                       const QString& title);

}  // namespace vybeg::ui
