#pragma once

#include "core/analysis/identify.h"
#include "core/analysis/settings.h"
#include "core/base/describe.h"
#include "core/resonator/results/resonator_parameters.h"

#include <QObject>
#include <QString>
#include <QUndoStack>

#include <functional>
#include <vector>

namespace vybeg::ui {

// The steps of undo and redo of a document, each with words for the menu in the present language.
class UndoSteps : public QUndoStack {
public:
    using Words = std::function<QString()>;
    using Act = std::function<void()>;

    UndoSteps() { setUndoLimit(200); }

    // A step that is done already. Steps in a row with the same gesture (>= 0), a drag, are one.
    void add(Words words, Act undo, Act redo, int gesture = -1);
    // A step that sets a value, and sets it.
    template <class Value, class Set>
    void change(const Words& words, const Value& before, const Value& after, const Set& set,
                int gesture = -1) {
        add(
            words, [set, before] { set(before); }, [set, after] { set(after); }, gesture);
        set(after);
    }
    // What would be undone and redone; empty: nothing.
    QString undoWords() const { return wordsAt(index() - 1); }
    QString redoWords() const { return wordsAt(index()); }

private:
    QString wordsAt(int place) const;
};

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
    void changed(const Settings& before);  // or the tolerances: then these are as before

private:
    void apply(const Settings& settings);

    UndoSteps& steps_;
    Settings settings_;
    Tolerance tolerance_;
};

// What a person says of the gyro of a session; empty where nothing is said.
struct GyroData {
    QString serial;
    QString type;
    QString operator_name;
    QString comment;

    friend bool operator==(const GyroData&, const GyroData&) = default;
};

template <class Archive, Described<GyroData> Owner>
void describe(Archive&& archive, Owner& gyro) {
    archive("serial", gyro.serial);
    archive("type", gyro.type);
    archive("operator", gyro.operator_name);
    archive("comment", gyro.comment);
}

// The gyro of a session, and what its resonator has to keep.
struct Dossier {
    GyroData gyro;
    std::vector<ParameterLimit> limits;

    friend bool operator==(const Dossier&, const Dossier&) = default;
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
    void set(const UndoSteps::Words& words, const Dossier& dossier);

    UndoSteps& steps_;
    Dossier dossier_;
};

}  // namespace vybeg::ui
