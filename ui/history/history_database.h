#pragma once

#include "core/analysis/measurement_list.h"
#include "core/database/results_database.h"
#include "ui/document/background_jobs.h"
#include "ui/document/document.h"
#include "ui/history/history_view.h"

#include <QString>
#include <QStringList>

#include <functional>
#include <memory>
#include <optional>
#include <string>

class QWidget;

namespace vybeg::ui {

// The settings of a stored result and of each of its recordings; nothing: they cannot be read.
std::optional<IdentifySettings> settingsOf(const StoredResult& result);

// Leaves out the recordings of a set that are not where they were; returns their paths.
QStringList leaveOutMissing(MeasurementSet& set);

// A job of a database of results in the background, which opens the file for itself, so that none
// of them holds it. A message of the document names a wait for another program. Errors: those of
// ResultsDatabase.
struct DatabaseJob {
    BackgroundJobs& jobs;
    int key;
    Document& document;
    QString path;
};

// Makes the file where there is none, and says whether it is a database.
void makeDatabase(const DatabaseJob& job, Done<bool> done);

// Gyros, and the history of a parameter. Without `gyro`, of all.
void readHistory(const DatabaseJob& job, const std::optional<std::string>& gyro,
                 const std::string& parameter, Done<StoredHistory> done);

void readResult(const DatabaseJob& job, std::int64_t id, Done<StoredResult> done);

// The current set's result with the present recordings and settings; null: there is none.
std::shared_ptr<const SetResult> addableResult(const Document& document);
// Asks under which gyro and date addableResult() goes into the database, and puts it there; then
// calls `added`. `gyros`: those of the database, which are proposed.
void askToAdd(const DatabaseJob& job, const QStringList& gyros, QWidget* window,
              const std::function<void()>& added);

}  // namespace vybeg::ui
