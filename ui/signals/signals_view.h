#pragma once

#include "ui/plots/track_view.h"
#include "ui/signals/signal_picture.h"

#include <QWidget>

#include <array>
#include <memory>
#include <optional>

class QCustomPlot;

namespace vybeg::ui {

class SignalOverlay;
class SignalStack;

// The plots of the signals with mouse and keyboard; time range, zoom history, tracker and cursors
// are those of the view of the tracks.
//
// Wheel: time about the mouse; drag: pan; Shift+drag: zoom into a part of the time; double click or
// Home: fit; R or Alt+Left, Alt+Right: zoom history; + and -: zoom; Left, Right: pan; 1 and 2:
// cursor A and B to the mouse, 0 removes both; cursors can be dragged.
class SignalsView : public QWidget {
    Q_OBJECT

public:
    explicit SignalsView(TrackView& tracks, QWidget* parent = nullptr);
    ~SignalsView() override;

    // The time range of the content is that of the tracks.
    void setContent(SignalContent content);
    const SignalContent& content() const;
    const SignalPicture& picture() const;
    // Width of the time axis, pixels.
    int timeWidth() const;
    // Draws tracker and cursors again.
    void showCursors();
    // Where an instant lies in the widget.
    double positionOf(double time_s) const;

    QSize sizeHint() const override { return {900, 700}; }
    QSize minimumSizeHint() const override { return {320, 320}; }

signals:
    void resized();

protected:
    void keyPressEvent(QKeyEvent* event) override;
    void resizeEvent(QResizeEvent* event) override;
    void changeEvent(QEvent* event) override;
    void focusInEvent(QFocusEvent* event) override;
    void focusOutEvent(QFocusEvent* event) override;
    void paintEvent(QPaintEvent* event) override;
    void mousePressEvent(QMouseEvent* event) override;
    void mouseMoveEvent(QMouseEvent* event) override;
    void mouseReleaseEvent(QMouseEvent* event) override;
    void mouseDoubleClickEvent(QMouseEvent* event) override;
    void wheelEvent(QWheelEvent* event) override;
    void leaveEvent(QEvent* event) override;

private:
    enum class Drag { none, pan, part, cursorA, cursorB };

    double timeAt(const QPointF& position) const;
    bool inPlots(const QPointF& position) const;
    std::optional<Cursor> cursorAt(const QPointF& position) const;

    TrackView& tracks_;
    QCustomPlot* plot_;
    std::unique_ptr<SignalStack> stack_;
    SignalOverlay* overlay_;
    Drag drag_ = Drag::none;
    QPointF press_;
    AxisRange press_time_;
};

}  // namespace vybeg::ui
