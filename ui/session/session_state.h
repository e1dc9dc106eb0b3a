#pragma once

#include "ui/document/document.h"
#include "ui/session/session.h"
#include "ui/values/ids.h"

#include <vector>

namespace vybeg::ui {

// The document and the view as a session.
Session sessionOf(const Document& document, const TrackView& tracks);

// Puts a session in the place of all recordings and sets of the document, and begins to compute its
// analyses. Recordings with an empty path are left out. Returns the ids of the recordings in their
// order, 0 for those left out.
std::vector<RecordingId> restoreSession(const Session& session, Document& document);

// What the plots of a session show; for the end of the computations, because plots begin with the
// whole range of each recording that joins.
void restoreView(const SessionView& view, TrackView& tracks);

}  // namespace vybeg::ui
