#pragma once

#include "ui/plots/time_stack.h"
#include "ui/values/zoom_state.h"

#include <QObject>
#include <QTimer>
#include <QWidget>

#include <cstddef>
#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <vector>

class QCustomPlot;
class QKeyEvent;

namespace vybeg::ui {

// Kind of input of one entry of the zoom history; `none` is an entry of its own.
enum class Gesture : std::uint8_t {
    none,
    wheel_time,
    wheel_value,
    drag,
    key_time,
    key_value,
    outside
};

// The view that plots show, with its history, as in a browser. Successive steps of one gesture are
// one entry.
class ZoomNavigator : public QObject {
    Q_OBJECT

public:
    // `clipped`: a view limited to what can be shown.
    explicit ZoomNavigator(std::function<ZoomState(ZoomState)> clipped);

    const ZoomState& current() const { return states_[position_]; }
    bool canBack() const { return position_ > 0; }
    bool canForward() const { return position_ + 1 < states_.size(); }

    void visit(ZoomState state, Gesture gesture);
    // Goes there unclipped, and forgets what was forward; with `same_entry` in the place of the
    // current entry.
    void goTo(ZoomState state, bool same_entry);
    void restart(const ZoomState& state);
    void back();
    void forward();
    void zoomTime(double factor, double about_s, Gesture gesture);
    void panTime(double fraction);
    // Keys of the time: R and Alt with an arrow for the history, arrows to pan. Returns whether the
    // key is one of them.
    bool takeKey(const QKeyEvent& event);
    // What can be shown has become another: a view of all of it, and one that lies outside, begin
    // anew.
    void follow(const AxisRange& before, const AxisRange& now);

    static constexpr double notch = 0.8;  // of a range per notch of the wheel or key
    static constexpr double arrow = 0.1;  // of a range per arrow key
    void endGesture() { gesture_ = Gesture::none; }

signals:
    // Another view, or another history.
    void moved();

private:
    std::function<ZoomState(ZoomState)> clipped_;
    std::vector<ZoomState> states_{ZoomState()};
    std::size_t position_ = 0;
    QTimer pause_;  // active while the next step belongs to the same gesture
    Gesture gesture_ = Gesture::none;
};

class TimeOverlay;

// The two measuring cursors.
enum class Cursor { a, b };

// Plots on one time axis with the mouse and the keyboard of this axis. Several views may share the
// time range with its history, the tracker and the cursors: they are what the functions below
// without a body say.
//
// Wheel: time about the mouse; drag: pan; Shift+drag: zoom into a rectangle; double click or Home:
// fit; R or Alt+Left, Alt+Right: zoom history; + and -: zoom time about the tracker or the centre;
// Left, Right: pan; 1 and 2: cursor A and B to the tracker, 0 removes both; cursors can be dragged,
// and Shift+Left, Shift+Right move the one that was last placed or dragged by a pixel.
class TimeGestures : public QWidget {
    Q_OBJECT

public:
    explicit TimeGestures(QWidget* parent = nullptr);
    ~TimeGestures() override;

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

signals:
    // Margins of the time axes of the visible view, pixels from both edges.
    void timeAxisPlaced(int left, int right);

protected:
    QCustomPlot& plot() const { return *plot_; }
    // Takes the plots over; before the view is shown.
    void setPlots(const TimeStack* stack, TimeOverlay& overlay);

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
    // Moves the chosen cursor, else the other one: whether there is one.
    bool stepCursor(int pixels);
    void showBand(std::optional<QRectF> band);

    QCustomPlot* plot_;
    std::unique_ptr<const TimeStack> stack_;
    TimeOverlay* overlay_ = nullptr;
    Drag drag_ = Drag::none;
    Cursor chosen_ = Cursor::a;
    QPointF press_;
    ZoomState press_state_;
};

// Items that move with the mouse, on a separate layer, so that the curves below are not drawn
// again: the hair lines of the tracker and the two cursors, the rubber band.
class TimeOverlay : public QCPLayerable {
public:
    TimeOverlay(const TimeStack& stack, const TimeGestures& gestures);

    void setBand(std::optional<QRectF> band) { band_ = band; }

protected:
    const TimeGestures& gestures() const { return gestures_; }

    void applyDefaultAntialiasingHint(QCPPainter* painter) const override;
    void draw(QCPPainter* painter) override;

private:
    void drawHair(QCPPainter& painter, std::optional<double> time_s, const QColor& color,
                  const QString& name) const;

    const TimeStack& stack_;
    const TimeGestures& gestures_;
    std::optional<QRectF> band_;
};

}  // namespace vybeg::ui
