#include "ui/document/settings_model.h"

#include "ui/words/settings_text.h"

#include <utility>

namespace vybeg::ui {

SettingsModel::SettingsModel(UndoSteps& steps, QObject* parent) : QObject(parent), steps_(steps) {}

void SettingsModel::setSettings(const Settings& settings, int gesture) {
    if (settings == settings_) {
        return;
    }
    const Settings before = settings_;
    steps_.add([before, settings] { return changedGroups(before, settings).join(", "); },
               [this, before] { apply(before); }, [this, settings] { apply(settings); }, gesture);
    apply(settings);
}

void SettingsModel::setTolerance(const Tolerance& tolerance) {
    if (tolerance == tolerance_) {
        return;
    }
    const Tolerance before = tolerance_;
    steps_.add([] { return tr("tolerances of the channels"); }, [this, before] { apply(before); },
               [this, tolerance] { apply(tolerance); });
    apply(tolerance);
}

void SettingsModel::startWith(const Settings& settings, const Tolerance& tolerance) {
    steps_.stack().clear();
    apply(tolerance);
    apply(settings);
}

void SettingsModel::apply(const Settings& settings) {
    const Settings before = std::exchange(settings_, settings);
    emit settingsChanged(before);
}

void SettingsModel::apply(const Tolerance& tolerance) {
    tolerance_ = tolerance;
    emit toleranceChanged();
}

DossierModel::DossierModel(UndoSteps& steps, QObject* parent) : QObject(parent), steps_(steps) {}

void DossierModel::setGyro(const GyroData& gyro) {
    Dossier dossier = dossier_;
    dossier.gyro = gyro;
    set([] { return tr("the gyro's data"); }, dossier);
}

void DossierModel::setLimits(const std::vector<ParameterLimit>& limits) {
    Dossier dossier = dossier_;
    dossier.limits = limits;
    set([] { return tr("limits of the parameters"); }, dossier);
}

void DossierModel::set(UndoSteps::Words words, const Dossier& dossier) {
    if (dossier == dossier_) {
        return;
    }
    steps_.add(
        std::move(words), [this, before = dossier_] { startWith(before); },
        [this, dossier] { startWith(dossier); });
    startWith(dossier);
}

void DossierModel::startWith(const Dossier& dossier) {
    if (dossier != dossier_) {
        dossier_ = dossier;
        emit changed();
    }
}

}  // namespace vybeg::ui
