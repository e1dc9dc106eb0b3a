#pragma once

#include "ui/document/edits.h"
#include "ui/document/recording_store.h"
#include "ui/values/ids.h"
#include "ui/values/recording_set.h"

#include <QStringList>

#include <vector>

namespace vybeg::ui {

// A set with all that belongs to its identification: recordings with their conditions, and the
// settings, which are those of its measurement list or of the panel. Precondition: its recordings
// are in `recordings`.
MeasurementSet measurementOf(const RecordingSet& set, const SettingsModel& settings,
                             const RecordingStore& recordings);

// Files of the set's measurement list that are not among its recordings: not opened, or removed.
QStringList absentFiles(const RecordingSet& set);

// The same list with the row of that file for the recording `id`.
ListedSet withRowFor(const ListedSet& listed, const QString& path, RecordingId id);

// Files that a set of a list names more than once.
QStringList namedTwice(const MeasurementSet& set);

// Opens the recordings of a measurement list, but no logs, and makes a set of the document of each
// of its sets, still without ids. A recording that is open already, read in the same way, is taken
// as it is.
std::vector<RecordingSet> openSets(const MeasurementList& list, RecordingStore& recordings);

}  // namespace vybeg::ui
