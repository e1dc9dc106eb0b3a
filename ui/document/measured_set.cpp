#include "ui/document/measured_set.h"

#include <QDir>
#include <QFileInfo>

#include <algorithm>
#include <memory>
#include <utility>

namespace vybeg::ui {

namespace {

// The window is the identification's own: that of the tracks has another purpose.
IdentifySettings settingsOfPanel(const SettingsModel& settings) {
    IdentifySettings own;
    own.signal = settings.settings();
    own.tolerance = settings.tolerance();
    return own;
}

RecordingRef rowOf(const RecordingEntry& entry) {
    return {entry.name.toStdString(), entry.path.toStdU16String(), entry.options};
}

// Ids of the recordings of all sets of recordings in their order; those that are not open yet are
// opened together.
std::vector<RecordingId> openEachOnce(const MeasurementList& list, RecordingStore& recordings) {
    std::vector<RecordingToOpen> wanted;
    for (const MeasurementSet& set : list.sets) {
        if (set.settings.logs.given()) {
            continue;
        }
        for (const RecordingRef& row : set.recordings) {
            const QString path = QString::fromStdU16String(row.path.u16string());
            wanted.push_back({QDir::cleanPath(QFileInfo(path).absoluteFilePath()), row.open});
        }
    }
    return recordings.openOnce(wanted);
}

// Logs hold no samples, and with a phase no carrier is searched.
SignalSettings byPanel(SignalSettings of_log, const LogChoice& logs, const SettingsModel& panel) {
    of_log.calibration = panel.settings().calibration;
    of_log.calibration.offset_auto = false;
    of_log.calibration.offset_c = of_log.calibration.offset_d = 0;
    of_log.f0_hz = logs.without_phase() ? panel.settings().f0_hz : std::nullopt;
    return of_log;
}

}  // namespace

MeasurementSet measurementOf(const RecordingSet& set, const SettingsModel& settings,
                             const RecordingStore& recordings) {
    MeasurementSet measured;
    measured.name = set.name.toStdString();
    measured.settings = set.listed ? set.listed->settings : settingsOfPanel(settings);
    measured.settings.model = set.model;
    std::vector<SignalSettings> of_each;
    if (isOfLogs(set)) {
        if (set.listed->by_panel) {
            measured.settings.tolerance = settings.tolerance();
        }
        for (const auto& log : set.listed->members) {
            measured.recordings.push_back(log.second.row);
            of_each.push_back(set.listed->by_panel
                                  ? byPanel(log.second.signal, measured.settings.logs, settings)
                                  : log.second.signal);
        }
    }
    for (const RecordingId id : set.recordings) {
        const ListedMember* listed = nullptr;
        if (set.listed) {
            const auto found = set.listed->members.find(id);
            listed = found == set.listed->members.end() ? nullptr : &found->second;
        }
        const RecordingEntry& entry = *recordings.find(id);
        measured.recordings.push_back(listed ? listed->row : rowOf(entry));
        measured.recordings.back().sha256 = entry.sha256.toStdString();
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

QStringList namedTwice(const MeasurementSet& set) {
    QStringList files;
    const auto& rows = set.recordings;
    for (std::size_t k = 0; k < rows.size(); ++k) {
        const auto same = [&](const RecordingRef& earlier) {
            return earlier.path == rows[k].path && earlier.open == rows[k].open;
        };
        const QString file = QString::fromStdString(rows[k].file);
        if (std::any_of(rows.begin(), rows.begin() + static_cast<std::ptrdiff_t>(k), same) &&
            !files.contains(file)) {
            files << file;
        }
    }
    return files;
}

std::vector<RecordingSet> openSets(const MeasurementList& list, RecordingStore& recordings) {
    const std::vector<RecordingId> ids = openEachOnce(list, recordings);
    std::size_t next = 0;
    std::vector<RecordingSet> sets;
    for (const MeasurementSet& measured : list.sets) {
        RecordingSet set;
        set.name = QString::fromStdString(measured.name);
        set.model = measured.settings.model;
        ListedSet listed{measured.settings, {}};
        listed.settings.of_recordings.clear();
        const bool of_logs = measured.settings.logs.given();
        const auto count = static_cast<int>(measured.recordings.size());
        for (std::size_t k = 0; k < measured.recordings.size(); ++k) {
            const auto id =
                of_logs ? static_cast<RecordingId>(static_cast<int>(k) - count) : ids[next++];
            listed.members.insert_or_assign(
                id, ListedMember{measured.recordings[k], measured.settings.signal_of(k)});
            if (!of_logs && std::ranges::find(set.recordings, id) == set.recordings.end()) {
                set.recordings.push_back(id);
            }
        }
        set.listed = std::make_shared<const ListedSet>(std::move(listed));
        sets.push_back(std::move(set));
    }
    return sets;
}

}  // namespace vybeg::ui
