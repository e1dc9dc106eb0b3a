#include "ui/document/drift_store.h"

#include "ui/values/recording_set.h"

#include <QFileInfo>

#include <algorithm>
#include <filesystem>
#include <utility>

namespace vybeg::ui {

namespace {

constexpr int job_key = -1;  // those of recordings and requests are positive

}  // namespace

void DriftStore::open(const QStringList& paths) {
    DriftInput after = input_;
    for (const QString& path : paths) {
        RecordingRef log;
        log.path = QFileInfo(path).absoluteFilePath().toStdU16String();
        if (std::ranges::count(after.logs, log.path, &RecordingRef::path) == 0) {
            after.logs.push_back(std::move(log));
        }
    }
    if (after.logs.size() > input_.logs.size()) {
        step([] { return tr("open whole-angle logs"); }, after);
    }
    emit opened();
}

void DriftStore::remove(const QStringList& paths) {
    DriftInput after = input_;
    const auto gone = std::erase_if(
        after.logs, [&paths](const RecordingRef& log) { return paths.contains(pathText(log)); });
    if (gone > 0) {
        const QString name = QFileInfo(paths.front()).fileName();
        const bool one = gone == 1;
        step([one, name] { return one ? tr("remove %1").arg(name) : tr("remove logs"); }, after);
    }
}

void DriftStore::setSettings(const DriftSettings& settings) {
    if (settings != input_.settings) {
        step([] { return tr("settings of the drift"); }, {input_.logs, settings});
    }
}

void DriftStore::startWith(DriftInput input) {
    if (!input.logs.empty() || !input_.logs.empty() || input.settings != input_.settings) {
        restore(std::move(input));
    }
}

void DriftStore::step(const UndoSteps::Words& words, const DriftInput& after) {
    steps_.change(words, input_, after, [this](const DriftInput& input) { restore(input); });
}

void DriftStore::restore(DriftInput input) {
    input_ = std::move(input);
    compute();
    emit changed();
}

void DriftStore::compute() {
    outcome_.reset();
    failure_.reset();
    if (input_.logs.empty()) {
        job_.forget(job_key);
        emit settled(Topic::drift);
        return;
    }
    std::vector<std::filesystem::path> paths;
    for (const RecordingRef& log : input_.logs) {
        paths.push_back(log.path);
    }
    job_.run<DriftOutcome>(
        job_key,
        [paths = std::move(paths), settings = input_.settings](const JobControl& job) {
            return drift_of_logs(paths, settings, job);
        },
        [this](Result<DriftOutcome>&& result) { take(std::move(result)); });
}

void DriftStore::take(Result<DriftOutcome>&& result) {
    if (result) {
        for (std::size_t k = 0; k < input_.logs.size(); ++k) {
            input_.logs[k].sha256 = result->drift.logs[k].sha256;
        }
        outcome_ = std::make_shared<const DriftOutcome>(std::move(*result));
        emit settled(Topic::drift);
    } else {
        failure_ = result.error();
        emit reported(errorMessage(*failure_, Topic::drift));
    }
    emit changed();
}

}  // namespace vybeg::ui

#include "moc_drift_store.cpp"
