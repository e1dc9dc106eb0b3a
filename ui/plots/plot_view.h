#pragma once

#include "ui/plots/plot_file.h"
#include "ui/plots/xy_plot.h"
#include "ui/values/ids.h"
#include "ui/widgets/theme.h"
#include "ui/words/display_units.h"

#include <QWidget>

#include <concepts>
#include <functional>
#include <optional>
#include <utility>
#include <vector>

class QAction;
class QCustomPlot;

namespace vybeg::ui {

// A plot in a panel. Ctrl+C copies it; its context menu also exports; its frame shows the keyboard
// focus.
class PlotView : public QWidget {
    Q_OBJECT

public:
    // The plot, under the name of this widget.
    virtual Figure figure() const = 0;

signals:
    void exportWanted(const Figure& figure);

protected:
    explicit PlotView(QWidget* parent);

    Theme theme() const { return themeOf(palette()); }
    // Puts the drawing into the widget, which leaves room for the frame. It ignores the mouse, so
    // that the wheel scrolls the panel around it.
    void addDrawing(QWidget* drawing);
    // Draws anew: of another content, palette, size or language.
    virtual void rebuild() = 0;
    // Whether there is something to copy and export.
    void setDrawn(bool drawn);

    void paintEvent(QPaintEvent* event) override;

private:
    void retranslate();

    QAction* copy_;
    QAction* export_;
};

// A plot of one quantity against another in a panel.
class XYPlotView : public PlotView {
    Q_OBJECT

public:
    explicit XYPlotView(QWidget* parent = nullptr);

    void setContent(const XYPlot& content);
    const XYPlot& content() const { return content_; }
    int head() const;  // headOf() its content at its width
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

// The plots for an export: those that show something, by their accessible names.
FigureSource figuresOf(const std::vector<const XYPlotView*>& plots, const QString& name,
                       const QString& title);

// A page of the window, or a part of one: plots, and numbers beside them.
class MeasuredPage : public QWidget {
    Q_OBJECT

public:
    explicit MeasuredPage(QWidget* parent);

    virtual FigureSource figures() const { return {}; }
    virtual void setUnits(const DisplayUnits& units);
    virtual void setAnalysis(AnalysisId /*chosen*/) {}

signals:
    void exportWanted(const Figure& figure);
    void figuresChanged();  // figures() are others, or there are some now

protected:
    Theme theme() const { return themeOf(palette()); }
    const DisplayUnits& units() const { return units_; }
    // Palette or units are others.
    virtual void showAgain() {}
    // A plot, or another part in the page's units; its export is exportWanted().
    template <class Part>
    Part* withPart(Part* part) {
        connect(part, &Part::exportWanted, this, &MeasuredPage::exportWanted);
        if constexpr (std::derived_from<Part, MeasuredPage>) {
            parts_.push_back(part);
        }
        return part;
    }
    // A plot of at least that height, pixels.
    XYPlotView* addPlot(const char* name, int least_height);
    // The texts of the page in the language of the window.
    virtual void retranslate() {}

private:
    DisplayUnits units_;
    std::vector<MeasuredPage*> parts_;
};

}  // namespace vybeg::ui
