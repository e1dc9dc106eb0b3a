#pragma once

#include "ui/plots/plot_content.h"
#include "ui/plots/time_gestures.h"
#include "ui/values/shown_analysis.h"
#include "ui/words/display_units.h"

#include <array>
#include <optional>
#include <vector>

namespace vybeg::ui {

class PanelFocus;
class PlotOverlay;
class PlotStack;

// The stacked plots of the slow variables of all visible analyses over one time axis; owner of the
// time range, tracker and cursors that other views share.
//
// Besides the gestures of the time: Ctrl+wheel: value axis of the plot under the mouse; Ctrl+Plus,
// Ctrl+Minus, Up, Down: value axis of the focused plot; Tab: next plot.
//
// Times are seconds from the start of the recording. Setters emit only timeRangeChanged.
class TrackView : public TimeGestures {
    Q_OBJECT

public:
    explicit TrackView(QWidget* parent = nullptr);

    // Keeps the visible time range. Shows everything if everything was visible before, if the range
    // lies outside the new analyses or if a new recording joins.
    // Of them `unlike` are hidden because they cannot be drawn over the others; the legend says so.
    void setAnalyses(std::vector<ShownAnalysis> analyses, int unlike = 0);
    const std::vector<ShownAnalysis>& analyses() const { return content_.analyses; }
    // Time that the zoom of other pages covers while there is no analysis.
    void setRecorded(const AxisRange& range, double rate_hz);
    void setShownVariables(std::vector<SlowVariable> variables);
    const std::vector<SlowVariable>& shownVariables() const { return content_.variables; }
    // Drops value ranges fixed by hand if their unit changes.
    void setUnits(const DisplayUnits& units);
    const DisplayUnits& units() const { return content_.units; }

    AxisRange timeRange() const { return zoom_.current().time; }
    // Clips the range to that of the analyses; adds it to the zoom history.
    void setTimeRange(AxisRange range);
    // Time range of the visible analyses; without any, that of the recording, otherwise {0, 1}.
    AxisRange fullTimeRange() const { return coveredTime(content_.analyses).value_or(recorded_); }
    // Time range and fixed value ranges at once, one step of the zoom history.
    void setZoom(ZoomState state) { zoom_.visit(std::move(state), Gesture::none); }

    ZoomNavigator& zoom() override { return zoom_; }
    std::optional<double> tracker() const override { return tracker_; }
    void setTracker(std::optional<double> time_s);
    std::optional<double> cursor(Cursor which) const override {
        return cursors_[static_cast<std::size_t>(which)];
    }
    void setCursor(Cursor which, std::optional<double> time_s);
    void moveTracker(std::optional<double> time_s) override;
    void moveCursor(Cursor which, std::optional<double> time_s) override;
    // The plot that the menu acts on: the one with the focus, else the one under the mouse.
    std::optional<SlowVariable> chosenVariable() const;
    // Of its value axis, displayed units; without a range it follows the data. A step of the zoom.
    AxisRange valueRange(SlowVariable variable) const;
    void setValueRange(SlowVariable variable, std::optional<AxisRange> range);
    // Instants in rising order, marked by thin lines in all plots: axis crossings, for example.
    void setMarks(std::vector<double> times_s);
    // Fitted curves drawn over the plots, displayed units.
    void setTrends(std::vector<TrendCurve> trends);

    // Present content with the time range, input of plotsFigure().
    PlotContent content() const;

    QSize sizeHint() const override { return {900, 700}; }
    QSize minimumSizeHint() const override;

public slots:
    void fit() override { zoom_.visit({fullTimeRange(), {}}, Gesture::none); }

signals:
    // Time range, or the history of zooms.
    void timeRangeChanged(double from_s, double to_s);
    void trackerMoved(double time_s);
    // The user moved, placed or removed a cursor.
    void cursorsChanged();
    void variablesChanged();

private:
    bool hasTime() const override { return coveredTime(content_.analyses).has_value(); }
    void pressedAt(const QPointF& at) override;
    void panValues(ZoomState& state, const QPointF& moved) override;
    QRectF bandBetween(const QPointF& from, const QPointF& to) const override;
    void zoomValuesTo(ZoomState& state, const QRectF& band) override;
    bool zoomValues(const QPointF& at, double factor) override;
    void hoverAt(const QPointF& at) override;
    bool takeKey(QKeyEvent* event) override;
    // Scales the value axis about a fraction of its height from below and shifts it by a fraction.
    void changeValues(SlowVariable variable, double factor, double about, double shift,
                      Gesture gesture);

    // A view with its time range inside the full one, and with valid value ranges.
    ZoomState clipped(ZoomState state) const;
    void rebuild();
    void matchFocus();
    void redraw();
    void followLayout();

    PlotContent content_;
    AxisRange recorded_;
    double recorded_hz_ = 0;  // sample rate; 0: not known
    ZoomNavigator zoom_;
    PlotStack& stack_;
    PlotOverlay* overlay_ = nullptr;
    std::vector<PanelFocus*> focus_;  // one per plot in the tab order
    std::optional<double> tracker_;
    std::array<std::optional<double>, 2> cursors_;
    std::optional<SlowVariable> pointed_;  // at the mouse
    // Of the plot in which a drag began.
    std::optional<SlowVariable> press_variable_;
    AxisRange press_values_;
};

}  // namespace vybeg::ui
