#pragma once

#include "core/recording/checks/recording_check.h"
#include "core/recording/envelope/envelope.h"
#include "ui/values/zoom_state.h"
#include "ui/widgets/theme.h"

#include <QPixmap>
#include <QWidget>

#include <memory>

namespace vybeg::ui {

// The overview strip: the whole raw recording as minima and maxima of both channels, the visible
// range (bright, with handles at its edges) and the analysed range (bar along the foot, with
// handles). Times are seconds from the start of the recording; setters emit nothing.
//
// Drag an edge to move it, the inside to shift the range; a click outside centres the visible
// range; a double click shows all; the wheel zooms. Keys: Left, Right, +, -, Home act on the
// visible range, with Shift on the analysed one.
class SignalView : public QWidget {
    Q_OBJECT

public:
    explicit SignalView(QWidget* parent = nullptr);

    // Shows a recording of that length without data yet; 0: none, the strip is empty.
    void setReading(double seconds);
    // The part read so far; parts that are only sampled are paler, the rest hatched. The time axis
    // is always that of the whole recording.
    void setEnvelope(std::shared_ptr<const Envelope> envelope, double rate_hz);
    // Faults of the recording check: clipped ranges are a bar along the top, places of lost samples
    // lines with a point. Null: unknown.
    void setFaults(std::shared_ptr<const SampleFaults> faults);
    void setVisibleRange(AxisRange range) { setRange(false, range); }
    void setAnalysedRange(AxisRange range) { setRange(true, range); }
    // Margins of the time axis, pixels from both edges, for alignment with other plots.
    void setMargins(int left, int right);
    // Area above the time axis, in coordinates of the widget.
    QRect plotArea() const { return rect().adjusted(left_, 2, -right_, -range_row); }

    AxisRange visibleRange() const { return visible_; }
    AxisRange analysedRange() const { return analysed_; }

    QSize sizeHint() const override { return {600, 40}; }
    QSize minimumSizeHint() const override { return {160, 40}; }

signals:
    void visibleRangeEdited(double from_s, double to_s);
    void analysedRangeEdited(double from_s, double to_s);

protected:
    void paintEvent(QPaintEvent* event) override;
    void changeEvent(QEvent* event) override;
    void mousePressEvent(QMouseEvent* event) override;
    void mouseMoveEvent(QMouseEvent* event) override;
    void mouseReleaseEvent(QMouseEvent* event) override;
    void mouseDoubleClickEvent(QMouseEvent* event) override;
    void wheelEvent(QWheelEvent* event) override;
    void keyPressEvent(QKeyEvent* event) override;

private:
    enum class Grip { none, from, to, all };  // of the visible or the analysed range

    // Height of the row below the signals, the bar of the analysed range.
    static constexpr int range_row = 9;

    double toPixel(double time_s) const;
    double toTime(double pixel) const;
    Grip gripAt(const QPointF& position) const;
    void drag(double time_s);
    // The signals, where the analysed range lies.
    bool isBelow(const QPointF& position) const { return position.y() > plotArea().bottom(); }
    AxisRange& range(bool analysed) { return analysed ? analysed_ : visible_; }
    void setRange(bool analysed, AxisRange range);
    void edit(bool analysed, AxisRange edited);
    void zoomVisible(double factor, double about_s);
    void drawEnvelope(QPainter& painter, const QRect& area) const;
    void drawFaults(QPainter& painter, const QRect& area) const;
    void drawRanges(QPainter& painter, const QRect& area) const;
    void drawLabel(QPainter& painter, const QRect& area, int alignment, const QString& text) const;
    void drawLength(QPainter& painter, const QRect& area) const;

    std::shared_ptr<const Envelope> envelope_;
    std::shared_ptr<const SampleFaults> faults_;
    double seconds_ = 0;
    double rate_hz_ = 0;
    AxisRange visible_;
    AxisRange analysed_;
    Theme theme_;
    QPixmap drawn_;  // the envelope at the present size; null if it must be drawn again
    int left_ = 8;
    int right_ = 8;
    Grip grip_ = Grip::none;
    bool grips_analysed_ = false;
    double press_s_ = 0;
    AxisRange press_range_;
};

}  // namespace vybeg::ui
