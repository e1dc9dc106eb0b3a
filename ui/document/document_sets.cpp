// The part of the document that holds sets of runs, what was identified from them, and the passport
// that they are compared with.
#include "ui/document/document.h"

#include <QCoreApplication>
#include <QFileInfo>

#include <algorithm>

namespace vybeg::ui {

namespace {

// In any order: the resonator is the same.
bool sameRecordings(const std::vector<int>& a, const std::vector<int>& b) {
    return std::ranges::is_permutation(a, b);
}

}  // namespace

// One change of a tolerance.
class ToleranceCommand : public QUndoCommand {
public:
    ToleranceCommand(Document& document, const Tolerance& after)
        : document_(document), before_(document.tolerance_), after_(after) {}

    void undo() override { document_.apply(before_); }
    void redo() override { document_.apply(after_); }

private:
    Document& document_;
    Tolerance before_;
    Tolerance after_;
};

RunSet* Document::findSet(int id) {
    const auto found = std::ranges::find(sets_, id, &RunSet::id);
    return found == sets_.end() ? nullptr : &*found;
}

const RunSet* Document::set(int id) const {
    const auto found = std::ranges::find(sets_, id, &RunSet::id);
    return found == sets_.end() ? nullptr : &*found;
}

void Document::setCurrentSet(int id) {
    if (id != current_set_ && set(id)) {
        current_set_ = id;
        emit setsChanged();
    }
}

int Document::addSet(const std::vector<int>& recording_ids) {
    RunSet set;
    set.id = ++last_id_;
    set.number = ++sets_made_;
    set.recordings = recording_ids;
    sets_.push_back(std::move(set));
    current_set_ = last_id_;
    emit setsChanged();
    return current_set_;
}

void Document::removeSet(int id) {
    forgetIdentification(id);
    std::erase_if(sets_, [id](const RunSet& set) { return set.id == id; });
    if (!set(current_set_)) {
        current_set_ = sets_.empty() ? 0 : sets_.back().id;
    }
    emit setsChanged();
}

void Document::renameSet(int id, const QString& name) {
    if (RunSet* set = findSet(id); set && set->name != name.trimmed()) {
        set->name = name.trimmed();
        emit setsChanged();
    }
}

void Document::setModel(int id, FitOptions::Model model) {
    if (RunSet* set = findSet(id); set && set->model != model) {
        forgetIdentification(id);
        set->model = model;
        emit setsChanged();
    }
}

void Document::edited(RunSet& set) {
    forgetIdentification(set.id);
    if (!set.outcomes.empty() && !sameRecordings(set.outcomes.back()->recordings, set.recordings)) {
        set.outcomes.erase(set.outcomes.begin(), set.outcomes.end() - 1);
    }
    emit setsChanged();
}

void Document::addToSet(const std::vector<int>& recording_ids) {
    std::vector<int> more;
    const RunSet* now = currentSet();
    for (const int id : recording_ids) {
        if (recording(id) && (!now || std::ranges::count(now->recordings, id) == 0)) {
            more.push_back(id);
        }
    }
    if (!now) {
        addSet(more);
    } else if (!more.empty()) {
        RunSet& set = *findSet(current_set_);
        set.recordings.insert(set.recordings.end(), more.begin(), more.end());
        edited(set);
    }
}

void Document::removeFromSet(int id, const std::vector<int>& recording_ids) {
    RunSet* set = findSet(id);
    const auto gone = [&](int recording) {
        return std::ranges::count(recording_ids, recording) > 0;
    };
    if (set && std::erase_if(set->recordings, gone) > 0) {
        edited(*set);
    }
}

void Document::forgetInSets(int recording_id) {
    for (RunSet& set : sets_) {
        removeFromSet(set.id, {recording_id});
    }
}

void Document::openIntoSet(const QStringList& paths) {
    std::vector<int> ids;
    for (const QString& path : paths) {
        const auto same = std::ranges::find(recordings_, QFileInfo(path).absoluteFilePath(),
                                            &RecordingEntry::path);
        if (same == recordings_.end()) {
            open({path});
            ids.push_back(recordings_.back().id);
        } else {
            ids.push_back(same->id);
        }
    }
    addToSet(ids);
}

void Document::setTolerance(const Tolerance& tolerance) {
    if (!(tolerance == tolerance_)) {
        undo_.push(new ToleranceCommand(*this, tolerance));
    }
}

void Document::apply(const Tolerance& tolerance) {
    tolerance_ = tolerance;
    emit settingsChanged();
    emit setsChanged();  // what was found with other tolerances is out of date
}

// The window is the identification's own: that of the tracks has another purpose.
IdentifySettings Document::settingsOf(const RunSet& set) const {
    IdentifySettings settings;
    settings.signal = settings_;
    settings.model = set.model;
    settings.tolerance = tolerance_;
    return settings;
}

bool Document::canIdentify() const {
    const RunSet* set = currentSet();
    if (!set || set->recordings.empty()) {
        return currentRecording() && currentRecording()->recording;
    }
    return std::ranges::all_of(set->recordings,
                               [this](int id) { return recording(id)->recording.has_value(); });
}

void Document::identify() {
    if (!canIdentify()) {
        return;
    }
    if (!currentSet() || currentSet()->recordings.empty()) {
        addToSet({current_});
    }
    const RunSet& set = *currentSet();
    forgetIdentification(set.id);
    std::vector<Recording> recordings;
    std::vector<IdentifiedInput> inputs;
    for (const int id : set.recordings) {
        const RecordingEntry& entry = *recording(id);
        recordings.push_back(*entry.recording);
        inputs.push_back({entry.name.toStdString(), entry.sha256.toStdString(),
                          entry.recording->start, entry.recording->seconds(),
                          entry.recording->rate_hz, 0});
    }
    const int key = ++last_id_;
    Request request;
    request.set_id = set.id;
    enter(key, request);
    job_.identify(key, recordings, std::move(inputs), settingsOf(set),
                  [this, key, members = set.recordings](Result<ResonatorOutcome> result) {
                      if (result) {
                          result->recordings = members;
                      }
                      whenIdentified(key, std::move(result));
                  });
    emit busyChanged();
}

void Document::whenIdentified(int key, Result<ResonatorOutcome> result) {
    const auto found = requests_.find(key);
    if (found == requests_.end()) {
        return;
    }
    const int id = found->second.set_id;
    if (result) {
        RunSet& set = *findSet(id);
        // Older ones of other recordings, or of the same settings, are of no more use.
        std::erase_if(set.outcomes, [&](const auto& older) {
            return !sameRecordings(older->recordings, result->recordings) ||
                   older->identification.settings == result->identification.settings;
        });
        set.outcomes.push_back(std::make_shared<const ResonatorOutcome>(std::move(*result)));
        emit setsChanged();
        emit identified(id);
    } else if (result.error().code != ErrorCode::interrupted) {
        reportError(result.error());
    }
    requestDone(key);
}

void Document::forgetIdentification(int set_id) {
    const auto asked = std::ranges::find_if(
        requests_, [set_id](const auto& request) { return request.second.set_id == set_id; });
    if (asked != requests_.end()) {
        const int key = asked->first;
        job_.forget(key);
        requestDone(key);
    }
}

bool Document::outOfDate(const RunSet& set, const ResonatorOutcome& outcome) const {
    return !sameRecordings(outcome.recordings, set.recordings) ||
           outcome.identification.settings != settingsOf(set);
}

std::shared_ptr<const ResonatorOutcome> Document::outcome(const RunSet& set) const {
    const auto current = std::ranges::find_if(
        set.outcomes, [&](const auto& outcome) { return !outOfDate(set, *outcome); });
    if (current != set.outcomes.end()) {
        return *current;
    }
    return set.outcomes.empty() ? nullptr : set.outcomes.back();
}

void Document::savePassport(const QString& path, std::function<void(const Status&)> done) {
    const RunSet* set = currentSet();
    if (const auto found = set ? outcome(*set) : nullptr) {
        job_.writePassport(++last_id_, found,
                           QStringLiteral("vybeg ") + QCoreApplication::applicationVersion(), path,
                           std::move(done));
    }
}

void Document::openPassport(const QString& path) {
    constexpr int one_at_a_time = 0;  // a newer one takes the place of one that is being read
    job_.readPassport(one_at_a_time, path, [this, path](Result<Passport> passport) {
        if (!passport) {
            reportError(passport.error());
            return;
        }
        passport_ = OpenPassport{QFileInfo(path).fileName(), std::move(*passport)};
        emit passportChanged();
    });
}

void Document::closePassport() {
    passport_.reset();
    emit passportChanged();
}

void Document::setFrequencyLimit(double ppm) {
    if (ppm != compare_.f_limit_ppm) {
        compare_.f_limit_ppm = ppm;
        emit passportChanged();
    }
}

std::vector<Difference> Document::differences() const {
    const RunSet* set = currentSet();
    const auto found = set ? outcome(*set) : nullptr;
    return passport_ && found ? compare(passport_->passport, found->identification.fit, compare_)
                              : std::vector<Difference>();
}

}  // namespace vybeg::ui
