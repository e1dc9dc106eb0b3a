#pragma once

#include "ui/document/document.h"

#include <QTreeWidget>

class QAction;

namespace vybeg::ui {

// The runs: a row per analysis with its colour, source and results. The check box shows it in the
// plots; F2 renames, Delete removes, Ctrl+R analyses again with its settings. A mark in the row
// opens its warnings; if leakage limits the mean frequency, the row has the button Snap.
class RunList : public QTreeWidget {
    Q_OBJECT

public:
    explicit RunList(Document& document, QWidget* parent = nullptr);

    // The run of the current row, 0 without one.
    int currentRun() const;
    void setCurrentRun(int id);
    QSize sizeHint() const override { return {600, 130}; }

signals:
    void currentRunChanged(int id);

protected:
    void changeEvent(QEvent* event) override;

private:
    enum Column {
        name,
        recording,
        algorithm,
        window,
        windows,
        frequency,
        noise,
        time,
        notes,
        column_count
    };

    void rebuild();
    void retranslate();
    void fill(QTreeWidgetItem& item, const RunEntry& entry);
    void fillNotes(QTreeWidgetItem& item, const RunEntry& entry);

    Document& document_;
    QAction* rename_;
    QAction* rerun_;
    QAction* remove_;
};

// A sample of a run's line: its colour and dash.
QIcon runIcon(const Run& run);

}  // namespace vybeg::ui
