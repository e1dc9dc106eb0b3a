#pragma once

#include "core/analysis/identify.h"
#include "core/analysis/settings.h"
#include "ui/document/undo_steps.h"
#include "ui/values/dossier.h"

#include <QObject>

namespace vybeg::ui {

// The settings and tolerances that are being edited, with undo and redo.
class SettingsModel : public QObject {
    Q_OBJECT

public:
    explicit SettingsModel(UndoSteps& steps) : steps_(steps) {}

    const Settings& settings() const { return settings_; }
    // Changes with the same gesture (>= 0) in a row, a drag, are one step.
    void setSettings(const Settings& settings, int gesture = -1);
    // Uncertainty of the channels; only the identification uses it.
    const Tolerance& tolerance() const { return tolerance_; }
    void setTolerance(const Tolerance& tolerance);
    // Settings of the program's start: no step, and none before them.
    void startWith(const Settings& settings, const Tolerance& tolerance = {});

signals:
    void settingsChanged(const Settings& before);
    void toleranceChanged();

private:
    void apply(const Settings& settings);
    void apply(const Tolerance& tolerance);

    UndoSteps& steps_;
    Settings settings_;
    Tolerance tolerance_;
};

// The gyro's data and limits of the session, with undo and redo.
class DossierModel : public QObject {
    Q_OBJECT

public:
    explicit DossierModel(UndoSteps& steps) : steps_(steps) {}

    const Dossier& dossier() const { return dossier_; }
    void setGyro(const GyroData& gyro);
    void setLimits(const std::vector<ParameterLimit>& limits);
    // Of a session that is opened: no step.
    void startWith(const Dossier& dossier);

signals:
    void changed();

private:
    void set(UndoSteps::Words words, const Dossier& dossier);

    UndoSteps& steps_;
    Dossier dossier_;
};

}  // namespace vybeg::ui
