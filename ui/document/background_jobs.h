#pragma once

#include "core/analysis/analyse.h"
#include "core/analysis/analysis.h"
#include "core/analysis/settings.h"
#include "core/base/error.h"
#include "core/batch/identify_set.h"
#include "core/recording/envelope/envelope.h"
#include "core/recording/open/preview.h"
#include "core/recording/samples/open_options.h"
#include "core/recording/samples/recording.h"
#include "core/track/events.h"
#include "core/track/track_summary.h"
#include "ui/values/curve_data.h"
#include "ui/values/ids.h"
#include "ui/values/recording_set.h"

#include <QElapsedTimer>
#include <QObject>
#include <QString>
#include <QThreadPool>

#include <exception>
#include <functional>
#include <map>
#include <memory>
#include <optional>
#include <stop_token>
#include <utility>
#include <vector>

namespace vybeg::ui {

// What an analysis gives the window: the track, its curves, what one line says about it, and its
// events. Made in the background, so that nothing is left to compute where the window draws.
struct AnalysisOutcome {
    std::shared_ptr<const Analysis> analysis;
    Curves curves;
    TrackSummary summary;
    std::vector<Event> events;
};

AnalysisOutcome outcomeOf(Analysis found);

// What a job does in the background, and what gets its result in the window's thread.
template <class Value>
using Work = std::function<Result<Value>(const JobControl&)>;
template <class Value>
using Done = std::function<void(Result<Value>)>;

// The only file of ui/ with threads. Every job works in the background on values and returns its
// result by value to the thread of this object; `done` is called there. Jobs are distinguished by
// kind and key: a new job of the same kind and key stops the one before it, and whatever that still
// delivers is dropped by its generation number. Analyses run one after the other, each on all
// processors; everything else runs beside them, live analyses too: nobody waits for a long run with
// a spin box in hand. Large parts of a result (samples, track, curves, envelope) are also freed in
// the background, whoever lets go of it last.
class BackgroundJobs : public QObject {
    Q_OBJECT

public:
    enum class Kind {
        open,
        envelope,
        hash,
        carrier,
        check,
        analysis,
        live,
        identification,
        page,
        write
    };

    BackgroundJobs();
    // Stops every job and waits until the last has heard it.
    ~BackgroundJobs() override;

    // `looked` gets what can be seen of a file whose opening takes long, before it is open.
    void open(int key, const QString& path, const OpenOptions& options,
              std::function<void(const QuickOverview&)> looked, Done<Recording> done);
    // `grown` gets pictures of the envelope while it grows, some ten a second.
    void buildEnvelope(int key, const Recording& recording, EnvelopeSink grown,
                       Done<std::shared_ptr<const Envelope>> done);
    void analyse(int key, const Recording& recording, const Settings& settings,
                 Done<AnalysisOutcome> done);
    // The same for a setting that is still being changed: `early` first gets a part of
    // a long one, some windows of all and then all of the visible (analyse_visible_first()).
    void analyseLive(int key, const Recording& recording, const Settings& settings,
                     const TimeRange& visible, std::function<void(AnalysisOutcome)> early,
                     Done<AnalysisOutcome> done);

    // One resonator for all recordings.
    void identify(int key, OpenSet open, Done<SavedResult> done);
    // Makes a file.
    void write(int key, std::function<Status(const JobControl&)> work,
               std::function<void(Status)> done);
    // Any other work: on values of its own, and it ends when its JobControl is cancelled.
    template <class Value>
    void run(Kind kind, int key, Work<Value> work, Done<Value> done) {
        start<Result<Value>>(
            others_, {kind, key},
            [work = std::move(work)](const Ticket& ticket) {
                return work(JobControl(ticket.stop));
            },
            std::move(done));
    }
    // The same for a page or a store, one work for each key; reports the progress.
    template <class Value>
    void run(int key, Work<Value> work, Done<Value> done) {
        start<Result<Value>>(
            others_, {Kind::page, key},
            [this, key, work = std::move(work)](const Ticket& ticket) {
                return work(reporting(key, ticket.stop));
            },
            std::move(done));
    }

    // Whether a job is under way or its result is still to be delivered.
    bool busy() const { return !tasks_.empty(); }
    // Waits until every job has ended and its result is delivered.
    void finish();
    // Stops all jobs about a key without a result.
    void forget(int key);
    void forgetLive(int key);
    // Stops all analyses, live ones and identifications too; each delivers ErrorCode::interrupted.
    void cancelAnalyses();

signals:
    // 0..1 of the analysis or other work with that key; 0: an analysis has begun to compute.
    void analysisProgress(int key, double fraction);

private:
    struct Task {
        quint64 generation = 0;
        std::stop_source stop;
    };
    using TaskId = std::pair<Kind, int>;
    // What a job knows of itself while it works.
    struct Ticket {
        TaskId id;
        quint64 generation = 0;
        std::stop_token stop;
    };

    // Outcome: Result<Value>, or Status.
    template <class Outcome>
    void start(QThreadPool& pool, TaskId id, std::function<Outcome(const Ticket&)> work,
               std::function<void(Outcome)> done);
    bool isStale(const Ticket& ticket) const;
    // Lets `act` run in the window's thread, unless the job is stale by then.
    void post(const Ticket& ticket, std::function<void()> act);
    // Emits analysisProgress() in the window's thread.
    void tellProgress(int key, double fraction);
    JobControl reporting(int key, std::stop_token stop);

    quint64 generation_ = 0;
    std::map<TaskId, Task> tasks_;
    QThreadPool openings_;
    QThreadPool analyses_;
    QThreadPool live_;
    QThreadPool others_;
};

template <class Outcome>
void BackgroundJobs::start(QThreadPool& pool, TaskId id, std::function<Outcome(const Ticket&)> work,
                           std::function<void(Outcome)> done) {
    Task& task = tasks_[id];
    task.stop.request_stop();
    task = Task{++generation_, std::stop_source{}};
    pool.start([this, ticket = Ticket{id, task.generation, task.stop.get_token()},
                work = std::move(work), done = std::move(done)] {
        Outcome result = Error{ErrorCode::interrupted, {}, {}};
        try {
            if (!ticket.stop.stop_requested()) {
                result = work(ticket);
            }
        } catch (...) {
            result = error_of(std::current_exception());
        }
        auto deliver = [this, ticket, result = std::move(result), done]() mutable {
            if (isStale(ticket)) {
                return;  // a newer job of its kind and key has taken its place
            }
            tasks_.erase(ticket.id);
            done(std::move(result));
        };
        // The destructor waits for this thread, so that `this` is still there.
        QMetaObject::invokeMethod(this, std::move(deliver), Qt::QueuedConnection);
    });
}

// An analysis or identification that is asked for.
struct Request {
    RecordingId recording_id = RecordingId::none;
    Settings settings;
    bool live = false;
    SetId set_id = SetId::none;  // not 0: an identification
    bool restored = false;       // of a session: no later one replaces it
};

// The requests that are not done yet, and their progress.
class RequestQueue : public QObject {
    Q_OBJECT

public:
    explicit RequestQueue(BackgroundJobs& job);

    // A key that is there already gets the new request.
    void enter(int key, const Request& request);
    const Request* find(int key) const;
    // An analysis of that recording that a new one replaces: neither live nor
    // session; 0: none.
    int keyOfAnalysis(RecordingId recording_id) const;
    int keyOfSet(SetId set_id) const;  // its identification; 0: none
    std::vector<int> keysOfRecording(RecordingId recording_id) const;
    void done(int key);
    // Stops a request whose successor follows at once: no signal.
    void replace(int key);
    // Stops a request.
    void forget(int key);

    bool busy() const { return !requests_.empty(); }
    double progress() const;
    std::optional<double> secondsLeft() const;

signals:
    void busyChanged();
    void progressChanged();

private:
    BackgroundJobs& job_;
    std::map<int, Request> requests_;  // by key, in the order of asking
    int asked_ = 0;                    // since the window was last idle
    double fraction_ = 0;              // of the analysis that computes now
    QElapsedTimer busy_since_;
};

}  // namespace vybeg::ui
