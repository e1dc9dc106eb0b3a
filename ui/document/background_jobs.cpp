#include "ui/document/background_jobs.h"

#include "core/output/passport_json.h"
#include "core/recording/open/open_recording.h"
#include "core/recording/open/preview.h"
#include "core/recording/samples/recording.h"
#include "ui/words/program_name.h"

#include <QCoreApplication>
#include <QEvent>
#include <QJsonDocument>

#include <algorithm>
#include <filesystem>

namespace vybeg::ui {

namespace {

// Between two progress signals, ms: more often than this nobody sees.
constexpr qint64 progress_interval_ms = 40;

// The threads that free memory; not the global pool, because Qt draws with that.
QThreadPool& freeingPool() {
    static QThreadPool pool;
    return pool;
}

// Gives the memory of a long recording's results back in the background: that would
// hold up the window for too long.
template <class Value>
std::shared_ptr<const Value> freedInBackground(std::shared_ptr<const Value> value) {
    const Value* place = value.get();
    return {place, [value = std::move(value)](const Value*) mutable {
                freeingPool().start([value = std::move(value)] {});
            }};
}

Result<AnalysisOutcome> outcomeIfUnchanged(const Recording& recording, Result<Analysis> found) {
    TRY(unchanged(recording));
    return found ? Result<AnalysisOutcome>(outcomeOf(std::move(*found))) : found.error();
}

// Seconds from now on.
std::function<double()> stopwatch() {
    QElapsedTimer started;
    started.start();
    return [started] { return 1e-9 * static_cast<double>(started.nsecsElapsed()); };
}

template <class Condition>
int firstKey(const std::map<int, Request>& requests, Condition condition) {
    const auto found = std::ranges::find_if(
        requests, [&](const auto& request) { return condition(request.second); });
    return found == requests.end() ? 0 : found->first;
}

}  // namespace

AnalysisOutcome outcomeOf(Analysis found) {
    AnalysisOutcome outcome;
    const WindowPlan& plan = found.plan;
    outcome.summary = summarise(found.track, plan.independent(), found.f_correlation);
    // Between windows that lie far apart anything may have happened.
    if (static_cast<std::int64_t>(found.track.rows()) == plan.count) {
        outcome.events = find_events(found.track);
    }
    outcome.analysis = freedInBackground(std::make_shared<const Analysis>(std::move(found)));
    for (const auto& curve : curvesOf(outcome.analysis)) {
        outcome.curves.push_back(freedInBackground(curve));
    }
    return outcome;
}

BackgroundJobs::BackgroundJobs() {
    // More than processors: most of them wait for a disk, and none may keep a file from opening.
    openings_.setMaxThreadCount(4);
    analyses_.setMaxThreadCount(1);
    live_.setMaxThreadCount(1);
    others_.setMaxThreadCount(4);
}

BackgroundJobs::~BackgroundJobs() {
    for (auto& [id, task] : tasks_) {
        task.stop.request_stop();
    }
    for (QThreadPool* pool : {&openings_, &analyses_, &live_, &others_}) {
        pool->clear();
    }
    for (QThreadPool* pool : {&openings_, &analyses_, &live_, &others_}) {
        pool->waitForDone();
    }
}

void BackgroundJobs::finish() {
    while (busy()) {
        for (QThreadPool* pool : {&openings_, &analyses_, &live_, &others_}) {
            pool->waitForDone();
        }
        QCoreApplication::sendPostedEvents(this, QEvent::MetaCall);
    }
}

bool BackgroundJobs::isStale(const Ticket& ticket) const {
    const auto found = tasks_.find(ticket.id);
    return found == tasks_.end() || found->second.generation != ticket.generation;
}

void BackgroundJobs::post(const Ticket& ticket, std::function<void()> act) {
    QMetaObject::invokeMethod(
        this,
        [this, ticket, act = std::move(act)] {
            if (!isStale(ticket)) {
                act();
            }
        },
        Qt::QueuedConnection);
}

void BackgroundJobs::open(int key, const QString& path, const OpenOptions& options,
                          std::function<void(const QuickOverview&)> looked, Done<Recording> done) {
    start<Result<Recording>>(
        openings_, {Kind::open, key},
        [this, path = std::filesystem::path(path.toStdU16String()), options,
         looked = std::move(looked)](const Ticket& ticket) {
            const JobControl job(ticket.stop, {}, stopwatch());
            if (const auto look = quick_overview(path, options, job)) {
                post(ticket, [looked, look = *look] { looked(look); });
            }
            Result<Recording> opened = open_recording(path, options, job);
            if (opened) {
                opened->source = freedInBackground(opened->source);
            }
            return opened;
        },
        std::move(done));
}

void BackgroundJobs::buildEnvelope(int key, const Recording& recording, EnvelopeSink grown,
                                   Done<std::shared_ptr<const Envelope>> done) {
    using Picture = std::shared_ptr<const Envelope>;
    start<Result<Picture>>(
        others_, {Kind::envelope, key},
        [this, source = recording.source, grown = std::move(grown)](const Ticket& ticket) {
            const EnvelopeSink show = [&](const Picture& picture) {
                post(ticket, [grown, picture = freedInBackground(picture)] { grown(picture); });
            };
            Result<Picture> whole =
                build_envelope(*source, JobControl(ticket.stop, {}, stopwatch()), show);
            return whole ? Result<Picture>(freedInBackground(*whole)) : whole;
        },
        std::move(done));
}

void BackgroundJobs::tellProgress(int key, double fraction) {
    QMetaObject::invokeMethod(
        this, [this, key, fraction] { emit analysisProgress(key, fraction); },
        Qt::QueuedConnection);
}

JobControl BackgroundJobs::reporting(int key, std::stop_token stop) {
    auto last = std::make_shared<QElapsedTimer>();
    last->start();
    return JobControl(
        stop,
        [this, key, last](double fraction) {
            if (last->elapsed() >= progress_interval_ms) {
                last->restart();
                tellProgress(key, fraction);
            }
        },
        stopwatch());
}

void BackgroundJobs::analyse(int key, const Recording& recording, const Settings& settings,
                             Done<AnalysisOutcome> done) {
    start<Result<AnalysisOutcome>>(
        analyses_, {Kind::analysis, key},
        [this, key, recording, settings](const Ticket& ticket) {
            tellProgress(key, 0);
            return outcomeIfUnchanged(
                recording, vybeg::analyse(recording, settings, reporting(key, ticket.stop)));
        },
        std::move(done));
}

void BackgroundJobs::analyseLive(int key, const Recording& recording, const Settings& settings,
                                 const TimeRange& visible,
                                 std::function<void(AnalysisOutcome)> early,
                                 Done<AnalysisOutcome> done) {
    start<Result<AnalysisOutcome>>(
        live_, {Kind::live, key},
        [this, key, recording, settings, visible, early = std::move(early)](const Ticket& ticket) {
            const EarlySink show = [&](Analysis some) {
                post(ticket, [early, outcome = outcomeOf(std::move(some))] { early(outcome); });
            };
            return outcomeIfUnchanged(recording,
                                      analyse_visible_first(recording, settings, visible, show,
                                                            reporting(key, ticket.stop)));
        },
        std::move(done));
}

void BackgroundJobs::identify(int key, OpenSet open, Done<SavedResult> done) {
    start<Result<SavedResult>>(
        analyses_, {Kind::identification, key},
        [this, key, open = std::move(open)](const Ticket& ticket) -> Result<SavedResult> {
            tellProgress(key, 0);
            const JobControl job = reporting(key, ticket.stop);
            OpenSet read = open;
            TRY(read_contents(read, ticket.stop));
            auto result = TRY(identify_set(read, programName().toStdString(), {}, job));
            const auto json = QByteArray::fromStdString(saved_result_json(result));
            return SavedResult{std::move(result), QJsonDocument::fromJson(json).object(), {}};
        },
        std::move(done));
}

void BackgroundJobs::write(int key, std::function<Status(const JobControl&)> work,
                           std::function<void(Status)> done) {
    start<Status>(
        others_, {Kind::write, key},
        [work = std::move(work)](const Ticket& ticket) { return work(JobControl(ticket.stop)); },
        std::move(done));
}

void BackgroundJobs::forget(int key) {
    std::erase_if(tasks_, [key](auto& entry) {
        if (entry.first.second != key) {
            return false;
        }
        entry.second.stop.request_stop();
        return true;
    });
}

void BackgroundJobs::forgetLive(int key) {
    if (const auto found = tasks_.find({Kind::live, key}); found != tasks_.end()) {
        found->second.stop.request_stop();
        tasks_.erase(found);
    }
}

void BackgroundJobs::cancelAnalyses() {
    for (auto& [id, task] : tasks_) {
        if (id.first == Kind::analysis || id.first == Kind::live ||
            id.first == Kind::identification) {
            task.stop.request_stop();
        }
    }
}

RequestQueue::RequestQueue(BackgroundJobs& job) : job_(job) {
    connect(&job_, &BackgroundJobs::analysisProgress, this, [this](int key, double fraction) {
        if (requests_.contains(key)) {
            fraction_ = fraction;
            emit progressChanged();
        }
    });
}

void RequestQueue::enter(int key, const Request& request) {
    if (!busy()) {
        asked_ = 0;
        fraction_ = 0;
        busy_since_.start();
    }
    if (!requests_.contains(key)) {
        ++asked_;
    } else {
        fraction_ = 0;
    }
    requests_[key] = request;
    emit busyChanged();
}

const Request* RequestQueue::find(int key) const {
    const auto found = requests_.find(key);
    return found == requests_.end() ? nullptr : &found->second;
}

int RequestQueue::keyOfAnalysis(RecordingId recording_id) const {
    return firstKey(requests_, [&](const Request& request) {
        return request.recording_id == recording_id && !request.live && !request.restored;
    });
}

int RequestQueue::keyOfSet(SetId set_id) const {
    return firstKey(requests_, [&](const Request& request) { return request.set_id == set_id; });
}

std::vector<int> RequestQueue::keysOfRecording(RecordingId recording_id) const {
    std::vector<int> keys;
    for (const auto& [key, request] : requests_) {
        if (request.recording_id == recording_id) {
            keys.push_back(key);
        }
    }
    return keys;
}

void RequestQueue::done(int key) {
    requests_.erase(key);
    fraction_ = 0;
    emit busyChanged();
}

void RequestQueue::replace(int key) {
    if (requests_.erase(key) > 0) {
        job_.forget(key);
        --asked_;
    }
}

void RequestQueue::forget(int key) {
    if (const Request* request = find(key)) {
        request->live ? job_.forgetLive(key) : job_.forget(key);
        done(key);
    }
}

double RequestQueue::progress() const {
    if (requests_.empty()) {
        return 1;
    }
    const double finished = asked_ - static_cast<double>(requests_.size());
    return std::clamp((finished + fraction_) / asked_, 0.0, 1.0);
}

std::optional<double> RequestQueue::secondsLeft() const {
    const double share = progress();
    const double elapsed = static_cast<double>(busy_since_.elapsed()) / 1000;
    // The first half second says too little about the rest.
    if (!busy() || elapsed < 0.5 || share < 0.01) {
        return std::nullopt;
    }
    return elapsed * (1 - share) / share;
}

}  // namespace vybeg::ui

#include "moc_background_jobs.cpp"
