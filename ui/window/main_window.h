#pragma once

#include "ui/document/document.h"
#include "ui/plots/plot_view.h"
#include "ui/values/ids.h"
#include "ui/widgets/theme.h"
#include "ui/window/commands.h"
#include "ui/window/page_stack.h"
#include "ui/words/display_units.h"
#include "ui/words/language.h"

#include <QMainWindow>
#include <QPointer>

#include <optional>
#include <vector>

class QMenuBar;
class QToolBar;

namespace vybeg::ui {

class BatchCommands;
class CursorTimes;
class DriftPage;
class FileCommands;
class HelpView;
class HistoryPage;
class Ledger;
class MessageBar;
class Overview;
class ResonatorPage;
class SessionKeeper;
class SettingsPanel;
class SignalsPage;
class StatusLine;
class TrackView;
class TracksPage;
class WavePanel;
class WelcomePage;
class WindowMenus;

// The window: puts panels and pages together and connects them. All state is the document's, which
// outlives the window; the window's own (geometry, theme, language) is kept in QSettings.
class MainWindow : public QMainWindow {
    Q_OBJECT

public:
    explicit MainWindow(Document& document, QWidget* parent = nullptr);
    ~MainWindow() override;

    Document& document() { return document_; }
    QAction* action(Command command) const { return commands_->action(command); }
    void setLanguage(const QString& code);
    void setThemeMode(ThemeMode mode);

    FileCommands& files() { return *files_; }
    SessionKeeper& session() { return *session_; }
    // Program, libraries, platform and settings, for a report of a fault.
    QString diagnosticsText() const;

protected:
    void closeEvent(QCloseEvent* event) override;
    void dragEnterEvent(QDragEnterEvent* event) override;
    void dropEvent(QDropEvent* event) override;

private:
    friend struct WindowCommands;

    void buildPages();
    void layOut();
    void buildTopRow();
    void connectDocument();
    void connectSession();
    void connectPanels();
    void showTitle();
    void showPanels();
    void showCursors();
    void showTimes();
    void showCurrentRecording();
    void showAnalyses();
    void showAnalysis(AnalysisId id);
    void setUnits(const DisplayUnits& units);
    // Of the page that is shown.
    FigureSource figures() const;
    void showHelp();
    void restoreState();
    void saveState();
    void applyLook();
    void retranslate();

    Document& document_;
    Language language_;
    ThemeMode theme_mode_ = ThemeMode::system;
    Theme theme_;
    Commands* commands_ = nullptr;
    WindowMenus* menus_ = nullptr;
    SessionKeeper* session_ = nullptr;
    FileCommands* files_ = nullptr;
    BatchCommands* batch_ = nullptr;
    bool leaving_ = false;  // changes are saved or given up
    bool sidebar_wanted_ = true;
    std::optional<bool> wave_wanted_;  // nothing: where there is room
    QMenuBar* menu_bar_ = nullptr;
    QToolBar* tools_ = nullptr;

    PageStack* pages_ = nullptr;
    WelcomePage* welcome_ = nullptr;
    MessageBar* messages_ = nullptr;
    TracksPage* tracks_page_ = nullptr;
    TrackView* tracks_ = nullptr;  // of the page
    SignalsPage* signals_ = nullptr;
    DriftPage* drift_ = nullptr;
    HistoryPage* history_ = nullptr;
    std::vector<MeasuredPage*> all_pages_;  // as Page
    SettingsPanel* settings_ = nullptr;
    Overview* overview_ = nullptr;
    Ledger* ledger_ = nullptr;
    CursorTimes* times_ = nullptr;
    ResonatorPage* resonator_ = nullptr;
    WavePanel* wave_ = nullptr;
    QWidget* wave_button_ = nullptr;
    StatusLine* status_ = nullptr;
    QPointer<HelpView> help_;
};

}  // namespace vybeg::ui
