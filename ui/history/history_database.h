#pragma once

#include "core/analysis/measurement_list.h"
#include "core/database/results_database.h"
#include "ui/document/background_jobs.h"
#include "ui/document/document.h"
#include "ui/history/history_charts.h"

#include <QDialog>
#include <QObject>
#include <QString>
#include <QStringList>

#include <memory>
#include <string>

class QComboBox;
class QDialogButtonBox;
class QLabel;
class QLineEdit;

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

// Asks under which gyro and date a result goes into the database.
class StoreDialog : public QDialog {
    Q_OBJECT

public:
    // `gyros`: those of the database. The date is ISO 8601 or empty.
    StoreDialog(const QStringList& gyros, const QString& gyro, const QString& date,
                QWidget* parent = nullptr);

signals:
    void chosen(const QString& gyro, const QString& date);

private:
    void refresh();

    QComboBox* gyro_;
    QLineEdit* date_;
    QLabel* fault_;
    QDialogButtonBox* buttons_;
};

// The way of the current set's result into a database of results.
class ResultAdder : public QObject {
    Q_OBJECT

public:
    explicit ResultAdder(Document& document) : document_(document) {}

    // The result with the present recordings and settings; null: there is none.
    std::shared_ptr<const ResonatorOutcome> addable() const;
    // Asks for gyro and date; `gyros` of the database are proposed.
    void ask(const QString& path, const QStringList& gyros, QWidget* window);

signals:
    // The database at `path` has it.
    void added(const QString& path);

private:
    void add(const QString& path, const QString& gyro, const QString& date);

    Document& document_;
    BackgroundJobs job_;
};

}  // namespace vybeg::ui
