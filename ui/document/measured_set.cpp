#include "ui/document/measured_set.h"

#include <algorithm>
#include <cstddef>
#include <memory>
#include <optional>
#include <utility>

namespace vybeg::ui {

namespace {

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
    if (set.listed) {
        measured.settings = set.listed->settings;
    } else {
        // The window is the identification's own: that of the tracks has another purpose.
        measured.settings.signal = settings.settings();
        measured.settings.tolerance = settings.tolerance();
    }
    measured.settings.of_recordings.clear();
    measured.settings.model = set.model;
    std::vector<SignalSettings> of_each;
    if (isOfLogs(set)) {
        if (set.by_panel) {
            measured.settings.tolerance = settings.tolerance();
        }
        measured.recordings = set.listed->recordings;
        for (std::size_t k = 0; k < measured.recordings.size(); ++k) {
            const SignalSettings& signal = set.listed->settings.signal_of(k);
            of_each.push_back(set.by_panel ? byPanel(signal, measured.settings.logs, settings)
                                           : signal);
        }
    }
    for (const RecordingId id : set.recordings) {
        const std::optional<std::size_t> row = rowOf(set, id);
        const RecordingEntry& entry = *recordings.find(id);
        measured.recordings.push_back(row ? set.listed->recordings[*row]
                                          : RecordingRef{entry.name.toStdString(),
                                                         entry.path.toStdU16String(),
                                                         entry.options});
        measured.recordings.back().id = number(id);
        measured.recordings.back().sha256 = entry.sha256.toStdString();
        of_each.push_back(row ? set.listed->settings.signal_of(*row) : measured.settings.signal);
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
    std::vector<RecordingRef> wanted;
    for (const MeasurementSet& set : list.sets) {
        if (!set.settings.logs.given()) {
            wanted.insert(wanted.end(), set.recordings.begin(), set.recordings.end());
        }
    }
    // In their order; those that are not open yet are opened together.
    const std::vector<RecordingId> ids = recordings.openOnce(wanted);
    std::size_t next = 0;
    std::vector<RecordingSet> sets;
    for (const MeasurementSet& measured : list.sets) {
        RecordingSet set;
        set.name = QString::fromStdString(measured.name);
        set.model = measured.settings.model;
        auto listed = std::make_shared<MeasurementSet>(measured);
        if (!measured.settings.logs.given()) {
            listed->recordings.clear();
            listed->settings.of_recordings.clear();
            for (std::size_t k = 0; k < measured.recordings.size(); ++k) {
                const RecordingId id = ids[next++];
                const auto known = std::ranges::find(set.recordings, id);
                const auto row = known - set.recordings.begin();
                if (known == set.recordings.end()) {
                    set.recordings.push_back(id);
                    listed->recordings.emplace_back();
                    listed->settings.of_recordings.emplace_back();
                }
                // Of rows that name one recording the last one counts.
                listed->recordings[static_cast<std::size_t>(row)] = measured.recordings[k];
                listed->recordings[static_cast<std::size_t>(row)].id = number(id);
                listed->settings.of_recordings[static_cast<std::size_t>(row)] =
                    measured.settings.signal_of(k);
            }
        }
        set.listed = std::move(listed);
        sets.push_back(std::move(set));
    }
    return sets;
}

bool sameMembers(const std::vector<RecordingRef>& a, const std::vector<RecordingRef>& b) {
    return std::ranges::is_permutation(
        a, b, [](const RecordingRef& one, const RecordingRef& other) {
            return one.id == other.id &&
                   (one.id != 0 || (one.path == other.path && one.open == other.open));
        });
}

const Error* refusalOf(const RecordingSet& set, const MeasurementSet& now) {
    if (!set.refusal) {
        return nullptr;
    }
    const auto& [asked, error] = *set.refusal;
    const bool alike = sameMembers(asked.recordings, now.recordings) &&
                       std::ranges::equal(asked.recordings, now.recordings, {},
                                          &RecordingRef::conditions, &RecordingRef::conditions);
    return alike && asked.settings == now.settings ? &error : nullptr;
}

}  // namespace vybeg::ui
