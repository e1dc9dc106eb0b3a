#pragma once

#include "core/analysis/measurement_list.h"
#include "ui/document/edits.h"
#include "ui/document/recording_store.h"
#include "ui/values/recording_set.h"

#include <QStringList>

#include <vector>

namespace vybeg::ui {

// All that belongs to the identification of a set: recordings with their conditions, and the
// settings, which are those of its measurement list or of the panel. Precondition: its recordings
// are open.
MeasurementSet measurementOf(const RecordingSet& set, const SettingsModel& settings,
                             const RecordingStore& recordings);

// Whether they are the same members of a set, in any order: the resonator is the same. Logs, which
// have no ids, are the same files, read in the same way.
bool sameMembers(const std::vector<RecordingRef>& a, const std::vector<RecordingRef>& b);

// Why a set has no result, where it was refused as it is now; null otherwise.
const Error* refusalOf(const RecordingSet& set, const MeasurementSet& now);

// Files that a set of a list names more than once.
QStringList namedTwice(const MeasurementSet& set);

// Opens the recordings of a measurement list, but no logs, and makes a set of the document of each
// of its sets, still without ids. A recording that is open already, read in the same way, is taken
// as it is.
std::vector<RecordingSet> openSets(const MeasurementList& list, RecordingStore& recordings);

}  // namespace vybeg::ui
