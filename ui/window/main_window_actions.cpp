// Menus, tool bar, shortcuts and their texts.
#include "ui/panels/cursor_panel.h"
#include "ui/panels/run_list.h"
#include "ui/plots/plot_export.h"
#include "ui/plots/signal_view.h"
#include "ui/plots/track_view.h"
#include "ui/resonator/resonator_panel.h"
#include "ui/settings/settings_panel.h"
#include "ui/window/command_texts.h"
#include "ui/window/compare_dialog.h"
#include "ui/window/main_window.h"
#include "ui/window/recent_files.h"
#include "ui/window/status_line.h"

#include <QAbstractButton>
#include <QActionGroup>
#include <QApplication>
#include <QClipboard>
#include <QDockWidget>
#include <QMenuBar>
#include <QSettings>
#include <QToolBar>

namespace vybeg::ui {

void MainWindow::buildActions() {
    for (std::size_t i = 0; i < actions_.size(); ++i) {
        actions_[i] = new QAction(this);
        actions_[i]->setShortcuts(shortcutsOf(static_cast<Command>(i)));
    }
    const auto on = [this](Command command, auto&& act) {
        connect(action(command), &QAction::triggered, this, std::forward<decltype(act)>(act));
    };
    on(Command::open, [this] { askForFiles(); });
    on(Command::import_file, [this] { askForImport(); });
    on(Command::close_recording,
       [this] { document_.closeRecording(document_.currentRecording()->id); });
    on(Command::export_plots, [this] {
        askWhereTo(tr("Export plots"), QStringLiteral("vybeg.png"),
                   {tr("PNG image (*.png)"), tr("SVG drawing (*.svg)"), tr("PDF document (*.pdf)")},
                   [this](const QString& path) { exportPlotsTo(path); });
    });
    on(Command::export_track, [this] {
        askWhereTo(tr("Export track"), QStringLiteral("track.csv"), {tr("Track (*.csv)")},
                   [this](const QString& path) { exportTrackTo(path); });
    });
    on(Command::save_passport, [this] {
        askWhereTo(tr("Save passport"), QStringLiteral("passport.json"), {tr("Passport (*.json)")},
                   [this](const QString& path) { savePassportTo(path); });
    });
    on(Command::compare_passport, [this] { askForPassport(); });
    on(Command::quit, [this] { close(); });
    on(Command::undo, [this] { document_.undoStack().undo(); });
    on(Command::redo, [this] { document_.undoStack().redo(); });
    on(Command::copy_plot, [this] {
        const PlotContent content = tracks_->content();
        copyPlots(content, paperSize(content));
    });
    on(Command::copy_table, [this] { QApplication::clipboard()->setText(cursor_->tableText()); });
    on(Command::zoom_in, [this] { tracks_->zoomIn(); });
    on(Command::zoom_out, [this] { tracks_->zoomOut(); });
    on(Command::zoom_fit, [this] { tracks_->fit(); });
    on(Command::zoom_back, [this] { tracks_->zoomBack(); });
    on(Command::zoom_forward, [this] { tracks_->zoomForward(); });
    on(Command::run, [this] { settings_->run(); });
    on(Command::live, [this](bool on_now) { document_.setLive(on_now); });
    on(Command::cancel, [this] { status_->cancel(); });
    on(Command::compare, [this] { openCompare(); });
    on(Command::identify, [this] { identify(); });
    on(Command::new_set, [this] {
        document_.addSet();
        readings_->setCurrentWidget(resonator_);
    });
    on(Command::help, [this] { showHelp(); });
    on(Command::copy_diagnostics,
       [this] { QApplication::clipboard()->setText(diagnosticsText()); });
    on(Command::about, [this] { showAbout(); });
    action(Command::quit)->setMenuRole(QAction::QuitRole);
    action(Command::about)->setMenuRole(QAction::AboutRole);
    connect(&document_.undoStack(), &QUndoStack::indexChanged, this, &MainWindow::refreshActions);

    for (const Command command : {Command::sigma_bands, Command::log_a_A, Command::live}) {
        action(command)->setCheckable(true);
    }
    action(Command::sigma_bands)->setChecked(tracks_->units().sigma_bands);
    on(Command::sigma_bands, [this](bool on_now) {
        changeUnits([on_now](DisplayUnits& units) { units.sigma_bands = on_now; });
    });
    on(Command::log_a_A, [this](bool on_now) {
        changeUnits([on_now](DisplayUnits& units) { units.log_a_A = on_now; });
    });
}

void MainWindow::changeUnits(const std::function<void(DisplayUnits&)>& change) {
    DisplayUnits units = tracks_->units();
    change(units);
    tracks_->setUnits(units);
    cursor_->setUnits(units);
    resonator_->setUnits(units);
}

QMenu* MainWindow::choiceMenu(QMenu* parent, const std::vector<const char*>& texts, int chosen,
                              const std::function<void(int)>& choose) {
    QMenu* menu = parent->addMenu(QString());
    auto* group = new QActionGroup(menu);
    for (std::size_t i = 0; i < texts.size(); ++i) {
        QAction* entry = menu->addAction(QString());
        entry->setCheckable(true);
        entry->setChecked(static_cast<int>(i) == chosen);
        group->addAction(entry);
        choices_.push_back({entry, texts[i]});
        connect(entry, &QAction::triggered, this, [choose, i] { choose(static_cast<int>(i)); });
    }
    return menu;
}

void MainWindow::buildMenus() {
    const auto top = [this](const char* title) {
        QMenu* menu = menuBar()->addMenu(QString());
        menu->setToolTipsVisible(true);
        menus_[menu] = title;
        return menu;
    };
    const auto add = [this](QMenu* menu, std::initializer_list<Command> commands) {
        for (const Command command : commands) {
            menu->addAction(action(command));
        }
    };
    QMenu* file = top(QT_TR_NOOP("&File"));
    add(file, {Command::open});
    recent_ = new RecentFiles(this);
    menus_[recent_] = QT_TR_NOOP("Open &recent");
    file->addMenu(recent_);
    connect(recent_, &RecentFiles::chosen, this,
            [this](const QString& path) { document_.open({path}); });
    add(file, {Command::import_file, Command::close_recording});
    file->addSeparator();
    add(file, {Command::export_plots, Command::export_track});
    file->addSeparator();
    add(file, {Command::save_passport, Command::compare_passport});
    file->addSeparator();
    add(file, {Command::quit});

    QMenu* edit = top(QT_TR_NOOP("&Edit"));
    add(edit, {Command::undo, Command::redo});
    edit->addSeparator();
    add(edit, {Command::copy_plot, Command::copy_table});

    QMenu* view = top(QT_TR_NOOP("&View"));
    add(view, {Command::zoom_in, Command::zoom_out, Command::zoom_fit, Command::zoom_back,
               Command::zoom_forward});
    view->addSeparator();
    QMenu* variables = view->addMenu(QString());
    menus_[variables] = QT_TR_NOOP("&Plots");
    for (const SlowVariable variable : shown_slow_variables) {
        QAction* shown = variables->addAction(QString());
        shown->setCheckable(true);
        shown->setData(static_cast<int>(variable));
        const auto& now = tracks_->shownVariables();
        shown->setChecked(std::ranges::find(now, variable) != now.end());
        choices_.push_back({shown, nullptr});
        connect(shown, &QAction::triggered, this, [this, variables] {
            std::vector<SlowVariable> wanted;
            for (const QAction* each : variables->actions()) {
                if (each->isChecked()) {
                    wanted.push_back(static_cast<SlowVariable>(each->data().toInt()));
                }
            }
            tracks_->setShownVariables(std::move(wanted));
        });
    }
    menus_[choiceMenu(view,
                      {QT_TR_NOOP("Hz"), QT_TR_NOOP("rad/s"), QT_TR_NOOP("Deviation from f₀, Hz"),
                       QT_TR_NOOP("Deviation from f₀, ppm")},
                      static_cast<int>(tracks_->units().frequency), [this](int unit) {
                          changeUnits([unit](DisplayUnits& units) {
                              units.frequency = static_cast<FrequencyUnit>(unit);
                          });
                      })] = QT_TR_NOOP("Fre&quency in");
    menus_[choiceMenu(view, {QT_TR_NOOP("Radians"), QT_TR_NOOP("Degrees")},
                      static_cast<int>(tracks_->units().angle), [this](int unit) {
                          changeUnits([unit](DisplayUnits& units) {
                              units.angle = static_cast<AngleUnit>(unit);
                          });
                      })] = QT_TR_NOOP("&Angles in");
    menus_[choiceMenu(
        view, {QT_TR_NOOP("Recording units"), QT_TR_NOOP("Decibels")},
        tracks_->units().amplitude == AmplitudeUnit::decibels ? 1 : 0, [this](int unit) {
            changeUnits([unit](DisplayUnits& units) {
                units.amplitude = unit == 1 ? AmplitudeUnit::decibels : AmplitudeUnit::recording;
            });
        })] = QT_TR_NOOP("A&mplitudes in");
    add(view, {Command::log_a_A, Command::sigma_bands});
    view->addSeparator();
    QMenu* panels = view->addMenu(QString());
    menus_[panels] = QT_TR_NOOP("Pa&nels");
    for (const auto& [dock, title] : docks_) {
        panels->addAction(dock->toggleViewAction());
    }
    menus_[choiceMenu(view, {QT_TR_NOOP("As the system"), QT_TR_NOOP("Light"), QT_TR_NOOP("Dark")},
                      QSettings().value(QStringLiteral("theme"), 0).toInt(), [this](int mode) {
                          setThemeMode(static_cast<ThemeMode>(mode));
                      })] = QT_TR_NOOP("&Theme");
    QMenu* language = view->addMenu(QString());
    menus_[language] = QT_TR_NOOP("Lan&guage");
    languages_ = new QActionGroup(this);
    for (const auto& [code, name] : {std::pair{"en", "English"}, std::pair{"ru", "Русский"}}) {
        // A language is named in itself, so that its speakers find it.
        QAction* entry = language->addAction(QString::fromUtf8(name));
        entry->setData(QString::fromLatin1(code));
        entry->setCheckable(true);
        languages_->addAction(entry);
        connect(entry, &QAction::triggered, this,
                [this, entry] { setLanguage(entry->data().toString()); });
    }

    QMenu* analysis = top(QT_TR_NOOP("&Analysis"));
    add(analysis, {Command::run, Command::live, Command::cancel, Command::compare});
    analysis->addSeparator();
    add(analysis, {Command::identify, Command::new_set});
    QMenu* help = top(QT_TR_NOOP("&Help"));
    add(help, {Command::help, Command::copy_diagnostics, Command::about});
}

void MainWindow::buildToolBar() {
    tools_ = addToolBar(QString());
    tools_->setObjectName(QStringLiteral("tools"));
    tools_->setMovable(false);
    tools_->setToolButtonStyle(Qt::ToolButtonTextBesideIcon);
    tools_->setIconSize({20, 20});
    for (const Command command :
         {Command::open, Command::run, Command::compare, Command::export_plots}) {
        tools_->addAction(action(command));
    }
    tools_->addSeparator();
    for (const Command command : {Command::zoom_fit, Command::zoom_back}) {
        tools_->addAction(action(command));
    }
    auto* gap = new QWidget(tools_);
    gap->setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Preferred);
    tools_->addWidget(gap);
    for (QAction* language : languages_->actions()) {
        tools_->addAction(language);
    }
}

void MainWindow::refreshActions() {
    const RecordingEntry* entry = document_.currentRecording();
    const bool open = entry && entry->recording;
    const auto enable = [this](std::initializer_list<Command> commands, bool enabled) {
        for (const Command command : commands) {
            action(command)->setEnabled(enabled);
        }
    };
    const bool plots = !document_.runs().empty();
    enable({Command::run, Command::compare}, open);
    enable({Command::close_recording}, entry != nullptr);
    enable({Command::export_plots, Command::copy_plot, Command::copy_table, Command::zoom_in,
            Command::zoom_out, Command::zoom_fit},
           plots);
    const RunEntry* chosen = document_.run(runs_->currentRun());
    enable({Command::export_track}, chosen && !chosen->partial());
    enable({Command::zoom_back}, tracks_->canZoomBack());
    enable({Command::zoom_forward}, tracks_->canZoomForward());
    enable({Command::undo}, document_.undoStack().canUndo());
    enable({Command::redo}, document_.undoStack().canRedo());
    enable({Command::cancel}, document_.busy());
    const RunSet* set = document_.currentSet();
    const auto outcome = set ? document_.outcome(*set) : nullptr;
    enable({Command::identify}, document_.canIdentify());
    enable({Command::save_passport}, outcome && !document_.outOfDate(*set, *outcome));
}

void MainWindow::retranslate() {
    for (std::size_t i = 0; i < actions_.size(); ++i) {
        const auto which = static_cast<Command>(i);
        QAction& command = *actions_[i];
        command.setText(commandName(which));
        QString tip = commandTip(which);
        if (tip.isEmpty()) {
            tip = command.text().remove(QLatin1Char('&'));
        }
        if (!command.shortcut().isEmpty()) {
            tip +=
                QStringLiteral(" (%1)").arg(command.shortcut().toString(QKeySequence::NativeText));
        }
        command.setToolTip(tip);
    }
    for (const auto& [menu, title] : menus_) {
        menu->setTitle(tr(title));
    }
    for (const auto& [dock, title] : docks_) {
        dock->setWindowTitle(tr(title));
        // Qt names these once, in the language of the start.
        const auto name = [dock = dock](const char* button, const QString& text) {
            if (auto* widget = dock->findChild<QAbstractButton*>(QLatin1String(button))) {
                widget->setToolTip(text);
                widget->setAccessibleName(text);
            }
        };
        name("qt_dockwidget_floatbutton", tr("Float"));
        name("qt_dockwidget_closebutton", tr("Close this panel"));
    }
    for (const Choice& choice : choices_) {
        if (choice.text) {
            choice.action->setText(tr(choice.text));
        } else {
            const auto variable = static_cast<SlowVariable>(choice.action->data().toInt());
            choice.action->setText(displayMeaning(variable));
        }
    }
    readings_->setTabText(0, tr("At the cursor"));
    readings_->setTabText(1, tr("Resonator"));
    readings_->setTabText(2, tr("Events"));
    tools_->setWindowTitle(tr("Tools"));
    signal_->setAccessibleName(tr("Overview of the recording"));
    refreshActions();
}

}  // namespace vybeg::ui
