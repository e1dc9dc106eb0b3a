#include "ui/window/window_menus.h"

#include "ui/plots/track_view.h"
#include "ui/widgets/page_parts.h"
#include "ui/words/rich_text.h"

#include <QAction>
#include <QActionGroup>
#include <QDir>
#include <QFileInfo>
#include <QLocale>
#include <QMenuBar>
#include <QSettings>

#include <algorithm>
#include <utility>

namespace vybeg::ui {

namespace {

constexpr int most_files = 10;
const QString key = QStringLiteral("recent_files");

}  // namespace

RecentFiles::RecentFiles(QWidget* parent) : QMenu(parent) {
    setToolTipsVisible(true);
    connect(this, &QMenu::aboutToShow, this, &RecentFiles::rebuild);
    keepTranslated(*this, [this] { rebuild(); });
}

QStringList RecentFiles::paths() const {
    return QSettings().value(key).toStringList();
}

void RecentFiles::add(const QString& path) {
    const QString absolute = QFileInfo(path).absoluteFilePath();
    QStringList files = paths();
    files.removeAll(absolute);
    files.prepend(absolute);
    QSettings().setValue(key, QStringList(files.mid(0, most_files)));
    rebuild();
}

void RecentFiles::rebuild() {
    clear();
    const QStringList files = paths();
    setEnabled(!files.isEmpty());
    for (qsizetype i = 0; i < files.size(); ++i) {
        const QString& path = files[i];
        QString name = QFileInfo(path).fileName();
        name.replace(QLatin1Char('&'), QStringLiteral("&&"));
        QAction* action = addAction(i < 9 ? QStringLiteral("&%1 %2").arg(i + 1).arg(name) : name);
        action->setToolTip(plainTip(QDir::toNativeSeparators(path)));
        connect(action, &QAction::triggered, this, [this, path] { emit chosen(path); });
    }
    if (!files.isEmpty()) {
        addSeparator();
        connect(addAction(tr("Clear this list")), &QAction::triggered, this, [this] {
            QSettings().remove(key);
            // Queued: the action that was triggered belongs to the menu being rebuilt.
            QMetaObject::invokeMethod(this, &RecentFiles::rebuild, Qt::QueuedConnection);
        });
    }
}

WindowMenus::WindowMenus(const Commands& commands, TrackView& tracks, std::function<int()> theme,
                         QMenuBar* bar)
    : QObject(bar),
      commands_(commands),
      tracks_(tracks),
      bar_(bar),
      recent_(new RecentFiles(bar)),
      theme_(std::move(theme)) {
    QMenu* file = top(QT_TR_NOOP("&File"));
    add(file, {{Command::open}});
    file->addMenu(named(recent_, QT_TR_NOOP("Open rece&nt")));
    add(file,
        {{Command::import_file, Command::open_logs, Command::open_whole_angle,
          Command::open_database, Command::close_recording},
         {Command::save_session, Command::save_session_as},
         {Command::export_plots, Command::article_figure, Command::export_track, Command::report},
         {Command::save_passport, Command::compare_passport},
         {Command::quit}});
    add(top(QT_TR_NOOP("&Edit")),
        {{Command::undo, Command::redo}, {Command::copy_plot, Command::copy_table}});
    addView();
    add(top(QT_TR_NOOP("&Analysis")), {{Command::analyse, Command::live, Command::cancel}});
    add(top(QT_TR_NOOP("&Gyro")), {{Command::gyro_data, Command::limits},
                                   {Command::identify, Command::new_set},
                                   {Command::batch}});
    add(top(QT_TR_NOOP("&Help")), {{Command::help, Command::copy_diagnostics, Command::about}});
}

QMenu* WindowMenus::top(const char* title) {
    QMenu* menu = bar_->addMenu(QString());
    menu->setToolTipsVisible(true);
    return named(menu, title);
}

QMenu* WindowMenus::named(QMenu* menu, const char* title) {
    entries_.push_back({menu->menuAction(), title});
    return menu;
}

void WindowMenus::add(QMenu* menu, std::initializer_list<std::initializer_list<Command>> groups) {
    for (const std::initializer_list<Command>& group : groups) {
        if (&group != groups.begin()) {
            menu->addSeparator();
        }
        for (const Command command : group) {
            menu->addAction(commands_.action(command));
        }
    }
}

void WindowMenus::addChoice(QMenu* parent, const char* title, const std::vector<const char*>& texts,
                            const std::function<int()>& chosen,
                            const std::function<void(int)>& choose) {
    QMenu* menu = named(parent->addMenu(QString()), title);
    auto* group = new QActionGroup(menu);
    for (std::size_t i = 0; i < texts.size(); ++i) {
        QAction* entry = menu->addAction(QString());
        entry->setCheckable(true);
        group->addAction(entry);
        entries_.push_back({entry, texts[i]});
        connect(entry, &QAction::triggered, this, [choose, i] { choose(static_cast<int>(i)); });
    }
    const auto show = [group, chosen] { group->actions().at(chosen())->setChecked(true); };
    show();
    connect(menu, &QMenu::aboutToShow, this, show);  // a session may have changed it
}

void WindowMenus::addView() {
    QMenu* view = top(QT_TR_NOOP("&View"));
    add(view, {{Command::page_tracks, Command::page_signals, Command::page_residuals,
                Command::page_windows, Command::page_resonator, Command::page_drift,
                Command::page_history},
               {Command::zoom_in, Command::zoom_out, Command::zoom_fit, Command::zoom_back,
                Command::zoom_forward},
               {}});
    addVariables(view);
    addUnits(view);
    add(view, {{Command::axis_limits, Command::log_a_A, Command::sigma_bands},
               {Command::sidebar, Command::wave, Command::fitted_wave},
               {}});
    addChoice(view, QT_TR_NOOP("&Theme"),
              {QT_TR_NOOP("As the system"), QT_TR_NOOP("Light"), QT_TR_NOOP("Dark")}, theme_,
              [this](int mode) { emit themeChosen(mode); });
    // A language is named in itself, so that its speakers find it.
    addChoice(
        view, QT_TR_NOOP("Lang&uage"), {"English", "Русский"},
        [] { return QLocale().language() == QLocale::Russian ? 1 : 0; },
        [this](int language) {
            emit languageChosen(language == 1 ? QStringLiteral("ru") : QStringLiteral("en"));
        });
}

void WindowMenus::addVariables(QMenu* view) {
    QMenu* variables = named(view->addMenu(QString()), QT_TR_NOOP("&Plots"));
    for (const SlowVariable variable : shown_slow_variables) {
        QAction* shown = variables->addAction(QString());
        shown->setCheckable(true);
        shown->setData(static_cast<int>(variable));
        entries_.push_back({shown, nullptr});
        connect(shown, &QAction::triggered, this, [this, variables] {
            std::vector<SlowVariable> wanted;
            for (const QAction* each : variables->actions()) {
                if (each->isChecked()) {
                    wanted.push_back(static_cast<SlowVariable>(each->data().toInt()));
                }
            }
            tracks_.setShownVariables(std::move(wanted));
        });
    }
    const auto show = [this, variables] {
        const auto& now = tracks_.shownVariables();
        for (QAction* each : variables->actions()) {
            const auto variable = static_cast<SlowVariable>(each->data().toInt());
            each->setChecked(std::ranges::find(now, variable) != now.end());
        }
    };
    show();
    connect(variables, &QMenu::aboutToShow, this, show);
}

void WindowMenus::addUnits(QMenu* view) {
    const auto add = [this, view]<class Unit>(const char* title, Unit DisplayUnits::*member,
                                              const std::vector<const char*>& texts) {
        addChoice(
            view, title, texts,
            [this, member] { return static_cast<int>(tracks_.units().*member); },
            [this, member](int unit) {
                DisplayUnits units = tracks_.units();
                units.*member = static_cast<Unit>(unit);
                emit unitsChosen(units);
            });
    };
    add(QT_TR_NOOP("Fre&quency in"), &DisplayUnits::frequency,
        {QT_TR_NOOP("Hz"), QT_TR_NOOP("rad/s"), QT_TR_NOOP("Deviation from f₀, Hz"),
         QT_TR_NOOP("Deviation from f₀, ppm")});
    add(QT_TR_NOOP("&Angles in"), &DisplayUnits::angle,
        {QT_TR_NOOP("Radians"), QT_TR_NOOP("Degrees")});
    add(QT_TR_NOOP("2θ_A or θ_A, bran&ch"), &DisplayUnits::wave_angle,
        {QT_TR_NOOP("2θ_A"), QT_TR_NOOP("θ_A, continuous"), QT_TR_NOOP("θ_A from −45° to 45°"),
         QT_TR_NOOP("θ_A from 0° to 90°")});
    add(QT_TR_NOOP("A&mplitudes in"), &DisplayUnits::amplitude,
        {QT_TR_NOOP("Recording units"), QT_TR_NOOP("Decibels")});
}

void WindowMenus::retranslate() {
    for (const Entry& entry : entries_) {
        if (entry.text) {
            entry.action->setText(tr(entry.text));
        } else {
            const auto variable = static_cast<SlowVariable>(entry.action->data().toInt());
            entry.action->setText(displayMeaning(variable));
        }
    }
}

}  // namespace vybeg::ui

#include "moc_window_menus.cpp"
