#pragma once

#include "ui/document/dossier_model.h"

#include <QDialog>

class QLineEdit;
class QPlainTextEdit;

namespace vybeg::ui {

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

}  // namespace vybeg::ui
