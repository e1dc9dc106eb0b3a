#pragma once

#include "core/analysis/identify.h"
#include "core/analysis/settings.h"
#include "ui/document/undo_steps.h"

#include <QObject>

namespace vybeg::ui {

// The settings and tolerances that are being edited, with undo and redo.
class SettingsModel : public QObject {
    Q_OBJECT

public:
    explicit SettingsModel(UndoSteps& steps, QObject* parent = nullptr);

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

}  // namespace vybeg::ui
