#include "ui/document/settings_model.h"

#include <utility>

namespace vybeg::ui {

// A step of undo: one change of the settings or of the tolerances.
template <class Value>
class ValueChange : public QUndoCommand {
public:
    ValueChange(SettingsModel& model, Value before, Value after, int gesture = -1)
        : model_(model), before_(std::move(before)), after_(std::move(after)), gesture_(gesture) {}

    void undo() override { model_.apply(before_); }
    void redo() override { model_.apply(after_); }
    int id() const override { return gesture_; }
    bool mergeWith(const QUndoCommand* other) override {
        after_ = static_cast<const ValueChange*>(other)->after_;
        return true;
    }

private:
    SettingsModel& model_;
    Value before_;
    Value after_;
    int gesture_;
};

SettingsModel::SettingsModel(QObject* parent) : QObject(parent) {
    undo_.setUndoLimit(200);
}

void SettingsModel::setSettings(const Settings& settings, int gesture) {
    if (!(settings == settings_)) {
        undo_.push(new ValueChange<Settings>(*this, settings_, settings, gesture));
    }
}

void SettingsModel::setTolerance(const Tolerance& tolerance) {
    if (!(tolerance == tolerance_)) {
        undo_.push(new ValueChange<Tolerance>(*this, tolerance_, tolerance));
    }
}

void SettingsModel::startWith(const Settings& settings) {
    undo_.clear();
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

}  // namespace vybeg::ui
