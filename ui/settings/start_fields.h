#pragma once

#include "ui/settings/settings_fields.h"

class QCheckBox;
class QComboBox;
class QLabel;

namespace vybeg::ui {

// Start of the conjugate gradient: algorithm 1, the window before, or typed values of the five
// parameters. Disabled for the other algorithms.
class StartFields : public SettingsFields {
    Q_OBJECT

public:
    explicit StartFields(QWidget* parent = nullptr);

protected:
    void refresh() override;
    void retranslate() override;

private:
    enum Start { automatic, previous, typed };

    void chooseStart(int start);
    void editTyped();

    QComboBox* start_;
    NumberField* a_A_;
    NumberField* a_B_;
    NumberField* two_theta_A_;
    NumberField* alpha_;
    NumberField* f_;
    QCheckBox* every_window_;
};

}  // namespace vybeg::ui
