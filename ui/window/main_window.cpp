#include "ui/window/main_window.h"

#include "ui/drift/drift_page.h"
#include "ui/history/history_page.h"
#include "ui/panels/cursor_times.h"
#include "ui/panels/file_list.h"
#include "ui/panels/findings_flag.h"
#include "ui/panels/ledger.h"
#include "ui/panels/message_bar.h"
#include "ui/panels/wave_panel.h"
#include "ui/plots/track_view.h"
#include "ui/residuals/residuals_page.h"
#include "ui/resonator/resonator_page.h"
#include "ui/resonator/set_panel.h"
#include "ui/session/session.h"
#include "ui/session/session_keeper.h"
#include "ui/settings/settings_panel.h"
#include "ui/signals/signals_page.h"
#include "ui/sweep/sweep_page.h"
#include "ui/widgets/number_field.h"
#include "ui/widgets/page_parts.h"
#include "ui/window/file_commands.h"
#include "ui/window/help.h"
#include "ui/window/overview.h"
#include "ui/window/status_line.h"
#include "ui/window/tracks_page.h"
#include "ui/window/window_menus.h"

#include <QAction>
#include <QApplication>
#include <QCloseEvent>
#include <QDropEvent>
#include <QFileInfo>
#include <QGridLayout>
#include <QHBoxLayout>
#include <QJsonDocument>
#include <QMenuBar>
#include <QMimeData>
#include <QScreen>
#include <QSettings>
#include <QStatusBar>
#include <QStringList>
#include <QTabBar>
#include <QToolBar>
#include <QVBoxLayout>

#include <algorithm>

namespace vybeg::ui {

namespace {

const QString theme_key = QStringLiteral("theme");
const QString live_key = QStringLiteral("live");
const QString language_key = QStringLiteral("language");
const QString view_key = QStringLiteral("window/view");
const QString geometry_key = QStringLiteral("window/geometry");
const QString sidebar_key = QStringLiteral("window/sidebar");

// Units and plots of the last window; degrees at the first start.
SessionView storedView() {
    const QByteArray stored = QSettings().value(view_key).toByteArray();
    if (stored.isEmpty()) {
        SessionView first;
        first.units.angle = AngleUnit::degrees;
        return first;
    }
    return viewFromJson(QJsonDocument::fromJson(stored).object());
}

// "session.vybeg — HRG-17 — run.wav — Vybeg", as far as there are these. `session`: its path.
QString titleOf(const Document& document, const QString& session) {
    const RecordingEntry* entry = document.currentRecording();
    QStringList parts;
    if (!session.isEmpty()) {
        parts << QFileInfo(session).fileName();
    }
    if (const QString& serial = document.dossier().dossier().gyro.serial; !serial.isEmpty()) {
        parts << serial;
    }
    if (entry && (entry->recording || entry->envelope)) {
        parts << entry->name;
    }
    parts << QStringLiteral("Vybeg");
    return parts.join(QStringLiteral(" — "));
}

QString linkTo(Page page) {
    return QStringLiteral("<a href=\"%1\">%2</a>").arg(pageWord(page), pageTitle(page));
}

// The open sets and logs, and the pages of their results; empty: none.
QString openedText(const Document& document) {
    QStringList opened;
    for (const RecordingSet& set : document.sets().all()) {
        if (hasContent(set)) {
            opened << MainWindow::tr("%1: page %2")
                          .arg(setName(document, set).toHtmlEscaped(), linkTo(Page::resonator));
        }
    }
    QStringList logs;
    for (const RecordingRef& log : document.drift().logs()) {
        logs << QString::fromStdString(log.name()).toHtmlEscaped();
    }
    if (!logs.isEmpty()) {
        opened << MainWindow::tr("whole-angle logs %1: page %2")
                      .arg(logs.join(QStringLiteral(", ")), linkTo(Page::drift));
    }
    if (!opened.isEmpty()) {
        opened.prepend(
            MainWindow::tr("No recording is open, and this page is about recordings. Open are:"));
    }
    return opened.join(QStringLiteral("<br>"));
}

}  // namespace

MainWindow::MainWindow(Document& document, QWidget* parent)
    : QMainWindow(parent), document_(document) {
    setObjectName(QStringLiteral("main_window"));
    setAcceptDrops(true);
    menu_bar_ = new QMenuBar(this);
    buildPages();
    layOut();
    session_ = new SessionKeeper(document_, *tracks_, this);
    files_ = new FileCommands(document_, *session_, *tracks_, *ledger_, this);
    batch_ = new BatchCommands(document_, this);
    status_ = new StatusLine(document_, this);
    times_ = new CursorTimes(this);
    statusBar()->addWidget(times_);
    statusBar()->addWidget(status_, 1);
    statusBar()->setSizeGripEnabled(false);
    messages_->floatOver(*this, [this] { return status_->progressWidth(); });
    connect(status_, &StatusLine::progressPlaced, messages_, &MessageBar::settle);
    connect(messages_, &MessageBar::cameOrWent, this, &MainWindow::showPanels);
    commands_ = new Commands(WindowCommands::of(*this), this);
    menus_ = new WindowMenus(
        *commands_, *tracks_, [this] { return static_cast<int>(theme_mode_); }, menu_bar_);
    action(Command::sigma_bands)->setChecked(tracks_->units().sigma_bands);
    action(Command::fitted_wave)->setChecked(true);
    action(Command::quit)->setMenuRole(QAction::QuitRole);
    action(Command::about)->setMenuRole(QAction::AboutRole);
    buildTopRow();
    connectDocument();
    connectSession();
    connectPanels();
    restoreState();
    keepTranslated(*this, [this] { retranslate(); });
    whenChanged(*this, {QEvent::Resize}, [this] { showPanels(); });
    whenChanged(*this, {QEvent::ThemeChange}, [this] {
        if (theme_mode_ == ThemeMode::system) {
            applyLook();
        }
    });
    showAnalyses();
    tracks_->setFocus();
}

void MainWindow::buildPages() {
    welcome_ = new WelcomePage(this);
    tracks_page_ = new TracksPage(document_, this);
    tracks_ = &tracks_page_->tracks();
    signals_ = new SignalsPage(document_, *tracks_, this);
    resonator_ = new ResonatorPage(document_, this);
    drift_ = new DriftPage(document_, this);
    history_ = new HistoryPage(document_, this);
    all_pages_ = {tracks_page_,
                  signals_,
                  new ResidualsPage(document_, *tracks_, this),
                  new SweepPage(document_, this),
                  resonator_,
                  drift_,
                  history_};
    pages_ = new PageStack(welcome_, this);
    std::ranges::for_each(all_pages_, [this](MeasuredPage* page) { pages_->add(page); });
    settings_ = new SettingsPanel(document_, this);
    overview_ = new Overview(document_, *tracks_, this);
    overview_->standOver(signals_->view());
    wave_ = new WavePanel(document_, this);
    ledger_ = new Ledger(document_, this);
    ledger_->setSetNames([this](const RecordingSet& set) { return setName(document_, set); });
    messages_ = new MessageBar(this);
}

// The settings at the left, the ledger below both: each page shows what acts on it.
void MainWindow::layOut() {
    wave_->setFixedWidth(260);
    settings_->setSizePolicy(QSizePolicy::Fixed, QSizePolicy::Preferred);
    auto* center = new QWidget(this);
    auto* grid = new QGridLayout(center);
    grid->setContentsMargins(0, 0, 0, 0);
    grid->setHorizontalSpacing(2);
    grid->setVerticalSpacing(0);
    grid->addWidget(settings_, 0, 0, 2, 1);
    grid->addWidget(overview_, 0, 1);
    grid->addWidget(pages_, 1, 1);
    grid->addWidget(wave_, 0, 2, 2, 1);
    grid->addWidget(ledger_, 2, 0, 1, 3);
    grid->setColumnStretch(1, 1);
    grid->setRowStretch(1, 1);
    setCentralWidget(center);
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
    menu_bar_->setSizePolicy(QSizePolicy::Fixed, QSizePolicy::Preferred);
    fill(new QHBoxLayout(row), {}, 0,
         {{menu_bar_, 0, Qt::AlignVCenter}, LayoutPart(1), pages_->tabs(), LayoutPart(1), tools_});
    setMenuWidget(row);
    wave_button_ = settings_->addTool(action(Command::wave));
    tracks_->setContextMenuPolicy(Qt::ActionsContextMenu);
    for (const Command command :
         {Command::zoom_fit, Command::zoom_back, Command::axis_limits, Command::log_a_A,
          Command::sigma_bands, Command::copy_plot, Command::export_plots}) {
        tracks_->addAction(action(command));
    }
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
        showAnalyses();
    });
    connect(&document_, &Document::settled, messages_, &MessageBar::withdraw);
    connect(&document_, &Document::reported, messages_, &MessageBar::add);
    connect(&document_.sets(), &SetStore::changed, this, &MainWindow::showCurrentRecording);
    connect(&document_.sets(), &SetStore::opened, this, [this](const QStringList& paths) {
        for (const QString& path : paths) {
            menus_->recentFiles()->add(path);
        }
        pages_->showPage(Page::resonator);
        resonator_->setFocus();  // no field, whose undo would hide that of the set
    });
    connect(&document_.drift(), &DriftStore::opened, this,
            [this] { pages_->showPage(Page::drift); });
    connect(&document_.drift(), &DriftStore::changed, this, &MainWindow::showCurrentRecording);
    connect(&tracks_page_->logTracks(), &LogTracks::changed, this,
            &MainWindow::showCurrentRecording);
    connect(&document_.passport(), &PassportStore::opened, this, [this] {
        pages_->showPage(Page::resonator);
        resonator_->showComparison();
    });
    connect(&document_.passport(), &PassportStore::wanted, files_, &FileCommands::askForPassport);
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
    connect(session_, &SessionKeeper::analysisWanted, ledger_, &Ledger::setCurrentAnalysis);
    session_->setViewSource([this](SessionView& view) {
        view.trend = ledger_->trendKind();
        view.page = pageWord(pages_->page());
    });
    connect(session_, &SessionKeeper::viewRestored, this, [this](const SessionView& view) {
        ledger_->setTrendKind(view.trend);
        if (const auto page = pageOfWord(view.page)) {
            pages_->showPage(*page);
        }
        ledger_->setVariables(tracks_->shownVariables());
        showCursors();
        showTitle();
    });
}

void MainWindow::connectPanels() {
    const auto open = [this](const QString& path) { files_->open({path}); };
    const auto show_resonator = [this] { pages_->showPage(Page::resonator); };
    connect(pages_, &PageStack::pageShown, commands_, &Commands::refresh);
    connect(pages_, &PageStack::pageShown, this, &MainWindow::showPanels);
    connect(welcome_, &WelcomePage::pageWanted, pages_, &PageStack::showPage);
    connect(welcome_, &WelcomePage::openWanted, action(Command::open), &QAction::trigger);
    connect(welcome_, &WelcomePage::recentChosen, this, open);
    connect(welcome_, &WelcomePage::demonstrationWanted, files_, &FileCommands::openDemonstration);
    connect(menus_->recentFiles(), &RecentFiles::chosen, this, open);
    connect(menus_, &WindowMenus::unitsChosen, this, &MainWindow::setUnits);
    connect(menus_, &WindowMenus::themeChosen, this,
            [this](int theme) { setThemeMode(static_cast<ThemeMode>(theme)); });
    connect(menus_, &WindowMenus::languageChosen, this, &MainWindow::setLanguage);
    connect(&overview_->flag(), &FindingsFlag::placeChosen, this,
            [this](double time_s, double seconds) {
                tracks_page_->goToEvent(time_s, seconds);
                ledger_->setMouse(time_s);
                wave_->setTime(time_s);
            });
    connect(settings_, &SettingsPanel::visibleRangeWanted, overview_,
            &Overview::analyseVisibleRange);
    connect(settings_, &SettingsPanel::wanted, this, [this] {
        sidebar_wanted_ = true;
        showPanels();
    });
    for (const MeasuredPage* page : all_pages_) {
        connect(page, &MeasuredPage::figuresChanged, commands_, &Commands::refresh);
        connect(page, &MeasuredPage::exportWanted, files_, &FileCommands::exportPlot);
    }
    connect(drift_, &DriftPage::exportResultWanted, files_, &FileCommands::askWhereToPutDrift);
    connect(drift_, &DriftPage::openWanted, files_, &FileCommands::askForWholeAngleLogs);
    connect(history_, &HistoryPage::exportAllWanted, files_, &FileCommands::exportHistory);
    connect(history_, &HistoryPage::databaseWanted, files_, &FileCommands::askForDatabase);
    connect(history_, &HistoryPage::setOpened, this, show_resonator);
    connect(batch_, &BatchCommands::helpWanted, this, &MainWindow::showHelp);
    connect(batch_, &BatchCommands::setOpened, this, show_resonator);
    connect(files_, &FileCommands::databaseChosen, this, [this](const QString& path, bool make) {
        pages_->showPage(Page::history);
        history_->openDatabase(path, make);
    });
    connect(tracks_, &TrackView::trackerMoved, this, [this](double time_s) {
        ledger_->setMouse(time_s);
        wave_->setTime(time_s);
    });
    connect(tracks_, &TrackView::cursorsChanged, this, &MainWindow::showCursors);
    connect(tracks_, &TrackView::variablesChanged, this,
            [this] { ledger_->setVariables(tracks_->shownVariables()); });
    connect(ledger_, &Ledger::trendsChanged, tracks_, &TrackView::setTrends);
    connect(times_, &CursorTimes::edited, this,
            [this](std::optional<double> a_s, std::optional<double> b_s) {
                tracks_->setCursor(Cursor::a, a_s);
                tracks_->setCursor(Cursor::b, b_s);
                showCursors();
            });
    connect(tracks_, &TrackView::timeRangeChanged, commands_, &Commands::refresh);
    connect(ledger_, &Ledger::currentAnalysisChanged, this, &MainWindow::showAnalysis);
    connect(wave_, &WavePanel::exportWanted, files_, &FileCommands::exportPlot);
}

void MainWindow::showCurrentRecording() {
    const bool recordings = !document_.recordings().empty();
    if (!recordings) {
        welcome_->setRecent(menus_->recentFiles()->paths());
        welcome_->setOpened(openedText(document_));
    }
    pages_->setOpen({recordings, std::ranges::any_of(document_.sets().all(), hasContent),
                     !document_.drift().logs().empty(),
                     !tracks_page_->logTracks().shown().empty()});
    showTitle();
    commands_->refresh();
}

// What the page needs, and the user has not put away. The wave has room in a wide window.
void MainWindow::showPanels() {
    constexpr int wide = 1600;
    const PageNeeds needs = pages_->needs();
    const bool wave = wave_wanted_.value_or(pages_->page() == Page::samples && width() >= wide);
    settings_->setVisible(needs.sidebar && sidebar_wanted_);
    overview_->setVisible(needs.overview);
    ledger_->setVisible(needs.ledger);
    times_->setVisible(needs.ledger && !document_.analyses().empty());
    wave_->setVisible(needs.wave && wave);
    wave_button_->setVisible(needs.wave && width() >= wide);
    // The row of the times is the ledger's, and that of the messages; other pages own the window.
    const bool row = needs.ledger || !messages_->isHidden();
    if (row == statusBar()->isHidden()) {
        statusBar()->setVisible(row);
        statusBar()->removeWidget(status_);
        status_->floatOver(row ? nullptr : centralWidget());
        if (row) {
            statusBar()->addWidget(status_, 1);
            status_->show();
        }
    }
    action(Command::sidebar)->setChecked(sidebar_wanted_);
    action(Command::wave)->setChecked(wave);
}

void MainWindow::showCursors() {
    ledger_->setCursors(tracks_->cursor(Cursor::a), tracks_->cursor(Cursor::b));
    showTimes();
    signals_->showCursors();
}

void MainWindow::showTimes() {
    const AnalysisEntry* chosen = document_.analysis(ledger_->currentAnalysis());
    times_->setTimes(tracks_->cursor(Cursor::a), tracks_->cursor(Cursor::b),
                     chosen ? chosen->shown.analysis.get() : nullptr);
}

void MainWindow::showTitle() {
    setWindowTitle(titleOf(document_, session_->path()));
}

void MainWindow::showAnalyses() {
    showAnalysis(ledger_->currentAnalysis());
    showPanels();
    commands_->refresh();
}

void MainWindow::showAnalysis(AnalysisId id) {
    session_->setCurrentAnalysis(id);
    overview_->flag().setAnalysis(id);
    showTimes();
    wave_->setAnalysis(id);
    std::ranges::for_each(all_pages_, [id](MeasuredPage* page) { page->setAnalysis(id); });
}

void MainWindow::setUnits(const DisplayUnits& units) {
    std::ranges::for_each(all_pages_, [&units](MeasuredPage* page) { page->setUnits(units); });
    ledger_->setUnits(units);
    batch_->setUnits(units);
    action(Command::sigma_bands)->setChecked(units.sigma_bands);
    action(Command::log_a_A)->setChecked(units.log_a_A);
}

FigureSource MainWindow::figures() const {
    return all_pages_.at(static_cast<std::size_t>(pages_->page()))->figures();
}

void MainWindow::dragEnterEvent(QDragEnterEvent* event) {
    if (!localFiles(*event->mimeData()).isEmpty()) {
        event->acceptProposedAction();
    }
}

void MainWindow::dropEvent(QDropEvent* event) {
    files_->openTogether(localFiles(*event->mimeData()));
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

void MainWindow::restoreState() {
    const QSettings settings;
    theme_mode_ = static_cast<ThemeMode>(settings.value(theme_key, 0).toInt());
    applyLook();
    document_.setLive(settings.value(live_key, true).toBool());
    setLanguage(settings.value(language_key, Language::ofTheSystem()).toString());
    const SessionView view = storedView();
    setUnits(view.units);
    if (!view.variables.empty()) {
        tracks_->setShownVariables(view.variables);
    }
    // No larger than the screen leaves room for, its own frame counted.
    resize(QSize(1400, 900).boundedTo(screen()->availableSize() - QSize(0, 40)));
    restoreGeometry(settings.value(geometry_key).toByteArray());
    sidebar_wanted_ = settings.value(sidebar_key, true).toBool();
    ledger_->setVariables(tracks_->shownVariables());
    showPanels();
}

void MainWindow::saveState() {
    QSettings settings;
    SessionView view;
    view.units = tracks_->units();
    view.variables = tracks_->shownVariables();
    settings.setValue(view_key, QJsonDocument(viewToJson(view)).toJson(QJsonDocument::Compact));
    settings.setValue(geometry_key, saveGeometry());
    settings.setValue(sidebar_key, sidebar_wanted_);
    settings.setValue(live_key, document_.live());
}

MainWindow::~MainWindow() {
    dropTyped(*this);
}

void MainWindow::closeEvent(QCloseEvent* event) {
    enterTyped(*this);
    if (!leaving_ && (session_->isSaving() || session_->isModified())) {
        event->ignore();
        files_->askToSaveAndThen([this] {
            leaving_ = true;
            close();
        });
        return;
    }
    saveState();
    session_->end();
    batch_->leave();
    document_.cancel();
    QMainWindow::closeEvent(event);
}

void MainWindow::setLanguage(const QString& code) {
    language_.use(code);
    QSettings().setValue(language_key, language_.code());
    if (help_) {
        help_->setLanguage(language_.code());
    }
}

void MainWindow::setThemeMode(ThemeMode mode) {
    theme_mode_ = mode;
    QSettings().setValue(theme_key, static_cast<int>(mode));
    applyLook();
}

void MainWindow::applyLook() {
    theme_ = applyTheme(*qApp, theme_mode_);
    commands_->setIcons(theme_.palette);
    statusBar()->setMinimumHeight(messages_->lineHeight());
}

void MainWindow::retranslate() {
    commands_->retranslate();
    menus_->retranslate();
    tools_->setAccessibleName(tr("Tools"));
    showCurrentRecording();  // names pages
}

}  // namespace vybeg::ui

#include "moc_main_window.cpp"
