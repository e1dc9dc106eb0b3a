#include "ui/document/set_store.h"

#include "core/analysis/measurement_list.h"
#include "core/output/identify_json.h"
#include "core/output/output_file.h"
#include "core/output/passport_json.h"

#include <QFileInfo>

#include <algorithm>
#include <filesystem>
#include <utility>

namespace vybeg::ui {

namespace {

// Logs, and recordings by their ids alone.
std::vector<RecordingRef> membersOf(const RecordingSet& set) {
    std::vector<RecordingRef> members =
        isOfLogs(set) ? set.listed->recordings : std::vector<RecordingRef>();
    for (const RecordingId id : set.recordings) {
        members.emplace_back().id = number(id);
    }
    return members;
}

bool isOf(const SetResult& outcome, const RecordingSet& set) {
    return sameMembers(outcome.set.recordings, membersOf(set));
}

QStringList pathsOf(const MeasurementSet& set) {
    QStringList paths;
    for (const RecordingRef& recording : set.recordings) {
        paths << pathText(recording);
    }
    return paths;
}

bool contains(const std::vector<RecordingId>& ids, RecordingId id) {
    return std::ranges::find(ids, id) != ids.end();
}

// What the window says of the gyro, where the list of the set says nothing.
MeasurementSet told(MeasurementSet set, const GyroData& session) {
    for (RecordingRef& recording : set.recordings) {
        Conditions& conditions = recording.conditions;
        for (const auto& [text, otherwise] :
             {std::pair{&conditions.gyro, &session.serial},
              std::pair{&conditions.operator_name, &session.operator_name},
              std::pair{&conditions.comment, &session.comment}}) {
            *text = text->empty() ? otherwise->toStdString() : *text;
        }
    }
    return set;
}

// With the contents read from the files of the recordings, which are the same in their order.
MeasurementSet asRead(MeasurementSet set, const MeasurementSet& read) {
    for (std::size_t k = 0; k < set.recordings.size(); ++k) {
        const RecordingRef& from = read.recordings[k];
        RecordingRef& recording = set.recordings[k];
        recording.sha256 = from.sha256;
        recording.start = from.start;
        recording.seconds = from.seconds;
        recording.rate_hz = from.rate_hz;
        recording.f0_hz = from.f0_hz;
    }
    return set;
}

}  // namespace

QStringList absentFiles(const RecordingSet& set) {
    QStringList files;
    if (set.listed && !isOfLogs(set)) {
        for (const RecordingRef& row : set.listed->recordings) {
            if (!contains(set.recordings, static_cast<RecordingId>(row.id))) {
                files << QString::fromStdString(row.file);
            }
        }
    }
    return files;
}

MeasurementSet withRowFor(MeasurementSet listed, const QString& path, RecordingId id) {
    const auto row = std::ranges::find_if(listed.recordings, [&path](const RecordingRef& each) {
        return each.id == number(RecordingId::none) && pathText(each) == path;
    });
    if (row != listed.recordings.end()) {
        row->id = number(id);
    }
    return listed;
}

SetStore::SetStore(BackgroundJobs& job, const SettingsModel& settings, RecordingStore& recordings,
                   RequestQueue& queue, IdCounter& ids, UndoSteps& steps)
    : job_(job),
      settings_(settings),
      recordings_(recordings),
      queue_(queue),
      ids_(ids),
      steps_(steps) {
    // Outcomes of other settings are out of date.
    connect(&settings_, &SettingsModel::changed, this, &SetStore::changed);
}

const RecordingSet* SetStore::find(SetId id) const {
    const auto found = std::ranges::find(sets_, id, &RecordingSet::id);
    return found == sets_.end() ? nullptr : &*found;
}

void SetStore::setCurrent(SetId id) {
    if (id != current_ && find(id)) {
        current_ = id;
        emit changed();
    }
}

void SetStore::step(UndoSteps::Words words, const std::function<void()>& edit) {
    const State before{sets_, current_};
    edit();
    steps_.add(
        std::move(words), [this, before] { restore(before); },
        [this, after = State{sets_, current_}] { restore(after); });
}

// Results found meanwhile stay with their recordings; closed recordings stay away.
void SetStore::restore(const State& state) {
    std::vector<RecordingSet> sets = state.sets;
    for (RecordingSet& set : sets) {
        std::erase_if(set.recordings, [this](RecordingId id) { return !recordings_.find(id); });
        const RecordingSet* now = find(set.id);
        if (now && sameMembers(membersOf(*now), membersOf(set))) {
            set.outcomes = now->outcomes;
            set.kept = now->kept;
            set.kept_up_to_date = now->kept_up_to_date;
            set.refusal = now->refusal;
        } else {
            queue_.forget(queue_.keyOfSet(set.id));
        }
    }
    for (const RecordingSet& set : sets_) {
        if (std::ranges::find(sets, set.id, &RecordingSet::id) == sets.end()) {
            queue_.forget(queue_.keyOfSet(set.id));
        }
    }
    sets_ = std::move(sets);
    current_ = find(state.current) ? state.current : sets_.empty() ? SetId::none : sets_.back().id;
    emit changed();
}

SetId SetStore::add(const std::vector<RecordingId>& recording_ids) {
    step([] { return tr("new set"); },
         [&] {
             RecordingSet set;
             set.id = ids_.next<SetId>();
             set.number = ++made_;
             set.recordings = recording_ids;
             current_ = set.id;
             sets_.push_back(std::move(set));
         });
    emit changed();
    return current_;
}

void SetStore::remove(SetId id) {
    queue_.forget(queue_.keyOfSet(id));
    step([] { return tr("remove the set"); },
         [&] {
             std::erase_if(sets_, [id](const RecordingSet& set) { return set.id == id; });
             if (!find(current_)) {
                 current_ = sets_.empty() ? SetId::none : sets_.back().id;
             }
         });
    emit changed();
}

void SetStore::rename(SetId id, const QString& name) {
    if (RecordingSet* set = entry(id); set && set->name != name.trimmed()) {
        step([] { return tr("rename the set"); }, [&] { set->name = name.trimmed(); });
        emit changed();
    }
}

void SetStore::setModel(SetId id, FitOptions::Model model) {
    if (RecordingSet* set = entry(id); set && set->model != model) {
        queue_.forget(queue_.keyOfSet(id));
        step([] { return tr("model of the set"); }, [&] { set->model = model; });
        emit changed();
    }
}

void SetStore::setListed(SetId id, MeasurementSet listed) {
    if (RecordingSet* set = entry(id)) {
        set->listed = std::make_shared<const MeasurementSet>(std::move(listed));
        emit changed();
    }
}

void SetStore::changeListed(SetId id, MeasurementSet listed) {
    queue_.forget(queue_.keyOfSet(id));
    step([] { return tr("calibration of the set"); }, [&] { setListed(id, std::move(listed)); });
}

void SetStore::restoreSets(std::vector<RecordingSet> sets) {
    append(std::move(sets));
    emit changed();
}

void SetStore::edited(RecordingSet& set) {
    queue_.forget(queue_.keyOfSet(set.id));
    if (!set.outcomes.empty() && !isOf(*set.outcomes.back(), set)) {
        set.outcomes.erase(set.outcomes.begin(), set.outcomes.end() - 1);
    }
    emit changed();
}

void SetStore::insertInto(SetId id, const std::vector<RecordingId>& recording_ids) {
    RecordingSet& set = *entry(id);
    const std::size_t before = set.recordings.size();
    for (const auto recording : recording_ids) {
        if (recordings_.find(recording) && !contains(set.recordings, recording)) {
            set.recordings.push_back(recording);
        }
    }
    if (set.recordings.size() > before) {
        edited(set);
    }
}

void SetStore::eraseFrom(SetId id, const std::vector<RecordingId>& recording_ids) {
    RecordingSet* set = entry(id);
    const auto gone = [&](RecordingId recording) { return contains(recording_ids, recording); };
    if (set && std::erase_if(set->recordings, gone) > 0) {
        edited(*set);
    }
}

void SetStore::addTo(SetId id, const std::vector<RecordingId>& recording_ids) {
    const RecordingSet& set = *entry(id);
    const auto is_new = [&](RecordingId recording) { return !contains(set.recordings, recording); };
    if (std::ranges::any_of(recording_ids, is_new)) {
        step([] { return tr("recordings of the set"); }, [&] { insertInto(id, recording_ids); });
    }
}

void SetStore::addToCurrent(const std::vector<RecordingId>& recording_ids) {
    if (current() && !isOfLogs(*current())) {
        addTo(current_, recording_ids);
    } else {
        add(recording_ids);
    }
}

void SetStore::removeFrom(SetId id, const std::vector<RecordingId>& recording_ids) {
    const RecordingSet* set = find(id);
    const auto is_in = [&](RecordingId recording) { return contains(set->recordings, recording); };
    if (set && std::ranges::any_of(recording_ids, is_in)) {
        step([] { return tr("recordings of the set"); }, [&] { eraseFrom(id, recording_ids); });
    }
}

void SetStore::removeFromAll(RecordingId recording_id) {
    for (const SetId id : holding(recording_id)) {
        eraseFrom(id, {recording_id});
    }
}

void SetStore::putInto(const std::vector<SetId>& set_ids, RecordingId recording_id) {
    for (const SetId id : set_ids) {
        if (find(id)) {
            insertInto(id, {recording_id});
        }
    }
}

std::vector<SetId> SetStore::holding(RecordingId recording_id) const {
    std::vector<SetId> ids;
    for (const RecordingSet& set : sets_) {
        if (contains(set.recordings, recording_id)) {
            ids.push_back(set.id);
        }
    }
    return ids;
}

void SetStore::openList(const QString& path, const OpenOptions& options) {
    const auto list = read_measurement_list(QFileInfo(path).absoluteFilePath().toStdU16String(),
                                            options, measured({}).settings);
    if (!list) {
        emit reported(errorMessage(list.error()));
        return;
    }
    for (const Message& message : warningMessages(QFileInfo(path).fileName(), list->warnings)) {
        emit reported(message);
    }
    open(*list);
    emit opened({path});
}

void SetStore::open(const MeasurementList& list) {
    std::vector<RecordingSet> sets = openSets(list, recordings_);
    for (const MeasurementSet& set : list.sets) {
        if (const QStringList twice = namedTwice(set); !twice.isEmpty()) {
            emit reported(warningMessage([name = QString::fromStdString(set.name), twice] {
                return tr("The set %1 of the list names these recordings more than once: %2. Each "
                          "counts once.")
                    .arg(name, twice.join(QStringLiteral(", ")));
            }));
        }
    }
    enter(std::move(sets), [] { return tr("sets of the list"); });
}

void SetStore::openLogs(const MeasurementSet& set) {
    std::vector<RecordingSet> sets = openSets({{}, {set}, {}}, recordings_);
    sets.front().by_panel = true;
    enter(std::move(sets), [] { return tr("open logs"); });
    identifySet(current_);
    emit opened(pathsOf(set));
}

void SetStore::setLogs(SetId id, const MeasurementSet& set) {
    RecordingSet* now = entry(id);
    if (!now || !isOfLogs(*now)) {
        return;
    }
    const QStringList before = pathsOf(measured(*now));
    const RecordingSet other = std::move(openSets({{}, {set}, {}}, recordings_).front());
    step([] { return tr("logs of the set"); },
         [&] {
             now->name = other.name;
             now->listed = other.listed;
             edited(*now);
         });
    QStringList further = pathsOf(set);
    further.removeIf([&before](const QString& path) { return before.contains(path); });
    if (!further.isEmpty()) {
        emit opened(further);
    }
}

void SetStore::enter(std::vector<RecordingSet> sets, UndoSteps::Words words) {
    step(std::move(words), [&] {
        const std::size_t first = sets_.size();
        append(std::move(sets));
        current_ = first < sets_.size() ? sets_[first].id : SetId::none;
    });
    emit changed();
}

void SetStore::append(std::vector<RecordingSet> sets) {
    for (RecordingSet& set : sets) {
        set.id = ids_.next<SetId>();
        set.number = ++made_;
        sets_.push_back(std::move(set));
    }
}

MeasurementSet SetStore::measured(const RecordingSet& set) const {
    return measurementOf(set, settings_, recordings_);
}

// Without a set, recordings that were opened together are one. Logs are read by the identification.
bool SetStore::canIdentify() const {
    const RecordingSet* set = current();
    if (set && isOfLogs(*set)) {
        return hasMembers(*set);
    }
    const std::vector<RecordingId> ids =
        set && !set->recordings.empty() ? set->recordings : recordings_.openedTogether();
    return !ids.empty() && std::ranges::all_of(ids, [this](RecordingId id) {
        return recordings_.find(id)->recording.has_value();
    });
}

void SetStore::identify() {
    if (!canIdentify()) {
        return;
    }
    if (!current() || (current()->recordings.empty() && !isOfLogs(*current()))) {
        addToCurrent(recordings_.openedTogether());
    }
    identifySet(current_);
}

void SetStore::identifySet(SetId id) {
    const RecordingSet& set = *find(id);
    queue_.forget(queue_.keyOfSet(set.id));
    const MeasurementSet wanted = measured(set);
    if (const Status alike = check_conditions(wanted); !alike) {
        refuse(id, wanted, alike.error());
        return;
    }
    OpenSet open;
    open.set = wanted;
    for (const auto recording : set.recordings) {
        open.recordings.push_back(*recordings_.find(recording)->recording);
    }
    const int key = ids_.next();
    Request request;
    request.set_id = set.id;
    queue_.enter(key, request);
    job_.identify(key, std::move(open), [this, key, wanted](Result<SavedResult>&& result) {
        whenIdentified(key, wanted, std::move(result));
    });
}

void SetStore::whenIdentified(int key, const MeasurementSet& wanted, Result<SavedResult>&& result) {
    const auto id = queue_.find(key)->set_id;
    if (result) {
        RecordingSet& set = *entry(id);
        // Older ones of other recordings, or of the same settings, have no use any more.
        std::erase_if(set.outcomes, [&](const auto& older) {
            return !sameMembers(older->set.recordings, result->set.recordings) ||
                   older->identification.settings == result->identification.settings;
        });
        set.outcomes.push_back(std::make_shared<const SavedResult>(std::move(*result)));
        set.kept.reset();
        set.kept_up_to_date = false;
        emit changed();
        emit identified(id);
    } else if (result.error().code != ErrorCode::interrupted) {
        refuse(id, wanted, result.error());
    }
    queue_.done(key);
}

void SetStore::refuse(SetId id, const MeasurementSet& wanted, const Error& error) {
    entry(id)->refusal = {wanted, error};
    emit reported(errorMessage(error));
}

bool SetStore::outOfDate(const RecordingSet& set, const SetResult& outcome) const {
    return !isOf(outcome, set) || outcome.identification.settings != measured(set).settings;
}

std::shared_ptr<const SavedResult> SetStore::outcome(const RecordingSet& set) const {
    const auto up_to_date = std::ranges::find_if(
        set.outcomes, [&](const auto& outcome) { return !outOfDate(set, *outcome); });
    if (up_to_date != set.outcomes.end()) {
        return *up_to_date;
    }
    return set.outcomes.empty() ? nullptr : set.outcomes.back();
}

SetResult SetStore::underPresentConditions(const RecordingSet& set,
                                           const SetResult& outcome) const {
    if (isOfLogs(set)) {  // the list's conditions of a log do not change
        SetResult result = outcome;
        result.set.name = set.name.toStdString();
        return result;
    }
    RecordingSet ordered = set;
    ordered.recordings.clear();
    for (const RecordingRef& recording : outcome.set.recordings) {
        ordered.recordings.push_back(static_cast<RecordingId>(recording.id));
    }
    SetResult result = outcome;
    result.set = asRead(measured(ordered), outcome.set);
    return result;
}

void SetStore::savePassport(const QString& path, const GyroData& session,
                            std::function<void(const Status&)> done) {
    const RecordingSet* set = current();
    if (const auto found = set ? outcome(*set) : nullptr) {
        SetResult result = underPresentConditions(*set, *found);
        result.set = told(std::move(result.set), session);
        job_.write(
            ids_.next(),
            [result = std::move(result),
             to = std::filesystem::path(path.toStdU16String())](const JobControl& job) {
                return write_file(to, passport_json(passport_of(result)), job);
            },
            std::move(done));
    }
}

std::optional<Diagnostic> SetStore::otherGyro(const Passport& passport,
                                              const GyroData& session) const {
    const RecordingSet* set = current();
    return set ? other_gyro(passport, gyro_of(told(measured(*set), session))) : std::nullopt;
}

}  // namespace vybeg::ui

#include "moc_set_store.cpp"
