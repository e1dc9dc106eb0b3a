#pragma once

#include "ui/document/document.h"
#include "ui/plots/plot_file.h"
#include "ui/widgets/theme.h"
#include "ui/words/display_units.h"

#include <QWidget>

class QComboBox;
class QLabel;
class QPushButton;

namespace vybeg::ui {

class NumberField;
class QuantityTable;
class Section;
class XYPlotView;

// The current set compared with the open passport; hidden without one.
class ComparisonView : public QWidget {
    Q_OBJECT

public:
    explicit ComparisonView(Document& document, QWidget* parent = nullptr);

    // Null: the set is not identified yet.
    void setOutcome(std::shared_ptr<const ResonatorOutcome> outcome);
    void setUnits(const DisplayUnits& units);
    void setTheme(const Theme& theme);
    void open();

signals:
    void exportWanted(const Figure& figure);

private:
    void rebuild();
    void retranslate();

    Document& document_;
    std::shared_ptr<const ResonatorOutcome> shown_;
    DisplayUnits units_;
    Theme theme_;
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
