#pragma once

#include "ui/plots/plot_file.h"
#include "ui/resonator/outcome_view.h"

class QComboBox;
class QGridLayout;
class QLabel;

namespace vybeg::ui {

class QuantityTable;
class RoundView;
class XYPlotView;

// An identification as figures: the rim, the drift function and the balance of the channels; for
// the free model, the reason for their absence.
class FiguresView : public OutcomeView {
    Q_OBJECT

public:
    explicit FiguresView(QWidget* parent = nullptr);

    void setTheme(const Theme& theme) override;

    FigureSource figures() const;

signals:
    void exportWanted(const Figure& figure);

protected:
    void resizeEvent(QResizeEvent* event) override;

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
    bool side_by_side_ = true;
    QLabel* rim_name_ = nullptr;
    RoundView* rim_ = nullptr;
    QLabel* drift_name_ = nullptr;
    XYPlotView* drift_plot_ = nullptr;
    QuantityTable* drift_ = nullptr;
    QLabel* balance_name_ = nullptr;
    QComboBox* balance_axis_ = nullptr;
    XYPlotView* balance_plot_ = nullptr;
};

}  // namespace vybeg::ui
