#pragma once

#include "ui/settings/settings_fields.h"

#include <array>
#include <cstdint>
#include <optional>

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

private:
    enum class Unit { samples, periods, milliseconds };  // as in the list of choices

    Unit unit() const;
    void setSamples(double samples);
    void showState();
    void showResidual(std::int64_t window);

    NumberField* length_;
    QComboBox* unit_;
    QLabel* others_;  // the length in the other units
    QLabel* residual_;
    QPushButton* snap_;
    NumberField* hop_;
    NumberField* overlap_;
};

// The part of the recording that is analysed.
class RangeFields : public SettingsFields {
    Q_OBJECT

public:
    explicit RangeFields(QWidget* parent = nullptr);

signals:
    // The user wants the visible range of the plots.
    void visibleRangeWanted();
};

// Carrier, search band, and the band-pass before all processing.
class CarrierFields : public SettingsFields {
    Q_OBJECT

public:
    explicit CarrierFields(QWidget* parent = nullptr);

private:
    struct BandFields {
        std::optional<Band> Settings::*member;
        std::array<NumberField*, 2> ends;
        std::optional<Band> shown;

        bool isFaulty() const;
    };

    void editBand(const BandFields& fields);
    void showBand(BandFields& fields);
    static void showConflict(const BandFields& fields);

    std::array<BandFields, 2> bands_;
};

// Start of the conjugate gradient: algorithm 1, the window before, or typed values of the five
// parameters. Disabled for the other algorithms.
class StartFields : public SettingsFields {
    Q_OBJECT

public:
    explicit StartFields(QWidget* parent = nullptr);

    QString summary() const override;

private:
    enum Start { automatic, previous, typed };

    void showState();

    QComboBox* start_;
    std::array<NumberField*, 5> typed_{};  // as StartValues: a_A, a_B, 2θ_A, α, f
    QCheckBox* every_window_;
};

// Calibration of the pick-offs and its tolerances.
class CalibrationFields : public SettingsFields {
    Q_OBJECT

public:
    explicit CalibrationFields(QWidget* parent = nullptr);

    QString summary() const override;

signals:
    void toleranceEdited(const Tolerance& tolerance);

private:
    void addTolerance(const Texts& texts, ErrorSource source, double step);
};

}  // namespace vybeg::ui
