#pragma once

#include "core/resonator/results/resonator_parameters.h"
#include "ui/document/document.h"
#include "ui/plots/plot_view.h"
#include "ui/resonator/resonator_text.h"
#include "ui/values/recording_set.h"
#include "ui/widgets/theme.h"
#include "ui/words/display_units.h"

#include <QWidget>

#include <memory>
#include <utility>
#include <vector>

class QComboBox;
class QGridLayout;
class QLabel;
class QPushButton;

namespace vybeg::ui {

class NumberField;
class QuantityTable;
class RoundView;
class Section;
class WarningList;
class XYPlotView;

// What a part of the page Resonator shows of an identification.
class OutcomeView : public QWidget {
    Q_OBJECT

public:
    using QWidget::QWidget;

    // Null: the set is not identified yet.
    void setOutcome(std::shared_ptr<const ResonatorOutcome> outcome) {
        shown_ = std::move(outcome);
        rebuild();
    }
    void setUnits(const DisplayUnits& units) {
        units_ = units;
        rebuild();
    }
    void setTheme(const Theme& theme);

signals:
    void exportWanted(const Figure& figure);

protected:
    virtual void rebuild() = 0;
    // A plot in the view's theme; its export is exportWanted().
    template <class Plot>
    Plot* withPlot(Plot* plot) {
        plots_.push_back(plot);
        connect(plot, &PlotView::exportWanted, this, &OutcomeView::exportWanted);
        return plot;
    }

    std::shared_ptr<const ResonatorOutcome> shown_;
    DisplayUnits units_;
    Theme theme_ = lightTheme();

private:
    std::vector<PlotView*> plots_;
};

// An identification as tables, with the sentences that belong to them.
class NumbersView : public OutcomeView {
    Q_OBJECT

public:
    explicit NumbersView(QWidget* parent = nullptr);

    void setLimits(const std::vector<ParameterLimit>& limits);

signals:
    // One of calibrationOffers().
    void calibrationChosen(const QString& offer, const vybeg::ui::FoundCalibration& found);

private:
    void rebuild() override;
    void retranslate();
    static QString modesTitle(const ResonatorFit& fit);

    std::vector<ParameterLimit> limits_;
    WarningList* findings_;
    WarningList* warnings_;
    QLabel* statistical_;
    QuantityTable* waves_;
    QuantityTable* resonator_;
    QuantityTable* sensitivities_;
    QuantityTable* modes_;
    QuantityTable* runs_;
    Section* waves_section_;
    Section* resonator_section_;
    Section* sensitivities_section_;
    Section* modes_section_;
    Section* runs_section_;
};

// An identification as figures: the rim, the drift function and the balance of the channels; for
// the free model, the reason for their absence.
class FiguresView : public OutcomeView {
    Q_OBJECT

public:
    explicit FiguresView(QWidget* parent = nullptr);

    FigureSource figures() const;

private:
    QWidget* buildPlots();
    // The rim beside the drift function, or above it where the page is narrow.
    void place(bool side_by_side);
    void rebuild() override;
    void showBalance();
    void retranslate();

    QLabel* hint_;
    QWidget* plots_ = nullptr;
    QGridLayout* grid_ = nullptr;
    QLabel* rim_name_ = nullptr;
    RoundView* rim_ = nullptr;
    QLabel* drift_name_ = nullptr;
    XYPlotView* drift_plot_ = nullptr;
    QuantityTable* drift_ = nullptr;
    QLabel* balance_name_ = nullptr;
    QComboBox* balance_axis_ = nullptr;
    XYPlotView* balance_plot_ = nullptr;
};

// The current set compared with the open passport; hidden without one.
class ComparisonView : public OutcomeView {
    Q_OBJECT

public:
    explicit ComparisonView(Document& document, QWidget* parent = nullptr);

    void open();

private:
    void rebuild() override;
    void retranslate();

    Document& document_;
    QLabel* passport_;
    QLabel* other_gyro_;
    QLabel* limit_label_;
    NumberField* limit_;
    QuantityTable* differences_;
    QLabel* incomparable_;
    QComboBox* track_choice_;
    XYPlotView* tracks_;
    QPushButton* close_;
    Section* section_;
};

}  // namespace vybeg::ui
