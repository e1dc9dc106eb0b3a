#pragma once

#include "ui/document/document.h"
#include "ui/plots/plot_view.h"

class QLabel;
class QScrollArea;

namespace vybeg::ui {

class ComparisonView;
class FiguresView;
class NumbersView;
class SetPanel;
struct FoundCalibration;

// The resonator of the current set: sets at the left, then the parameters with tabs of what they
// follow from, figures at the right.
class ResonatorPage : public MeasuredPage {
    Q_OBJECT

public:
    explicit ResonatorPage(Document& document, QWidget* parent = nullptr);

    // Opens the comparison.
    void showComparison();

    FigureSource figures() const override;

private:
    void refresh();
    void showAgain() override { refresh(); }
    void retranslate() override;
    void showTabs();
    void rebuild();
    void calibrate(const QString& offer, const FoundCalibration& found);
    void showState(const RecordingSet* set);
    QString stateText(const RecordingSet* set) const;

    Document& document_;
    std::shared_ptr<const SetResult> shown_;
    std::shared_ptr<const SavedResult> kept_;  // shown where nothing is identified here
    SetPanel* set_;
    QLabel* state_;
    NumbersView* numbers_;
    QScrollArea* middle_;  // of the numbers
    FiguresView* figures_;
    ComparisonView* comparison_;
    int balance_tab_ = 0;
    int comparison_tab_ = 0;
};

}  // namespace vybeg::ui
