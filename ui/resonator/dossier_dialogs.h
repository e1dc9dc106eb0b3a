#pragma once

#include "ui/document/edits.h"
#include "ui/words/display_units.h"

#include <QDialog>

#include <vector>

class QLabel;
class QLineEdit;
class QPlainTextEdit;
class QPushButton;

namespace vybeg::ui {

class NumberField;

// Asks for the data of the session's gyro. accepted(): gyro() is that of the fields.
class GyroDialog : public QDialog {
    Q_OBJECT

public:
    explicit GyroDialog(const GyroData& gyro, QWidget* parent = nullptr);

    GyroData gyro() const;

private:
    QLineEdit* serial_;
    QLineEdit* type_;
    QLineEdit* operator_;
    QPlainTextEdit* comment_;
};

// Opens the dialog; its data become those of the dossier.
void askForGyro(DossierModel& dossier, QWidget* window);

// Asks for the limits of the resonator's parameters, in the units of display. accepted(): limits()
// are those of the fields.
class LimitsDialog : public QDialog {
    Q_OBJECT

public:
    LimitsDialog(const std::vector<ParameterLimit>& limits, const DisplayUnits& units,
                 QWidget* parent = nullptr);

    // Of the parameters that have any.
    std::vector<ParameterLimit> limits() const;

private:
    struct Row {
        ResonatorParameter parameter;
        double factor;  // of the display
        ParameterLimit before;
        NumberField* lower;
        NumberField* upper;
    };
    // Whether every field is a number, and no lower limit is above the upper one.
    void check();

    std::vector<Row> rows_;
    QLabel* fault_ = nullptr;  // the first reason why the limits are none
    QPushButton* ok_;
};

// Opens the dialog; its limits become those of the dossier.
void askForLimits(DossierModel& dossier, const DisplayUnits& units, QWidget* window);

}  // namespace vybeg::ui
