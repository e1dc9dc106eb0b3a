#include "ui/plots/track_view.h"

#include "ui/plots/plot_panel.h"
#include "ui/plots/plot_stack.h"
#include "ui/widgets/page_parts.h"
#include "ui/words/rich_text.h"

#include <QCoreApplication>
#include <QFocusEvent>
#include <QKeyEvent>
#include <QPainter>
#include <QWidget>
#include <qcustomplot.h>

#include <algorithm>
#include <cmath>

namespace vybeg::ui {

namespace {

// Heights, pixels.
constexpr int least_plot = 70;    // with the gap below it
constexpr int around_plots = 20;  // time axis

// Whether an analysis belongs to a recording without an analysis in `before`.
bool hasOtherRecording(const std::vector<ShownAnalysis>& analyses,
                       const std::vector<ShownAnalysis>& before) {
    return std::ranges::any_of(analyses, [&](const ShownAnalysis& shown) {
        return std::ranges::find(before, shown.recording, &ShownAnalysis::recording) ==
               before.end();
    });
}

double scaled(const QCPAxis& axis, double coordinate) {
    return axis.scaleType() == QCPAxis::stLogarithmic ? std::log(coordinate) : coordinate;
}

double unscaled(const QCPAxis& axis, double position) {
    return axis.scaleType() == QCPAxis::stLogarithmic ? std::exp(position) : position;
}

// An axis' range scaled about a fraction of it and shifted by a fraction, on its own scale.
AxisRange changed(const QCPAxis& axis, const AxisRange& range, double factor, double about,
                  double shift) {
    const double lower = scaled(axis, range.lower);
    const double span = scaled(axis, range.upper) - lower;
    const double from = lower + about * span * (1 - factor) + shift * span;
    return {unscaled(axis, from), unscaled(axis, from + factor * span)};
}

}  // namespace

// Representative of a plot for keyboard and screen reader: an invisible widget over a panel with
// the focus, the accessible name and the focus frame. Transparent for the mouse.
class PanelFocus : public QWidget {
public:
    PanelFocus(SlowVariable variable, QWidget* parent) : QWidget(parent), variable_(variable) {
        setAttribute(Qt::WA_TransparentForMouseEvents);
        setFocusPolicy(Qt::TabFocus);
    }

    SlowVariable variable() const { return variable_; }
    void setColor(const QColor& color) {
        color_ = color;
        update();
    }

protected:
    void paintEvent(QPaintEvent*) override {
        if (!framed_) {
            return;
        }
        QPainter painter(this);
        painter.setRenderHint(QPainter::Antialiasing);
        painter.setPen(QPen(color_, 1.5));
        painter.drawRoundedRect(QRectF(rect()).adjusted(1.5, 1.5, -1.5, -1.5), 4, 4);
    }

    // The frame is shown only for focus by keyboard.
    void focusInEvent(QFocusEvent* event) override {
        framed_ = event->reason() == Qt::TabFocusReason ||
                  event->reason() == Qt::BacktabFocusReason ||
                  event->reason() == Qt::ShortcutFocusReason;
        update();
    }

    void focusOutEvent(QFocusEvent*) override {
        framed_ = false;
        update();
    }

private:
    SlowVariable variable_;
    QColor color_;
    bool framed_ = false;
};

// Over the slow variables: a dot on each curve at the tracker, and what an empty view says.
class PlotOverlay : public TimeOverlay {
public:
    PlotOverlay(const PlotStack& stack, const TimeGestures& gestures)
        : TimeOverlay(stack, gestures), stack_(stack) {}

    // Text in the middle of an empty view.
    void setHint(const QString& hint) { hint_ = hint; }
    // Number of analyses that are not drawn, for the corner of the first plot.
    void setUnlike(int count) { unlike_ = count; }

protected:
    void draw(QCPPainter* painter) override {
        if (!hint_.isEmpty()) {
            painter->setPen(stack_.theme().mutedText);
            painter->setFont(plotFont(*mParentPlot));
            painter->drawText(mParentPlot->viewport(), int(Qt::AlignCenter | Qt::TextWordWrap),
                              hint_);
            return;
        }
        if (unlike_ > 0 && !stack_.panels().empty()) {
            const PlotPanel& first = *stack_.panels().front();
            painter->setPen(stack_.theme().mutedText);
            painter->setFont(first.font());
            painter->drawText(
                QRectF(first.rect()).adjusted(6, 2, -6, -2), int(Qt::AlignRight | Qt::AlignTop),
                QCoreApplication::translate("PlotStack", "%n not drawn: other length or unit",
                                            nullptr, unlike_));
        }
        TimeOverlay::draw(painter);
        if (const auto time_s = gestures().tracker()) {
            for (const PlotPanel* panel : stack_.panels()) {
                panel->drawDots(*painter, *time_s);
            }
        }
    }

private:
    const PlotStack& stack_;
    QString hint_;
    int unlike_ = 0;
};

TrackView::TrackView(QWidget* parent)
    : TimeGestures(parent),
      zoom_([this](ZoomState state) { return clipped(std::move(state)); }),
      stack_(*new PlotStack(plot(), 0, PlotHead::margin)),
      overlay_(new PlotOverlay(stack_, *this)) {
    setPlots(&stack_, *overlay_);
    setFocusPolicy(Qt::ClickFocus);
    setAccessibleName(tr("Slow variables over time"));
    connect(&plot(), &QCustomPlot::afterLayout, this, &TrackView::followLayout);
    connect(&zoom_, &ZoomNavigator::moved, this, [this] {
        redraw();
        emit timeRangeChanged(timeRange().lower, timeRange().upper);
    });
    rebuild();
    whenChanged(
        *this,
        {QEvent::LanguageChange, QEvent::LocaleChange, QEvent::FontChange, QEvent::PaletteChange},
        [this] {
            setAccessibleName(tr("Slow variables over time"));
            rebuild();
        });
    whenChanged(*this, {QEvent::Resize, QEvent::Show}, [this] { redraw(); });
}

void TrackView::setAnalyses(std::vector<ShownAnalysis> analyses, int unlike) {
    const auto before = coveredTime(content_.analyses);
    const bool fitted = timeRange() == fullTimeRange();
    // A zoom into a recording without analyses stays when the first one arrives.
    const bool joined = before && hasOtherRecording(analyses, content_.analyses);
    content_.analyses = std::move(analyses);
    content_.unlike = unlike;
    const AxisRange full = fullTimeRange();
    const AxisRange shown = timeRange();
    rebuild();
    if ((!before && fitted) || shown.lower >= full.upper || shown.upper <= full.lower) {
        zoom_.restart({full, {}});
    } else if ((fitted || joined) && coveredTime(content_.analyses)) {
        zoom_.goTo({full, zoom_.current().fixed}, fitted);
    }
}

void TrackView::setRecorded(const AxisRange& range, double rate_hz) {
    const AxisRange before = fullTimeRange();
    recorded_ = range;
    recorded_hz_ = rate_hz;
    zoom_.follow(before, fullTimeRange());
}

ZoomState TrackView::clipped(ZoomState state) const {
    const AxisRange full = fullTimeRange();
    AxisRange& time = state.time;
    // Least span of four samples, the resolution of a track.
    double least = 1e-6 * full.span();
    const auto resolve = [&](double rate_hz) {
        if (rate_hz > 0) {
            least = std::min(least, 4 / rate_hz);
        }
    };
    resolve(recorded_hz_);
    for (const ShownAnalysis& shown : content_.analyses) {
        resolve(shown.rate_hz);
    }
    const double span = std::clamp(time.span(), std::min(least, full.span()), full.span());
    const double centre = 0.5 * (time.lower + time.upper);
    // A range that only lies too far out is shifted at its edge, not through its centre, so that it
    // keeps its last bit and the history recognises it.
    if (span != time.span()) {
        time = {centre - 0.5 * span, centre + 0.5 * span};
    }
    if (time.lower < full.lower) {
        time = {full.lower, std::min(full.upper, full.lower + span)};
    } else if (time.upper > full.upper) {
        time = {std::max(full.lower, full.upper - span), full.upper};
    }
    std::erase_if(state.fixed, [](const auto& entry) {
        const AxisRange& range = entry.second;
        return !(range.span() > 0) || !std::isfinite(range.span());
    });
    return state;
}

void TrackView::setShownVariables(std::vector<SlowVariable> variables) {
    content_.variables = std::move(variables);
    rebuild();
    emit variablesChanged();
}

void TrackView::setUnits(const DisplayUnits& units) {
    ZoomState state = zoom_.current();
    std::erase_if(state.fixed, [&](const auto& entry) {
        return displayScale(entry.first, units, 1) != displayScale(entry.first, content_.units, 1);
    });
    const bool changed = !(units == content_.units);
    content_.units = units;
    if (changed) {
        zoom_.restart(state);  // the ranges of the history are in the old units
    }
    rebuild();
}

void TrackView::setMarks(std::vector<double> times_s) {
    if (times_s != content_.marks_s) {
        content_.marks_s = std::move(times_s);
        stack_.setMarks(content_.marks_s);
        plot().replot(QCustomPlot::rpQueuedReplot);
    }
}

void TrackView::setTrends(std::vector<TrendCurve> trends) {
    content_.trends = std::move(trends);
    rebuild();
}

PlotContent TrackView::content() const {
    PlotContent content = content_;
    content.zoom = zoom_.current();
    return content;
}

void TrackView::setTimeRange(AxisRange range) {
    ZoomState state = zoom_.current();
    state.time = range;
    zoom_.visit(std::move(state), Gesture::outside);
}

void TrackView::setTracker(std::optional<double> time_s) {
    tracker_ = time_s;
    refreshOverlay();
}

void TrackView::setCursor(Cursor which, std::optional<double> time_s) {
    cursors_[static_cast<std::size_t>(which)] = time_s;
    refreshOverlay();
}

QSize TrackView::minimumSizeHint() const {
    const int rows = std::max(1, static_cast<int>(content_.variables.size()));
    return {320, around_plots + rows * least_plot};
}

void TrackView::rebuild() {
    content_.theme = themeOf(palette());
    plot().setBackground(QBrush(content_.theme.plotBackground));
    stack_.prepare(plot().size());
    stack_.setContent(content());
    const bool has_analyses = hasTime();
    overlay_->setHint(has_analyses ? QString()
                                   : tr("No analysis yet.\nOpen a recording and press Keep (F5)."));
    overlay_->setUnlike(content_.unlike);
    for (const char* name : {"background", "grid", "main", "axes"}) {
        plot().layer(QString::fromLatin1(name))->setVisible(has_analyses);
    }
    matchFocus();
    updateGeometry();
    redraw();
}

void TrackView::matchFocus() {
    if (!std::ranges::equal(focus_, content_.variables, {}, &PanelFocus::variable)) {
        std::ranges::for_each(focus_, [](PanelFocus* frame) { delete frame; });
        focus_.clear();
        for (const SlowVariable variable : content_.variables) {
            focus_.push_back(new PanelFocus(variable, this));
            focus_.back()->show();
        }
    }
    for (PanelFocus* frame : focus_) {
        frame->setColor(content_.theme.accent);
        frame->setAccessibleName(
            QCoreApplication::translate("PlotFocus", "Plot of %1, %2")
                .arg(indexPlain(displaySymbol(frame->variable(), content_.units)),
                     displayMeaning(frame->variable())));
    }
}

void TrackView::redraw() {
    // The number of strips may have changed since the last resize.
    stack_.prepare(plot().size());
    stack_.setZoom(zoom_.current());
    // Other pages zoom, too; a hidden plot is drawn when it is shown.
    if (isVisible()) {
        plot().replot(QCustomPlot::rpQueuedReplot);
    }
}

void TrackView::followLayout() {
    for (PanelFocus* frame : focus_) {
        if (const PlotPanel* panel = stack_.panel(frame->variable())) {
            frame->setGeometry(panel->outerRect());
        }
    }
}

void TrackView::changeValues(SlowVariable variable, double factor, double about, double shift,
                             Gesture gesture) {
    const PlotPanel* panel = stack_.panel(variable);
    if (!panel) {
        return;
    }
    ZoomState state = zoom_.current();
    state.fixed[variable] = changed(*panel->valueAxis(), panel->values(), factor, about, shift);
    zoom_.visit(std::move(state), gesture);
}

void TrackView::moveTracker(std::optional<double> time_s) {
    if (time_s == tracker_) {
        return;
    }
    setTracker(time_s);
    if (time_s) {
        emit trackerMoved(*time_s);
    }
}

void TrackView::moveCursor(Cursor which, std::optional<double> time_s) {
    setCursor(which, time_s);
    emit cursorsChanged();
}

void TrackView::pressedAt(const QPointF& at) {
    const PlotPanel& panel = *stack_.panelAt(at);
    const auto frame = std::ranges::find(focus_, panel.variable(), &PanelFocus::variable);
    if (frame != focus_.end()) {
        (*frame)->setFocus(Qt::MouseFocusReason);
    }
    press_variable_ = panel.variable();
    press_values_ = panel.values();
}

// An automatic axis remains automatic; a fixed one moves along.
void TrackView::panValues(ZoomState& state, const QPointF& moved) {
    const PlotPanel* panel = stack_.panel(*press_variable_);
    if (panel && state.fixed.contains(panel->variable())) {
        state.fixed[panel->variable()] = changed(*panel->valueAxis(), press_values_, 1, 0,
                                                 moved.y() / std::max(1, panel->height()));
    }
}

QRectF TrackView::bandBetween(const QPointF& from, const QPointF& to) const {
    const PlotPanel* panel = stack_.panel(*press_variable_);
    return panel ? QRectF(from, to).normalized().intersected(QRectF(panel->rect())) : QRectF();
}

void TrackView::zoomValuesTo(ZoomState& state, const QRectF& band) {
    const PlotPanel* panel = stack_.panel(*press_variable_);
    if (panel && band.height() >= least_band) {
        state.fixed[panel->variable()] = {panel->valueAxis()->pixelToCoord(band.bottom()),
                                          panel->valueAxis()->pixelToCoord(band.top())};
    }
}

bool TrackView::zoomValues(const QPointF& at, double factor) {
    const PlotPanel& panel = *stack_.panelAt(at);
    const double about = (panel.bottom() - at.y()) / std::max(1, panel.height());
    changeValues(panel.variable(), factor, std::clamp(about, 0., 1.), 0, Gesture::wheel_value);
    return true;
}

// At the margin, the meaning of the symbol there.
void TrackView::hoverAt(const QPointF& at) {
    const PlotPanel* panel = stack_.panelAt(at);
    const bool margin = panel && at.x() < panel->rect().left();
    setToolTip(margin ? displayMeaning(panel->variable()) : QString());
    pointed_ = panel ? std::optional(panel->variable()) : pointed_;
}

std::optional<SlowVariable> TrackView::chosenVariable() const {
    const auto focused = std::ranges::find_if(focus_, &PanelFocus::hasFocus);
    if (focused != focus_.end()) {
        return (*focused)->variable();
    }
    const auto& shown = content_.variables;
    if (pointed_ && std::ranges::count(shown, *pointed_) > 0) {
        return pointed_;
    }
    return shown.empty() ? std::nullopt : std::optional(shown.front());
}

AxisRange TrackView::valueRange(SlowVariable variable) const {
    const PlotPanel* panel = stack_.panel(variable);
    return panel ? panel->values() : AxisRange();
}

void TrackView::setValueRange(SlowVariable variable, std::optional<AxisRange> range) {
    ZoomState state = zoom_.current();
    if (range) {
        state.fixed[variable] = *range;
    } else {
        state.fixed.erase(variable);
    }
    zoom_.visit(std::move(state), Gesture::none);
}

bool TrackView::takeKey(QKeyEvent* event) {
    if (content_.variables.empty()) {
        return false;
    }
    const bool up = event->key() == Qt::Key_Up;
    const bool in = event->key() == Qt::Key_Plus || event->key() == Qt::Key_Equal;
    const auto focused = std::ranges::find_if(focus_, &PanelFocus::hasFocus);
    const SlowVariable variable =
        focused == focus_.end() ? content_.variables.front() : (*focused)->variable();
    if (up || event->key() == Qt::Key_Down) {
        changeValues(variable, 1, 0.5, up ? ZoomNavigator::arrow : -ZoomNavigator::arrow,
                     Gesture::key_value);
    } else if (event->modifiers() & Qt::ControlModifier && (in || event->key() == Qt::Key_Minus)) {
        changeValues(variable, in ? ZoomNavigator::notch : 1 / ZoomNavigator::notch, 0.5, 0,
                     Gesture::key_value);
    } else {
        return takeTimeKey(event);
    }
    return true;
}

}  // namespace vybeg::ui

#include "moc_track_view.cpp"
