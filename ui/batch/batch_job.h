#pragma once

#include "core/batch/batch_request.h"
#include "ui/document/background_jobs.h"

#include <QObject>

#include <functional>
#include <memory>
#include <stop_token>

namespace vybeg::ui {

// The batch of the command line in the background; its rows arrive as signals in this thread.
// Finished rows stay on the disk when the object goes.
class BatchJob : public QObject {
    Q_OBJECT

public:
    explicit BatchJob(QObject* parent = nullptr);
    ~BatchJob() override;

    // Precondition: not running.
    void start(const BatchRequest& request);
    // Ends with `interrupted` soon.
    void stop();
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
