#pragma once

#include "core/analysis/settings.h"
#include "ui/document/background_jobs.h"
#include "ui/values/ids.h"

#include <QElapsedTimer>
#include <QObject>

#include <map>
#include <optional>
#include <vector>

namespace vybeg::ui {

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
