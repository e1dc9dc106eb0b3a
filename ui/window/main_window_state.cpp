// What the window keeps between sessions, and what changes while it stands: look and language.
#include "ui/drift/drift_page.h"
#include "ui/history/history_page.h"
#include "ui/panels/ledger.h"
#include "ui/panels/wave_panel.h"
#include "ui/plots/track_view.h"
#include "ui/residuals/residuals_page.h"
#include "ui/resonator/resonator_page.h"
#include "ui/session/session.h"
#include "ui/session/session_keeper.h"
#include "ui/signals/signals_page.h"
#include "ui/sweep/sweep_page.h"
#include "ui/widgets/number_field.h"
#include "ui/window/batch_commands.h"
#include "ui/window/file_commands.h"
#include "ui/window/help.h"
#include "ui/window/main_window.h"
#include "ui/window/overview.h"
#include "ui/window/tracks_page.h"
#include "ui/window/window_menus.h"

#include <QApplication>
#include <QCloseEvent>
#include <QJsonDocument>
#include <QScreen>
#include <QSettings>
#include <QToolBar>

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

}  // namespace

ThemeMode MainWindow::storedThemeMode() {
    return static_cast<ThemeMode>(QSettings().value(theme_key, 0).toInt());
}

void MainWindow::restoreState() {
    const QSettings settings;
    theme_mode_ = storedThemeMode();
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
    menus_->setLanguage(language_.code());
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
}

void MainWindow::retranslate() {
    commands_->retranslate();
    menus_->retranslate();
    tools_->setAccessibleName(tr("Tools"));
    showCurrentRecording();  // names pages
}

}  // namespace vybeg::ui
