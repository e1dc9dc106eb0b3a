#include "ui/batch/batch_job.h"

#include "core/batch/batch_request.h"

#include <QCoreApplication>
#include <QLocale>

#include <algorithm>
#include <cmath>
#include <utility>

namespace vybeg::ui {

namespace {

constexpr double minute_s = 60;
constexpr double hour_s = 3600;
constexpr double ms_per_s = 1000;

}  // namespace

void BatchProgress::begin(std::size_t sets) {
    *this = BatchProgress();
    sets_ = sets;
    since_.start();
}

void BatchProgress::add(bool kept) {
    ++done_;
    if (!kept) {
        ++computed_;
        last_row_ms_ = since_.elapsed();
    }
}

std::optional<double> BatchProgress::secondsLeft() const {
    if (computed_ == 0 || done_ == sets_) {
        return std::nullopt;
    }
    const double each_ms = static_cast<double>(last_row_ms_) / static_cast<double>(computed_);
    const double left_ms = each_ms * static_cast<double>(sets_ - done_) -
                           static_cast<double>(since_.elapsed() - last_row_ms_);
    return std::max(left_ms, 0.) / ms_per_s;
}

QString durationText(double seconds) {
    const QLocale locale;
    if (seconds < 1.5 * minute_s) {
        return QCoreApplication::translate("Duration", "%1 s")
            .arg(locale.toString(std::ceil(seconds), 'f', 0));
    }
    if (seconds < 1.5 * hour_s) {
        return QCoreApplication::translate("Duration", "%1 min")
            .arg(locale.toString(std::ceil(seconds / minute_s), 'f', 0));
    }
    return QCoreApplication::translate("Duration", "%1 h")
        .arg(locale.toString(seconds / hour_s, 'f', 1));
}

namespace {

constexpr int only_one = 0;

}  // namespace

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
