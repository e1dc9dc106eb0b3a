#include "ui/document/edits.h"

#include "ui/words/settings_text.h"

#include <utility>

namespace vybeg::ui {

namespace {

class Step : public QUndoCommand {
public:
    Step(UndoSteps::Words words, UndoSteps::Act undo, UndoSteps::Act redo, int gesture)
        : words_(std::move(words)),
          undo_(std::move(undo)),
          redo_(std::move(redo)),
          gesture_(gesture) {}

    QString words() const { return words_(); }
    void undo() override { undo_(); }
    // The stack redoes a new command, which is done already.
    void redo() override {
        if (std::exchange(done_, false)) {
            return;
        }
        redo_();
    }
    int id() const override { return gesture_; }
    bool mergeWith(const QUndoCommand* other) override {
        redo_ = static_cast<const Step*>(other)->redo_;
        return true;
    }

private:
    UndoSteps::Words words_;
    UndoSteps::Act undo_;
    UndoSteps::Act redo_;
    int gesture_;
    bool done_ = true;
};

}  // namespace

void UndoSteps::add(Words words, Act undo, Act redo, int gesture) {
    push(new Step(std::move(words), std::move(undo), std::move(redo), gesture));
}

QString UndoSteps::wordsAt(int place) const {
    const auto* step = static_cast<const Step*>(command(place));
    return step ? step->words() : QString();
}

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
                  [this](const Tolerance& to) {
                      tolerance_ = to;
                      emit changed(settings_);
                  });
}

void SettingsModel::startWith(const Settings& settings, const Tolerance& tolerance) {
    steps_.clear();
    tolerance_ = tolerance;
    apply(settings);
}

void SettingsModel::apply(const Settings& settings) {
    const Settings before = std::exchange(settings_, settings);
    emit changed(before);
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

void DossierModel::set(const UndoSteps::Words& words, const Dossier& dossier) {
    if (dossier == dossier_) {
        return;
    }
    steps_.change(words, dossier_, dossier, [this](const Dossier& to) { startWith(to); });
}

void DossierModel::startWith(const Dossier& dossier) {
    if (dossier != dossier_) {
        dossier_ = dossier;
        emit changed();
    }
}

}  // namespace vybeg::ui

#include "moc_edits.cpp"
