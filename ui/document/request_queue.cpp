#include "ui/document/request_queue.h"

#include <algorithm>

namespace vybeg::ui {
namespace {

template <class Condition>
int firstKey(const std::map<int, Request>& requests, Condition condition) {
    const auto found = std::ranges::find_if(
        requests, [&](const auto& request) { return condition(request.second); });
    return found == requests.end() ? 0 : found->first;
}

}  // namespace

RequestQueue::RequestQueue(BackgroundJobs& job) : job_(job) {
    connect(&job_, &BackgroundJobs::analysisProgress, this, [this](int key, double fraction) {
        if (requests_.contains(key)) {
            fraction_ = fraction;
            emit progressChanged();
        }
    });
    connect(&job_, &BackgroundJobs::analysisStarted, this, [this] {
        fraction_ = 0;
        emit progressChanged();
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
