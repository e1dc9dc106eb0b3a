#pragma once

#include "core/analysis/measurement_list.h"
#include "core/database/results_database.h"
#include "core/database/stored_result.h"
#include "ui/document/background_jobs.h"
#include "ui/document/document.h"
#include "ui/history/history_charts.h"

#include <QStringList>

#include <functional>
#include <string>

namespace vybeg::ui {

// A stored result as a measurement list of one set, with its settings; `settings_known`: whether
// they could be read from the result. Recordings that are not where they were are left out.
struct StoredSet {
    MeasurementList list;
    QStringList missing;  // paths
    bool settings_known = true;
};

StoredSet storedSet(const StoredResult& result, const IdentifySettings& otherwise);

// A database of results in the background: each job opens the file for itself, so that none of them
// holds it. A message of the document names a wait for another program. Errors: those of
// ResultsDatabase.

// Makes the file where there is none, and says whether it is a database.
void makeDatabase(BackgroundJobs& job, int key, Document& document, const QString& path,
                  Done<bool> done);

// Gyros, and the history of a parameter. Without `gyro`, of all.
void readHistory(BackgroundJobs& job, int key, Document& document, const QString& path,
                 const std::optional<std::string>& gyro, const std::string& parameter,
                 Done<StoredHistory> done);

void readResult(BackgroundJobs& job, int key, Document& document, const QString& path,
                std::int64_t id, Done<StoredResult> done);

// As `vybeg-cli batch --database` does. `done` gets the name of the earlier result that it
// replaces.
void storeResult(BackgroundJobs& job, int key, Document& document, const QString& path,
                 SetResult result, Done<std::optional<StoredName>> done);

}  // namespace vybeg::ui
