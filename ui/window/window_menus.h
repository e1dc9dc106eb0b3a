#pragma once

#include "ui/window/commands.h"
#include "ui/words/display_units.h"

#include <QMenu>
#include <QObject>

#include <functional>
#include <vector>

class QMenuBar;

namespace vybeg::ui {

class TrackView;

// The "Open recent" menu: the last recordings that could be opened, newest first, kept between
// sessions.
class RecentFiles : public QMenu {
    Q_OBJECT

public:
    explicit RecentFiles(QWidget* parent = nullptr);

    void add(const QString& path);
    QStringList paths() const;

signals:
    void chosen(const QString& path);

private:
    void rebuild();
};

// The menu bar: the commands, and choices of units, plots, theme and language.
class WindowMenus : public QObject {
    Q_OBJECT

public:
    // `theme`: the choice in effect, as ThemeMode.
    WindowMenus(const Commands& commands, TrackView& tracks, std::function<int()> theme,
                QMenuBar* bar);

    RecentFiles* recentFiles() const { return recent_; }
    void retranslate();

signals:
    void unitsChosen(const DisplayUnits& units);
    void themeChosen(int theme);
    void languageChosen(const QString& code);

private:
    struct Entry {
        QAction* action;   // or that of a menu
        const char* text;  // of a slow variable: none
    };

    QMenu* top(const char* title);
    QMenu* named(QMenu* menu, const char* title);
    // Groups of commands, a line between each two.
    void add(QMenu* menu, std::initializer_list<std::initializer_list<Command>> groups);
    void addChoice(QMenu* parent, const char* title, const std::vector<const char*>& texts,
                   const std::function<int()>& chosen, const std::function<void(int)>& choose);
    void addView();
    void addVariables(QMenu* view);
    void addUnits(QMenu* view);

    const Commands& commands_;
    TrackView& tracks_;
    QMenuBar* bar_;
    RecentFiles* recent_;
    std::function<int()> theme_;
    std::vector<Entry> entries_;  // but for the commands
};

}  // namespace vybeg::ui
