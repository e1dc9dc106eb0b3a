#pragma once

#include "ui/document/document.h"
#include "ui/panels/ledger_rows.h"
#include "ui/panels/measuring.h"
#include "ui/values/ids.h"
#include "ui/values/shown_analysis.h"
#include "ui/words/display_units.h"

#include <QTreeWidget>

#include <functional>
#include <utility>
#include <vector>

class QAction;

namespace vybeg::ui {

class LedgerHead;

// The recordings and their analyses, a row for each analysis and for each recording without one.
// The columns read the slow variables of the plots at the mouse, at the cursors, between them or
// as a trend, as the switch in the header says.
//
// The current row is the chosen analysis and the current recording. The check box shows an
// analysis in the plots; F2 renames, Ctrl+R analyses again, Delete removes, Insert adds the
// recordings of the selected rows to the current set.
class Ledger : public QTreeWidget {
    Q_OBJECT

public:
    explicit Ledger(Document& document, QWidget* parent = nullptr);

    // The analysis of the current row, none without one.
    AnalysisId currentAnalysis() const;
    void setCurrentAnalysis(AnalysisId id);
    std::vector<RecordingId> selectedRecordings() const;
    // How the sets are called, which stand beside the names of recordings.
    void setSetNames(std::function<QString(const RecordingSet&)> name_of) {
        name_of_set_ = std::move(name_of);
    }

    void setUnits(const DisplayUnits& units);
    // Those of the plots.
    void setVariables(const std::vector<SlowVariable>& variables);
    void setMouse(std::optional<double> time_s);
    void setCursors(std::optional<double> a_s, std::optional<double> b_s);
    TrendKind trendKind() const { return measuring_.kind; }
    void setTrendKind(TrendKind kind);
    ReadAt readAt() const { return read_at_; }
    void setReadAt(ReadAt at);
    // The tables at the mouse and, with both cursors, at the cursors (measuring.h).
    QString tableText() const;
    // Column of a variable, or of other things by their titles in the header.
    int columnOf(SlowVariable variable) const;
    int noiseColumn() const { return first_variable + static_cast<int>(variables_.size()); }
    int notesColumn() const { return noiseColumn() + 1; }

    enum Column { name = name_column, algorithm, window, frequency, trend, first_variable };

signals:
    void currentAnalysisChanged(AnalysisId id);
    // Trends of the chosen analysis, to draw over the plots; empty without both cursors.
    void trendsChanged(const std::vector<TrendCurve>& trends);

protected:
    void resizeEvent(QResizeEvent* event) override;

private:
    void addActions();
    void rebuild();
    void retranslate();
    void fill(const LedgerRow& row, QTreeWidgetItem& item);
    QString setsOf(RecordingId id) const;
    void chooseRow();
    void measure();
    void fillCells();
    LedgerReader reader() const { return {document_, read_at_, measuring_, trends_, units_}; }
    void fillVariables();
    void layoutColumns();
    void fitHeight();
    void enableActions();

    Document& document_;
    LedgerHead* head_;
    QAction* rename_;
    QAction* again_;
    QAction* add_to_set_;
    QAction* reopen_;
    QAction* copy_facts_;
    QAction* remove_;
    std::function<QString(const RecordingSet&)> name_of_set_;
    DisplayUnits units_;
    std::vector<SlowVariable> variables_{main_slow_variables.begin(), main_slow_variables.end()};
    Measuring measuring_;
    MeasuredTrends trends_;
    std::vector<TrendCurve> drawn_;
    ReadAt read_at_ = ReadAt::mouse;
    bool concise_ = false;  // there is no room for ±
};

}  // namespace vybeg::ui
