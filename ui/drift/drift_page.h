#pragma once

#include "ui/document/document.h"
#include "ui/plots/measured_page.h"

#include <memory>

class QLabel;
class QPushButton;

namespace vybeg::ui {

class DriftPanel;
class QuantityTable;
class Section;
class WarningList;
class XYPlotView;

// The drift of whole-angle logs: logs and settings at the left, the drift against the angle in the
// middle, harmonics and resonator at the right. While a newer drift is computed, the one before is
// shown.
class DriftPage : public MeasuredPage {
    Q_OBJECT

public:
    explicit DriftPage(Document& document, QWidget* parent = nullptr);

    void setUnits(const DisplayUnits& units) override;

    FigureSource figures() const override;

signals:
    void openWanted();
    void exportResultWanted();

private:
    QWidget* buildContent();
    void refresh();
    void showFound();
    QString stateText() const;
    void retranslate() override;

    Document& document_;
    DisplayUnits units_;
    std::shared_ptr<const DriftOutcome> shown_;
    DriftPanel* panel_;
    QPushButton* export_;
    QLabel* state_;
    QLabel* hint_;
    QWidget* content_ = nullptr;
    XYPlotView* plot_ = nullptr;
    WarningList* warnings_ = nullptr;
    Section* harmonics_section_ = nullptr;
    QuantityTable* harmonics_ = nullptr;
    QLabel* agreement_ = nullptr;
    Section* resonator_section_ = nullptr;
    QuantityTable* resonator_ = nullptr;
    QLabel* statistical_ = nullptr;
};

}  // namespace vybeg::ui
