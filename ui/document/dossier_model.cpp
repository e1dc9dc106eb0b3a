#include "ui/document/dossier_model.h"

#include <utility>

namespace vybeg::ui {

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
