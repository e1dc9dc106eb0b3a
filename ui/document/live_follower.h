#pragma once

#include "ui/document/recording_store.h"
#include "ui/document/request_queue.h"
#include "ui/document/run_store.h"

#include <QObject>

namespace vybeg::ui {

// Live analysis: each recording has a run that follows the settings, with its name and colour, as
// soon as they change while the recording is the current one: first the visible range, then the
// rest; the newest settings win. Runs of Document::analyse() stay as they are. After switching off,
// running computations finish.
class LiveFollower : public QObject {
    Q_OBJECT

public:
    LiveFollower(BackgroundJobs& job, const SettingsModel& settings, RecordingStore& recordings,
                 RunStore& runs, RequestQueue& queue, QObject* parent = nullptr);

    void setOn(bool on);
    bool on() const { return on_; }
    // Time range of the plots.
    void setVisibleRange(const TimeRange& visible) { visible_ = visible; }
    // Analyses a recording with the present settings, or with others.
    void follow(int recording_id) { follow(recording_id, settings_.settings()); }
    void follow(int recording_id, const Settings& wanted);
    // The same for a recording that may show the present settings already.
    void catchUp(int recording_id);

signals:
    void onChanged();
    void finished(int run_id, double seconds);
    void reported(const Message& message);
    void settled(Topic topic);

private:
    int show(int recording_id, const Settings& requested, AnalysisOutcome outcome);
    void whenDone(int recording_id, Result<AnalysisOutcome> result);

    BackgroundJobs& job_;
    const SettingsModel& settings_;
    RecordingStore& recordings_;
    RunStore& runs_;
    RequestQueue& queue_;
    bool on_ = false;
    TimeRange visible_;
};

}  // namespace vybeg::ui
