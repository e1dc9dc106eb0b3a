#pragma once

#include <QKeySequence>
#include <QList>
#include <QString>

namespace vybeg::ui {

// What the menus, the tool bar and the keyboard offer.
enum class Command {
    open,
    import_file,
    close_recording,
    export_plots,
    export_track,
    save_passport,
    compare_passport,
    quit,
    undo,
    redo,
    copy_plot,
    copy_table,
    zoom_in,
    zoom_out,
    zoom_fit,
    zoom_back,
    zoom_forward,
    sigma_bands,
    log_a_A,
    run,
    live,
    cancel,
    compare,
    identify,
    new_set,
    help,
    copy_diagnostics,
    about,
    count
};

// In the interface's language. A command whose name says all has no tip.
QString commandName(Command command);
QString commandTip(Command command);
QList<QKeySequence> shortcutsOf(Command command);

}  // namespace vybeg::ui
