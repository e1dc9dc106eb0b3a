// The table of all commands of the window.

#include "ui/panels/ledger.h"
#include "ui/plots/figure.h"
#include "ui/plots/track_view.h"
#include "ui/report/document_report.h"
#include "ui/resonator/dossier_dialogs.h"
#include "ui/settings/settings_panel.h"
#include "ui/signals/signals_page.h"
#include "ui/window/batch_commands.h"
#include "ui/window/file_commands.h"
#include "ui/window/help.h"
#include "ui/window/main_window.h"
#include "ui/window/status_line.h"
#include "ui/window/tracks_page.h"

#include <QApplication>
#include <QClipboard>

#include <algorithm>

namespace vybeg::ui {

std::vector<CommandRow> windowCommands(MainWindow& w) {
    const auto any = [&w] { return w.document_.currentRecording() != nullptr; };
    const auto open = [&w] {
        const RecordingEntry* entry = w.document_.currentRecording();
        return entry != nullptr && entry->recording.has_value();
    };
    const auto anything = [&w, any] {
        return any() || !w.document_.drift().logs().empty() ||
               std::ranges::any_of(w.document_.sets().all(), isOfLogs);
    };
    const auto plots = [&w] { return !w.document_.analyses().empty(); };
    const auto figures = [&w] { return !w.figures().plots.isEmpty(); };
    return {
        {.id = Command::open,
         .text = QT_TRANSLATE_NOOP("Command", "&Open…"),
         .tip = QT_TRANSLATE_NOOP(
             "Command", "Open recordings of a free decay, a measurement list, or a session"),
         .icon = "open",
         .keys = {QKeySequence::Open},
         .act = [&w] { w.files_->askForRecordings(); }},
        {.id = Command::import_file,
         .text = QT_TRANSLATE_NOOP("Command", "&Import…"),
         .tip = QT_TRANSLATE_NOOP("Command",
                                  "Say how a file is to be read, and see at once what comes of it"),
         .keys = {QKeyCombination(Qt::CTRL | Qt::SHIFT, Qt::Key_O)},
         .act = [&w] { w.files_->askForImport(); }},
        {.id = Command::open_logs,
         .text = QT_TRANSLATE_NOOP("Command", "Open &logs…"),
         .tip = QT_TRANSLATE_NOOP("Command",
                                  "Open logs of a controller, a lock-in or a phasemeter in place "
                                  "of recordings, and identify their resonator"),
         .keys = {QKeyCombination(Qt::CTRL | Qt::SHIFT, Qt::Key_L)},
         .act = [&w] { w.files_->askForLogs(); }},
        {.id = Command::open_database,
         .text = QT_TRANSLATE_NOOP("Command", "Open &database…"),
         .tip = QT_TRANSLATE_NOOP("Command",
                                  "Open a database of results, for the history of its gyros"),
         .act = [&w] { w.files_->askForDatabase(); }},
        {.id = Command::open_whole_angle,
         .text = QT_TRANSLATE_NOOP("Command", "Open w&hole-angle logs…"),
         .tip = QT_TRANSLATE_NOOP("Command",
                                  "Open logs of a wave whose amplitude is held while it turns, for "
                                  "its drift against the angle"),
         .act = [&w] { w.files_->askForWholeAngleLogs(); }},
        {.id = Command::close_recording,
         .text = QT_TRANSLATE_NOOP("Command", "&Close recording"),
         .tip = QT_TRANSLATE_NOOP("Command", "Close the current recording and its analyses"),
         .keys = {QKeyCombination(Qt::CTRL, Qt::Key_W)},
         .enabled = any,
         .act = [&w] { w.document_.closeRecording(w.document_.currentRecording()->id); }},
        {.id = Command::save_session,
         .text = QT_TRANSLATE_NOOP("Command", "&Save session"),
         .tip = QT_TRANSLATE_NOOP(
             "Command", "Recordings, settings, analyses, sets and view, to go on with later"),
         .keys = {QKeyCombination(Qt::CTRL, Qt::Key_S)},
         .enabled = anything,
         .act = [&w] { w.files_->saveSession(); }},
        {.id = Command::save_session_as,
         .text = QT_TRANSLATE_NOOP("Command", "S&ave session as…"),
         .keys = {QKeyCombination(Qt::CTRL | Qt::SHIFT, Qt::Key_S)},
         .enabled = anything,
         .act = [&w] { w.files_->saveSessionAs(); }},
        {.id = Command::export_plots,
         .text = QT_TRANSLATE_NOOP("Command", "&Export plots…"),
         .tip = QT_TRANSLATE_NOOP("Command", "Save the plots as PNG, SVG or PDF"),
         .icon = "export",
         .keys = {QKeyCombination(Qt::CTRL, Qt::Key_E)},
         .enabled = figures,
         .act = [&w] { w.files_->exportPlots(w.figures()); }},
        {.id = Command::article_figure,
         .text = QT_TRANSLATE_NOOP("Command", "Article's &figure…"),
         .tip = QT_TRANSLATE_NOOP("Command",
                                  "The article's figure: a column for each analysis that is shown, "
                                  "with the scatter of its windows"),
         .keys = {QKeySequence(Qt::Key_F6)},
         .enabled = plots,
         .act = [&w] { w.files_->exportPlots(w.tracks_page_->articleFigure()); }},
        {.id = Command::export_track,
         .text = QT_TRANSLATE_NOOP("Command", "Export &track…"),
         .tip =
             QT_TRANSLATE_NOOP("Command", "Save the slow variables of the chosen analysis as CSV"),
         .keys = {QKeyCombination(Qt::CTRL | Qt::SHIFT, Qt::Key_E)},
         .enabled =
             [&w] {
                 const AnalysisEntry* chosen = w.document_.analysis(w.ledger_->currentAnalysis());
                 return chosen && !chosen->partial();
             },
         .act = [&w] { w.files_->askWhereToPutTrack(); }},
        {.id = Command::report,
         .text = QT_TRANSLATE_NOOP("Command", "&Report…"),
         .tip = QT_TRANSLATE_NOOP("Command",
                                  "A PDF of the recordings: settings, plots, resonator with its "
                                  "uncertainty budget, events, warnings"),
         .icon = "report",
         .keys = {QKeySequence::Print},
         .enabled = [&w] { return !reportSubjects(w.document_).empty(); },
         .act = [&w] { w.files_->askForReport(w.pages_->page() == Page::resonator); }},
        {.id = Command::save_passport,
         .text = QT_TRANSLATE_NOOP("Command", "Save &passport…"),
         .tip = QT_TRANSLATE_NOOP("Command",
                                  "Save what was identified from the set as the gyro's passport"),
         .enabled =
             [&w] {
                 const RecordingSet* set = w.document_.sets().current();
                 const auto outcome = set ? w.document_.sets().outcome(*set) : nullptr;
                 return outcome && !w.document_.sets().outOfDate(*set, *outcome);
             },
         .act = [&w] { w.files_->askWhereToPutPassport(); }},
        {.id = Command::compare_passport,
         .text = QT_TRANSLATE_NOOP("Command", "Compare &with passport…"),
         .tip = QT_TRANSLATE_NOOP(
             "Command", "Which parameters of the resonator have changed since its passport"),
         .act = [&w] { w.files_->askForPassport(); }},
        {.id = Command::quit,
         .text = QT_TRANSLATE_NOOP("Command", "&Quit"),
         .keys = {QKeyCombination(Qt::CTRL, Qt::Key_Q)},
         .act = [&w] { w.close(); }},
        {.id = Command::undo,
         .text = QT_TRANSLATE_NOOP("Command", "&Undo"),
         .tip = QT_TRANSLATE_NOOP("Command",
                                  "Take back the last change of settings, analyses or sets"),
         .icon = "undo",
         .keys = {QKeyCombination(Qt::CTRL, Qt::Key_Z)},
         .enabled = [&w] { return w.document_.undoStack().canUndo(); },
         .object = [&w] { return w.document_.undoSteps().undoWords(); },
         .act = [&w] { w.document_.undoStack().undo(); }},
        {.id = Command::redo,
         .text = QT_TRANSLATE_NOOP("Command", "&Redo"),
         .tip = QT_TRANSLATE_NOOP("Command", "Make the change again that was taken back"),
         .icon = "redo",
         .keys = {QKeyCombination(Qt::CTRL | Qt::SHIFT, Qt::Key_Z),
                  QKeyCombination(Qt::CTRL, Qt::Key_Y)},
         .enabled = [&w] { return w.document_.undoStack().canRedo(); },
         .object = [&w] { return w.document_.undoSteps().redoWords(); },
         .act = [&w] { w.document_.undoStack().redo(); }},
        {.id = Command::copy_plot,
         .text = QT_TRANSLATE_NOOP("Command", "&Copy plots"),
         .tip = QT_TRANSLATE_NOOP("Command", "The plots as an image to the clipboard"),
         .icon = "copy",
         .keys = {QKeyCombination(Qt::CTRL | Qt::SHIFT, Qt::Key_C)},
         .enabled = figures,
         .act =
             [&w] {
                 const FigureSource source = w.figures();
                 std::vector<int> all(static_cast<std::size_t>(source.plots.size()));
                 std::iota(all.begin(), all.end(), 0);
                 const Figure figure = source.figure(all);
                 copyDrawing(figure.draw, {figure.size});
             }},
        {.id = Command::copy_table,
         .text = QT_TRANSLATE_NOOP("Command", "Copy &table"),
         .tip = QT_TRANSLATE_NOOP("Command",
                                  "The values at the cursor to the clipboard, for a spreadsheet"),
         .keys = {QKeyCombination(Qt::CTRL | Qt::SHIFT, Qt::Key_T)},
         .enabled = plots,
         .act = [&w] { QApplication::clipboard()->setText(w.ledger_->tableText()); }},
        {.id = Command::page_tracks,
         .text = QT_TRANSLATE_NOOP("Command", "Trac&ks"),
         .tip = QT_TRANSLATE_NOOP("Command", "The page with the slow variables over time"),
         .keys = {QKeyCombination(Qt::CTRL, Qt::Key_1)},
         .enabled = any,
         .act = [&w] { w.pages_->showPage(Page::tracks); }},
        {.id = Command::page_signals,
         .text = QT_TRANSLATE_NOOP("Command", "Si&gnals"),
         .tip = QT_TRANSLATE_NOOP("Command",
                                  "The page with the samples, the wave fitted to them and what it "
                                  "leaves"),
         .keys = {QKeyCombination(Qt::CTRL, Qt::Key_2)},
         .enabled = any,
         .act = [&w] { w.pages_->showPage(Page::samples); }},
        {.id = Command::page_resonator,
         .text = QT_TRANSLATE_NOOP("Command", "Reso&nator"),
         .tip = QT_TRANSLATE_NOOP("Command",
                                  "The page with the resonator of a set: parameters, rim, drift"),
         .keys = {QKeyCombination(Qt::CTRL, Qt::Key_5)},
         .enabled = anything,
         .act = [&w] { w.pages_->showPage(Page::resonator); }},
        {.id = Command::page_residuals,
         .text = QT_TRANSLATE_NOOP("Command", "Resi&duals"),
         .tip = QT_TRANSLATE_NOOP("Command",
                                  "The page with spectrum, distribution and autocorrelation of "
                                  "what the waves leave of the samples"),
         .keys = {QKeyCombination(Qt::CTRL, Qt::Key_3)},
         .enabled = any,
         .act = [&w] { w.pages_->showPage(Page::residuals); }},
        {.id = Command::page_windows,
         .text = QT_TRANSLATE_NOOP("Command", "&Windows"),
         .tip = QT_TRANSLATE_NOOP("Command",
                                  "The page with scatter, bound and leakage against the length of "
                                  "the window, and the recommended window"),
         .keys = {QKeyCombination(Qt::CTRL, Qt::Key_4)},
         .enabled = any,
         .act = [&w] { w.pages_->showPage(Page::windows); }},
        {.id = Command::page_drift,
         .text = QT_TRANSLATE_NOOP("Command", "Drift of the whole angl&e"),
         .tip = QT_TRANSLATE_NOOP("Command",
                                  "The page with the drift of whole-angle logs against the angle, "
                                  "and what it and the efforts say of the resonator"),
         .keys = {QKeyCombination(Qt::CTRL, Qt::Key_6)},
         .act = [&w] { w.pages_->showPage(Page::drift); }},
        {.id = Command::page_history,
         .text = QT_TRANSLATE_NOOP("Command", "&History"),
         .tip = QT_TRANSLATE_NOOP("Command",
                                  "The page with the parameters of each gyro over all results of "
                                  "the laboratory's database"),
         .keys = {QKeyCombination(Qt::CTRL, Qt::Key_7)},
         .act = [&w] { w.pages_->showPage(Page::history); }},
        {.id = Command::zoom_in,
         .text = QT_TRANSLATE_NOOP("Command", "Zoom &in"),
         .enabled = plots,
         .act = [&w] { w.tracks_->zoomIn(); }},
        {.id = Command::zoom_out,
         .text = QT_TRANSLATE_NOOP("Command", "Zoom &out"),
         .enabled = plots,
         .act = [&w] { w.tracks_->zoomOut(); }},
        {.id = Command::zoom_fit,
         .text = QT_TRANSLATE_NOOP("Command", "&Fit"),
         .tip = QT_TRANSLATE_NOOP("Command", "Show the whole time range (double click, Home)"),
         .icon = "zoom-fit",
         .keys = {QKeyCombination(Qt::CTRL, Qt::Key_0)},
         .enabled = plots,
         .act = [&w] { w.tracks_->fit(); }},
        {.id = Command::zoom_back,
         .text = QT_TRANSLATE_NOOP("Command", "Zoom &back"),
         .tip = QT_TRANSLATE_NOOP("Command", "Back in the zoom history (R)"),
         .icon = "zoom-back",
         .keys = {QKeyCombination(Qt::ALT, Qt::Key_Left)},
         .enabled = [&w] { return w.tracks_->zoom().canBack(); },
         .act = [&w] { w.tracks_->zoom().back(); }},
        {.id = Command::zoom_forward,
         .text = QT_TRANSLATE_NOOP("Command", "Zoom fo&rward"),
         .tip = QT_TRANSLATE_NOOP("Command", "Forward in the zoom history"),
         .keys = {QKeyCombination(Qt::ALT, Qt::Key_Right)},
         .enabled = [&w] { return w.tracks_->zoom().canForward(); },
         .act = [&w] { w.tracks_->zoom().forward(); }},
        {.id = Command::sidebar,
         .text = QT_TRANSLATE_NOOP("Command", "Settings of the anal&ysis"),
         .tip = QT_TRANSLATE_NOOP(
             "Command", "The settings beside the plots; without them the plots are wider"),
         .keys = {QKeySequence(Qt::Key_F9)},
         .switched =
             [&w](bool shown) {
                 w.sidebar_wanted_ = shown;
                 w.showPanels();
             }},
        {.id = Command::wave,
         .text = QT_TRANSLATE_NOOP("Command", "Wa&ve"),
         .tip = QT_TRANSLATE_NOOP("Command",
                                  "The waves at the mouse beside the plots, as figures: the "
                                  "amplitude around the rim, D against C"),
         .keys = {QKeySequence(Qt::Key_W)},
         .switched =
             [&w](bool shown) {
                 w.wave_wanted_ = shown;
                 w.showPanels();
             }},
        {.id = Command::fitted_wave,
         .text = QT_TRANSLATE_NOOP("Command", "Fitted wave"),
         .tip = QT_TRANSLATE_NOOP("Command",
                                  "The wave of the chosen analysis over the samples of the page "
                                  "Signals: zoomed out its amplitude, zoomed in the wave itself"),
         .switched = [&w](bool shown) { w.signals_->setWave(shown); }},
        {.id = Command::sigma_bands,
         .text = QT_TRANSLATE_NOOP("Command", "One-&sigma bands"),
         .switched =
             [&w](bool on_now) {
                 DisplayUnits units = w.tracks_->units();
                 units.sigma_bands = on_now;
                 w.setUnits(units);
             }},
        {.id = Command::log_a_A,
         .text = QT_TRANSLATE_NOOP("Command", "&Log axis for a_A"),
         .switched =
             [&w](bool on_now) {
                 DisplayUnits units = w.tracks_->units();
                 units.log_a_A = on_now;
                 w.setUnits(units);
             }},
        {.id = Command::analyse,
         .text = QT_TRANSLATE_NOOP("Command", "&Analyse"),
         .tip = QT_TRANSLATE_NOOP(
             "Command",
             "Analyse the current recording with the settings of the panel and keep the analysis"),
         .icon = "run",
         .keys = {QKeySequence(Qt::Key_F5)},
         .enabled = open,
         .act = [&w] { w.settings_->analyse(); }},
        {.id = Command::live,
         .text = QT_TRANSLATE_NOOP("Command", "&Live"),
         .tip = QT_TRANSLATE_NOOP(
             "Command",
             "Every change of a setting shows at once, in an analysis that follows the panel"),
         .keys = {QKeyCombination(Qt::CTRL, Qt::Key_L)},
         .switched = [&w](bool on_now) { w.document_.setLive(on_now); }},
        {.id = Command::cancel,
         .text = QT_TRANSLATE_NOOP("Command", "&Cancel"),
         .tip = QT_TRANSLATE_NOOP("Command", "Stop the analyses that are under way"),
         .icon = "cancel",
         .keys = {QKeyCombination(Qt::SHIFT, Qt::Key_F5)},
         .enabled = [&w] { return w.document_.busy(); },
         .act = [&w] { w.status_->cancel(); }},
        {.id = Command::gyro_data,
         .text = QT_TRANSLATE_NOOP("Command", "Gyro's &data…"),
         .tip = QT_TRANSLATE_NOOP("Command",
                                  "Serial number, type, operator and comment of the session"),
         .act = [&w] { askForGyro(w.document_.dossier(), &w); }},
        {.id = Command::limits,
         .text = QT_TRANSLATE_NOOP("Command", "&Limits…"),
         .tip = QT_TRANSLATE_NOOP("Command", "What the resonator's parameters have to keep"),
         .act = [&w] { askForLimits(w.document_.dossier(), w.tracks_->units(), &w); }},
        {.id = Command::identify,
         .text = QT_TRANSLATE_NOOP("Command", "&Identify resonator"),
         .tip = QT_TRANSLATE_NOOP("Command", "Fit one resonator to all recordings of the set"),
         .keys = {QKeySequence(Qt::Key_F7)},
         .enabled = [&w] { return w.document_.sets().canIdentify(); },
         .act =
             [&w] {
                 w.pages_->showPage(Page::resonator);
                 w.document_.sets().identify();
             }},
        {.id = Command::new_set,
         .text = QT_TRANSLATE_NOOP("Command", "&New set of recordings"),
         .tip = QT_TRANSLATE_NOOP("Command",
                                  "Recordings of another resonator, to be identified together"),
         .act =
             [&w] {
                 w.document_.sets().add();
                 w.pages_->showPage(Page::resonator);
             }},
        {.id = Command::batch,
         .text = QT_TRANSLATE_NOOP("Command", "&Batch…"),
         .tip = QT_TRANSLATE_NOOP("Command",
                                  "Compute many sets of a list or folder into a table, without "
                                  "opening their recordings"),
         .keys = {QKeyCombination(Qt::CTRL, Qt::Key_B)},
         .act = [&w] { w.batch_->show(); }},
        {.id = Command::help,
         .text = QT_TRANSLATE_NOOP("Command", "&Help"),
         .tip = QT_TRANSLATE_NOOP("Command", "How to use the program, the method and its formulas"),
         .icon = "help",
         .keys = {QKeySequence(Qt::Key_F1)},
         .act = [&w] { w.showHelp(); }},
        {.id = Command::copy_diagnostics,
         .text = QT_TRANSLATE_NOOP("Command", "Copy &diagnostics"),
         .tip = QT_TRANSLATE_NOOP(
             "Command", "Versions and settings to the clipboard, for a report of a fault"),
         .act = [&w] { QApplication::clipboard()->setText(w.diagnosticsText()); }},
        {.id = Command::about,
         .text = QT_TRANSLATE_NOOP("Command", "&About Vybeg"),
         .act = [&w] { showAbout(&w, w.action(Command::copy_diagnostics)); }},
    };
}

}  // namespace vybeg::ui
