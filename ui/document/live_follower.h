#pragma once

#include "ui/document/analysis_store.h"
#include "ui/document/recording_store.h"
#include "ui/document/request_queue.h"
#include "ui/values/ids.h"

#include <QObject>

namespace vybeg::ui {

// Live analysis: each recording has an analysis that follows the settings, with its name and
// colour, as soon as they change while the recording is the current one: first the visible range,
// then the rest; the newest settings win. Analyses of Document::analyse() stay as they are. After
// switching off, running computations finish.
class LiveFollower : public QObject {
    Q_OBJECT

public:
    LiveFollower(BackgroundJobs& job, const SettingsModel& settings, RecordingStore& recordings,
                 AnalysisStore& analyses, RequestQueue& queue);

    void setOn(bool on);
    bool on() const { return on_; }
    // Time range of the plots.
    void setVisibleRange(const TimeRange& visible) { visible_ = visible; }
    // Analyses a recording with the present settings, or with others.
    void follow(RecordingId recording_id) { follow(recording_id, settings_.settings()); }
    void follow(RecordingId recording_id, const Settings& wanted);
    // The same for a recording that may show the present settings already.
    void catchUp(RecordingId recording_id);

signals:
    void onChanged();
    void finished(AnalysisId analysis_id, double seconds);
    void reported(const Message& message);
    void settled(Topic topic);

private:
    AnalysisId show(RecordingId recording_id, const Settings& requested, AnalysisOutcome outcome);
    void whenDone(RecordingId recording_id, Result<AnalysisOutcome> result);

    BackgroundJobs& job_;
    const SettingsModel& settings_;
    RecordingStore& recordings_;
    AnalysisStore& analyses_;
    RequestQueue& queue_;
    bool on_ = false;
    TimeRange visible_;
};

}  // namespace vybeg::ui
