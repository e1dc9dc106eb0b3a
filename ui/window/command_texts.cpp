#include "ui/window/command_texts.h"

#include <QCoreApplication>

#include <array>

namespace vybeg::ui {

namespace {

struct CommandTexts {
    const char* text;
    const char* tip;
};

// In the order of Command.
constexpr std::array<CommandTexts, static_cast<std::size_t>(Command::count)> command_texts{{
    {QT_TRANSLATE_NOOP("Command", "&Open…"),
     QT_TRANSLATE_NOOP("Command", "Open recordings of a free decay")},
    {QT_TRANSLATE_NOOP("Command", "&Import…"),
     QT_TRANSLATE_NOOP("Command",
                       "Say how a file is to be read, and see at once what comes of it")},
    {QT_TRANSLATE_NOOP("Command", "&Close recording"),
     QT_TRANSLATE_NOOP("Command", "Close the current recording and its runs")},
    {QT_TRANSLATE_NOOP("Command", "&Export plots…"),
     QT_TRANSLATE_NOOP("Command", "Save the plots as PNG, SVG or PDF")},
    {QT_TRANSLATE_NOOP("Command", "Export &track…"),
     QT_TRANSLATE_NOOP("Command", "Save the slow variables of the chosen run as CSV")},
    {QT_TRANSLATE_NOOP("Command", "Save &passport…"),
     QT_TRANSLATE_NOOP("Command", "Save what was identified from the set as the gyro's passport")},
    {QT_TRANSLATE_NOOP("Command", "Compare &with passport…"),
     QT_TRANSLATE_NOOP("Command",
                       "Which parameters of the resonator have changed since its passport")},
    {QT_TRANSLATE_NOOP("Command", "&Quit"), ""},
    {QT_TRANSLATE_NOOP("Command", "&Undo"),
     QT_TRANSLATE_NOOP("Command", "Take back the last change of the settings")},
    {QT_TRANSLATE_NOOP("Command", "&Redo"),
     QT_TRANSLATE_NOOP("Command", "Make the change of the settings again")},
    {QT_TRANSLATE_NOOP("Command", "&Copy plots"),
     QT_TRANSLATE_NOOP("Command", "The plots as an image to the clipboard")},
    {QT_TRANSLATE_NOOP("Command", "Copy &table"),
     QT_TRANSLATE_NOOP("Command", "The values at the cursor to the clipboard, for a spreadsheet")},
    {QT_TRANSLATE_NOOP("Command", "Zoom &in"), ""},
    {QT_TRANSLATE_NOOP("Command", "Zoom &out"), ""},
    {QT_TRANSLATE_NOOP("Command", "&Fit"),
     QT_TRANSLATE_NOOP("Command", "Show the whole time range (double click, Home)")},
    {QT_TRANSLATE_NOOP("Command", "Zoom &back"),
     QT_TRANSLATE_NOOP("Command", "Back in the zoom history (R)")},
    {QT_TRANSLATE_NOOP("Command", "Zoom fo&rward"),
     QT_TRANSLATE_NOOP("Command", "Forward in the zoom history")},
    {QT_TRANSLATE_NOOP("Command", "One-&sigma bands"), ""},
    {QT_TRANSLATE_NOOP("Command", "&Logarithmic working amplitude"), ""},
    {QT_TRANSLATE_NOOP("Command", "&Run"),
     QT_TRANSLATE_NOOP("Command",
                       "Analyse the current recording with the settings of the panel, as a run "
                       "that is kept")},
    {QT_TRANSLATE_NOOP("Command", "&Live"),
     QT_TRANSLATE_NOOP("Command",
                       "Every change of a setting shows at once, in a run that follows the panel")},
    {QT_TRANSLATE_NOOP("Command", "&Cancel"),
     QT_TRANSLATE_NOOP("Command", "Stop the analyses that are under way")},
    {QT_TRANSLATE_NOOP("Command", "Compare &windows…"),
     QT_TRANSLATE_NOOP("Command", "The article's figure: one column per window length")},
    {QT_TRANSLATE_NOOP("Command", "&Identify resonator"),
     QT_TRANSLATE_NOOP("Command", "Fit one resonator to all recordings of the set")},
    {QT_TRANSLATE_NOOP("Command", "&New set of runs"),
     QT_TRANSLATE_NOOP("Command", "Recordings of another resonator, to be identified together")},
    {QT_TRANSLATE_NOOP("Command", "&Help"),
     QT_TRANSLATE_NOOP("Command", "How to use the program, the method and its formulas")},
    {QT_TRANSLATE_NOOP("Command", "Copy &diagnostics"),
     QT_TRANSLATE_NOOP("Command",
                       "Versions and settings to the clipboard, for a report of a fault")},
    {QT_TRANSLATE_NOOP("Command", "&About Vybeg"), ""},
}};

}  // namespace

QString commandName(Command command) {
    return QCoreApplication::translate("Command",
                                       command_texts[static_cast<std::size_t>(command)].text);
}

QString commandTip(Command command) {
    const char* tip = command_texts[static_cast<std::size_t>(command)].tip;
    return *tip ? QCoreApplication::translate("Command", tip) : QString();
}

QList<QKeySequence> shortcutsOf(Command command) {
    switch (command) {
        case Command::open: return {QKeySequence::Open};
        case Command::import_file: return {QKeyCombination(Qt::CTRL | Qt::SHIFT, Qt::Key_O)};
        case Command::close_recording: return {QKeyCombination(Qt::CTRL, Qt::Key_W)};
        case Command::export_plots: return {QKeyCombination(Qt::CTRL, Qt::Key_E)};
        case Command::export_track: return {QKeyCombination(Qt::CTRL, Qt::Key_S)};
        case Command::quit: return {QKeyCombination(Qt::CTRL, Qt::Key_Q)};
        case Command::undo: return {QKeyCombination(Qt::CTRL, Qt::Key_Z)};
        case Command::redo:
            return {QKeyCombination(Qt::CTRL | Qt::SHIFT, Qt::Key_Z),
                    QKeyCombination(Qt::CTRL, Qt::Key_Y)};
        case Command::copy_plot: return {QKeyCombination(Qt::CTRL | Qt::SHIFT, Qt::Key_C)};
        case Command::copy_table: return {QKeyCombination(Qt::CTRL | Qt::SHIFT, Qt::Key_T)};
        case Command::zoom_fit: return {QKeyCombination(Qt::CTRL, Qt::Key_0)};
        case Command::zoom_back: return {QKeyCombination(Qt::ALT, Qt::Key_Left)};
        case Command::zoom_forward: return {QKeyCombination(Qt::ALT, Qt::Key_Right)};
        case Command::run: return {QKeySequence(Qt::Key_F5)};
        case Command::live: return {QKeyCombination(Qt::CTRL, Qt::Key_L)};
        case Command::cancel: return {QKeyCombination(Qt::SHIFT, Qt::Key_F5)};
        case Command::compare: return {QKeySequence(Qt::Key_F6)};
        case Command::identify: return {QKeySequence(Qt::Key_F7)};
        case Command::help: return {QKeySequence(Qt::Key_F1)};
        default: return {};
    }
}

}  // namespace vybeg::ui
