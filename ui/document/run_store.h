#pragma once

#include "core/base/error.h"
#include "ui/document/analysis_job.h"
#include "ui/document/id_counter.h"
#include "ui/document/recording_store.h"
#include "ui/values/run.h"

#include <QObject>

#include <cstdint>
#include <functional>
#include <vector>

namespace vybeg::ui {

// A run, its recording and settings, and what the background derived from its track.
struct RunEntry {
    Run run;
    int recording_id = 0;
    Settings requested;  // as asked for; run.analysis->settings is as used
    TrackSummary summary;
    std::vector<Event> events;
    bool live = false;  // follows the settings, see LiveFollower

    // Has only some of its windows yet.
    bool partial() const {
        return static_cast<std::int64_t>(run.analysis->track.rows()) < run.analysis->plan.count;
    }
};

// The runs of the open recordings, with names, colours and dashes of their own.
class RunStore : public QObject {
    Q_OBJECT

public:
    RunStore(AnalysisJob& job, const RecordingStore& recordings, IdCounter& ids,
             QObject* parent = nullptr);

    const std::vector<RunEntry>& all() const { return runs_; }
    const RunEntry* find(int id) const;
    const RunEntry* liveOf(int recording_id) const;
    // In the order of drawing: with `live_on_top` the live runs last.
    std::vector<Run> plotted(bool live_on_top) const;

    // Returns the run's id. A run of the same recording and settings gets the new outcome.
    int show(int recording_id, const Settings& requested, AnalysisOutcome outcome);
    // The same for the live run of a recording.
    int showLive(int recording_id, const Settings& requested, AnalysisOutcome outcome);
    void setVisible(int id, bool visible);
    void rename(int id, const QString& name);
    void remove(int id);
    void removeOf(int recording_id);

    // Track CSV in the background; `done` gets the result. A partial run is not written.
    void exportTrack(int id, const QString& path, std::function<void(const Status&)> done);

signals:
    void changed();
    void added(int id);

private:
    // `wish`: its style, where no other run has it.
    RunEntry newRun(const RecordingEntry& recording, const QString& name, int wish = 0);
    RunEntry& addLive(int recording_id);

    AnalysisJob& job_;
    const RecordingStore& recordings_;
    IdCounter& ids_;
    std::vector<RunEntry> runs_;
};

}  // namespace vybeg::ui
