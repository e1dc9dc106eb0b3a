#pragma once

#include "ui/plots/zoom_navigator.h"

#include <QWidget>

#include <optional>

class QCustomPlot;

namespace vybeg::ui {

class TimeOverlay;
class TimeStack;
struct HairLines;

// The two measuring cursors.
enum class Cursor { a, b };

// Plots on one time axis with the mouse and the keyboard of this axis. Several views may share the
// time range with its history, the tracker and the cursors: they are what the functions below
// without a body say.
//
// Wheel: time about the mouse; drag: pan; Shift+drag: zoom into a rectangle; double click or Home:
// fit; R or Alt+Left, Alt+Right: zoom history; + and -: zoom time about the tracker or the centre;
// Left, Right: pan; 1 and 2: cursor A and B to the tracker, 0 removes both; cursors can be dragged.
class TimeGestures : public QWidget {
    Q_OBJECT

public:
    explicit TimeGestures(QWidget* parent = nullptr);

    virtual ZoomNavigator& zoom() = 0;
    virtual std::optional<double> tracker() const = 0;
    virtual std::optional<double> cursor(Cursor which) const = 0;
    // As the mouse and the keyboard do, with signals; seconds.
    virtual void moveTracker(std::optional<double> time_s) = 0;
    virtual void moveCursor(Cursor which, std::optional<double> time_s) = 0;
    virtual void fit() = 0;

    // Keys of the time axis and the cursors: whether it was one.
    bool takeTimeKey(QKeyEvent* event);
    // Where an instant lies in the widget.
    double positionOf(double time_s) const;
    // Draws tracker and cursors again.
    void refreshOverlay();

public slots:
    void zoomIn() { zoomByKey(ZoomNavigator::notch); }
    void zoomOut() { zoomByKey(1 / ZoomNavigator::notch); }

protected:
    QCustomPlot& plot() const { return *plot_; }
    // For the overlay.
    HairLines hairs() const;
    // Both belong to the derived class; before the view is shown.
    void setPlots(const TimeStack& stack, TimeOverlay& overlay);
    // First the plot, because it uses the stack while it is drawn.
    void removePlot();

    // Positions from here on are those of the plot.
    // Whether there is a time axis to act on.
    virtual bool hasTime() const { return true; }
    virtual void pressedAt(const QPointF&) {}
    // What follows of a drag besides the time.
    virtual void panValues(ZoomState&, const QPointF& /*moved*/) {}
    // The rectangle to zoom into, of a drag from the press to a position.
    virtual QRectF bandBetween(const QPointF& from, const QPointF& to) const;
    virtual void zoomValuesTo(ZoomState&, const QRectF& /*band*/) {}
    // Ctrl+wheel: whether it acts on values instead of the time.
    virtual bool zoomValues(const QPointF& /*at*/, double /*factor*/) { return false; }
    virtual void hoverAt(const QPointF&) {}
    virtual bool takeKey(QKeyEvent* event) { return takeTimeKey(event); }

    void keyPressEvent(QKeyEvent* event) override;
    void mousePressEvent(QMouseEvent* event) override;
    void mouseMoveEvent(QMouseEvent* event) override;
    void mouseReleaseEvent(QMouseEvent* event) override;
    void mouseDoubleClickEvent(QMouseEvent* event) override;
    void wheelEvent(QWheelEvent* event) override;
    void leaveEvent(QEvent* event) override;

    static constexpr double least_band = 5;  // pixels; a smaller one is a click

private:
    enum class Drag { none, pan, band, cursorA, cursorB };

    QPointF inPlot(const QPointF& position) const;
    double timeAt(const QPointF& at) const;
    std::optional<Cursor> cursorAt(const QPointF& at) const;
    void zoomByKey(double factor);
    void showBand(std::optional<QRectF> band);

    QCustomPlot* plot_;
    const TimeStack* stack_ = nullptr;
    TimeOverlay* overlay_ = nullptr;
    Drag drag_ = Drag::none;
    QPointF press_;
    ZoomState press_state_;
};

}  // namespace vybeg::ui
