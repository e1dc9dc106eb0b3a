#pragma once

#include "core/analysis/identify_settings.h"
#include "core/analysis/settings.h"
#include "core/base/result.h"
#include "core/recording/samples/open_options.h"
#include "ui/document/analysis_store.h"
#include "ui/document/document.h"
#include "ui/document/drift_store.h"
#include "ui/document/edits.h"
#include "ui/document/passport_store.h"
#include "ui/session/session_view.h"
#include "ui/values/ids.h"
#include "ui/values/recording_set.h"

#include <QDir>
#include <QJsonObject>
#include <QString>

#include <vector>

namespace vybeg::ui {

// Everything that makes the same picture and numbers again when the recordings are there: their
// analyses are computed again.
struct Session {
    Settings settings;
    Tolerance tolerance;
    Dossier dossier;
    bool live = true;
    std::vector<ClosedRecording> recordings;
    int current = -1;                // place in `recordings`; -1: none
    std::vector<RecordingSet> sets;  // by the ids of `recordings`
    int current_set = -1;
    int current_analysis = -1;  // place among all analyses
    DriftInput drift;
    PassportInput passport;
    SessionView view;
    // Keys of the file that this program does not know, written again.
    QJsonObject unknown;
};

// The document and the view as a session.
Session sessionOf(const Document& document, const TrackView& tracks);

// Puts a session in the place of all recordings and sets of the document, and begins to compute its
// analyses. Recordings with an empty path are left out. Returns the ids of the recordings in their
// order, 0 for those left out.
std::vector<RecordingId> restoreSession(const Session& session, Document& document);

inline constexpr int session_schema = 1;
inline const QString session_schema_key = QStringLiteral("vybeg_session");

// A session as the JSON object of its file; paths relative to `folder` where they lie below it.
QJsonObject sessionToJson(const Session& session, const QDir& folder);

// The first key whose value is not of the kind that a session has there; empty: none.
QString misplacedKey(const QJsonObject& json);

// The reverse. Values that are missing keep their defaults. Errors: setting_invalid, for a value
// that a setting does not take.
Result<Session> sessionFromJson(const QJsonObject& json, const QDir& folder);

}  // namespace vybeg::ui
