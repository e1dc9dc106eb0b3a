#pragma once

#include "ui/document/background_jobs.h"
#include "ui/document/document.h"

#include <QObject>
#include <QString>
#include <QStringList>

#include <memory>

namespace vybeg::ui {

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
