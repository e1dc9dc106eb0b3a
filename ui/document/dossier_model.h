#pragma once

#include "ui/document/undo_steps.h"
#include "ui/values/dossier.h"

#include <QObject>

namespace vybeg::ui {

// The gyro's data and limits of the session, with undo and redo.
class DossierModel : public QObject {
    Q_OBJECT

public:
    explicit DossierModel(UndoSteps& steps, QObject* parent = nullptr);

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
