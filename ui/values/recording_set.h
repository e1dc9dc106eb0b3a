#pragma once

#include "core/analysis/passport.h"
#include "ui/values/ids.h"

#include <QJsonObject>
#include <QString>

#include <map>
#include <memory>
#include <vector>

namespace vybeg::ui {

// The result of a set of the document.
struct ResonatorOutcome : SetResult {
    std::vector<RecordingId> recordings;  // ids in the document, as set.recordings
    double seconds = 0;                   // duration
    QJsonObject kept;                     // saved_result_json()
};

// Result of an identification that a session brings, shown until the set is identified here.
struct KeptResult {
    QJsonObject json;         // saved_result_json(); empty: none
    bool up_to_date = false;  // with the recordings and settings of the session
};

// One recording, or one log, as its row of a measurement list gives it.
struct ListedMember {
    RecordingRef row;
    SignalSettings signal;
};

// What a measurement list says of a set. Recordings that come to the set later have the signal
// settings of `settings`. `Key`: what names a recording, an id in the document or a place in a
// session.
template <class Key>
struct ListedSetBy {
    IdentifySettings settings;
    // Negative or of no member of the set: a row whose recording is not in it. Logs, which no
    // document opens, are all such rows, in their order.
    std::map<Key, ListedMember> members;
    // Of logs that no list names: calibration and tolerances are those of the panel.
    bool by_panel = false;
};

using ListedSet = ListedSetBy<RecordingId>;

// Recordings of one resonator, started at different angles, that are identified together. A single
// recording is a set of one.
struct RecordingSet {
    SetId id = SetId::none;
    int number = 0;  // for the default name
    QString name;    // empty: default name
    std::vector<RecordingId>
        recordings;  // ids in the document, in the order in which they were added
    FitOptions::Model model = FitOptions::Model::automatic;
    std::shared_ptr<const ListedSet> listed;  // null: the settings of the panel hold
    // The newest last. All have the present recordings of the set; otherwise only the last one
    // remains, out of date.
    std::vector<std::shared_ptr<const ResonatorOutcome>> outcomes;
    KeptResult kept;
};

// Whether it has logs in place of recordings: they are the rows of `listed`.
inline bool isOfLogs(const RecordingSet& set) {
    return set.listed && set.listed->settings.logs.given();
}

// Whether it has what an identification needs, recordings or logs.
inline bool hasMembers(const RecordingSet& set) {
    return isOfLogs(set) ? !set.listed->members.empty() : !set.recordings.empty();
}

// Whether it shows something without an open recording.
inline bool hasContent(const RecordingSet& set) {
    return isOfLogs(set) || !set.kept.json.isEmpty();
}

// Passport for the comparison of sets.
struct OpenPassport {
    QString name;  // of its file
    Passport passport;
};

}  // namespace vybeg::ui
