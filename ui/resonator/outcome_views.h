#pragma once

#include "core/resonator/results/resonator_parameters.h"
#include "ui/document/document.h"
#include "ui/plots/plot_view.h"
#include "ui/resonator/resonator_plots.h"
#include "ui/resonator/resonator_text.h"
#include "ui/values/recording_set.h"

#include <array>
#include <memory>
#include <utility>
#include <vector>

class QAction;
class QComboBox;
class QLabel;
class QPushButton;
class QTableWidgetItem;
class QTabWidget;

namespace vybeg::ui {

class NumberField;
class QuantityTable;
class RoundView;
class WarningList;

// What a part of the page Resonator shows of an identification.
class OutcomeView : public MeasuredPage {
public:
    OutcomeView(Document& document, QWidget* parent);

    // Null: the set is not identified yet.
    void setOutcome(std::shared_ptr<const SetResult> outcome);

protected:
    Document& document_;
    std::shared_ptr<const SetResult> shown_;
    RunStyles styles_;  // of its recordings
};

// The parameters of the resonator, with their limits and their change since the open passport, of
// the free model its modes, with what their uncertainties hold; below them, a tab each, tables of
// what they follow from.
class NumbersView : public OutcomeView {
    Q_OBJECT

public:
    explicit NumbersView(Document& document, QWidget* parent = nullptr);

    // A further tab, which scrolls; its title is tabs()->setTabText().
    int addTab(QWidget* content);
    QTabWidget* tabs() const { return tabs_; }
    bool isEmpty() const { return !shown_; }

signals:
    // One of calibrationOffers().
    void calibrationChosen(const QString& offer, const vybeg::ui::FoundCalibration& found);

private:
    void showAgain() override;
    void retranslate() override;
    static QString modesTitle(const ResonatorFit& fit);
    void showParameters();
    void showStatistical();
    void say(const QTableWidgetItem* item);

    WarningList* warnings_;
    QuantityTable* resonator_;
    QLabel* reason_;  // of the chosen cell
    QLabel* statistical_;
    bool told_ = false;  // in full
    QTabWidget* tabs_;
    WarningList* findings_;
    QuantityTable* waves_;
    std::array<QuantityTable*, 2> runs_;
    QuantityTable* modes_;
    QuantityTable* sensitivities_;
    int recordings_tab_ = 0;
    int modes_tab_ = 0;
    int sensitivities_tab_ = 0;
};

// An identification as figures: the rim, the drift function with its harmonics and, to be put
// elsewhere, the balance of the channels; for the free model, the reason for their absence.
class FiguresView : public OutcomeView {
    Q_OBJECT

public:
    explicit FiguresView(Document& document, QWidget* parent = nullptr);

    FigureSource figures() const override;
    QWidget* balance() const { return balance_; }

private:
    void showAgain() override;
    void showBalance();
    void retranslate() override;

    QLabel* hint_;
    QWidget* plots_;
    QLabel* rim_name_;
    RoundView* rim_;
    QLabel* drift_name_;
    XYPlotView* drift_plot_;
    QLabel* drift_;  // its harmonics
    QAction* copy_drift_;
    QWidget* balance_;
    QLabel* balance_name_;
    QComboBox* balance_axis_;
    XYPlotView* balance_plot_;
};

// The current set compared with the open passport.
class ComparisonView : public OutcomeView {
    Q_OBJECT

public:
    explicit ComparisonView(Document& document, QWidget* parent = nullptr);

private:
    void showAgain() override;
    void retranslate() override;

    QLabel* passport_;
    QLabel* other_gyro_;
    QLabel* limit_label_;
    NumberField* limit_;
    QuantityTable* differences_;
    QLabel* incomparable_;
    QComboBox* track_choice_;
    XYPlotView* tracks_;
    QPushButton* close_;
};

}  // namespace vybeg::ui
