#pragma once

#include "ui/document/analysis_job.h"
#include "ui/values/run.h"
#include "ui/values/run_set.h"

#include <QElapsedTimer>
#include <QObject>
#include <QStringList>
#include <QUndoStack>

#include <cstdint>
#include <functional>
#include <map>
#include <memory>
#include <optional>
#include <vector>

namespace vybeg::ui {

// A recording in the window's list. `recording` is empty while the file is being opened; where that
// takes long it has an envelope already.
struct RecordingEntry {
    int id = 0;
    QString path;
    QString name;
    OpenOptions options;
    std::optional<Recording> recording;
    std::optional<double> f0_hz;                 // once the search has found it
    std::optional<Settings> f0_search;           // with these settings
    Calibration f0_calibration;                  // of that search, offsets found
    QString sha256;                              // once it is computed
    std::shared_ptr<const Envelope> envelope;    // as far as it has been read, or looked at
    double envelope_rate_hz = 0;                 // frames of the envelope in a second
    std::shared_ptr<const SampleFaults> faults;  // once the recording check is through
};

// A run, where it comes from, and what was made of it in the background.
struct RunEntry {
    Run run;
    int recording_id = 0;
    Settings requested;  // as asked for; run.analysis->settings is as used
    TrackSummary summary;
    std::vector<Event> events;
    bool live = false;  // follows the settings, see Document::setLive()

    // Has only some of its windows yet.
    bool partial() const {
        return static_cast<std::int64_t>(run.analysis->track.rows()) < run.analysis->plan.count;
    }
};

enum class Severity { info, warning, error };

// Of messages with a topic the newest takes the place of the one before, and all of them go when
// there is nothing to tell any more.
enum class Topic { none, live };

// What the window tells the engineer. The text is a function, so that a change of language reaches
// what is already on the screen.
struct Message {
    Severity severity = Severity::info;
    std::function<QString()> text;
    // A file that could be opened if the engineer said how (rate, channels, raw layout).
    QString reopen_path;
    OpenOptions reopen_options;
    Topic topic = Topic::none;
};

// Open recordings, the settings being edited, and the runs: the only source of change signals in
// the window. Widgets change it through these functions and listen; nobody else holds state.
class Document : public QObject {
    Q_OBJECT

public:
    explicit Document(QObject* parent = nullptr);

    // Recordings. Each is analysed with the current settings as soon as it is open.
    void open(const QStringList& paths, const OpenOptions& options = {});
    void reopen(int id, const OpenOptions& options);
    void closeRecording(int id);  // its runs go with it
    void setCurrentRecording(int id);
    const std::vector<RecordingEntry>& recordings() const { return recordings_; }
    const RecordingEntry* recording(int id) const;
    const RecordingEntry* currentRecording() const { return recording(current_); }

    // Settings, with undo and redo. Changes with the same gesture (>= 0) in a row, a drag, are one
    // step.
    const Settings& settings() const { return settings_; }
    void setSettings(const Settings& settings, int gesture = -1);
    // How well the channels are known, a part of the identification alone; with undo and redo.
    const Tolerance& tolerance() const { return tolerance_; }
    void setTolerance(const Tolerance& tolerance);
    // What the program was started with: no undo step.
    void startWith(const Settings& settings);
    QUndoStack& undoStack() { return undo_; }
    // The carrier that windows are counted in: typed, else found in the current recording.
    std::optional<double> carrier() const;

    // Analyses, in the background.
    void analyse();
    void rerun(int run_id);
    void rerunSnapped(int run_id);  // with the window moved to whole half-periods
    // One run of the current recording per window length; comparisonReady() when all are done.
    void compareWindows(const std::vector<std::int64_t>& lengths);
    // Live: each recording has a run that follows the settings, with its name and colour, as soon
    // as they change while the recording is the current one: first where the plots show it, then
    // the rest; the newest settings win. Runs that analyse() makes are kept as they are. Switched
    // off, what computes comes to its end.
    void setLive(bool live);
    bool live() const { return live_; }
    // What the plots show.
    void setVisibleRange(const TimeRange& visible) { visible_ = visible; }
    void cancel();
    bool busy() const { return !requests_.empty(); }
    double progress() const;
    std::optional<double> secondsLeft() const;

    // Runs.
    const std::vector<RunEntry>& runs() const { return runs_; }
    const RunEntry* run(int id) const;
    // In the order of drawing: what follows the settings lies on top of what was kept.
    std::vector<Run> plottedRuns() const;
    void setRunVisible(int id, bool visible);
    void renameRun(int id, const QString& name);
    void removeRun(int id);
    // Track CSV in the background; `done` hears how it went. A partial run is not written.
    void exportTrack(int id, const QString& path, std::function<void(const Status&)> done);

    // Sets of runs, and what was identified from them (document_sets.cpp). An edit of a set stops
    // its identification; what was found before stays, out of date.
    const std::vector<RunSet>& sets() const { return sets_; }
    const RunSet* set(int id) const;
    const RunSet* currentSet() const { return set(current_set_); }
    void setCurrentSet(int id);
    int addSet(const std::vector<int>& recording_ids = {});  // becomes the current one
    void removeSet(int id);
    void renameSet(int id, const QString& name);
    void setModel(int id, FitOptions::Model model);
    // To the current set; the first one is made where there is none. Already there: no matter.
    void addToSet(const std::vector<int>& recording_ids);
    void removeFromSet(int id, const std::vector<int>& recording_ids);
    // Files from outside: those that are open already are added, the others opened and added.
    void openIntoSet(const QStringList& paths);
    // The current set, in the background; where it is empty, the current recording as a set of one.
    void identify();
    bool canIdentify() const;
    // The newest of a set: with its recordings and settings as they are now, if there is one.
    std::shared_ptr<const ResonatorOutcome> outcome(const RunSet& set) const;
    bool outOfDate(const RunSet& set, const ResonatorOutcome& outcome) const;

    // Passports. They are written and read in the background; errors are reported.
    void savePassport(const QString& path, std::function<void(const Status&)> done);
    void openPassport(const QString& path);
    void closePassport();
    // What counts as a change of the frequency, ppm.
    void setFrequencyLimit(double ppm);
    double frequencyLimit() const { return compare_.f_limit_ppm; }
    const OpenPassport* passport() const { return passport_ ? &*passport_ : nullptr; }
    // Of the current set's outcome from the passport; empty where one of them is missing.
    std::vector<Difference> differences() const;

    void report(const Message& message) { emit reported(message); }
    void reportError(const Error& error);

signals:
    void recordingsChanged();       // the list
    void recordingChanged(int id);  // something became known about one
    void envelopeGrown(int id);     // there is more of it to see
    void currentRecordingChanged();
    void settingsChanged();
    void carrierChanged();
    void liveChanged();
    void runsChanged();
    void runAdded(int id);
    void setsChanged();      // the sets, their recordings and what was found
    void passportChanged();  // what sets are compared with
    void identified(int set_id);
    void busyChanged();
    void progressChanged();
    void finished(int run_id, double seconds);
    void opened(const QString& path);
    void comparisonReady(const QList<int>& run_ids);
    void reported(const Message& message);
    void settled(Topic topic);  // what was reported about it holds no more

private:
    struct Request {
        int recording_id = 0;
        Settings settings;
        int batch = 0;  // 0: a run of its own
        bool live = false;
        int set_id = 0;  // not 0: an identification
    };

    RecordingEntry* find(int id);
    void whenLookedAt(int id, const FirstLook& look);
    void whenOpened(int id, Result<Recording> result);
    void searchCarrier(int id);
    void checkSamples(int id);
    void readEnvelope(int id);
    void hashFile(int id);
    void ask(int recording_id, const Settings& settings, int batch);
    void runAgain(int recording_id, const Settings& requested);
    void enter(int key, const Request& request);
    static void showOutcome(RunEntry& entry, const Settings& requested, AnalysisOutcome outcome);
    // `wish`: its style, where no other run has it.
    RunEntry newRun(const RecordingEntry& recording, const QString& name, int wish = 0);
    // document_live.cpp
    void follow(int recording_id);
    void catchUp(int recording_id);
    void showLive(int recording_id, const Settings& requested, AnalysisOutcome outcome);
    RunEntry& addLive(int recording_id);
    void whenLive(int recording_id, Result<AnalysisOutcome> result);
    void forgetLive(int recording_id);
    RunEntry* liveRun(int recording_id);
    static Settings withKnownCarrier(const RecordingEntry& entry, Settings settings);
    void learnCarrier(int recording_id, const Settings& requested, const Settings& used);
    // document_sets.cpp
    RunSet* findSet(int id);
    IdentifySettings settingsOf(const RunSet& set) const;
    void edited(RunSet& set);
    void forgetIdentification(int set_id);
    void forgetInSets(int recording_id);
    void whenIdentified(int key, Result<ResonatorOutcome> result);
    void whenAnalysed(int key, Result<AnalysisOutcome> result);
    int addRun(const Request& request, AnalysisOutcome outcome);
    void apply(const Settings& settings);
    void apply(const Tolerance& tolerance);
    void requestDone(int key);

    AnalysisJob job_;
    QUndoStack undo_;
    std::vector<RecordingEntry> recordings_;
    std::vector<RunEntry> runs_;
    Settings settings_;
    Tolerance tolerance_;
    int current_ = 0;
    int last_id_ = 0;
    std::map<int, Request> requests_;  // by key, in the order of asking
    std::map<int, QList<int>> batches_;
    int requests_asked_ = 0;  // since the window was last idle
    double fraction_ = 0;     // of the analysis that computes now
    QElapsedTimer busy_since_;
    bool live_ = false;
    TimeRange visible_;
    std::vector<RunSet> sets_;
    int current_set_ = 0;
    int sets_made_ = 0;
    std::optional<OpenPassport> passport_;
    CompareOptions compare_;

    friend class SettingsCommand;
    friend class ToleranceCommand;
};

}  // namespace vybeg::ui
