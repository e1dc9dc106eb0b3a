#pragma once

#include "core/analysis/measurement_list.h"
#include "ui/batch/batch_form.h"
#include "ui/document/document.h"
#include "ui/history/history_export.h"
#include "ui/plots/plot_file.h"
#include "ui/report/report_document.h"
#include "ui/values/ids.h"
#include "ui/words/display_units.h"

#include <QObject>
#include <QPointer>

#include <functional>
#include <initializer_list>
#include <string_view>

namespace vybeg::ui {

class BatchWindow;
class FileQuestions;
class ImportDialog;
class Ledger;
class LogDialog;
class SessionKeeper;
class TrackView;

// Everything that goes in or out of the window by a question: importing, logs, exporting, passports
// and the comparison of windows. Failures go to the message bar.
class FileCommands : public QObject {
    Q_OBJECT

public:
    FileCommands(Document& document, SessionKeeper& session, TrackView& tracks, Ledger& ledger,
                 QWidget* window);

    // Recordings, measurement lists and sessions. Before a session takes the place of one with
    // changes, it asks.
    void open(const QStringList& paths, const OpenOptions& options = {});
    // Two files of which the first has one channel are one recording, which the import dialog
    // shows.
    void openTogether(const QStringList& paths);
    // A simulated recording.
    void openDemonstration();
    void saveSession(const std::function<void()>& then = [] {});
    void saveSessionAs(const std::function<void()>& then = [] {});
    // Goes on at once where nothing is lost, else after the answer of the engineer.
    void askToSaveAndThen(const std::function<void()>& then);

    void askForRecordings();
    void askForImport();
    void askForLogs();
    void askForPassport();
    // A database of results, or where to make one; ends in databaseChosen().
    void askForDatabase(bool make);
    void askForWholeAngleLogs();
    void askWhereToPutTrack();
    void askWhereToPutDrift();
    void askWhereToPutPassport();
    void openImport(const QString& path, const OpenOptions& options);
    // By a dialog, which takes the logs of several calls while it is open: one set.
    void openLogs(const QStringList& paths) { editLogs(SetId::none, paths); }
    // The logs of a set, with further ones; without a set a new one.
    void editLogs(SetId id, const QStringList& further);

    // By the ending of the path.
    void exportTrackTo(const QString& path);
    void exportDriftTo(const QString& path);
    void savePassportTo(const QString& path);
    // By a dialog: plots, size, caption.
    void exportPlots(const FigureSource& source);
    void exportPlot(const Figure& figure);
    // The page History, as a table or, where the path ends in .pdf, as a report.
    void exportHistory(const HistoryExport& all);
    void exportHistoryTo(const QString& path, const HistoryExport& all);
    // By a dialog: subject, title block, plots. Written in the background.
    // Of the current recording, or of the current set.
    void askForReport(bool of_set);
    // Several contents are chapters; `about` says of what.
    void writeReport(const std::vector<ReportContent>& contents, const QString& about,
                     const QString& path);
    // By the ending of the path; says so in the window.
    bool writeFigure(const Figure& figure, const Paper& paper, const QString& path);

signals:
    // `make`: where there is none.
    void databaseChosen(const QString& path, bool make);

private:
    // Before the session's file loses what another program wrote into it.
    void askToReplaceAndThen(const std::function<void()>& then);
    // What `write` does, unless it would take the place of an open recording or log, or the path's
    // ending is none of these ("": it may have none; no endings: `write` looks at it).
    using Done = std::function<void(const Status&)>;
    void put(const QString& path, std::initializer_list<std::string_view> endings,
             const std::function<void(const Done&)>& write);

    Document& document_;
    SessionKeeper& session_;
    TrackView& tracks_;
    Ledger& ledger_;
    FileQuestions& ask_;
    QWidget* window_;
    BackgroundJobs imports_;  // previews of the dialogs for files; the demonstration
    QPointer<ImportDialog> import_;
    QPointer<LogDialog> logs_;
    ReportWriter reports_;
};

// The window of a batch, its questions for files, and its way back: a set that is opened from its
// table.
class BatchCommands : public QObject {
    Q_OBJECT

public:
    BatchCommands(Document& document, QWidget* window);

    // Shows the window of the batch, which is made once.
    void show();
    void setUnits(const DisplayUnits& units);
    // The program ends.
    void leave();

signals:
    void setOpened();
    void helpWanted();

private:
    void ask(FileQuestions& questions, BatchPath which);
    void openSet(const MeasurementList& list);

    Document& document_;
    QWidget* window_;
    DisplayUnits units_;
    QPointer<BatchWindow> batch_;
};

}  // namespace vybeg::ui
