#pragma once

#include "core/resonator/results/parameter_limit.h"
#include "ui/resonator/outcome_view.h"

#include <vector>

class QLabel;

namespace vybeg::ui {

class QuantityTable;
class Section;
class WarningList;

// An identification as tables, with the sentences that belong to them.
class NumbersView : public OutcomeView {
    Q_OBJECT

public:
    explicit NumbersView(QWidget* parent = nullptr);

    void setLimits(const std::vector<ParameterLimit>& limits);

signals:
    void gainRatioChosen(const vybeg::Estimate& kappa);

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

}  // namespace vybeg::ui
