#pragma once

#include "ui/document/background_jobs.h"
#include "ui/document/recording_store.h"
#include "ui/values/ids.h"
#include "ui/values/shown_analysis.h"
#include "ui/widgets/theme.h"

#include <QJsonObject>
#include <QObject>

#include <cstddef>
#include <cstdint>
#include <functional>
#include <limits>
#include <map>
#include <optional>
#include <vector>

namespace vybeg::ui {

// An analysis, its recording and settings, and what the background derived from its track. Of a
// closed recording without its outcome: what brings it back with its look and place.
struct AnalysisEntry {
    ShownAnalysis shown;
    RecordingId recording_id = RecordingId::none;
    Settings requested;  // as asked for; shown.analysis->settings is as used
    TrackSummary summary;
    std::vector<Event> events;
    bool live = false;                            // follows the settings, see Document::setLive()
    int place = std::numeric_limits<int>::max();  // in the order of a session's analyses

    void take(AnalysisOutcome outcome);
    // Has only some of its windows yet.
    bool partial() const {
        return static_cast<std::int64_t>(shown.analysis->track.rows()) < shown.analysis->plan.count;
    }
};

// A recording's analysis without name, colour and outcome.
ShownAnalysis shownOf(const Recording& recording);

// A recording that is not open, with all that brings it back as it was: of a session, closed, or
// not found.
struct ClosedRecording {
    RecordingId id = RecordingId::none;
    std::size_t place = 0;  // in the list
    QString path;           // absolute
    QString sha256;         // empty: not known yet
    OpenOptions options;
    std::optional<std::vector<AnalysisEntry>> analyses;  // none: those of a new recording
    std::vector<SetId> sets;                             // that hold it
    QJsonObject unknown;  // keys in its session that this program does not know, written again
};

// An open recording as what brings it back with equal analyses.
ClosedRecording asClosed(const RecordingEntry& entry, const std::vector<AnalysisEntry>& analyses);

// The analyses of the open recordings, with names of their own, in the colours of their recordings.
class AnalysisStore : public QObject {
    Q_OBJECT

public:
    AnalysisStore(BackgroundJobs& job, const RecordingStore& recordings, IdCounter& ids,
                  UndoSteps& steps)
        : job_(job), recordings_(recordings), ids_(ids), steps_(steps) {}

    const std::vector<AnalysisEntry>& all() const { return analyses_; }
    const AnalysisEntry* find(AnalysisId id) const;
    // In the order of drawing: with `live_on_top` the live analyses last.
    std::vector<ShownAnalysis> plotted(bool live_on_top) const;

    // Returns the analysis's id. An analysis of the same recording and settings, or the live one of
    // the recording, gets the new outcome.
    AnalysisId show(RecordingId recording_id, const Settings& requested, AnalysisOutcome outcome,
                    bool live);
    // The next analysis of that recording with these settings gets the look and place of the wish.
    void expect(RecordingId recording_id, const AnalysisEntry& wish) {
        expected_.emplace(recording_id, wish);
    }
    // Steps of undo.
    void setVisible(AnalysisId id, bool visible);
    void rename(AnalysisId id, const QString& name);
    void remove(AnalysisId id);
    // From now on every analysis keeps its place, also among those that come back.
    void keepPlaces();
    void removeOf(RecordingId recording_id);

    // Track CSV in the background; `done` gets the result. A partial analysis is not written.
    void exportTrack(AnalysisId id, const QString& path, std::function<void(const Status&)> done);

signals:
    void changed();
    void added(AnalysisId id);

private:
    template <class Value>
    void change(AnalysisId id, Value ShownAnalysis::*member, const Value& value);
    void putBack(const AnalysisEntry& entry, std::size_t place);
    void takeOut(AnalysisId id);
    AnalysisEntry newAnalysis(const RecordingEntry& recording, const QString& name);
    // The colour of the recording's analyses, in a shade that none of that colour has.
    CurveStyle freeStyle(RecordingId recording_id) const;
    AnalysisEntry& add(AnalysisEntry entry);
    // The analysis that is expected, in its place; null where none is.
    AnalysisEntry* addExpected(RecordingId recording_id, const Settings& requested, bool live);

    BackgroundJobs& job_;
    const RecordingStore& recordings_;
    IdCounter& ids_;
    UndoSteps& steps_;
    std::vector<AnalysisEntry> analyses_;
    std::multimap<RecordingId, AnalysisEntry> expected_;  // by recording
};

}  // namespace vybeg::ui
