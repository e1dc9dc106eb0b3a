#pragma once

#include "core/analysis/passport.h"
#include "ui/values/ids.h"

#include <QJsonObject>
#include <QString>

#include <algorithm>
#include <cstddef>
#include <memory>
#include <optional>
#include <utility>
#include <vector>

namespace vybeg::ui {

// A result with the JSON by which a session keeps it.
struct SavedResult : SetResult {
    QJsonObject json;            // saved_result_json()
    std::optional<Error> fault;  // why the JSON of a session is none; without a result
};

// Recordings of one resonator, started at different angles, that are identified together. A single
// recording is a set of one.
struct RecordingSet {
    SetId id = SetId::none;
    int number = 0;  // for the default name
    QString name;    // empty: default name
    std::vector<RecordingId>
        recordings;  // ids in the document, in the order in which they were added
    FitOptions::Model model = FitOptions::Model::automatic;
    // What a measurement list says of the set: its rows with the ids of their recordings, none for
    // a row whose recording is not there. Logs, which no document opens, are all such rows.
    // Recordings that come to the set later have the signal settings of the list. Null: the
    // settings of the panel hold.
    std::shared_ptr<const MeasurementSet> listed;
    // Of logs that no list names: calibration and tolerances are those of the panel.
    bool by_panel = false;
    // The newest last, with the ids of their recordings. All have the present recordings of the
    // set; otherwise only the last one remains, out of date.
    std::vector<std::shared_ptr<const SavedResult>> outcomes;
    // Why these recordings with these settings have no result; with the set as it was asked for.
    std::optional<std::pair<MeasurementSet, Error>> refusal;
    // Result that a session brings, shown until the set is identified here.
    std::shared_ptr<const SavedResult> kept;  // null: none
    bool kept_up_to_date = false;             // with the recordings and settings of the session
    // Keys of the set in its session that this program does not know, written again.
    QJsonObject unknown;
};

inline QString pathText(const RecordingRef& recording) {
    return QString::fromStdU16String(recording.path.u16string());
}

// Whether it has logs in place of recordings: they are the rows of `listed`.
inline bool isOfLogs(const RecordingSet& set) {
    return set.listed && set.listed->settings.logs.given();
}

// Whether it has what an identification needs, recordings or logs.
inline bool hasMembers(const RecordingSet& set) {
    return isOfLogs(set) ? !set.listed->recordings.empty() : !set.recordings.empty();
}

// Whether it shows something without an open recording.
inline bool hasContent(const RecordingSet& set) {
    return isOfLogs(set) || set.kept;
}

// The place of a recording's row in what the list says of the set; none: it has no row.
inline std::optional<std::size_t> rowOf(const RecordingSet& set, RecordingId id) {
    if (set.listed) {
        const auto& rows = set.listed->recordings;
        const auto found = std::ranges::find(rows, number(id), &RecordingRef::id);
        if (found != rows.end()) {
            return static_cast<std::size_t>(found - rows.begin());
        }
    }
    return std::nullopt;
}

}  // namespace vybeg::ui
