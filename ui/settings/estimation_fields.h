#pragma once

#include "ui/settings/settings_fields.h"

#include <array>

class QCheckBox;
class QComboBox;
class QLabel;
class QPushButton;

namespace vybeg::ui {

// The window: its length in samples, periods of the carrier or milliseconds; the present
// residual of orthogonality; Snap; the hop in samples or as an overlap.
class WindowFields : public SettingsFields {
    Q_OBJECT

public:
    explicit WindowFields(QWidget* parent = nullptr);

protected:
    void refresh() override;
    void retranslate() override;

private:
    enum class Unit { samples, periods, milliseconds };  // as in the list of choices

    Unit unit() const;
    void setLength(double length);
    void setSamples(double samples);
    void snap();

    NumberField* length_;
    QComboBox* unit_;
    QLabel* others_;  // the length in the other units
    QLabel* residual_;
    QPushButton* snap_;
    NumberField* hop_;
    NumberField* overlap_;
};

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
    std::array<NumberField*, 5> typed_{};  // as StartValues: a_A, a_B, 2θ_A, α, f
    QCheckBox* every_window_;
};

}  // namespace vybeg::ui
