#include "ui/document/settings_model.h"

#include "ui/words/settings_text.h"

#include <utility>

namespace vybeg::ui {

void SettingsModel::setSettings(const Settings& settings, int gesture) {
    if (settings == settings_) {
        return;
    }
    const Settings before = settings_;
    steps_.change([before, settings] { return changedGroups(before, settings).join(", "); }, before,
                  settings, [this](const Settings& to) { apply(to); }, gesture);
}

void SettingsModel::setTolerance(const Tolerance& tolerance) {
    if (tolerance == tolerance_) {
        return;
    }
    steps_.change([] { return tr("tolerances of the channels"); }, tolerance_, tolerance,
                  [this](const Tolerance& to) { apply(to); });
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
    steps_.change(std::move(words), dossier_, dossier,
                  [this](const Dossier& to) { startWith(to); });
}

void DossierModel::startWith(const Dossier& dossier) {
    if (dossier != dossier_) {
        dossier_ = dossier;
        emit changed();
    }
}

}  // namespace vybeg::ui
