// The table of all commands of the window.

#include "ui/panels/ledger.h"
#include "ui/plots/plot_stack.h"
#include "ui/plots/track_view.h"
#include "ui/report/report_content.h"
#include "ui/resonator/dossier_dialogs.h"
#include "ui/settings/settings_panel.h"
#include "ui/signals/signals_page.h"
#include "ui/window/file_commands.h"
#include "ui/window/help.h"
#include "ui/window/main_window.h"
#include "ui/window/status_line.h"
#include "ui/window/tracks_page.h"

#include <QApplication>
#include <QClipboard>

#include <algorithm>

namespace vybeg::ui {

std::vector<CommandRow> WindowCommands::of(MainWindow& w) {
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
    const auto panel = [&w](auto MainWindow::*wanted) {
        return [&w, wanted](bool shown) {
            w.*wanted = shown;
            w.showPanels();
        };
    };
    const auto units = [&w](bool DisplayUnits::*member) {
        return [&w, member](bool on_now) {
            DisplayUnits shown = w.tracks_->units();
            shown.*member = on_now;
            w.setUnits(shown);
        };
    };
    // The order of the tabs gives Ctrl+1, Ctrl+2, ...
    const auto page = [&w](Page shown, const char* text, const char* tip,
                           std::function<bool()> enabled = {}) {
        const int place = static_cast<int>(shown);
        static_assert(static_cast<int>(Command::page_history) -
                          static_cast<int>(Command::page_tracks) ==
                      static_cast<int>(Page::history));
        return CommandRow{
            .id = static_cast<Command>(static_cast<int>(Command::page_tracks) + place),
            .text = text,
            .tip = tip,
            .keys = {QKeyCombination(Qt::CTRL, Qt::Key(Qt::Key_1 + place))},
            .enabled = std::move(enabled),
            .act = [&w, shown] { w.pages_->showPage(shown); }};
    };
    return {
        {.id = Command::open,
         .text = QT_TR_NOOP("&Open…"),
         .tip = QT_TR_NOOP("Open recordings of a free decay, a measurement list, or a session"),
         .icon = "open",
         .keys = {QKeySequence::Open},
         .act = [&w] { w.files_->askForRecordings(); }},
        {.id = Command::import_file,
         .text = QT_TR_NOOP("&Import…"),
         .tip = QT_TR_NOOP("Say how a file is to be read, and see at once what comes of it"),
         .keys = {QKeyCombination(Qt::CTRL | Qt::SHIFT, Qt::Key_O)},
         .act = [&w] { w.files_->askForImport(); }},
        {.id = Command::open_logs,
         .text = QT_TR_NOOP("Open &logs…"),
         .tip = QT_TR_NOOP("Open logs of a controller, a lock-in or a phasemeter in place "
                           "of recordings, and identify their resonator"),
         .keys = {QKeyCombination(Qt::CTRL | Qt::SHIFT, Qt::Key_L)},
         .act = [&w] { w.files_->askForLogs(); }},
        {.id = Command::open_database,
         .text = QT_TR_NOOP("Open &database…"),
         .tip = QT_TR_NOOP("Open a database of results, for the history of its gyros"),
         .act = [&w] { w.files_->askForDatabase(false); }},
        {.id = Command::open_whole_angle,
         .text = QT_TR_NOOP("Open w&hole-angle logs…"),
         .tip = QT_TR_NOOP("Open logs of a wave whose amplitude is held while it turns, for "
                           "its drift against the angle"),
         .act = [&w] { w.files_->askForWholeAngleLogs(); }},
        {.id = Command::close_recording,
         .text = QT_TR_NOOP("&Close recording"),
         .tip = QT_TR_NOOP("Close the current recording and its analyses"),
         .keys = {QKeyCombination(Qt::CTRL, Qt::Key_W)},
         .enabled = any,
         .act = [&w] { w.document_.closeRecording(w.document_.currentRecording()->id); }},
        {.id = Command::save_session,
         .text = QT_TR_NOOP("&Save session"),
         .tip = QT_TR_NOOP("Recordings, settings, analyses, sets and view, to go on with later"),
         .keys = {QKeyCombination(Qt::CTRL, Qt::Key_S)},
         .enabled = anything,
         .act = [&w] { w.files_->saveSession(); }},
        {.id = Command::save_session_as,
         .text = QT_TR_NOOP("S&ave session as…"),
         .keys = {QKeyCombination(Qt::CTRL | Qt::SHIFT, Qt::Key_S)},
         .enabled = anything,
         .act = [&w] { w.files_->saveSessionAs(); }},
        {.id = Command::export_plots,
         .text = QT_TR_NOOP("&Export plots…"),
         .tip = QT_TR_NOOP("Save the plots as PNG, SVG or PDF"),
         .icon = "export",
         .keys = {QKeyCombination(Qt::CTRL, Qt::Key_E)},
         .enabled = figures,
         .act = [&w] { w.files_->exportPlots(w.figures()); }},
        {.id = Command::article_figure,
         .text = QT_TR_NOOP("Article's &figure…"),
         .tip = QT_TR_NOOP("The article's figure: a column for each analysis that is shown, "
                           "with the scatter of its windows"),
         .keys = {QKeySequence(Qt::Key_F6)},
         .enabled = plots,
         .act = [&w] { w.files_->exportPlots(w.tracks_page_->articleFigure()); }},
        {.id = Command::export_track,
         .text = QT_TR_NOOP("Export &track…"),
         .tip = QT_TR_NOOP("Save the slow variables of the chosen analysis as CSV"),
         .keys = {QKeyCombination(Qt::CTRL | Qt::SHIFT, Qt::Key_E)},
         .enabled =
             [&w] {
                 const AnalysisEntry* chosen = w.document_.analysis(w.ledger_->currentAnalysis());
                 return chosen && !chosen->partial();
             },
         .act = [&w] { w.files_->askWhereToPutTrack(); }},
        {.id = Command::report,
         .text = QT_TR_NOOP("&Report…"),
         .tip = QT_TR_NOOP("A PDF of the recordings: settings, plots, resonator with its "
                           "uncertainty budget, events, warnings"),
         .icon = "report",
         .keys = {QKeySequence::Print},
         .enabled = [&w] { return !reportSubjects(w.document_).empty(); },
         .act = [&w] { w.files_->askForReport(w.pages_->page() == Page::resonator); }},
        {.id = Command::save_passport,
         .text = QT_TR_NOOP("Save &passport…"),
         .tip = QT_TR_NOOP("Save what was identified from the set as the gyro's passport"),
         .enabled =
             [&w] {
                 const RecordingSet* set = w.document_.sets().current();
                 const auto outcome = set ? w.document_.sets().outcome(*set) : nullptr;
                 return outcome && !w.document_.sets().outOfDate(*set, *outcome);
             },
         .act = [&w] { w.files_->askWhereToPutPassport(); }},
        {.id = Command::compare_passport,
         .text = QT_TR_NOOP("Compare &with passport…"),
         .tip = QT_TR_NOOP("Which parameters of the resonator have changed since its passport"),
         .act = [&w] { w.files_->askForPassport(); }},
        {.id = Command::quit,
         .text = QT_TR_NOOP("&Quit"),
         .keys = {QKeyCombination(Qt::CTRL, Qt::Key_Q)},
         .act = [&w] { w.close(); }},
        {.id = Command::undo,
         .text = QT_TR_NOOP("&Undo"),
         .tip = QT_TR_NOOP("Take back the last change of settings, analyses or sets"),
         .icon = "undo",
         .keys = {QKeyCombination(Qt::CTRL, Qt::Key_Z)},
         .enabled = [&w] { return w.document_.undoStack().canUndo(); },
         .object = [&w] { return w.document_.undoStack().undoWords(); },
         .act = [&w] { w.document_.undoStack().undo(); }},
        {.id = Command::redo,
         .text = QT_TR_NOOP("&Redo"),
         .tip = QT_TR_NOOP("Make the change again that was taken back"),
         .icon = "redo",
         .keys = {QKeyCombination(Qt::CTRL | Qt::SHIFT, Qt::Key_Z),
                  QKeyCombination(Qt::CTRL, Qt::Key_Y)},
         .enabled = [&w] { return w.document_.undoStack().canRedo(); },
         .object = [&w] { return w.document_.undoStack().redoWords(); },
         .act = [&w] { w.document_.undoStack().redo(); }},
        {.id = Command::copy_plot,
         .text = QT_TR_NOOP("&Copy plots"),
         .tip = QT_TR_NOOP("The plots as an image to the clipboard"),
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
         .text = QT_TR_NOOP("Copy &table"),
         .tip = QT_TR_NOOP("The values at the cursor to the clipboard, for a spreadsheet"),
         .keys = {QKeyCombination(Qt::CTRL | Qt::SHIFT, Qt::Key_T)},
         .enabled = plots,
         .act = [&w] { QApplication::clipboard()->setText(w.ledger_->tableText()); }},
        page(Page::tracks, QT_TR_NOOP("Trac&ks"),
             QT_TR_NOOP("The page with the slow variables over time"), any),
        page(Page::samples, QT_TR_NOOP("Si&gnals"),
             QT_TR_NOOP("The page with the samples, the wave fitted to them and the residual"),
             any),
        page(Page::residuals, QT_TR_NOOP("Resi&duals"),
             QT_TR_NOOP("The page with spectrum, distribution and autocorrelation of the "
                        "residuals of an analysis"),
             any),
        page(Page::windows, QT_TR_NOOP("&Windows"),
             QT_TR_NOOP("The page with scatter, bound and leakage against the length of the "
                        "window, and the recommended window"),
             any),
        page(Page::resonator, QT_TR_NOOP("Reso&nator"),
             QT_TR_NOOP("The page with the resonator of a set: parameters, rim, drift"), anything),
        page(Page::drift, QT_TR_NOOP("Drift of the whole angl&e"),
             QT_TR_NOOP("The page with the drift of whole-angle logs against the angle, and what "
                        "it and the efforts say of the resonator")),
        page(Page::history, QT_TR_NOOP("&History"),
             QT_TR_NOOP("The page with the parameters of each gyro over all results of the "
                        "laboratory's database")),
        {.id = Command::zoom_in,
         .text = QT_TR_NOOP("Zoom &in"),
         .enabled = plots,
         .act = [&w] { w.tracks_->zoomIn(); }},
        {.id = Command::zoom_out,
         .text = QT_TR_NOOP("Zoom &out"),
         .enabled = plots,
         .act = [&w] { w.tracks_->zoomOut(); }},
        {.id = Command::zoom_fit,
         .text = QT_TR_NOOP("&Fit"),
         .tip = QT_TR_NOOP("Show the whole time range (double click, Home)"),
         .icon = "zoom-fit",
         .keys = {QKeyCombination(Qt::CTRL, Qt::Key_0)},
         .enabled = plots,
         .act = [&w] { w.tracks_->fit(); }},
        {.id = Command::zoom_back,
         .text = QT_TR_NOOP("Zoom &back"),
         .tip = QT_TR_NOOP("Back in the zoom history (R)"),
         .icon = "zoom-back",
         .keys = {QKeyCombination(Qt::ALT, Qt::Key_Left)},
         .enabled = [&w] { return w.tracks_->zoom().canBack(); },
         .act = [&w] { w.tracks_->zoom().back(); }},
        {.id = Command::zoom_forward,
         .text = QT_TR_NOOP("Zoom fo&rward"),
         .tip = QT_TR_NOOP("Forward in the zoom history"),
         .keys = {QKeyCombination(Qt::ALT, Qt::Key_Right)},
         .enabled = [&w] { return w.tracks_->zoom().canForward(); },
         .act = [&w] { w.tracks_->zoom().forward(); }},
        {.id = Command::sidebar,
         .text = QT_TR_NOOP("Settings of the anal&ysis"),
         .tip = QT_TR_NOOP("The settings beside the plots; without them the plots are wider"),
         .keys = {QKeySequence(Qt::Key_F9)},
         .switched = panel(&MainWindow::sidebar_wanted_)},
        {.id = Command::wave,
         .text = QT_TR_NOOP("Wa&ve"),
         .tip = QT_TR_NOOP("The waves at the mouse beside the plots, as figures: the "
                           "amplitude around the rim, D against C"),
         .keys = {QKeySequence(Qt::Key_W)},
         .switched = panel(&MainWindow::wave_wanted_)},
        {.id = Command::fitted_wave,
         .text = QT_TR_NOOP("Fitted wave"),
         .tip = QT_TR_NOOP("The wave of the chosen analysis over the samples of the page "
                           "Signals: zoomed out its amplitude, zoomed in the wave itself"),
         .switched = [&w](bool shown) { w.signals_->setWave(shown); }},
        {.id = Command::sigma_bands,
         .text = QT_TR_NOOP("One-&sigma bands"),
         .switched = units(&DisplayUnits::sigma_bands)},
        {.id = Command::log_a_A,
         .text = QT_TR_NOOP("&Log axis for a_A"),
         .switched = units(&DisplayUnits::log_a_A)},
        {.id = Command::axis_limits,
         .text = QT_TR_NOOP("A&xis limits…"),
         .tip =
             QT_TR_NOOP("Limits of the value axis of the plot with the focus or under the mouse"),
         .keys = {QKeySequence(Qt::Key_L)},
         .enabled = plots,
         .act = [&w] { askForAxisLimits(*w.tracks_, &w); }},
        {.id = Command::analyse,
         .text = QT_TR_NOOP("&Keep"),
         .tip = QT_TR_NOOP(
             "Analyse the current recording with the settings of the panel and keep the analysis"),
         .icon = "run",
         .keys = {QKeySequence(Qt::Key_F5)},
         .enabled = open,
         .act = [&w] { w.settings_->analyse(); }},
        {.id = Command::live,
         .text = QT_TR_NOOP("&Live"),
         .tip = QT_TR_NOOP(
             "Every change of a setting shows at once, in an analysis that follows the panel"),
         .keys = {QKeyCombination(Qt::CTRL, Qt::Key_L)},
         .switched = [&w](bool on_now) { w.document_.setLive(on_now); }},
        {.id = Command::cancel,
         .text = QT_TR_NOOP("&Cancel"),
         .tip = QT_TR_NOOP("Stop the analyses that are under way"),
         .icon = "cancel",
         .keys = {QKeyCombination(Qt::SHIFT, Qt::Key_F5)},
         .enabled = [&w] { return w.document_.busy(); },
         .act = [&w] { w.status_->cancel(); }},
        {.id = Command::gyro_data,
         .text = QT_TR_NOOP("Gyro's &data…"),
         .tip = QT_TR_NOOP("Serial number, type, operator and comment of the session"),
         .act = [&w] { askForGyro(w.document_.dossier(), &w); }},
        {.id = Command::limits,
         .text = QT_TR_NOOP("&Limits…"),
         .tip = QT_TR_NOOP("What the resonator's parameters have to keep"),
         .act = [&w] { askForLimits(w.document_.dossier(), w.tracks_->units(), &w); }},
        {.id = Command::identify,
         .text = QT_TR_NOOP("&Identify resonator"),
         .tip = QT_TR_NOOP("Fit one resonator to all recordings of the set"),
         .keys = {QKeySequence(Qt::Key_F7)},
         .enabled = [&w] { return w.document_.sets().canIdentify(); },
         .act =
             [&w] {
                 w.pages_->showPage(Page::resonator);
                 w.document_.sets().identify();
             }},
        {.id = Command::new_set,
         .text = QT_TR_NOOP("&New set of recordings"),
         .tip = QT_TR_NOOP("Recordings of another resonator, to be identified together"),
         .act =
             [&w] {
                 w.document_.sets().add();
                 w.pages_->showPage(Page::resonator);
             }},
        {.id = Command::batch,
         .text = QT_TR_NOOP("&Batch…"),
         .tip = QT_TR_NOOP("Compute many sets of a list or folder into a table, without "
                           "opening their recordings"),
         .keys = {QKeyCombination(Qt::CTRL, Qt::Key_B)},
         .act = [&w] { w.batch_->show(); }},
        {.id = Command::help,
         .text = QT_TR_NOOP("&Help"),
         .tip = QT_TR_NOOP("How to use the program, the method and its formulas"),
         .icon = "help",
         .keys = {QKeySequence(Qt::Key_F1)},
         .act = [&w] { w.showHelp(); }},
        {.id = Command::copy_diagnostics,
         .text = QT_TR_NOOP("Copy &diagnostics"),
         .tip = QT_TR_NOOP("Versions and settings to the clipboard, for a report of a fault"),
         .act = [&w] { QApplication::clipboard()->setText(w.diagnosticsText()); }},
        {.id = Command::about,
         .text = QT_TR_NOOP("&About Vybeg"),
         .act = [&w] { showAbout(&w, w.action(Command::copy_diagnostics)); }},
    };
}

}  // namespace vybeg::ui
