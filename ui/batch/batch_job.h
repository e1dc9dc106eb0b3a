#pragma once

#include "core/batch/batch_request.h"
#include "ui/document/background_jobs.h"

#include <QElapsedTimer>
#include <QObject>
#include <QString>

#include <cstddef>
#include <functional>
#include <memory>
#include <optional>
#include <stop_token>

namespace vybeg::ui {

// How far a batch is, and how long it still takes: as long for each set as for those of this batch.
class BatchProgress {
public:
    void begin(std::size_t sets);
    // `kept`: a row of an earlier batch, which took no time.
    void add(bool kept);

    std::size_t sets() const { return sets_; }
    // Nothing before the first row of this batch, and at the end.
    std::optional<double> secondsLeft() const;

private:
    std::size_t sets_ = 0;
    std::size_t done_ = 0;
    std::size_t computed_ = 0;
    qint64 last_row_ms_ = 0;
    QElapsedTimer since_;
};

// "40 s", "12 min", "3.5 h".
QString durationText(double seconds);

// The batch of the command line in the background; its rows arrive as signals in this thread.
// Finished rows stay on the disk when the object goes.
class BatchJob : public QObject {
    Q_OBJECT

public:
    ~BatchJob() override;

    // Precondition: not running.
    void start(const BatchRequest& request);
    // Ends with `interrupted` soon.
    void stop() { stop_.request_stop(); }
    bool running() const { return running_; }

signals:
    void warned(const vybeg::Diagnostic& diagnostic);
    void begun(const std::shared_ptr<const vybeg::MeasurementList>& list);
    void rowFinished(const vybeg::FinishedRow& row);
    void ended(const vybeg::Status& status);

private:
    BatchEvents events();
    void post(std::function<void()> act);

    bool running_ = false;
    std::stop_source stop_;
    BackgroundJobs job_;  // the last member: it waits for its threads, which use the others
};

}  // namespace vybeg::ui
