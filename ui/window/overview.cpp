#include "ui/window/overview.h"

#include "ui/document/document.h"
#include "ui/panels/findings_flag.h"
#include "ui/plots/signal_view.h"
#include "ui/plots/track_view.h"
#include "ui/widgets/page_parts.h"

#include <QVBoxLayout>

namespace vybeg::ui {

namespace {

// Edits of the analysed range closer together than this are one drag, and one step of undo.
constexpr qint64 one_gesture_ms = 700;

}  // namespace

Overview::Overview(Document& document, TrackView& tracks, QWidget* parent)
    : QWidget(parent),
      document_(document),
      tracks_(tracks),
      signal_(new SignalView(this)),
      flag_(new FindingsFlag(document, this)) {
    fill(new QVBoxLayout(this), {}, {signal_});
    flag_->setGeometry(2, 4, 50, 26);
    connect(&document_, &Document::recordingsChanged, this, &Overview::showRecording);
    connect(&document_, &Document::recordingChanged, this, [this](RecordingId id) {
        if (document_.isCurrent(id)) {
            showRecording();
        }
    });
    connect(&document_, &Document::currentRecordingChanged, this, &Overview::showRecording);
    connect(&document_, &Document::envelopeGrown, this, &Overview::showEnvelope);
    connect(&document_, &Document::settingsChanged, this, &Overview::showAnalysedRange);
    connect(&document_, &Document::analysesChanged, this, &Overview::showVisibleRange);
    connect(signal_, &SignalView::visibleRangeEdited, this, [this](double from_s, double to_s) {
        tracks_.setTimeRange({from_s, to_s});
        // The plots show no more than their analyses cover, and say nothing where that is what they
        // have shown before.
        signal_->setVisibleRange(tracks_.timeRange());
    });
    connect(signal_, &SignalView::analysedRangeEdited, this, &Overview::editAnalysedRange);
    connect(&tracks_, &TrackView::timeRangeChanged, this, [this](double from_s, double to_s) {
        signal_->setVisibleRange({from_s, to_s});
        // Empty plots show nothing of the recording that is about to come.
        document_.setVisibleRange(document_.analyses().empty() ? TimeRange()
                                                               : TimeRange{from_s, to_s});
    });
    standOver(tracks_);
    showRecording();
}

void Overview::standOver(const TimeGestures& view) {
    connect(&view, &TimeGestures::timeAxisPlaced, this, [this, &view](int left, int right) {
        signal_->setMargins(left, right + signal_->width() - view.width());
        flag_->setFixedWidth(std::max(40, left - 8));
    });
}

void Overview::showRecording() {
    const RecordingEntry* entry = document_.currentRecording();
    if (entry && entry->recording) {
        signal_->setReading(entry->recording->seconds());
        tracks_.setRecorded({0, entry->recording->seconds()}, entry->recording->rate_hz);
        showEnvelope();
        signal_->setFaults(entry->faults);
        showVisibleRange();
        showAnalysedRange();
    } else if (entry && entry->envelope) {
        const double seconds =
            static_cast<double>(entry->envelope->frames()) / entry->envelope_rate_hz;
        signal_->setReading(seconds);
        tracks_.setRecorded({0, seconds}, entry->envelope_rate_hz);
        showEnvelope();
    } else {
        signal_->setReading(0);
        tracks_.setRecorded({}, 0);
    }
}

void Overview::showEnvelope() {
    const RecordingEntry* entry = document_.currentRecording();
    if (entry && entry->envelope) {
        signal_->setEnvelope(entry->envelope, entry->envelope_rate_hz);
    }
}

void Overview::showVisibleRange() {
    if (!document_.analyses().empty()) {
        signal_->setVisibleRange(tracks_.timeRange());
    }
}

void Overview::showAnalysedRange() {
    const RecordingEntry* entry = document_.currentRecording();
    if (entry && entry->recording) {
        const Settings& settings = document_.settings();
        signal_->setAnalysedRange(
            {settings.from_s.value_or(0), settings.to_s.value_or(entry->recording->seconds())});
    }
}

void Overview::analyseVisibleRange() {
    const AxisRange range = tracks_.timeRange();
    editAnalysedRange(range.lower, range.upper);
}

void Overview::editAnalysedRange(double from_s, double to_s) {
    const RecordingEntry* entry = document_.currentRecording();
    if (!entry || !entry->recording) {
        return;
    }
    if (!last_range_edit_.isValid() || last_range_edit_.elapsed() > one_gesture_ms) {
        ++range_gesture_;
    }
    last_range_edit_.start();
    Settings settings = document_.settings();
    settings.from_s = from_s > 0 ? std::optional(from_s) : std::nullopt;
    settings.to_s = to_s < entry->recording->seconds() ? std::optional(to_s) : std::nullopt;
    document_.setSettings(settings, range_gesture_);
}

}  // namespace vybeg::ui

#include "moc_overview.cpp"
