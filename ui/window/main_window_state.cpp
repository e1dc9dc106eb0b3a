// What the window keeps between sessions, and what changes while it stands: look and language.
#include "ui/residuals/residuals_page.h"
#include "ui/resonator/resonator_panel.h"
#include "ui/window/help_view.h"
#include "ui/window/main_window.h"
#include "ui/window/tracks_page.h"
#include "ui/window/window_menus.h"

#include <QApplication>
#include <QCloseEvent>
#include <QSettings>

namespace vybeg::ui {

namespace {

// Raised when docks or tool bars change, so that an old state is not forced on a new window.
constexpr int state_version = 1;

const QString theme_key = QStringLiteral("theme");
const QString live_key = QStringLiteral("live");
const QString language_key = QStringLiteral("language");
const QString geometry_key = QStringLiteral("window/geometry");
const QString state_key = QStringLiteral("window/state");

}  // namespace

ThemeMode MainWindow::storedThemeMode() {
    return static_cast<ThemeMode>(QSettings().value(theme_key, 0).toInt());
}

void MainWindow::storeLive(bool live) {
    QSettings().setValue(live_key, live);
}

void MainWindow::restoreState() {
    const QSettings settings;
    theme_mode_ = storedThemeMode();
    applyLook();
    document_.setLive(settings.value(live_key, true).toBool());
    setLanguage(settings.value(language_key, Language::ofTheSystem()).toString());
    resize(1400, 900);
    restoreGeometry(settings.value(geometry_key).toByteArray());
    QMainWindow::restoreState(settings.value(state_key).toByteArray(), state_version);
}

void MainWindow::saveState() {
    QSettings settings;
    settings.setValue(geometry_key, saveGeometry());
    settings.setValue(state_key, QMainWindow::saveState(state_version));
}

void MainWindow::closeEvent(QCloseEvent* event) {
    saveState();
    document_.cancel();
    QMainWindow::closeEvent(event);
}

void MainWindow::changeEvent(QEvent* event) {
    QMainWindow::changeEvent(event);
    if (event->type() == QEvent::LanguageChange) {
        retranslate();
    } else if (event->type() == QEvent::ThemeChange && theme_mode_ == ThemeMode::system) {
        applyLook();
    }
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
    tracks_page_->setTheme(theme_);
    residuals_->setTheme(theme_);
    resonator_->setTheme(theme_);
    commands_->setIcons(theme_.palette);
}

}  // namespace vybeg::ui
