// What the window keeps between sessions, and what changes while it stands: look and language.
#include "ui/plots/signal_view.h"
#include "ui/plots/track_view.h"
#include "ui/resonator/resonator_panel.h"
#include "ui/widgets/icons.h"
#include "ui/window/help_view.h"
#include "ui/window/main_window.h"

#include <QAction>
#include <QActionGroup>
#include <QApplication>
#include <QCloseEvent>
#include <QSettings>

namespace vybeg::ui {

namespace {

// Raised when docks or tool bars change, so that an old state is not forced on a new window.
constexpr int state_version = 1;

const char* iconName(Command command) {
    switch (command) {
        case Command::open: return "open";
        case Command::export_plots: return "export";
        case Command::undo: return "undo";
        case Command::redo: return "redo";
        case Command::copy_plot: return "copy";
        case Command::zoom_fit: return "zoom-fit";
        case Command::zoom_back: return "zoom-back";
        case Command::run: return "run";
        case Command::cancel: return "cancel";
        case Command::compare: return "compare";
        case Command::help: return "help";
        default: return nullptr;
    }
}

}  // namespace

void MainWindow::restoreState() {
    const QSettings settings;
    theme_mode_ = static_cast<ThemeMode>(settings.value(QStringLiteral("theme"), 0).toInt());
    applyLook();
    document_.setLive(settings.value(QStringLiteral("live"), true).toBool());
    setLanguage(settings.value(QStringLiteral("language"), Language::ofTheSystem()).toString());
    resize(1400, 900);
    restoreGeometry(settings.value(QStringLiteral("window/geometry")).toByteArray());
    QMainWindow::restoreState(settings.value(QStringLiteral("window/state")).toByteArray(),
                              state_version);
}

void MainWindow::saveState() {
    QSettings settings;
    settings.setValue(QStringLiteral("window/geometry"), saveGeometry());
    settings.setValue(QStringLiteral("window/state"), QMainWindow::saveState(state_version));
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
    QSettings().setValue(QStringLiteral("language"), language_.code());
    for (QAction* action : languages_->actions()) {
        action->setChecked(action->data().toString() == language_.code());
    }
    if (help_) {
        help_->setLanguage(language_.code());
    }
}

void MainWindow::setThemeMode(ThemeMode mode) {
    theme_mode_ = mode;
    QSettings().setValue(QStringLiteral("theme"), static_cast<int>(mode));
    applyLook();
}

void MainWindow::applyLook() {
    theme_ = applyTheme(*qApp, theme_mode_);
    signal_->setTheme(theme_);
    tracks_->setTheme(theme_);
    resonator_->setTheme(theme_);
    for (std::size_t i = 0; i < actions_.size(); ++i) {
        if (const char* name = iconName(static_cast<Command>(i))) {
            actions_[i]->setIcon(themedIcon(QLatin1String(name), theme_.palette));
        }
    }
}

}  // namespace vybeg::ui
