#pragma once

#include "ui/document/background_jobs.h"
#include "ui/document/document.h"

#include <QDialog>
#include <QObject>
#include <QString>
#include <QStringList>

#include <memory>

class QComboBox;
class QDialogButtonBox;
class QLabel;
class QLineEdit;

namespace vybeg::ui {

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
