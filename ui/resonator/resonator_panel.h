#pragma once

#include "ui/document/document.h"
#include "ui/resonator/resonator_plots.h"
#include "ui/widgets/theme.h"
#include "ui/words/display_units.h"

#include <QWidget>

class QComboBox;
class QLabel;
class QPushButton;
class QVBoxLayout;

namespace vybeg::ui {

class NumberField;
class QuantityTable;
class Section;
class SetPanel;
class XYPlotView;

// The resonator of the current set: recordings, results, comparison with a passport.
class ResonatorPanel : public QWidget {
    Q_OBJECT

public:
    explicit ResonatorPanel(Document& document, QWidget* parent = nullptr);

    void setUnits(const DisplayUnits& units);
    void setTheme(const Theme& theme);
    // Opens the comparison.
    void showComparison();

    QSize sizeHint() const override { return {330, 500}; }

signals:
    // The user wants to export a plot.
    void exportWanted(const XYPlot& plot);

protected:
    void changeEvent(QEvent* event) override;

private:
    Section* addSection(QVBoxLayout& layout, std::initializer_list<QWidget*> parts);
    void refresh();
    void rebuild();
    void showResult(const ResonatorOutcome& outcome);
    void showState(const RunSet* set, const ResonatorOutcome* outcome);
    void showDifferences(const ResonatorOutcome* outcome);
    void retranslate();
    static QString modesTitle(const ResonatorFit& fit);

    Document& document_;
    DisplayUnits units_;
    Theme theme_;
    std::shared_ptr<const ResonatorOutcome> shown_;
    SetPanel* set_;
    QLabel* state_;
    QLabel* findings_;
    QLabel* warnings_;
    QuantityTable* waves_;
    QuantityTable* resonator_;
    QLabel* statistical_;
    QuantityTable* sensitivities_;
    QuantityTable* modes_;
    QuantityTable* runs_;
    XYPlotView* drift_plot_;
    QuantityTable* drift_;
    XYPlotView* balance_plot_;
    QLabel* passport_;
    QLabel* incomparable_;
    QPushButton* close_passport_;
    QuantityTable* differences_;
    QComboBox* track_choice_;
    XYPlotView* tracks_;
    QLabel* limit_label_;
    NumberField* limit_;
    Section* waves_section_;
    Section* resonator_section_;
    Section* sensitivities_section_;
    Section* modes_section_;
    Section* runs_section_;
    Section* drift_section_;
    Section* balance_section_;
    Section* comparison_section_;
};

}  // namespace vybeg::ui
