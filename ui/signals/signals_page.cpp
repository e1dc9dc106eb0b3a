#include "ui/signals/signals_page.h"

#include "ui/document/document.h"
#include "ui/widgets/page_parts.h"
#include "ui/words/display_units.h"
#include "ui/words/error_text.h"

#include <QLabel>
#include <QLayout>
#include <QPainter>
#include <QVBoxLayout>

#include <algorithm>
#include <cmath>

namespace vybeg::ui {

namespace {

constexpr int pause_ms = 15;
constexpr int job_key = 1;
// An excerpt reaches so many visible ranges beyond each end, and the next one is read when less
// than a part of that is left.
constexpr double reach = 1;
constexpr double least_reach = 0.3;

AxisRange beyond(const AxisRange& range, double spans) {
    return {range.lower - spans * range.span(), range.upper + spans * range.span()};
}

}  // namespace

SignalsView::SignalsView(TrackView& tracks, QWidget* parent)
    : TimeGestures(parent),
      tracks_(tracks),
      stack_(*new SignalStack(plot(), std::vector(all_signal_parts.begin(), all_signal_parts.end()),
                              PlotHead::margin)) {
    setPlots(&stack_, *new SignalOverlay(stack_, *this));
    layout()->setContentsMargins(1, 1, 1, 1);  // the frame of the keyboard focus
    setFocusPolicy(Qt::StrongFocus);
    whenChanged(*this, {QEvent::LanguageChange, QEvent::LocaleChange, QEvent::FontChange},
                [this] { setContent(content()); });
}

void SignalsView::setContent(SignalContent content) {
    content.time = tracks_.timeRange();
    plot().setBackground(QBrush(content.theme.plotBackground));
    stack_.setContent(std::move(content), plot().size());
    plot().replot(QCustomPlot::rpQueuedReplot);
}

void SignalsView::moveTracker(std::optional<double> time_s) {
    tracks_.moveTracker(time_s);
    refreshOverlay();
}

// The frame shows the keyboard focus.
void SignalsView::paintEvent(QPaintEvent* event) {
    QWidget::paintEvent(event);
    if (hasFocus()) {
        QPainter painter(this);
        painter.setPen(content().theme.accent);
        painter.drawRect(rect().adjusted(0, 0, -1, -1));
    }
}

SignalsPage::SignalsPage(Document& document, TrackView& tracks, QWidget* parent)
    : MeasuredPage(parent),
      document_(document),
      tracks_(tracks),
      state_(withName(new QLabel(this), "signalsState")),
      view_(new SignalsView(tracks, this)) {
    setObjectName(QStringLiteral("signals"));
    state_->setWordWrap(true);
    state_->setContentsMargins(6, 2, 6, 2);
    state_->setTextInteractionFlags(Qt::TextSelectableByMouse | Qt::TextSelectableByKeyboard);
    state_->setFocusPolicy(Qt::ClickFocus);
    fill(new QVBoxLayout(this), {}, 0, {state_, {view_, 1}});

    pause_.setSingleShot(true);
    pause_.setInterval(pause_ms);
    connect(&pause_, &QTimer::timeout, this, &SignalsPage::request);
    whenChanged(*this, {QEvent::Show}, [this] { refresh(); });
    whenChanged(*this, {QEvent::Hide}, [this] { stop(); });
    whenChanged(*view_, {QEvent::Resize}, [this] { refresh(); });
    connect(&tracks_, &TrackView::timeRangeChanged, this, &SignalsPage::refresh);
    connect(&tracks_, &TrackView::cursorsChanged, this, &SignalsPage::showCursors);
    connect(&document_, &Document::recordingsChanged, this, &SignalsPage::refresh);
    connect(&document_, &Document::recordingChanged, this, &SignalsPage::refresh);
    connect(&document_, &Document::currentRecordingChanged, this, &SignalsPage::refresh);
    connect(&document_, &Document::envelopeGrown, this, &SignalsPage::refresh);
    connect(&document_, &Document::analysesChanged, this, &SignalsPage::refresh);
    retranslate();
}

const AnalysisEntry* SignalsPage::fitted() const {
    const AnalysisEntry* chosen = document_.analysis(analysis_id_);
    const RecordingEntry* entry = document_.currentRecording();
    const bool whole = chosen && entry && chosen->recording_id == entry->id && !chosen->partial() &&
                       chosen->shown.analysis->track.rows() > 0;
    return whole ? chosen : nullptr;
}

void SignalsPage::setAnalysis(AnalysisId id) {
    analysis_id_ = id;
    refresh();
}

void SignalsPage::showCursors() {
    view_->refreshOverlay();
}

SignalContent SignalsPage::content() const {
    SignalContent content;
    const RecordingEntry* entry = document_.currentRecording();
    if (entry) {
        content.envelope = entry->envelope;
        content.rate_hz = entry->envelope_rate_hz;
    }
    if (entry && entry->recording) {
        content.rate_hz = entry->recording->rate_hz;
        content.frames = entry->recording->frames();
        content.unit = channelUnit(*entry->recording);
        content.excerpt = known_.excerpt;
        // With gaps for lost samples there are more.
        if (known_.source) {
            content.frames = known_.source->samples->frames();
        }
    }
    if (const AnalysisEntry* chosen = fitted()) {
        content.analysis = chosen->shown.analysis;
        content.calibration = chosen->shown.analysis->settings.calibration;
        content.rms = chosen->shown.curve(SlowVariable::rms);
    }
    content.wave = wave_;
    content.no_residual = tr("The residual is what an analysis leaves of the samples.");
    content.theme = theme();
    content.time = tracks_.timeRange();
    return content;
}

// Shows the samples that are there, and asks for those that are missing. Hidden, the page waits.
void SignalsPage::refresh() {
    const RecordingEntry* entry = document_.currentRecording();
    const auto samples = entry && entry->recording ? entry->recording->source : nullptr;
    if (!entry || entry->id != known_.recording || samples != known_.samples) {
        known_ = {entry ? entry->id : RecordingId::none, samples};
        job_.forget(job_key);
        reading_ = false;
    }
    if (!isVisible()) {
        return;
    }
    view_->setContent(content());
    showState();
    if (!pause_.isActive() && !reading_) {
        pause_.start();
    }
}

void SignalsPage::request() {
    const RecordingEntry* entry = document_.currentRecording();
    if (!isVisible() || !entry || !entry->recording || reading_) {
        return;
    }
    const Recording& recording = *entry->recording;
    const AxisRange time = tracks_.timeRange();
    if (!fewSamples(time, recording.rate_hz, view_->timeWidth())) {
        return;
    }
    const AnalysisEntry* chosen = fitted();
    const auto analysis = chosen ? chosen->shown.analysis : nullptr;
    const bool same = known_.source && known_.source->analysis == analysis;
    if (same &&
        (known_.failure || (known_.excerpt && covers(*known_.excerpt, beyond(time, least_reach),
                                                     known_.source->samples->frames())))) {
        return;
    }
    const AxisRange wanted = beyond(time, reach);
    const auto first = static_cast<std::int64_t>(std::floor(wanted.lower * recording.rate_hz));
    const auto end = static_cast<std::int64_t>(std::ceil(wanted.upper * recording.rate_hz)) + 1;
    const std::int64_t from = std::max<std::int64_t>(0, first);
    reading_ = true;
    job_.run<Excerpt>(
        job_key,
        [recording, analysis, known = same ? known_.source : std::nullopt, from,
         count = end - from](const JobControl& job) -> Result<Excerpt> {
            auto source =
                TRY(known ? Result<SignalSource>(*known) : signal_source(recording, analysis, job));
            auto excerpt = TRY(signal_excerpt(source, from, count, job));
            return Excerpt{std::move(source),
                           std::make_shared<const SignalExcerpt>(std::move(excerpt))};
        },
        [this](Result<Excerpt> result) { take(std::move(result)); });
}

void SignalsPage::take(Result<Excerpt> result) {
    reading_ = false;
    known_.failure.reset();
    if (result) {
        known_.source = std::move(result->source);
        known_.excerpt = std::move(result->samples);
    } else {
        known_.failure = result.error();
    }
    view_->setContent(content());
    showState();
    if (!known_.failure) {
        pause_.start();  // the range may have moved meanwhile
    }
}

void SignalsPage::setWave(bool shown) {
    wave_ = shown;
    refresh();
}

void SignalsPage::showState() {
    const QString text = stateText();
    state_->setText(text);
    state_->setVisible(!text.isEmpty());
}

// What the plots and the chosen row do not say.
QString SignalsPage::stateText() const {
    const RecordingEntry* entry = document_.currentRecording();
    if (!entry) {
        return tr("No recording is open.");
    }
    if (!entry->recording) {
        return tr("The recording %1 is being opened…").arg(entry->name);
    }
    if (known_.failure) {
        return errorText(*known_.failure);
    }
    const AnalysisEntry* chosen = document_.analysis(analysis_id_);
    if (!chosen) {
        return tr("%1, samples as recorded. Keep (F5) fits the wave.").arg(entry->name);
    }
    const QString name = QStringLiteral("%1, %2").arg(entry->name, chosen->shown.name);
    if (!fitted()) {
        return tr("%1: the wave appears when all windows of the analysis are there.").arg(name);
    }
    const Settings& settings = chosen->shown.analysis->settings;
    const bool changed =
        settings.filter || settings.repair_lost || settings.calibration.delay_d_s != 0;
    if (changed && !view_->picture().samples) {
        return tr("%1: minima and maxima before filter, delay and gaps for lost samples; zoom in "
                  "for the samples of the analysis.")
            .arg(name);
    }
    return {};
}

FigureSource SignalsPage::figures() const {
    FigureSource source;
    const SignalContent shown = view_->content();
    if (!shown.envelope && !shown.excerpt) {
        return source;
    }
    std::vector<SignalPart> parts{SignalPart::c, SignalPart::d};
    source.plots = {QStringLiteral("C"), QStringLiteral("D")};
    if (shown.analysis) {
        parts.push_back(SignalPart::residual);
        source.plots << tr("Residual");
    }
    source.figure = [shown, parts](const std::vector<int>& places) {
        return signalFigure(shown, atPlaces(parts, places));
    };
    const RecordingEntry* entry = document_.currentRecording();
    source.title = entry ? entry->name : QString();
    return source;
}

void SignalsPage::stop() {
    pause_.stop();
    job_.forget(job_key);
    reading_ = false;
}

void SignalsPage::retranslate() {
    view_->setAccessibleName(tr("Signals over time"));
    refresh();
}

}  // namespace vybeg::ui

#include "moc_signals_page.cpp"
