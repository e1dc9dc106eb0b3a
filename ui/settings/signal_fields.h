#pragma once

#include "ui/settings/settings_fields.h"

#include <array>
#include <optional>

class QCheckBox;
class QLabel;
class QPushButton;

namespace vybeg::ui {

// The part of the recording that is analysed.
class RangeFields : public SettingsFields {
    Q_OBJECT

public:
    explicit RangeFields(QWidget* parent = nullptr);

signals:
    // The user wants the visible range of the plots.
    void visibleRangeWanted();

protected:
    void refresh() override;
    void retranslate() override;

private:
    NumberField* from_;
    NumberField* to_;
    QPushButton* whole_;
    QPushButton* visible_;
};

// Carrier, search band, and the band-pass before all processing.
class CarrierFields : public SettingsFields {
    Q_OBJECT

public:
    explicit CarrierFields(QWidget* parent = nullptr);

protected:
    void refresh() override;
    void retranslate() override;

private:
    struct BandFields {
        const char* option;  // its name
        std::optional<Band> Settings::*member;
        NumberField* low;
        NumberField* high;
        std::optional<Band> shown;
    };

    void editBand(const BandFields& fields);
    void showBand(BandFields& fields);
    static void showConflict(const BandFields& fields);

    NumberField* f0_;
    std::array<BandFields, 2> bands_;
};

// Calibration of the pick-offs and its tolerances.
class CalibrationFields : public SettingsFields {
    Q_OBJECT

public:
    explicit CalibrationFields(QWidget* parent = nullptr);

signals:
    void toleranceEdited(const Tolerance& tolerance);

protected:
    void refresh() override;
    void retranslate() override;

private:
    void addTolerances();
    void showTolerances();

    // A field of a number, `per_unit` of whose units are one of the number's.
    struct CalibrationField {
        NumberField* field;
        double Calibration::*member;
        double per_unit;
    };
    // A field of a tolerance, in units of `scale`.
    struct ToleranceField {
        NumberField* field;
        std::optional<double> Tolerance::*member;
        double scale;
    };

    std::vector<CalibrationField> numbers_;
    NumberField* offset_c_;
    NumberField* offset_d_;
    QCheckBox* offset_auto_;
    QCheckBox* repair_lost_;
    QLabel* tolerances_title_;
    std::vector<ToleranceField> tolerances_;
};

}  // namespace vybeg::ui
