#pragma once

#include "ui/document/document.h"
#include "ui/values/ids.h"

#include <QTreeWidget>

class QAction;

namespace vybeg::ui {

// The analyses: a row per analysis with its colour, source and results. The check box shows it in
// the plots; F2 renames, Delete removes, Ctrl+R analyses again with its settings. A mark in the row
// opens its warnings; if leakage limits the mean frequency, the row has the button Snap.
class AnalysisList : public QTreeWidget {
    Q_OBJECT

public:
    explicit AnalysisList(Document& document, QWidget* parent = nullptr);

    // The analysis of the current row, none without one.
    AnalysisId currentAnalysis() const;
    void setCurrentAnalysis(AnalysisId id);
    QSize sizeHint() const override { return {600, 130}; }

signals:
    void currentAnalysisChanged(AnalysisId id);

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

    static AnalysisId analysisOf(const QTreeWidgetItem& item);
    void rebuild();
    void retranslate();
    void fill(QTreeWidgetItem& item, const AnalysisEntry& entry);
    int rowHeight() const;
    void enableActions();
    void fillNotes(QTreeWidgetItem& item, const AnalysisEntry& entry);

    Document& document_;
    QAction* rename_;
    QAction* again_;
    QAction* remove_;
};

// A sample of an analysis's line: its colour and shade.
QIcon curveIcon(const ShownAnalysis& shown);

}  // namespace vybeg::ui
