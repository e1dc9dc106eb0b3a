#pragma once

#include "ui/document/background_jobs.h"
#include "ui/document/dossier_model.h"
#include "ui/document/id_counter.h"
#include "ui/document/live_follower.h"
#include "ui/document/message.h"
#include "ui/document/recording_store.h"
#include "ui/document/request_queue.h"
#include "ui/document/run_store.h"
#include "ui/document/set_store.h"
#include "ui/document/settings_model.h"

#include <QObject>
#include <QStringList>

#include <cstdint>
#include <functional>
#include <map>
#include <optional>
#include <vector>

namespace vybeg::ui {

// The session: open recordings, the settings being edited, runs and sets, each in a store of its
// own. The document connects the stores and asks for analyses. It is the only source of change
// signals in the window: widgets call its functions, listen, and hold no state of the session.
class Document : public QObject {
    Q_OBJECT

public:
    explicit Document(QObject* parent = nullptr);

    // Recordings. Each is analysed with the present settings as soon as it is open.
    void open(const QStringList& paths, const OpenOptions& options = {});
    void reopen(int id, const OpenOptions& options);
    // Opens a recording of a session and computes its runs; returns its id.
    int restore(const QString& path, const OpenOptions& options, std::vector<RunWish> runs);
    void closeRecording(int id);  // and its runs; a step of undo, which reads the file again
    void setCurrentRecording(int id) { recordings_.setCurrent(id); }
    const std::vector<RecordingEntry>& recordings() const { return recordings_.all(); }
    const RecordingEntry* recording(int id) const { return recordings_.find(id); }
    const RecordingEntry* currentRecording() const { return recordings_.current(); }
    bool isCurrent(int recording_id) const {
        return currentRecording() && currentRecording()->id == recording_id;
    }
    std::optional<double> carrier() const { return recordings_.carrier(); }

    // Settings (settings_model.h).
    const Settings& settings() const { return settings_.settings(); }
    void setSettings(const Settings& settings, int gesture = -1);
    const Tolerance& tolerance() const { return settings_.tolerance(); }
    void setTolerance(const Tolerance& tolerance) { settings_.setTolerance(tolerance); }
    void startWith(const Settings& settings, const Tolerance& tolerance = {}) {
        settings_.startWith(settings, tolerance);
    }
    // Steps of undo: settings, tolerances, runs, sets, closed recordings.
    UndoSteps& undoSteps() { return steps_; }
    const UndoSteps& undoSteps() const { return steps_; }
    QUndoStack& undoStack() { return steps_.stack(); }
    const QUndoStack& undoStack() const { return steps_.stack(); }

    // Analyses, in the background.
    void analyse();
    void rerun(int run_id);
    void rerunSnapped(int run_id);  // with the window moved to whole half-periods
    // One run of the current recording per window length; comparisonReady() when all are done.
    void compareWindows(const std::vector<std::int64_t>& lengths);
    void setLive(bool live) { live_.setOn(live); }
    bool live() const { return live_.on(); }
    void setVisibleRange(const TimeRange& visible) { live_.setVisibleRange(visible); }
    void cancel();
    bool busy() const { return queue_.busy(); }
    double progress() const { return queue_.progress(); }
    std::optional<double> secondsLeft() const { return queue_.secondsLeft(); }

    // Runs (run_store.h).
    const std::vector<RunEntry>& runs() const { return runs_.all(); }
    const RunEntry* run(int id) const { return runs_.find(id); }
    std::vector<Run> plottedRuns() const { return runs_.plotted(live()); }
    void setRunVisible(int id, bool visible) { runs_.setVisible(id, visible); }
    void renameRun(int id, const QString& name) { runs_.rename(id, name); }
    void removeRun(int id);
    void exportTrack(int id, const QString& path, std::function<void(const Status&)> done);

    // The gyro and its limits.
    DossierModel& dossier() { return dossier_; }
    const DossierModel& dossier() const { return dossier_; }

    SetStore& sets() { return sets_; }
    const SetStore& sets() const { return sets_; }

    void report(const Message& message) { emit reported(message); }

signals:
    void recordingsChanged();       // the list
    void recordingChanged(int id);  // something became known about one
    void envelopeGrown(int id);     // it covers more
    void currentRecordingChanged();
    void settingsChanged();  // and the tolerances
    void carrierChanged();
    void liveChanged();
    void runsChanged();
    void runAdded(int id);
    void busyChanged();
    void progressChanged();
    void finished(int run_id, double seconds);
    void opened(const QString& path);
    void comparisonReady(const QList<int>& run_ids);
    void reported(const Message& message);
    void settled(Topic topic);  // messages of this topic hold no more

private:
    // A recording that was closed: read again from its file, under the id that other steps know.
    struct Closed {
        int id = 0;
        std::size_t place = 0;
        QString path;
        OpenOptions options;
        std::optional<std::vector<RunWish>> runs;  // none: those of a new recording
        std::vector<int> sets;
    };
    Closed whatCloses(int id);
    void bringBack(const Closed& closed);
    void connectStores();
    void close(int id);
    void whenOpened(int id);
    void whenSettingsChanged(const Settings& before);
    void restoreRuns(int id, const std::vector<RunWish>& runs);
    void ask(const Request& request);
    void runAgain(int recording_id, const Settings& requested);
    void whenAnalysed(int key, Result<AnalysisOutcome> result);

    BackgroundJobs job_;
    IdCounter ids_;
    UndoSteps steps_;
    SettingsModel settings_{steps_};
    DossierModel dossier_{steps_};
    RecordingStore recordings_{job_, settings_, ids_};
    RunStore runs_{job_, recordings_, ids_, steps_};
    RequestQueue queue_{job_};
    LiveFollower live_{job_, settings_, recordings_, runs_, queue_};
    SetStore sets_{job_, settings_, recordings_, queue_, ids_, steps_};
    std::map<int, std::vector<RunWish>> restored_;  // by recording, until it is open
};

}  // namespace vybeg::ui
