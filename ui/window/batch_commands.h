#pragma once

#include "core/analysis/measurement_list.h"
#include "ui/batch/batch_form.h"
#include "ui/words/display_units.h"

#include <QObject>
#include <QPointer>

namespace vybeg::ui {

class BatchWindow;
class Document;
class FileQuestions;

// The window of a batch, its questions for files, and its way back: a set that is opened from its
// table.
class BatchCommands : public QObject {
    Q_OBJECT

public:
    BatchCommands(Document& document, QWidget* window);

    // Shows the window of the batch, which is made once.
    void show();
    void setUnits(const DisplayUnits& units);
    // The program ends.
    void leave();

signals:
    void setOpened();
    void helpWanted();

private:
    void ask(FileQuestions& questions, BatchPath which);
    void openSet(const MeasurementList& list);

    Document& document_;
    QWidget* window_;
    DisplayUnits units_;
    QPointer<BatchWindow> batch_;
};

}  // namespace vybeg::ui
