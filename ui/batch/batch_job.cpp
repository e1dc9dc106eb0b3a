#include "ui/batch/batch_job.h"

#include "core/batch/batch_request.h"

#include <utility>

namespace vybeg::ui {

namespace {

constexpr int only_one = 0;

}  // namespace

BatchJob::BatchJob(QObject* parent) : QObject(parent) {}

BatchJob::~BatchJob() {
    stop_.request_stop();
}

void BatchJob::start(const BatchRequest& request) {
    running_ = true;
    stop_ = std::stop_source();
    job_.write(
        only_one,
        [this, request, token = stop_.get_token()](const JobControl&) {
            return compute_batch(request, events(), token);
        },
        [this](const Status& status) {
            running_ = false;
            emit ended(status);
        });
}

void BatchJob::stop() {
    stop_.request_stop();
}

BatchEvents BatchJob::events() {
    return {
        [this](const std::vector<Diagnostic>& warnings) {
            for (const Diagnostic& each : warnings) {
                post([this, each] { emit warned(each); });
            }
        },
        [this](const MeasurementList& list) {
            post([this, own = std::make_shared<const MeasurementList>(list)] { emit begun(own); });
        },
        [this](const FinishedRow& row) { post([this, row] { emit rowFinished(row); }); }};
}

void BatchJob::post(std::function<void()> act) {
    QMetaObject::invokeMethod(this, std::move(act), Qt::QueuedConnection);
}

}  // namespace vybeg::ui
