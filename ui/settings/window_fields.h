#pragma once

#include "ui/settings/settings_fields.h"

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

// Window of an analysis with this state, samples.
std::int64_t windowInUse(const SettingsState& state);

}  // namespace vybeg::ui
