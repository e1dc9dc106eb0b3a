#pragma once

#include "ui/document/document.h"
#include "ui/plots/plot_file.h"
#include "ui/resonator/outcome_view.h"

class QComboBox;
class QLabel;
class QPushButton;

namespace vybeg::ui {

class NumberField;
class QuantityTable;
class Section;
class XYPlotView;

// The current set compared with the open passport; hidden without one.
class ComparisonView : public OutcomeView {
    Q_OBJECT

public:
    explicit ComparisonView(Document& document, QWidget* parent = nullptr);

    void setTheme(const Theme& theme) override;
    void open();

signals:
    void exportWanted(const Figure& figure);

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
