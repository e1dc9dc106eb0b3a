#pragma once

#include "core/resonator/results/parameter_limit.h"
#include "ui/values/recording_set.h"
#include "ui/widgets/theme.h"
#include "ui/words/display_units.h"

#include <QWidget>

#include <memory>
#include <vector>

class QLabel;

namespace vybeg::ui {

class QuantityTable;
class Section;
class WarningList;

// An identification as tables, with the sentences that belong to them.
class NumbersView : public QWidget {
    Q_OBJECT

public:
    explicit NumbersView(QWidget* parent = nullptr);

    // Null: nothing is shown.
    void setOutcome(std::shared_ptr<const ResonatorOutcome> outcome);
    void setUnits(const DisplayUnits& units);
    void setTheme(const Theme& theme);
    void setLimits(const std::vector<ParameterLimit>& limits);

signals:
    void gainRatioChosen(const vybeg::Estimate& kappa);

private:
    void rebuild();
    void retranslate();
    static QString modesTitle(const ResonatorFit& fit);

    std::shared_ptr<const ResonatorOutcome> shown_;
    DisplayUnits units_;
    Theme theme_;
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
