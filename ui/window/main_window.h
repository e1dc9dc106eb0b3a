#pragma once

#include "ui/document/document.h"
#include "ui/plots/xy_plot.h"
#include "ui/values/zoom_stack.h"
#include "ui/widgets/theme.h"
#include "ui/window/command_texts.h"
#include "ui/words/display_units.h"
#include "ui/words/language.h"

#include <QElapsedTimer>
#include <QMainWindow>
#include <QPointer>

#include <array>
#include <map>

class QActionGroup;
class QStackedWidget;
class QTabWidget;
class QToolBar;

namespace vybeg::ui {

class CompareDialog;
class CursorPanel;
class EventsPanel;
class HelpView;
class ImportDialog;
class MessageBar;
class RecentFiles;
class RecordingPanel;
class ResonatorPanel;
class RunList;
class SettingsPanel;
class SignalView;
class StaleMark;
class StatusLine;
class TrackView;
class WelcomePage;

// The window: puts the panels and views together and passes on what they tell each other. All state
// is the document's; all of the window's own (geometry, theme, language, units) is kept in
// QSettings.
class MainWindow : public QMainWindow {
    Q_OBJECT

public:
    explicit MainWindow(QWidget* parent = nullptr);
    ~MainWindow() override;

    Document& document() { return document_; }
    QAction* action(Command command) const { return actions_[static_cast<std::size_t>(command)]; }
    void setLanguage(const QString& code);
    void setThemeMode(ThemeMode mode);

    // By the ending of the path; a failure is told in the message bar.
    void exportPlotsTo(const QString& path);
    void exportTrackTo(const QString& path);
    void exportFigureTo(const QString& path);
    void savePassportTo(const QString& path);
    void comparePassport(const QString& path);
    // Program, libraries, platform and settings, for a report of a fault.
    QString diagnosticsText() const;

protected:
    void changeEvent(QEvent* event) override;
    void closeEvent(QCloseEvent* event) override;
    void dragEnterEvent(QDragEnterEvent* event) override;
    void dropEvent(QDropEvent* event) override;

private:
    struct Choice {
        QAction* action;
        const char* text;
    };

    // main_window.cpp
    void buildViews();
    void buildDocks();
    void connectDocument();
    void connectViews();
    void showCurrentRecording();
    void showEnvelope();
    void showAnalysedRange();
    void showRuns();
    void showBusy();
    void showRun(int id);
    void editAnalysedRange(double from_s, double to_s);
    void goToEvent(double time_s, double seconds);
    void identify();

    // main_window_actions.cpp
    void buildActions();
    void buildMenus();
    void buildToolBar();
    QMenu* choiceMenu(QMenu* parent, const std::vector<const char*>& texts, int chosen,
                      const std::function<void(int)>& choose);
    void retranslate();
    void refreshActions();
    void changeUnits(const std::function<void(DisplayUnits&)>& change);

    // main_window_files.cpp
    void askForFiles();
    void askForImport();
    void openImport(const QString& path, const OpenOptions& options);
    void askWhereTo(const QString& title, const QString& name, const QStringList& filters,
                    const std::function<void(const QString&)>& save);
    void told(const Status& status, const QString& path);
    void askForPassport();
    void exportResonatorPlot(const XYPlot& plot);
    void openCompare();
    void showComparison(const QList<int>& run_ids);
    void showHelp();
    void showAbout();

    // main_window_state.cpp
    void restoreState();
    void saveState();
    void applyLook();

    Language language_;
    Document document_;
    ThemeMode theme_mode_ = ThemeMode::system;
    Theme theme_;
    std::array<QAction*, static_cast<std::size_t>(Command::count)> actions_{};
    std::vector<Choice> choices_;
    std::map<QMenu*, const char*> menus_;
    std::map<QDockWidget*, const char*> docks_;
    QToolBar* tools_ = nullptr;
    QActionGroup* languages_ = nullptr;

    QStackedWidget* pages_ = nullptr;
    WelcomePage* welcome_ = nullptr;
    MessageBar* messages_ = nullptr;
    SignalView* signal_ = nullptr;
    StaleMark* stale_ = nullptr;
    TrackView* tracks_ = nullptr;
    RecordingPanel* recordings_ = nullptr;
    SettingsPanel* settings_ = nullptr;
    CursorPanel* cursor_ = nullptr;
    ResonatorPanel* resonator_ = nullptr;
    EventsPanel* events_ = nullptr;
    RunList* runs_ = nullptr;
    QTabWidget* readings_ = nullptr;
    RecentFiles* recent_ = nullptr;
    StatusLine* status_ = nullptr;
    QPointer<CompareDialog> compare_;
    QPointer<HelpView> help_;
    AnalysisJob imports_;  // previews of the import dialog
    QPointer<ImportDialog> import_;
    QElapsedTimer last_range_edit_;
    int range_gesture_ = 0;
};

}  // namespace vybeg::ui
