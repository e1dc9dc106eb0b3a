#pragma once

// How a job starts and ends; for the sources of AnalysisJob only.
#include "ui/document/analysis_job.h"

#include <new>
#include <utility>

namespace vybeg::ui {

template <class Value>
void AnalysisJob::start(QThreadPool& pool, TaskId id,
                        std::function<Result<Value>(const Ticket&)> work,
                        std::function<void(Result<Value>)> done) {
    Task& task = tasks_[id];
    task.stop.request_stop();
    task = Task{++generation_, std::stop_source{}};
    pool.start([this, ticket = Ticket{id, task.generation, task.stop.get_token()},
                work = std::move(work), done = std::move(done)] {
        Result<Value> result = Error{ErrorCode::interrupted, {}, {}};
        try {
            if (!ticket.stop.stop_requested()) {
                result = work(ticket);
            }
        } catch (const std::bad_alloc&) {
            result = Error{ErrorCode::out_of_memory, {}, {}};
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

}  // namespace vybeg::ui
