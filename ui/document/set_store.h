#pragma once

#include "core/analysis/passport.h"
#include "ui/document/background_jobs.h"
#include "ui/document/edits.h"
#include "ui/document/measured_set.h"
#include "ui/document/recording_store.h"
#include "ui/values/ids.h"
#include "ui/values/recording_set.h"

#include <QObject>
#include <QString>
#include <QStringList>

#include <functional>
#include <memory>
#include <optional>
#include <vector>

namespace vybeg::ui {

// Files of the set's measurement list that are not among its recordings: not opened, or removed.
QStringList absentFiles(const RecordingSet& set);

// The same list with the row of that file for the recording `id`.
MeasurementSet withRowFor(MeasurementSet listed, const QString& path, RecordingId id);

// Sets of recordings, and the resonators identified from them. An edit of a set stops its
// identification; its older result stays, out of date.
class SetStore : public QObject {
    Q_OBJECT

public:
    SetStore(BackgroundJobs& job, const SettingsModel& settings, RecordingStore& recordings,
             RequestQueue& queue, IdCounter& ids, UndoSteps& steps);

    const std::vector<RecordingSet>& all() const { return sets_; }
    const RecordingSet* find(SetId id) const;
    const RecordingSet* current() const { return find(current_); }
    void setCurrent(SetId id);
    // Steps of undo, up to removeFrom().
    SetId add(const std::vector<RecordingId>& recording_ids = {});  // becomes the current one
    void remove(SetId id);
    void rename(SetId id, const QString& name);
    void setModel(SetId id, FitOptions::Model model);
    // No step: a file of the set's list is found again.
    void setListed(SetId id, MeasurementSet listed);
    // Sets of a session, with the ids of open recordings, after the others; none becomes the
    // current one. No step.
    void restoreSets(std::vector<RecordingSet> sets);
    // Other settings of a listed set than those of its file; a step of undo.
    void changeListed(SetId id, MeasurementSet listed);
    // Recordings into a set of recordings, each once.
    void addTo(SetId id, const std::vector<RecordingId>& recording_ids);
    // Into the current set; without one, or where that has logs, into a new one.
    void addToCurrent(const std::vector<RecordingId>& recording_ids);
    void removeFrom(SetId id, const std::vector<RecordingId>& recording_ids);
    // No step: the recording is gone.
    void removeFromAll(RecordingId recording_id);
    // The reverse, for the undo of that.
    void putInto(const std::vector<SetId>& set_ids, RecordingId recording_id);
    std::vector<SetId> holding(RecordingId recording_id) const;
    // A measurement list: its recordings, and a set for each of its sets, in one step of undo.
    // `options`: of recordings whose row gives none. Errors are reported.
    void openList(const QString& path, const OpenOptions& options);
    // The same of a list in memory; its first set becomes the current one.
    void open(const MeasurementList& list);
    // A set of logs, which it identifies with calibration and tolerances of the panel; a step of
    // undo.
    void openLogs(const MeasurementSet& set);
    // Other logs of a set of logs, or the same read otherwise; a step of undo.
    void setLogs(SetId id, const MeasurementSet& set);
    // All that belongs to the identification of a set.
    MeasurementSet measured(const RecordingSet& set) const;

    // The current set, in the background; where it is empty, the current recording as a set of one.
    void identify();
    // Precondition: all its recordings are open.
    void identifySet(SetId id);
    bool canIdentify() const;
    bool identifying(SetId id) const { return queue_.keyOfSet(id) != 0; }
    // The newest of a set: with its present recordings and settings where there is one.
    std::shared_ptr<const SavedResult> outcome(const RecordingSet& set) const;
    bool outOfDate(const RecordingSet& set, const SetResult& outcome) const;
    // Why the set as it is now has no result; null: none is known.
    const Error* refusal(const RecordingSet& set) const { return refusalOf(set, measured(set)); }
    // An outcome of the set with the name and the conditions that the set has now.
    SetResult underPresentConditions(const RecordingSet& set, const SetResult& outcome) const;

    // In the background; errors are reported. Its gyro: the one that the current set's list names,
    // otherwise that of the session.
    void savePassport(const QString& path, const GyroData& session,
                      std::function<void(const Status&)> done);
    // The warning that a passport is of another gyro than the current set.
    std::optional<Diagnostic> otherGyro(const Passport& passport, const GyroData& session) const;

signals:
    void changed();  // the sets, their recordings and outcomes
    void identified(SetId set_id);
    void opened(const QStringList& paths);  // a list, or logs
    void reported(const Message& message);

private:
    // What a step of undo brings back.
    struct State {
        std::vector<RecordingSet> sets;
        SetId current = SetId::none;
    };
    // Makes an edit a step.
    void step(UndoSteps::Words words, const std::function<void()>& edit);
    void restore(const State& state);
    // Sets of a list, in a step.
    void enter(std::vector<RecordingSet> sets, UndoSteps::Words words);
    void append(std::vector<RecordingSet> sets);
    void insertInto(SetId id, const std::vector<RecordingId>& recording_ids);
    void eraseFrom(SetId id, const std::vector<RecordingId>& recording_ids);
    RecordingSet* entry(SetId id) { return const_cast<RecordingSet*>(find(id)); }
    void edited(RecordingSet& set);
    void whenIdentified(int key, const MeasurementSet& wanted, Result<SavedResult>&& result);
    void refuse(SetId id, const MeasurementSet& wanted, const Error& error);

    BackgroundJobs& job_;
    const SettingsModel& settings_;
    RecordingStore& recordings_;
    RequestQueue& queue_;
    IdCounter& ids_;
    UndoSteps& steps_;
    std::vector<RecordingSet> sets_;
    SetId current_ = SetId::none;
    int made_ = 0;
};

}  // namespace vybeg::ui
