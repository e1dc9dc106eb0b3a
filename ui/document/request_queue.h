#pragma once

#include "core/analysis/settings.h"
#include "ui/document/background_jobs.h"

#include <QElapsedTimer>
#include <QList>
#include <QObject>

#include <map>
#include <optional>
#include <vector>

namespace vybeg::ui {

// An analysis or identification that is asked for.
struct Request {
    int recording_id = 0;
    Settings settings;
    int batch = 0;  // of a comparison of windows; 0: a run of its own
    bool live = false;
    int set_id = 0;         // not 0: an identification
    bool restored = false;  // of a session: no later one replaces it
};

// The requests that are not done yet, and their progress.
class RequestQueue : public QObject {
    Q_OBJECT

public:
    explicit RequestQueue(BackgroundJobs& job, QObject* parent = nullptr);

    // A key that is there already gets the new request.
    void enter(int key, const Request& request);
    const Request* find(int key) const;
    // An analysis of that recording that a new one replaces: neither live nor of a batch or
    // session; 0: none.
    int keyOfRun(int recording_id) const;
    int keyOfSet(int set_id) const;  // its identification; 0: none
    std::vector<int> keysOfRecording(int recording_id) const;
    void done(int key);
    // Stops a request whose successor follows at once: no signal.
    void replace(int key);
    // Stops a request.
    void forget(int key);

    // A comparison: batchDone() with its runs when its last request is done.
    void beginBatch(int batch) { batches_[batch] = {}; }
    void addToBatch(int batch, int run_id) { batches_[batch].push_back(run_id); }
    void forgetBatches() { batches_.clear(); }

    bool busy() const { return !requests_.empty(); }
    double progress() const;
    std::optional<double> secondsLeft() const;

signals:
    void busyChanged();
    void progressChanged();
    void batchDone(const QList<int>& run_ids);

private:
    BackgroundJobs& job_;
    std::map<int, Request> requests_;  // by key, in the order of asking
    std::map<int, QList<int>> batches_;
    int asked_ = 0;        // since the window was last idle
    double fraction_ = 0;  // of the analysis that computes now
    QElapsedTimer busy_since_;
};

}  // namespace vybeg::ui
