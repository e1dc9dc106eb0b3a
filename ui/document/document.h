#pragma once

#include "ui/document/analysis_store.h"
#include "ui/document/background_jobs.h"
#include "ui/document/drift_store.h"
#include "ui/document/edits.h"
#include "ui/document/message.h"
#include "ui/document/passport_store.h"
#include "ui/document/recording_store.h"
#include "ui/document/set_store.h"
#include "ui/values/ids.h"

#include <QObject>
#include <QStringList>

#include <functional>
#include <map>
#include <optional>
#include <utility>
#include <vector>

namespace vybeg::ui {

// The session: open recordings, the settings being edited, analyses, sets, whole-angle logs and the
// passport, each in a store of its own. The document connects the stores and asks for analyses. It
// is the only source of change signals in the window: widgets call its functions, listen, and hold
// no state of the session.
class Document : public QObject {
    Q_OBJECT

public:
    Document();

    // Recordings. Each is analysed with the present settings as soon as it is open.
    void open(const QStringList& paths, const OpenOptions& options = {}) {
        recordings_.open(paths, options);
    }
    void reopen(RecordingId id, const OpenOptions& options);
    // Opens a recording of a session, under an id of its own, and computes its analyses; returns
    // its id.
    RecordingId restore(const ClosedRecording& recording);
    void closeRecording(
        RecordingId id);  // and its analyses; a step of undo, which reads the file again
    void setCurrentRecording(RecordingId id) { recordings_.setCurrent(id); }
    const std::vector<RecordingEntry>& recordings() const { return recordings_.all(); }
    const RecordingEntry* recording(RecordingId id) const { return recordings_.find(id); }
    const RecordingEntry* currentRecording() const { return recordings_.current(); }
    bool isCurrent(RecordingId recording_id) const {
        return currentRecording() && currentRecording()->id == recording_id;
    }
    std::optional<double> carrier() const { return recordings_.carrier(); }

    // Settings (edits.h).
    const Settings& settings() const { return settings_.settings(); }
    void setSettings(const Settings& settings, int gesture = -1) {
        settings_.setSettings(settings, gesture);
    }
    const Tolerance& tolerance() const { return settings_.tolerance(); }
    void setTolerance(const Tolerance& tolerance) { settings_.setTolerance(tolerance); }
    void startWith(const Settings& settings, const Tolerance& tolerance = {}) {
        settings_.startWith(settings, tolerance);
    }
    // Steps of undo: settings, tolerances, analyses, sets, closed recordings, whole-angle logs,
    // passport.
    UndoSteps& undoStack() { return steps_; }
    const UndoSteps& undoStack() const { return steps_; }

    // Analyses, in the background.
    void analyse();
    // `snapped`: with the window moved to whole half-periods.
    void analyseAgain(AnalysisId analysis_id, bool snapped = false);
    // Live: each recording has an analysis that follows the settings, with its name and colour, as
    // soon as they change while the recording is the current one: first the visible range, then the
    // rest; the newest settings win. Analyses of analyse() stay as they are. After switching off,
    // running computations finish.
    void setLive(bool live);
    bool live() const { return live_; }
    // Time range of the plots.
    void setVisibleRange(const TimeRange& visible) { visible_ = visible; }
    void cancel() { job_.cancelAnalyses(); }
    bool busy() const { return queue_.busy(); }
    // Whether any job is under way: analyses, reading, checks or writing.
    bool working() const { return queue_.busy() || job_.busy(); }
    double progress() const { return queue_.progress(); }
    std::optional<double> secondsLeft() const { return queue_.secondsLeft(); }

    // Analyses (analysis_store.h).
    const std::vector<AnalysisEntry>& analyses() const { return analyses_.all(); }
    const AnalysisEntry* analysis(AnalysisId id) const { return analyses_.find(id); }
    std::vector<ShownAnalysis> plottedAnalyses() const { return analyses_.plotted(live()); }
    void setAnalysisVisible(AnalysisId id, bool visible) { analyses_.setVisible(id, visible); }
    void renameAnalysis(AnalysisId id, const QString& name) { analyses_.rename(id, name); }
    void removeAnalysis(AnalysisId id);
    void exportTrack(AnalysisId id, const QString& path, std::function<void(const Status&)> done) {
        analyses_.exportTrack(id, path, std::move(done));
    }

    // The gyro and its limits.
    DossierModel& dossier() { return dossier_; }
    const DossierModel& dossier() const { return dossier_; }

    // Files from outside into the current set, once they are open: one that is no recording leaves
    // the set as it is. Those for a set of logs are asked about.
    void openIntoSet(const QStringList& paths);
    // What the logs of a set are, with further ones.
    void askForLogs(SetId id, const QStringList& further = {}) { emit logsWanted(id, further); }
    SetStore& sets() { return sets_; }
    const SetStore& sets() const { return sets_; }

    // Whole-angle logs.
    DriftStore& drift() { return drift_; }
    const DriftStore& drift() const { return drift_; }

    // What the results of the sets are compared with.
    PassportStore& passport() { return passport_; }
    const PassportStore& passport() const { return passport_; }

    void report(const Message& message) { emit reported(message); }

signals:
    void recordingsChanged();               // the list
    void recordingChanged(RecordingId id);  // something became known about one
    void envelopeGrown(RecordingId id);     // it covers more
    void currentRecordingChanged();
    void settingsChanged();  // and the tolerances
    void carrierChanged();
    void liveChanged();
    void analysesChanged();
    void analysisAdded(AnalysisId id);
    void busyChanged();
    void progressChanged();
    void finished(AnalysisId analysis_id, double seconds);
    void opened(const QString& path);
    void foundLog(const QString& path);  // a file that was to be opened as a recording
    void importWanted(const QString& path, const OpenOptions& options);  // with other options
    void logsWanted(SetId id, const QStringList& further);
    void reported(const Message& message);
    void settled(Topic topic);  // messages of this topic hold no more

private:
    ClosedRecording whatCloses(RecordingId id);
    // Reads it again from its file, under the id that other steps know.
    void bringBack(const ClosedRecording& closed);
    void close(RecordingId id);
    // The whole-angle logs among what was opened at once, when all of it is read: one step, in the
    // order in which it was chosen.
    void openAngleLogs(int together);
    // Those of each openIntoSet(), in one step, when none of them is still being opened.
    void takeArrived();
    void whenOpened(RecordingId id);
    void whenSettingsChanged(const Settings& before);
    void ask(const Request& request);
    // Live, of a recording: with these settings, or where it does not show the present ones yet.
    void follow(RecordingId recording_id, const Settings& wanted);
    void catchUp(RecordingId recording_id);
    AnalysisId show(const Request& request, AnalysisOutcome outcome);
    void whenAnalysed(int key, Result<AnalysisOutcome> result);

    BackgroundJobs job_;
    IdCounter ids_;
    UndoSteps steps_;
    SettingsModel settings_{steps_};
    DossierModel dossier_{steps_};
    RecordingStore recordings_{job_, settings_, ids_};
    AnalysisStore analyses_{job_, recordings_, ids_, steps_};
    RequestQueue queue_{job_};
    SetStore sets_{job_, settings_, recordings_, queue_, ids_, steps_};
    DriftStore drift_{job_, steps_};
    PassportStore passport_{job_, steps_};
    bool live_ = false;
    TimeRange visible_;
    std::map<RecordingId, std::vector<AnalysisEntry>> restored_;  // by recording, until it is open
    struct Arriving {
        SetId into = SetId::none;
        std::vector<RecordingId> ids;
    };
    std::vector<Arriving> arriving_;
    // By what was opened at once and by place in that, until all of it is read.
    std::map<int, std::map<RecordingId, QString>> angle_logs_;
};

}  // namespace vybeg::ui
