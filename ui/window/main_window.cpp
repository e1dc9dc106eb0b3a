#include "ui/window/main_window.h"

#include "ui/panels/cursor_panel.h"
#include "ui/panels/events_panel.h"
#include "ui/panels/message_bar.h"
#include "ui/panels/recording_panel.h"
#include "ui/panels/run_list.h"
#include "ui/panels/stale_mark.h"
#include "ui/plots/signal_view.h"
#include "ui/plots/track_view.h"
#include "ui/resonator/resonator_panel.h"
#include "ui/settings/settings_panel.h"
#include "ui/window/compare_dialog.h"
#include "ui/window/recent_files.h"
#include "ui/window/status_line.h"
#include "ui/window/welcome_page.h"
#include "ui/words/error_text.h"

#include <QDockWidget>
#include <QSettings>
#include <QStackedWidget>
#include <QStatusBar>
#include <QTabWidget>
#include <QVBoxLayout>

#include <algorithm>

namespace vybeg::ui {

namespace {

// Edits of the analysed range closer together than this are one drag, and one step of undo.
constexpr qint64 one_gesture_ms = 700;

}  // namespace

MainWindow::MainWindow(QWidget* parent) : QMainWindow(parent) {
    setObjectName(QStringLiteral("main_window"));
    setAcceptDrops(true);
    setDockOptions(AnimatedDocks | AllowTabbedDocks | AllowNestedDocks);
    setCorner(Qt::BottomLeftCorner, Qt::LeftDockWidgetArea);
    setCorner(Qt::BottomRightCorner, Qt::BottomDockWidgetArea);
    buildViews();
    buildDocks();
    status_ = new StatusLine(document_, this);
    statusBar()->addWidget(status_, 1);
    buildActions();
    buildMenus();
    buildToolBar();
    connectDocument();
    connectViews();
    restoreState();
    retranslate();
    showCurrentRecording();
    showRuns();
    tracks_->setFocus();
}

MainWindow::~MainWindow() {
    // The document's undo stack still tells of its emptying while it goes, when there is nothing
    // left to show.
    document_.undoStack().disconnect(this);
    document_.disconnect(this);
    // A field that lost the focus with the window would tell a document that is gone.
    if (QWidget* focused = focusWidget()) {
        focused->clearFocus();
    }
}

void MainWindow::buildViews() {
    pages_ = new QStackedWidget(this);
    welcome_ = new WelcomePage(pages_);
    auto* plots = new QWidget(pages_);
    signal_ = new SignalView(plots);
    stale_ = new StaleMark(document_, plots);
    tracks_ = new TrackView(plots);
    auto* layout = new QVBoxLayout(plots);
    layout->setContentsMargins(0, 0, 0, 0);
    layout->setSpacing(2);
    layout->addWidget(signal_);
    layout->addWidget(stale_);
    layout->addWidget(tracks_, 1);
    pages_->addWidget(welcome_);
    pages_->addWidget(plots);

    messages_ = new MessageBar(this);
    auto* center = new QWidget(this);
    auto* column = new QVBoxLayout(center);
    column->setContentsMargins(0, 0, 0, 0);
    column->setSpacing(2);
    column->addWidget(messages_);
    column->addWidget(pages_, 1);
    setCentralWidget(center);
}

void MainWindow::buildDocks() {
    recordings_ = new RecordingPanel(document_, this);
    settings_ = new SettingsPanel(document_, this);
    cursor_ = new CursorPanel(document_, this);
    resonator_ = new ResonatorPanel(document_, this);
    events_ = new EventsPanel(document_, this);
    runs_ = new RunList(document_, this);
    const auto dock = [this](QWidget* panel, const char* name, const char* title,
                             Qt::DockWidgetArea area) {
        auto* widget = new QDockWidget(this);
        widget->setObjectName(QLatin1String(name));
        widget->setWidget(panel);
        addDockWidget(area, widget);
        docks_[widget] = title;
        return widget;
    };
    auto* recordings =
        dock(recordings_, "recordings", QT_TR_NOOP("Recordings"), Qt::LeftDockWidgetArea);
    auto* settings = dock(settings_, "analysis", QT_TR_NOOP("Analysis"), Qt::LeftDockWidgetArea);
    readings_ = new QTabWidget(this);
    readings_->setDocumentMode(true);
    readings_->addTab(cursor_, QString());
    readings_->addTab(resonator_, QString());
    readings_->addTab(events_, QString());
    auto* readings =
        dock(readings_, "readings", QT_TR_NOOP("Values and events"), Qt::RightDockWidgetArea);
    // The tabs say what the title bar would say.
    readings->setTitleBarWidget(new QWidget(readings));
    auto* runs = dock(runs_, "runs", QT_TR_NOOP("Runs"), Qt::BottomDockWidgetArea);
    resizeDocks({recordings, settings}, {340, 420}, Qt::Vertical);
    resizeDocks({settings, readings}, {300, 330}, Qt::Horizontal);
    resizeDocks({runs}, {130}, Qt::Vertical);
}

void MainWindow::connectDocument() {
    connect(&document_, &Document::recordingsChanged, this, &MainWindow::showCurrentRecording);
    connect(&document_, &Document::recordingChanged, this, &MainWindow::showCurrentRecording);
    connect(&document_, &Document::envelopeGrown, this, &MainWindow::showEnvelope);
    connect(&document_, &Document::currentRecordingChanged, this,
            &MainWindow::showCurrentRecording);
    connect(&document_, &Document::settingsChanged, this, &MainWindow::showAnalysedRange);
    connect(&document_, &Document::runsChanged, this, &MainWindow::showRuns);
    connect(&document_, &Document::busyChanged, this, &MainWindow::showBusy);
    connect(&document_, &Document::opened, recent_, &RecentFiles::add);
    connect(&document_, &Document::liveChanged, this, [this] {
        action(Command::live)->setChecked(document_.live());
        QSettings().setValue(QStringLiteral("live"), document_.live());
        showRuns();
    });
    connect(&document_, &Document::settled, messages_, &MessageBar::withdraw);
    connect(&document_, &Document::comparisonReady, this, &MainWindow::showComparison);
    connect(&document_, &Document::reported, messages_, &MessageBar::add);
    connect(&document_, &Document::setsChanged, this, &MainWindow::refreshActions);
    connect(&document_, &Document::passportChanged, this, [this] {
        if (document_.passport()) {
            readings_->setCurrentWidget(resonator_);
            resonator_->showComparison();
        }
    });
}

void MainWindow::connectViews() {
    connect(welcome_, &WelcomePage::openWanted, this, &MainWindow::askForFiles);
    connect(messages_, &MessageBar::reopenWanted, this, &MainWindow::openImport);
    connect(recordings_, &RecordingPanel::placeChosen, this, &MainWindow::goToEvent);
    connect(recordings_, &RecordingPanel::reopenWanted, this, &MainWindow::openImport);
    connect(stale_, &StaleMark::runWanted, settings_, &SettingsPanel::run);
    connect(settings_, &SettingsPanel::visibleRangeWanted, this, [this] {
        const AxisRange range = tracks_->timeRange();
        editAnalysedRange(range.lower, range.upper);
    });
    connect(signal_, &SignalView::visibleRangeEdited, this, [this](double from_s, double to_s) {
        tracks_->setTimeRange({from_s, to_s});
        // The plots show no more than their runs cover, and say nothing where that is what they
        // have shown before.
        signal_->setVisibleRange(tracks_->timeRange());
    });
    connect(signal_, &SignalView::analysedRangeEdited, this, &MainWindow::editAnalysedRange);
    connect(tracks_, &TrackView::timeRangeChanged, this, [this](double from_s, double to_s) {
        signal_->setVisibleRange({from_s, to_s});
        // Empty plots show nothing of the recording that is about to come.
        document_.setVisibleRange(document_.runs().empty() ? TimeRange() : TimeRange{from_s, to_s});
    });
    connect(tracks_, &TrackView::timeAxisPlaced, signal_, &SignalView::setMargins);
    connect(tracks_, &TrackView::trackerMoved, this,
            [this](double time_s) { cursor_->setTime(time_s); });
    connect(tracks_, &TrackView::zoomHistoryChanged, this, &MainWindow::refreshActions);
    connect(runs_, &RunList::currentRunChanged, this, &MainWindow::showRun);
    connect(events_, &EventsPanel::eventChosen, this, &MainWindow::goToEvent);
    connect(resonator_, &ResonatorPanel::exportWanted, this, &MainWindow::exportResonatorPlot);
}

void MainWindow::showCurrentRecording() {
    const RecordingEntry* entry = document_.currentRecording();
    const bool any = !document_.recordings().empty();
    pages_->setCurrentIndex(any ? 1 : 0);
    QString title = QStringLiteral("Vybeg");
    if (entry && entry->recording) {
        const Recording& recording = *entry->recording;
        title = entry->name + QStringLiteral(" — ") + title;
        signal_->setReading(recording.seconds());
        showEnvelope();
        signal_->setFaults(entry->faults);
        if (!document_.runs().empty()) {
            signal_->setVisibleRange(tracks_->timeRange());
        }
        showAnalysedRange();
    } else if (entry && entry->envelope) {
        title = entry->name + QStringLiteral(" — ") + title;
        signal_->setReading(static_cast<double>(entry->envelope->frames()) /
                            entry->envelope_rate_hz);
        showEnvelope();
    } else {
        signal_->clear();
    }
    setWindowTitle(title);
    refreshActions();
}

void MainWindow::showEnvelope() {
    const RecordingEntry* entry = document_.currentRecording();
    if (entry && entry->envelope) {
        signal_->setEnvelope(entry->envelope, entry->envelope_rate_hz);
    }
}

void MainWindow::showAnalysedRange() {
    const RecordingEntry* entry = document_.currentRecording();
    if (entry && entry->recording) {
        const Settings& settings = document_.settings();
        signal_->setAnalysedRange(
            {settings.from_s.value_or(0), settings.to_s.value_or(entry->recording->seconds())});
    }
}

void MainWindow::showRuns() {
    tracks_->setRuns(document_.plottedRuns());
    if (!document_.runs().empty()) {
        signal_->setVisibleRange(tracks_->timeRange());
    }
    showRun(runs_->currentRun());
    refreshActions();
}

void MainWindow::showRun(int id) {
    events_->setRun(id);
    std::vector<double> crossings;
    const RunEntry* entry = document_.run(id);
    if (entry && entry->run.visible) {
        for (const Event& event : entry->events) {
            if (event.kind == EventKind::axis_crossing) {
                crossings.push_back(event.time_s);
            }
        }
    }
    tracks_->setMarks(std::move(crossings));
}

void MainWindow::showBusy() {
    if (compare_) {
        compare_->setBusy(document_.busy());
    }
    refreshActions();
}

void MainWindow::editAnalysedRange(double from_s, double to_s) {
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

void MainWindow::identify() {
    readings_->setCurrentWidget(resonator_);
    document_.identify();
}

void MainWindow::goToEvent(double time_s, double seconds) {
    // The present zoom, centred on the event, and wide enough to see it from both sides.
    const double span = std::max(tracks_->timeRange().span(), 3 * seconds);
    const double middle = time_s + seconds / 2;
    tracks_->setTimeRange({middle - span / 2, middle + span / 2});
    tracks_->setTracker(time_s);
    cursor_->setTime(time_s);
}

}  // namespace vybeg::ui
