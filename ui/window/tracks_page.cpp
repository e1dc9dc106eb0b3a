#include "ui/window/tracks_page.h"

#include "ui/document/document.h"
#include "ui/panels/stale_mark.h"
#include "ui/plots/plot_export.h"
#include "ui/plots/signal_view.h"
#include "ui/plots/track_view.h"
#include "ui/words/algorithm_text.h"
#include "ui/words/index_text.h"

#include <QEvent>
#include <QLocale>
#include <QScrollArea>
#include <QVBoxLayout>

#include <algorithm>

namespace vybeg::ui {

namespace {

// Edits of the analysed range closer together than this are one drag, and one step of undo.
constexpr qint64 one_gesture_ms = 700;

// "2θ_A" as "2θA", for texts without indices.
QString settingsText(const AnalysisEntry& entry) {
    const Analysis& analysis = *entry.shown.analysis;
    QString text = TracksPage::tr("%1: %2; window %3, hop %4 samples; f0 = %5 Hz")
                       .arg(entry.shown.recording, algorithmText(analysis.settings.algorithm))
                       .arg(analysis.plan.length)
                       .arg(analysis.plan.hop)
                       .arg(QLocale().toString(analysis.f0_hz(), 'f', 3));
    if (const auto& band = analysis.settings.filter) {
        text += TracksPage::tr("; filter %1 to %2 Hz")
                    .arg(QLocale().toString(band->low_hz), QLocale().toString(band->high_hz));
    }
    return text;
}

}  // namespace

TracksPage::TracksPage(Document& document, QWidget* parent)
    : QWidget(parent),
      document_(document),
      signal_(new SignalView(this)),
      stale_(new StaleMark(document, this)),
      tracks_(new TrackView(this)),
      scroll_(new QScrollArea(this)) {
    scroll_->setWidget(tracks_);
    scroll_->setWidgetResizable(true);
    scroll_->setFrameShape(QFrame::NoFrame);
    scroll_->setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
    scroll_->setFocusPolicy(Qt::NoFocus);
    auto* layout = new QVBoxLayout(this);
    layout->setContentsMargins(0, 0, 0, 0);
    layout->setSpacing(2);
    layout->addWidget(signal_);
    layout->addWidget(stale_);
    layout->addWidget(scroll_, 1);

    connect(&document_, &Document::recordingsChanged, this, &TracksPage::showRecording);
    connect(&document_, &Document::recordingChanged, this, [this](RecordingId id) {
        if (document_.isCurrent(id)) {
            showRecording();
        }
    });
    connect(&document_, &Document::currentRecordingChanged, this, &TracksPage::showRecording);
    connect(&document_, &Document::envelopeGrown, this, &TracksPage::showEnvelope);
    connect(&document_, &Document::settingsChanged, this, &TracksPage::showAnalysedRange);
    connect(&document_, &Document::analysesChanged, this, &TracksPage::showAnalyses);
    connect(&document_, &Document::liveChanged, this, &TracksPage::showAnalyses);
    connect(stale_, &StaleMark::analyseWanted, this, &TracksPage::analyseWanted);
    connect(signal_, &SignalView::visibleRangeEdited, this, [this](double from_s, double to_s) {
        tracks_->setTimeRange({from_s, to_s});
        // The plots show no more than their analyses cover, and say nothing where that is what they
        // have shown before.
        signal_->setVisibleRange(tracks_->timeRange());
    });
    connect(signal_, &SignalView::analysedRangeEdited, this, &TracksPage::editAnalysedRange);
    connect(tracks_, &TrackView::timeRangeChanged, this, [this](double from_s, double to_s) {
        signal_->setVisibleRange({from_s, to_s});
        // Empty plots show nothing of the recording that is about to come.
        document_.setVisibleRange(document_.analyses().empty() ? TimeRange()
                                                               : TimeRange{from_s, to_s});
    });
    connect(tracks_, &TrackView::timeAxisPlaced, this, [this](int left, int right) {
        signal_->setMargins(left, right + scroll_->width() - tracks_->width());
    });
    retranslate();
    showRecording();
    showAnalyses();
}

void TracksPage::showRecording() {
    const RecordingEntry* entry = document_.currentRecording();
    if (entry && entry->recording) {
        signal_->setReading(entry->recording->seconds());
        tracks_->setRecorded({{0, entry->recording->seconds()}, entry->recording->rate_hz});
        showEnvelope();
        signal_->setFaults(entry->faults);
        if (!document_.analyses().empty()) {
            signal_->setVisibleRange(tracks_->timeRange());
        }
        showAnalysedRange();
    } else if (entry && entry->envelope) {
        const double seconds =
            static_cast<double>(entry->envelope->frames()) / entry->envelope_rate_hz;
        signal_->setReading(seconds);
        tracks_->setRecorded({{0, seconds}, entry->envelope_rate_hz});
        showEnvelope();
    } else {
        signal_->clear();
        tracks_->setRecorded({});
    }
}

void TracksPage::showEnvelope() {
    const RecordingEntry* entry = document_.currentRecording();
    if (entry && entry->envelope) {
        signal_->setEnvelope(entry->envelope, entry->envelope_rate_hz);
    }
}

void TracksPage::showAnalysedRange() {
    const RecordingEntry* entry = document_.currentRecording();
    if (entry && entry->recording) {
        const Settings& settings = document_.settings();
        signal_->setAnalysedRange(
            {settings.from_s.value_or(0), settings.to_s.value_or(entry->recording->seconds())});
    }
}

void TracksPage::showAnalyses() {
    std::vector<ShownAnalysis> analyses = document_.plottedAnalyses();
    const int unlike = drawnWith(chosen_, analyses);
    tracks_->setAnalyses(std::move(analyses), unlike);
    if (!document_.analyses().empty()) {
        signal_->setVisibleRange(tracks_->timeRange());
    }
}

void TracksPage::chooseAnalysis(AnalysisId id) {
    if (id != chosen_) {
        chosen_ = id;
        showAnalyses();
    }
    std::vector<double> crossings;
    const AnalysisEntry* entry = document_.analysis(id);
    if (entry && entry->shown.visible) {
        for (const Event& event : entry->events) {
            if (event.kind == EventKind::axis_crossing) {
                crossings.push_back(event.time_s);
            }
        }
    }
    tracks_->setMarks(std::move(crossings));
}

void TracksPage::goToEvent(double time_s, double seconds) {
    const double span = std::max(tracks_->timeRange().span(), 3 * seconds);
    const double middle = time_s + seconds / 2;
    tracks_->setTimeRange({middle - span / 2, middle + span / 2});
    tracks_->setTracker(time_s);
}

void TracksPage::analyseVisibleRange() {
    const AxisRange range = tracks_->timeRange();
    editAnalysedRange(range.lower, range.upper);
}

void TracksPage::editAnalysedRange(double from_s, double to_s) {
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

FigureSource TracksPage::figures() const {
    PlotContent content = tracks_->content();
    content.unlike = 0;  // no note about what the window does
    FigureSource source;
    QStringList recordings;
    QStringList settings;
    for (const AnalysisEntry& entry : document_.analyses()) {
        const auto drawn = std::ranges::find(content.analyses, entry.shown.id, &ShownAnalysis::id);
        if (drawn != content.analyses.end() && drawn->visible) {
            recordings << entry.shown.recording;
            settings << settingsText(entry);
        }
    }
    recordings.removeDuplicates();
    if (settings.isEmpty()) {
        return source;
    }
    for (const SlowVariable variable : content.variables) {
        source.plots << indexPlain(displaySymbol(variable, content.units));
    }
    source.figure = [content](const std::vector<int>& places) {
        PlotContent some = content;
        some.variables.clear();
        for (const int place : places) {
            some.variables.push_back(content.variables[static_cast<std::size_t>(place)]);
        }
        return Figure{plotsDrawing(some), paperSize(some), QStringLiteral("vybeg")};
    };
    source.title = recordings.join(QStringLiteral(", "));
    source.settings = settings.join(QStringLiteral("; "));
    return source;
}

void TracksPage::setTheme(const Theme& theme) {
    signal_->setTheme(theme);
    tracks_->setTheme(theme);
}

void TracksPage::changeEvent(QEvent* event) {
    QWidget::changeEvent(event);
    if (event->type() == QEvent::LanguageChange) {
        retranslate();
    }
}

void TracksPage::retranslate() {
    signal_->setAccessibleName(tr("Overview of the recording"));
}

}  // namespace vybeg::ui
