#include "ui/window/main_window.h"

#include "ui/history/history_page.h"
#include "ui/panels/analysis_list.h"
#include "ui/panels/cursor_panel.h"
#include "ui/panels/events_panel.h"
#include "ui/panels/measure_panel.h"
#include "ui/panels/message_bar.h"
#include "ui/panels/recording_drag.h"
#include "ui/panels/recording_panel.h"
#include "ui/panels/wave_panel.h"
#include "ui/plots/track_view.h"
#include "ui/residuals/residuals_page.h"
#include "ui/resonator/resonator_page.h"
#include "ui/session/session_keeper.h"
#include "ui/settings/settings_panel.h"
#include "ui/signals/signals_page.h"
#include "ui/sweep/sweep_page.h"
#include "ui/window/about.h"
#include "ui/window/batch_commands.h"
#include "ui/window/file_commands.h"
#include "ui/window/help_view.h"
#include "ui/window/page_stack.h"
#include "ui/window/recent_files.h"
#include "ui/window/status_line.h"
#include "ui/window/tracks_page.h"
#include "ui/window/welcome_page.h"
#include "ui/window/window_commands.h"
#include "ui/window/window_menus.h"
#include "ui/window/window_title.h"

#include <QAction>
#include <QDockWidget>
#include <QDropEvent>
#include <QFileInfo>
#include <QHBoxLayout>
#include <QMenuBar>
#include <QMimeData>
#include <QSplitter>
#include <QStatusBar>
#include <QTabWidget>
#include <QToolBar>
#include <QVBoxLayout>

#include <algorithm>

namespace vybeg::ui {

MainWindow::MainWindow(Document& document, QWidget* parent)
    : QMainWindow(parent), document_(document) {
    setObjectName(QStringLiteral("main_window"));
    setAcceptDrops(true);
    menu_bar_ = new QMenuBar(this);
    setDockOptions(AnimatedDocks | AllowTabbedDocks | AllowNestedDocks);
    setCorner(Qt::BottomLeftCorner, Qt::LeftDockWidgetArea);
    setCorner(Qt::BottomRightCorner, Qt::BottomDockWidgetArea);
    buildPages();
    buildDocks();
    session_ = new SessionKeeper(document_, *tracks_, this);
    files_ = new FileCommands(document_, *session_, *tracks_, *analyses_, this);
    batch_ = new BatchCommands(document_, this);
    status_ = new StatusLine(document_, this);
    statusBar()->addWidget(status_, 1);
    commands_ = new Commands(
        windowCommands({document_, *tracks_, *cursor_, *measure_, *analyses_, *settings_, *status_,
                        *files_, *batch_, [this](const DisplayUnits& units) { setUnits(units); },
                        [this](Page page) { pages_->showPage(page); },
                        [this] { return pages_->page(); }, [this] { return figures(); },
                        [this] { showHelp(); },
                        [this] { showAbout(this, action(Command::copy_diagnostics)); },
                        [this] { return diagnosticsText(); }, [this] { close(); }}),
        this);
    menus_ = new WindowMenus(*commands_, *tracks_, panels_, static_cast<int>(storedThemeMode()),
                             menu_bar_);
    action(Command::sigma_bands)->setChecked(tracks_->units().sigma_bands);
    action(Command::quit)->setMenuRole(QAction::QuitRole);
    action(Command::about)->setMenuRole(QAction::AboutRole);
    buildTopRow();
    connectDocument();
    connectSession();
    connectPanels();
    restoreState();
    retranslate();
    showCurrentRecording();
    showAnalyses();
    tracks_->setFocus();
}

void MainWindow::buildPages() {
    welcome_ = new WelcomePage(this);
    tracks_page_ = new TracksPage(document_, this);
    tracks_ = &tracks_page_->tracks();
    signals_ = new SignalsPage(document_, *tracks_, this);
    resonator_ = new ResonatorPage(document_, this);
    residuals_ = new ResidualsPage(document_, this);
    sweep_ = new SweepPage(document_, this);
    history_ = new HistoryPage(document_, this);
    pages_ = new PageStack(welcome_, this);
    pages_->add(tracks_page_, QT_TRANSLATE_NOOP("Pages", "Tracks"));
    pages_->add(signals_, QT_TRANSLATE_NOOP("Pages", "Signals"));
    pages_->add(residuals_, QT_TRANSLATE_NOOP("Pages", "Residuals"));
    pages_->add(sweep_, QT_TRANSLATE_NOOP("Pages", "Windows"));
    pages_->add(resonator_, QT_TRANSLATE_NOOP("Pages", "Resonator"));
    pages_->add(history_, QT_TRANSLATE_NOOP("Pages", "History"));

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
    measure_ = new MeasurePanel(document_, this);
    wave_ = new WavePanel(document_, this);
    events_ = new EventsPanel(document_, this);
    analyses_ = new AnalysisList(document_, this);
    auto* recordings =
        panels_.add(recordings_, "recordings", QT_TR_NOOP("Recordings"), Qt::LeftDockWidgetArea,
                    {Page::tracks, Page::samples, Page::resonator, Page::residuals, Page::windows});
    auto* settings =
        panels_.add(settings_, "analysis", QT_TR_NOOP("Analysis"), Qt::LeftDockWidgetArea,
                    {Page::tracks, Page::samples, Page::residuals, Page::windows});
    readings_ = new QTabWidget(this);
    readings_->setDocumentMode(true);
    auto* at_cursor = new QSplitter(Qt::Vertical, readings_);
    at_cursor->addWidget(cursor_);
    at_cursor->addWidget(measure_);
    at_cursor->setStretchFactor(1, 1);
    at_cursor->setSizes({270, 430});
    readings_->addTab(at_cursor, QString());
    readings_->addTab(wave_, QString());
    readings_->addTab(events_, QString());
    auto* readings = panels_.add(readings_, "readings", QT_TR_NOOP("Values and events"),
                                 Qt::RightDockWidgetArea, {Page::tracks, Page::samples});
    // The tabs say what the title bar would say.
    readings->setTitleBarWidget(new QWidget(readings));
    auto* analyses =
        panels_.add(analyses_, "runs", QT_TR_NOOP("Analyses"), Qt::BottomDockWidgetArea,
                    {Page::tracks, Page::samples, Page::residuals});
    resizeDocks({recordings, settings}, {340, 420}, Qt::Vertical);
    resizeDocks({settings, readings}, {300, 390}, Qt::Horizontal);
    resizeDocks({analyses}, {130}, Qt::Vertical);
}

// Menus, pages and the commands of the mouse in one row: the plots have the height of the others.
void MainWindow::buildTopRow() {
    tools_ = new QToolBar;
    tools_->setToolButtonStyle(Qt::ToolButtonTextBesideIcon);
    tools_->setIconSize({16, 16});
    for (const Command command : {Command::open, Command::export_plots, Command::report}) {
        tools_->addAction(action(command));
    }
    auto* row = new QWidget(this);
    auto* line = new QHBoxLayout(row);
    line->setContentsMargins(0, 0, 0, 0);
    line->setSpacing(0);
    menu_bar_->setSizePolicy(QSizePolicy::Fixed, QSizePolicy::Preferred);
    line->addWidget(menu_bar_);
    line->addStretch(1);
    line->addWidget(pages_->tabs());
    line->addStretch(1);
    line->addWidget(tools_);
    setMenuWidget(row);
}

void MainWindow::connectDocument() {
    connect(&document_, &Document::recordingsChanged, this, &MainWindow::showCurrentRecording);
    connect(&document_, &Document::recordingChanged, this, [this](RecordingId id) {
        if (document_.isCurrent(id)) {
            showCurrentRecording();
        }
    });
    connect(&document_, &Document::currentRecordingChanged, this,
            &MainWindow::showCurrentRecording);
    connect(&document_, &Document::analysesChanged, this, &MainWindow::showAnalyses);
    connect(&document_, &Document::busyChanged, commands_, &Commands::refresh);
    connect(&document_, &Document::opened, menus_->recentFiles(), &RecentFiles::add);
    connect(&document_, &Document::liveChanged, this, [this] {
        action(Command::live)->setChecked(document_.live());
        storeLive(document_.live());
        showAnalyses();
    });
    connect(&document_, &Document::settled, messages_, &MessageBar::withdraw);
    connect(&document_, &Document::reported, messages_, &MessageBar::add);
    connect(&document_.sets(), &SetStore::changed, this, &MainWindow::showCurrentRecording);
    connect(&document_.sets(), &SetStore::listOpened, this, [this](const QString& path) {
        menus_->recentFiles()->add(path);
        pages_->showPage(Page::resonator);
    });
    connect(&document_.sets(), &SetStore::passportChanged, this, [this] {
        if (document_.sets().passport()) {
            pages_->showPage(Page::resonator);
            resonator_->showComparison();
        }
    });
    connect(&document_.dossier(), &DossierModel::changed, this, &MainWindow::showTitle);
    connect(&document_.undoStack(), &QUndoStack::indexChanged, commands_, &Commands::refresh);
}

void MainWindow::connectSession() {
    connect(session_, &SessionKeeper::pathChanged, this, [this] {
        showTitle();
        if (!session_->path().isEmpty()) {
            menus_->recentFiles()->add(session_->path());
        }
    });
    connect(session_, &SessionKeeper::unitsWanted, this, &MainWindow::setUnits);
    connect(session_, &SessionKeeper::analysisWanted, analyses_, &AnalysisList::setCurrentAnalysis);
    session_->setViewSource([this](SessionView& view) {
        view.trend = measure_->trendKind();
        view.page = pageWord(pages_->page());
    });
    connect(session_, &SessionKeeper::viewRestored, this, [this](const SessionView& view) {
        measure_->setTrendKind(view.trend);
        if (const auto page = pageOfWord(view.page)) {
            pages_->showPage(*page);
        }
        measure_->setCursors(tracks_->cursor(Cursor::a), tracks_->cursor(Cursor::b));
        signals_->showCursors();
        showTitle();
    });
}

void MainWindow::connectPanels() {
    connect(pages_, &PageStack::pageShown, commands_, &Commands::refresh);
    connect(pages_, &PageStack::pageShown, this, &MainWindow::showPanels);
    connect(welcome_, &WelcomePage::openWanted, action(Command::open), &QAction::trigger);
    connect(welcome_, &WelcomePage::recentChosen, this,
            [this](const QString& path) { files_->open({path}); });
    connect(welcome_, &WelcomePage::demonstrationWanted, files_, &FileCommands::openDemonstration);
    connect(messages_, &MessageBar::reopenWanted, files_, &FileCommands::openImport);
    connect(menus_, &WindowMenus::recentChosen, this,
            [this](const QString& path) { files_->open({path}); });
    connect(menus_, &WindowMenus::unitsChosen, this, &MainWindow::setUnits);
    connect(menus_, &WindowMenus::themeChosen, this,
            [this](int theme) { setThemeMode(static_cast<ThemeMode>(theme)); });
    connect(menus_, &WindowMenus::languageChosen, this, &MainWindow::setLanguage);
    connect(recordings_, &RecordingPanel::placeChosen, this, &MainWindow::goToEvent);
    connect(recordings_, &RecordingPanel::reopenWanted, files_, &FileCommands::openImport);
    connect(tracks_page_, &TracksPage::analyseWanted, settings_, &SettingsPanel::analyse);
    connect(settings_, &SettingsPanel::visibleRangeWanted, tracks_page_,
            &TracksPage::analyseVisibleRange);
    connect(signals_, &SignalsPage::analyseWanted, settings_, &SettingsPanel::analyse);
    connect(residuals_, &ResidualsPage::analyseWanted, settings_, &SettingsPanel::analyse);
    connect(residuals_, &ResidualsPage::figuresChanged, commands_, &Commands::refresh);
    connect(resonator_, &ResonatorPage::figuresChanged, commands_, &Commands::refresh);
    connect(sweep_, &SweepPage::figuresChanged, commands_, &Commands::refresh);
    connect(history_, &HistoryPage::figuresChanged, commands_, &Commands::refresh);
    connect(residuals_, &ResidualsPage::exportWanted, files_, &FileCommands::exportPlot);
    connect(sweep_, &SweepPage::exportWanted, files_, &FileCommands::exportPlot);
    connect(history_, &HistoryPage::exportWanted, files_, &FileCommands::exportPlot);
    connect(history_, &HistoryPage::exportAllWanted, files_, &FileCommands::exportHistory);
    connect(history_, &HistoryPage::openWanted, files_, &FileCommands::askForDatabase);
    connect(history_, &HistoryPage::newWanted, files_, &FileCommands::askForNewDatabase);
    connect(history_, &HistoryPage::setOpened, this, [this] { pages_->showPage(Page::resonator); });
    connect(batch_, &BatchCommands::helpWanted, this, &MainWindow::showHelp);
    connect(batch_, &BatchCommands::setOpened, this, [this] { pages_->showPage(Page::resonator); });
    connect(files_, &FileCommands::databaseChosen, this, [this](const QString& path, bool make) {
        pages_->showPage(Page::history);
        history_->openDatabase(path, make);
    });
    connect(tracks_, &TrackView::timeRangeChanged, this,
            [this] { residuals_->setVisibleRange(tracks_->timeRange()); });
    connect(tracks_, &TrackView::trackerMoved, this, [this](double time_s) {
        cursor_->setTime(time_s);
        wave_->setTime(time_s);
        residuals_->setCursor(tracks_->cursor(Cursor::a).value_or(time_s));
    });
    connect(tracks_, &TrackView::cursorsChanged, this, [this] {
        if (const auto a = tracks_->cursor(Cursor::a)) {
            residuals_->setCursor(*a);
        }
        measure_->setCursors(tracks_->cursor(Cursor::a), tracks_->cursor(Cursor::b));
    });
    connect(measure_, &MeasurePanel::trendsChanged, tracks_, &TrackView::setTrends);
    connect(measure_, &MeasurePanel::cursorsEdited, this,
            [this](std::optional<double> a_s, std::optional<double> b_s) {
                tracks_->setCursor(Cursor::a, a_s);
                tracks_->setCursor(Cursor::b, b_s);
                measure_->setCursors(a_s, b_s);
                signals_->showCursors();
            });
    connect(tracks_, &TrackView::zoomHistoryChanged, commands_, &Commands::refresh);
    connect(analyses_, &AnalysisList::currentAnalysisChanged, this, &MainWindow::showAnalysis);
    connect(events_, &EventsPanel::eventChosen, this, &MainWindow::goToEvent);
    connect(resonator_, &ResonatorPage::exportWanted, files_, &FileCommands::exportPlot);
    connect(wave_, &WavePanel::exportWanted, files_, &FileCommands::exportPlot);
}

void MainWindow::showCurrentRecording() {
    const auto has_result = [](const RecordingSet& set) { return !set.kept.json.isEmpty(); };
    const bool empty =
        document_.recordings().empty() && std::ranges::none_of(document_.sets().all(), has_result);
    if (empty) {
        welcome_->setRecent(menus_->recentFiles()->paths());
    }
    pages_->setWelcome(empty);
    showTitle();
    commands_->refresh();
}

// The welcome has the window for itself.
void MainWindow::showPanels() {
    panels_.showThoseOf(pages_->welcomes() ? std::nullopt : std::optional(pages_->page()));
}

void MainWindow::showTitle() {
    setWindowTitle(titleOf(document_, session_->path()));
}

void MainWindow::showAnalyses() {
    showAnalysis(analyses_->currentAnalysis());
    commands_->refresh();
}

void MainWindow::showAnalysis(AnalysisId id) {
    session_->setCurrentAnalysis(id);
    events_->setAnalysis(id);
    measure_->setAnalysis(id);
    wave_->setAnalysis(id);
    tracks_page_->chooseAnalysis(id);
    signals_->setAnalysis(id);
    residuals_->setVisibleRange(tracks_->timeRange());
    residuals_->setAnalysis(id);
}

void MainWindow::goToEvent(double time_s, double seconds) {
    tracks_page_->goToEvent(time_s, seconds);
    cursor_->setTime(time_s);
    wave_->setTime(time_s);
}

void MainWindow::setUnits(const DisplayUnits& units) {
    tracks_->setUnits(units);
    cursor_->setUnits(units);
    measure_->setUnits(units);
    resonator_->setUnits(units);
    sweep_->setUnits(units);
    history_->setUnits(units);
    batch_->setUnits(units);
    action(Command::sigma_bands)->setChecked(units.sigma_bands);
    action(Command::log_a_A)->setChecked(units.log_a_A);
}

FigureSource MainWindow::figures() const {
    switch (pages_->page()) {
        case Page::tracks: return tracks_page_->figures();
        case Page::samples: return signals_->figures();
        case Page::resonator: return resonator_->figures();
        case Page::residuals: return residuals_->figures();
        case Page::windows: return sweep_->figures();
        case Page::history: return history_->figures();
    }
    return {};
}

void MainWindow::dragEnterEvent(QDragEnterEvent* event) {
    if (!localFiles(*event->mimeData()).isEmpty()) {
        event->acceptProposedAction();
    }
}

void MainWindow::dropEvent(QDropEvent* event) {
    files_->open(localFiles(*event->mimeData()));
    event->acceptProposedAction();
}

void MainWindow::showHelp() {
    if (!help_) {
        help_ = new HelpView(language_.code(), this);
    }
    help_->show();
    help_->raise();
    help_->activateWindow();
}

QString MainWindow::diagnosticsText() const {
    return diagnosticsOf(document_, language_.code(), theme_.dark, devicePixelRatioF());
}

}  // namespace vybeg::ui
