#pragma once

#include "ui/plots/plot_content.h"
#include "ui/plots/plot_focus.h"
#include "ui/plots/zoom_navigator.h"
#include "ui/values/shown_analysis.h"
#include "ui/widgets/theme.h"
#include "ui/words/display_units.h"

#include <QWidget>

#include <array>
#include <memory>
#include <optional>
#include <vector>

class QCustomPlot;

namespace vybeg::ui {

class PlotOverlay;
class PlotStack;

// The two measuring cursors of the view.
enum class Cursor { a, b };

// The stacked plots of the slow variables of all visible analyses over one time axis.
//
// Wheel: time about the mouse; Ctrl+wheel: value axis of the plot under the mouse; drag: pan;
// Shift+drag: zoom into a rectangle; double click or Home: fit; R or Alt+Left, Alt+Right: zoom
// history; + and -: zoom time about the tracker or the centre; Left, Right: pan; Ctrl+Plus,
// Ctrl+Minus, Up, Down: value axis of the focused plot; Tab: next plot; 1 and 2: cursor A and B to
// the tracker, 0 removes both; cursors can be dragged.
//
// Times are seconds from the start of the recording. Setters emit only timeRangeChanged.
class TrackView : public QWidget {
    Q_OBJECT

public:
    explicit TrackView(QWidget* parent = nullptr);
    ~TrackView() override;

    // Keeps the visible time range. Shows everything if everything was visible before, if the range
    // lies outside the new analyses or if a new recording joins.
    // Of them `unlike` are hidden because they cannot be drawn over the others; the legend says so.
    void setAnalyses(std::vector<ShownAnalysis> analyses, int unlike = 0);
    const std::vector<ShownAnalysis>& analyses() const { return content_.analyses; }
    // Time that the zoom of other pages covers while there is no analysis.
    void setRecorded(const RecordedTime& recorded);
    void setShownVariables(std::vector<SlowVariable> variables);
    const std::vector<SlowVariable>& shownVariables() const { return content_.variables; }
    // Drops value ranges fixed by hand if their unit changes.
    void setUnits(const DisplayUnits& units);
    const DisplayUnits& units() const { return content_.units; }
    void setTheme(const Theme& theme);

    AxisRange timeRange() const { return zoom_.current().time; }
    // Clips the range to that of the analyses; adds it to the zoom history.
    void setTimeRange(AxisRange range);
    // Time range of the visible analyses; without any, that of the recording, otherwise {0, 1}.
    AxisRange fullTimeRange() const {
        return coveredTime(content_.analyses).value_or(recorded_.range);
    }
    // Time range and fixed value ranges at once, one step of the zoom history.
    void setZoom(ZoomState state) { zoom_.visit(std::move(state), Gesture::none); }
    // A fixed value axis in displayed units, or one that follows the data.
    void setValueRange(SlowVariable variable, std::optional<AxisRange> range);
    std::optional<AxisRange> valueRange(SlowVariable variable) const;

    // The time range with its history, which other pages share.
    ZoomNavigator& zoom() { return zoom_; }

    std::optional<double> tracker() const { return tracker_; }
    void setTracker(std::optional<double> time_s);
    std::optional<double> cursor(Cursor which) const;
    void setCursor(Cursor which, std::optional<double> time_s);
    // As the mouse and the keyboard do, with signals.
    void moveTracker(std::optional<double> time_s);
    void moveCursor(Cursor which, std::optional<double> time_s);
    // Keys of the time axis and the cursors, for other views of it: whether it was one.
    bool takeTimeKey(QKeyEvent* event);
    // Instants in rising order, marked by thin lines in all plots: axis crossings, for example.
    void setMarks(std::vector<double> times_s);
    // Fitted curves drawn over the plots, displayed units.
    void setTrends(std::vector<TrendCurve> trends);

    // The variable whose plot lies at a position of the widget, for context menus.
    std::optional<SlowVariable> variableAt(const QPoint& position) const;
    // Present content with the time range, input of plot_export.h.
    PlotContent content() const;

    QSize sizeHint() const override { return {900, 700}; }
    QSize minimumSizeHint() const override;

public slots:
    void fit() { zoom_.visit({fullTimeRange(), {}}, Gesture::none); }
    void zoomIn() { zoomByKey(ZoomNavigator::notch); }
    void zoomOut() { zoomByKey(1 / ZoomNavigator::notch); }

signals:
    void timeRangeChanged(double from_s, double to_s);
    void trackerMoved(double time_s);
    void trackerLeft();
    // The user moved, placed or removed a cursor.
    void cursorsChanged();
    void zoomHistoryChanged();
    void variablesChanged();
    // Margins of the time axes, pixels from both edges.
    void timeAxisPlaced(int left, int right);

protected:
    void keyPressEvent(QKeyEvent* event) override;
    void resizeEvent(QResizeEvent* event) override;
    void showEvent(QShowEvent* event) override;
    void changeEvent(QEvent* event) override;
    void mousePressEvent(QMouseEvent* event) override;
    void mouseMoveEvent(QMouseEvent* event) override;
    void mouseReleaseEvent(QMouseEvent* event) override;
    void mouseDoubleClickEvent(QMouseEvent* event) override;
    void wheelEvent(QWheelEvent* event) override;
    void leaveEvent(QEvent* event) override;

private:
    enum class Drag { none, pan, rubberBand, cursorA, cursorB };

    // The instant and, in the plot with the mouse, the value at a position.
    double timeAt(const QPointF& position) const;
    std::optional<Cursor> cursorAt(const QPointF& position) const;
    void pan(const QPointF& position);
    void zoomByKey(double factor);
    // Scales the value axis about a fraction of its height from below and shifts it by a fraction.
    void changeValues(SlowVariable variable, double factor, double about, double shift,
                      Gesture gesture);
    void zoomToBand(const QRectF& band);
    bool keyMoves(QKeyEvent* event);

    void rebuild();
    void redraw();
    void refreshOverlay();
    void followLayout();

    PlotContent content_;
    RecordedTime recorded_;
    ZoomNavigator zoom_;
    QCustomPlot* plot_ = nullptr;
    std::unique_ptr<PlotStack> stack_;
    PlotOverlay* overlay_ = nullptr;
    PlotFocus focus_{*this};
    std::optional<double> tracker_;
    std::array<std::optional<double>, 2> cursors_;
    Drag drag_ = Drag::none;
    QPointF press_;
    ZoomState press_state_;
    std::optional<SlowVariable> press_variable_;
    AxisRange press_values_;
};

}  // namespace vybeg::ui
