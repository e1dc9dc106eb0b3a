#pragma once

#include <QCoreApplication>
#include <QKeySequence>
#include <QList>
#include <QObject>

#include <array>
#include <functional>
#include <vector>

class QAction;
class QPalette;
class QWidget;

namespace vybeg::ui {

// What the menus, the row of the window and the keyboard offer.
enum class Command {
    open,
    import_file,
    open_logs,
    open_database,
    open_whole_angle,
    close_recording,
    save_session,
    save_session_as,
    export_plots,
    article_figure,
    export_track,
    report,
    save_passport,
    compare_passport,
    quit,
    undo,
    redo,
    copy_plot,
    copy_table,
    page_tracks,  // from here on as Page
    page_signals,
    page_residuals,
    page_windows,
    page_resonator,
    page_drift,
    page_history,
    zoom_in,
    zoom_out,
    zoom_fit,
    zoom_back,
    zoom_forward,
    sidebar,
    wave,
    fitted_wave,
    sigma_bands,
    log_a_A,
    axis_limits,
    analyse,
    live,
    cancel,
    gyro_data,
    limits,
    identify,
    new_set,
    batch,
    help,
    copy_diagnostics,
    about,
    count
};

// Everything about one command. Texts are of the context "Command"; a command whose name says all
// has no tip. Without `enabled` it always is. One with `switched` is checkable.
struct CommandRow {
    Command id;
    const char* text;
    const char* tip = nullptr;
    const char* icon = nullptr;
    QList<QKeySequence> keys{};
    std::function<bool()> enabled{};
    std::function<QString()> object{};  // words after the text, as those of the step to undo
    std::function<void()> act{};
    std::function<void(bool)> switched{};
};

class MainWindow;

// The table of all commands of a window.
struct WindowCommands {
    static std::vector<CommandRow> of(MainWindow& w);

    Q_DECLARE_TR_FUNCTIONS(Command)
};

// The actions of a table of commands, which has a row for each of Command.
class Commands : public QObject {
    Q_OBJECT

public:
    Commands(std::vector<CommandRow> rows, QWidget* window);

    QAction* action(Command command) const { return actions_[static_cast<std::size_t>(command)]; }
    // Enables what can be done now.
    void refresh();
    void retranslate();
    void setIcons(const QPalette& palette);

private:
    std::vector<CommandRow> rows_;
    std::array<QAction*, static_cast<std::size_t>(Command::count)> actions_{};
};

}  // namespace vybeg::ui
