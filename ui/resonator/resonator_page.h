#pragma once

#include "ui/document/document.h"
#include "ui/plots/figure_source.h"
#include "ui/widgets/theme.h"
#include "ui/words/display_units.h"

#include <QWidget>

class QLabel;

namespace vybeg::ui {

class ComparisonView;
class FiguresView;
class NumbersView;
class SetPanel;

// The resonator of the current set: recordings and numbers at the left, figures and the comparison
// with a passport at the right.
class ResonatorPage : public QWidget {
    Q_OBJECT

public:
    explicit ResonatorPage(Document& document, QWidget* parent = nullptr);

    void setUnits(const DisplayUnits& units);
    void setTheme(const Theme& theme);
    // Opens the comparison.
    void showComparison();

    FigureSource figures() const;

signals:
    void exportWanted(const Figure& figure);
    void figuresChanged();  // figures() are others, or there are some now

protected:
    void changeEvent(QEvent* event) override;

private:
    void refresh();
    void rebuild();
    void calibrate(const Estimate& kappa);
    void showState(const RecordingSet* set);
    QString stateText(const RecordingSet* set) const;
    static QString modelText(ResonatorModel model);

    Document& document_;
    Theme theme_;
    std::shared_ptr<const ResonatorOutcome> shown_;
    // The session's result, shown where nothing is identified here, and what it was read from.
    Result<SetResult> kept_ = SetResult{};
    QJsonObject kept_json_;
    SetPanel* set_;
    QLabel* state_;
    NumbersView* numbers_;
    FiguresView* figures_;
    ComparisonView* comparison_;
};

}  // namespace vybeg::ui
