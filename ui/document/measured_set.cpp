#include "ui/document/measured_set.h"

#include <QDir>
#include <QFileInfo>

#include <algorithm>

namespace vybeg::ui {

namespace {

// The window is the identification's own: that of the tracks has another purpose.
IdentifySettings settingsOfPanel(const SettingsModel& settings) {
    IdentifySettings own;
    own.signal = settings.settings();
    own.tolerance = settings.tolerance();
    return own;
}

ListedRecording rowOf(const RecordingEntry& entry) {
    return {entry.name.toStdString(), entry.path.toStdU16String(), entry.options, {}, {}};
}

// The id of a recording, which is opened unless it is open.
int openOnce(const ListedRecording& row, RecordingStore& recordings) {
    const QString path = QDir::cleanPath(
        QFileInfo(QString::fromStdU16String(row.path.u16string())).absoluteFilePath());
    for (const RecordingEntry& entry : recordings.all()) {
        if (entry.path == path && entry.options == row.open) {
            return entry.id;
        }
    }
    recordings.open({path}, row.open);
    return recordings.all().back().id;
}

}  // namespace

MeasurementSet measurementOf(const RecordingSet& set, const SettingsModel& settings,
                             const RecordingStore& recordings) {
    MeasurementSet measured;
    measured.name = set.name.toStdString();
    measured.settings = set.listed ? set.listed->settings : settingsOfPanel(settings);
    measured.settings.model = set.model;
    std::vector<SignalSettings> of_each;
    for (const int id : set.recordings) {
        const ListedMember* listed = nullptr;
        if (set.listed) {
            const auto found = set.listed->members.find(id);
            listed = found == set.listed->members.end() ? nullptr : &found->second;
        }
        measured.recordings.push_back(listed ? listed->row : rowOf(*recordings.find(id)));
        of_each.push_back(listed ? listed->signal : measured.settings.signal);
    }
    if (!of_each.empty()) {
        measured.settings.signal = of_each.front();
        const auto differs = [&](const auto& each) { return each != of_each.front(); };
        if (std::ranges::any_of(of_each, differs)) {
            measured.settings.of_recordings = std::move(of_each);
        }
    }
    return measured;
}

std::vector<RecordingSet> openSets(const MeasurementList& list, RecordingStore& recordings) {
    std::vector<RecordingSet> sets;
    for (const MeasurementSet& measured : list.sets) {
        RecordingSet set;
        set.name = QString::fromStdString(measured.name);
        set.model = measured.settings.model;
        ListedSet listed{measured.settings, list.other_columns, {}};
        listed.settings.of_recordings.clear();
        for (std::size_t k = 0; k < measured.recordings.size(); ++k) {
            const int id = openOnce(measured.recordings[k], recordings);
            listed.members.insert_or_assign(
                id, ListedMember{measured.recordings[k], measured.settings.signal_of(k)});
            if (std::ranges::find(set.recordings, id) == set.recordings.end()) {
                set.recordings.push_back(id);
            }
        }
        set.listed = std::make_shared<const ListedSet>(std::move(listed));
        sets.push_back(std::move(set));
    }
    return sets;
}

}  // namespace vybeg::ui
