#include "ui/analysis_job.h"

#include "core/report/track_csv.h"

#include <QElapsedTimer>

#include <algorithm>
#include <filesystem>

namespace vybeg::ui {

namespace {

// Between two progress signals, ms: more often than this nobody sees.
constexpr qint64 progress_interval_ms = 40;

std::filesystem::path toPath(const QString& path) {
    return std::filesystem::path(path.toStdU16String());
}

}  // namespace

AnalysisJob::AnalysisJob(QObject* parent) : QObject(parent) {
    analyses_.setMaxThreadCount(1);
    others_.setMaxThreadCount(2);
}

AnalysisJob::~AnalysisJob() {
    for (auto& [id, task] : tasks_) {
        task.stop.request_stop();
    }
    analyses_.clear();
    others_.clear();
    analyses_.waitForDone();
    others_.waitForDone();
}

template <class Value>
void AnalysisJob::start(QThreadPool& pool, TaskId id,
                        std::function<Result<Value>(std::stop_token)> work,
                        std::function<void(Result<Value>)> done) {
    Task& task = tasks_[id];
    task.stop.request_stop();
    task = Task{++generation_, std::stop_source{}};
    pool.start([this, id, generation = task.generation, stop = task.stop.get_token(),
                work = std::move(work), done = std::move(done)] {
        Result<Value> result = stop.stop_requested()
                                   ? Result<Value>(Error{ErrorCode::interrupted, {}, {}})
                                   : work(stop);
        auto deliver = [this, id, generation, result = std::move(result), done]() mutable {
            const auto found = tasks_.find(id);
            if (found == tasks_.end() || found->second.generation != generation) {
                return;  // stale: a newer job of its kind and key has taken its place
            }
            tasks_.erase(found);
            done(std::move(result));
        };
        // The destructor waits for this thread, so that `this` is still there.
        QMetaObject::invokeMethod(this, std::move(deliver), Qt::QueuedConnection);
    });
}

void AnalysisJob::open(int key, const QString& path, const OpenOptions& options,
                       std::function<void(Result<Recording>)> done) {
    start<Recording>(
        others_, {Kind::open, key},
        [path = toPath(path), options](std::stop_token stop) {
            return open_recording(path, options, JobControl(stop));
        },
        std::move(done));
}

void AnalysisJob::buildEnvelope(int key, const Recording& recording,
                                std::function<void(Result<std::shared_ptr<const Envelope>>)> done) {
    start<std::shared_ptr<const Envelope>>(
        others_, {Kind::envelope, key},
        [source = recording.source](std::stop_token stop) {
            return Envelope::build(*source, JobControl(stop));
        },
        std::move(done));
}

void AnalysisJob::hash(int key, const QString& path,
                       std::function<void(Result<std::string>)> done) {
    start<std::string>(
        others_, {Kind::hash, key},
        [path = toPath(path)](std::stop_token stop) { return file_sha256(path, JobControl(stop)); },
        std::move(done));
}

void AnalysisJob::findCarrier(int key, const Recording& recording, const Settings& settings,
                              std::function<void(Result<double>)> done) {
    start<double>(
        others_, {Kind::carrier, key},
        [recording, settings](std::stop_token stop) {
            return find_recording_carrier(recording, settings, JobControl(stop));
        },
        std::move(done));
}

void AnalysisJob::inspect(int key, const Recording& recording, const Settings& settings,
                          std::function<void(Result<SampleFaults>)> done) {
    start<SampleFaults>(
        others_, {Kind::check, key},
        [recording, settings](std::stop_token stop) {
            return vybeg::inspect(recording, settings, JobControl(stop));
        },
        std::move(done));
}

JobControl AnalysisJob::reporting(int key, std::stop_token stop) {
    QElapsedTimer started;
    started.start();
    auto last = std::make_shared<QElapsedTimer>(started);
    return JobControl(
        stop,
        [this, key, last](double fraction) {
            if (last->elapsed() >= progress_interval_ms) {
                last->restart();
                QMetaObject::invokeMethod(
                    this, [this, key, fraction] { emit analysisProgress(key, fraction); },
                    Qt::QueuedConnection);
            }
        },
        [started] { return 1e-9 * static_cast<double>(started.nsecsElapsed()); });
}

void AnalysisJob::analyse(int key, const Recording& recording, const Settings& settings,
                          std::function<void(Result<AnalysisOutcome>)> done) {
    start<AnalysisOutcome>(
        analyses_, {Kind::analysis, key},
        [this, key, recording, settings](std::stop_token stop) -> Result<AnalysisOutcome> {
            QMetaObject::invokeMethod(
                this, [this, key] { emit analysisStarted(key); }, Qt::QueuedConnection);
            Result<Analysis> found = vybeg::analyse(recording, settings, reporting(key, stop));
            if (!found) {
                return found.error();
            }
            AnalysisOutcome outcome;
            const WindowPlan& plan = found->plan;
            outcome.summary = summarise(
                found->track,
                std::min(1.0, static_cast<double>(plan.hop) / static_cast<double>(plan.length)));
            outcome.events = find_events(found->track);
            outcome.analysis = std::make_shared<const Analysis>(std::move(*found));
            return outcome;
        },
        std::move(done));
}

void AnalysisJob::writeTrack(int key, const Recording& recording,
                             std::shared_ptr<const Analysis> analysis, const QString& program,
                             const QString& path, std::function<void(Status)> done) {
    struct Nothing {};
    const auto write = [recording, analysis = std::move(analysis), name = program.toStdString(),
                        path = toPath(path)](std::stop_token stop) -> Status {
        const JobControl job(stop);
        const Result<std::string> hash = file_sha256(recording.path, job);
        if (!hash) {
            return hash.error();
        }
        Result<OutputFile> file = OutputFile::create(path, job);
        if (!file) {
            return file.error();
        }
        const auto header = track_header(name, recording, *hash, *analysis);
        if (Status written = write_track_csv(*file, analysis->track, header, job); !written) {
            return written;
        }
        return file->commit();
    };
    start<Nothing>(
        others_, {Kind::write, key},
        [write](std::stop_token stop) -> Result<Nothing> {
            const Status status = write(stop);
            return status ? Result<Nothing>(Nothing{}) : Result<Nothing>(status.error());
        },
        [done = std::move(done)](const Result<Nothing>& result) {
            done(result ? Status() : Status(result.error()));
        });
}

void AnalysisJob::forget(int key) {
    std::erase_if(tasks_, [key](auto& entry) {
        if (entry.first.second != key) {
            return false;
        }
        entry.second.stop.request_stop();
        return true;
    });
}

void AnalysisJob::cancelAnalyses() {
    for (auto& [id, task] : tasks_) {
        if (id.first == Kind::analysis) {
            task.stop.request_stop();
        }
    }
}

}  // namespace vybeg::ui
