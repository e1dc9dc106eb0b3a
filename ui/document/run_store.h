#pragma once

#include "core/base/error.h"
#include "ui/document/background_jobs.h"
#include "ui/document/id_counter.h"
#include "ui/document/recording_store.h"
#include "ui/values/run.h"

#include <QObject>

#include <cstdint>
#include <functional>
#include <limits>
#include <map>
#include <vector>

namespace vybeg::ui {

// A run, its recording and settings, and what the background derived from its track.
struct RunEntry {
    Run run;
    int recording_id = 0;
    Settings requested;  // as asked for; run.analysis->settings is as used
    TrackSummary summary;
    std::vector<Event> events;
    bool live = false;                            // follows the settings, see LiveFollower
    int place = std::numeric_limits<int>::max();  // in the order of a session's runs

    // Has only some of its windows yet.
    bool partial() const {
        return static_cast<std::int64_t>(run.analysis->track.rows()) < run.analysis->plan.count;
    }
};

// A run that a session asks for: the settings to compute it with, and its look and place among the
// others.
struct RunWish {
    Settings settings;
    QString name;
    QColor color;
    Qt::PenStyle dash = Qt::SolidLine;
    bool visible = true;
    bool live = false;
    int place = 0;
};

// The wish that gives an equal run.
RunWish wishOf(const RunEntry& entry, int place);

// The runs of the open recordings, with names, colours and dashes of their own.
class RunStore : public QObject {
    Q_OBJECT

public:
    RunStore(BackgroundJobs& job, const RecordingStore& recordings, IdCounter& ids,
             UndoSteps& steps, QObject* parent = nullptr);

    const std::vector<RunEntry>& all() const { return runs_; }
    const RunEntry* find(int id) const;
    const RunEntry* liveOf(int recording_id) const;
    // In the order of drawing: with `live_on_top` the live runs last.
    std::vector<Run> plotted(bool live_on_top) const;

    // Returns the run's id. A run of the same recording and settings gets the new outcome.
    int show(int recording_id, const Settings& requested, AnalysisOutcome outcome);
    // The same for the live run of a recording.
    int showLive(int recording_id, const Settings& requested, AnalysisOutcome outcome);
    // The next run of that recording with these settings gets the look and place of the wish.
    void expect(int recording_id, const RunWish& wish);
    // Steps of undo.
    void setVisible(int id, bool visible);
    void rename(int id, const QString& name);
    void remove(int id);
    // From now on every run keeps its place, also among those that come back.
    void keepPlaces();
    void removeOf(int recording_id);

    // Track CSV in the background; `done` gets the result. A partial run is not written.
    void exportTrack(int id, const QString& path, std::function<void(const Status&)> done);

signals:
    void changed();
    void added(int id);

private:
    void change(int id, const std::function<void(Run&)>& edit);
    void putBack(const RunEntry& entry, std::size_t place);
    void takeOut(int id);
    // `wish`: its style, where no other run has it.
    RunEntry newRun(const RecordingEntry& recording, const QString& name, int wish = 0);
    int styleWish(int recording_id) const;
    RunEntry& add(RunEntry entry);
    RunEntry& addLive(int recording_id);
    // The run that is expected, in its place; null where none is.
    RunEntry* addExpected(int recording_id, const Settings& requested, bool live);

    BackgroundJobs& job_;
    const RecordingStore& recordings_;
    IdCounter& ids_;
    UndoSteps& steps_;
    std::vector<RunEntry> runs_;
    std::multimap<int, RunWish> expected_;  // by recording
};

}  // namespace vybeg::ui
