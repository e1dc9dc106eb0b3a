#include "ui/history/result_adder.h"

#include "core/analysis/set_conditions.h"
#include "ui/history/history_job.h"
#include "ui/history/store_dialog.h"
#include "ui/history/stored_set.h"
#include "ui/resonator/set_panel.h"

#include <QFileInfo>

#include <utility>

namespace vybeg::ui {

namespace {

constexpr int storing_job = 1;

}  // namespace

std::shared_ptr<const ResonatorOutcome> ResultAdder::addable() const {
    const RecordingSet* set = document_.sets().current();
    const auto outcome = set ? document_.sets().outcome(*set) : nullptr;
    return outcome && !document_.sets().outOfDate(*set, *outcome) ? outcome : nullptr;
}

void ResultAdder::ask(const QString& path, const QStringList& gyros, QWidget* window) {
    const RecordingSet* set = document_.sets().current();
    const auto outcome = addable();
    if (!set || !outcome) {
        return;
    }
    const MeasurementSet measured = document_.sets().underPresentConditions(*set, *outcome).set;
    QString gyro = QString::fromStdString(gyro_of(measured));
    gyro = gyro.isEmpty() ? document_.dossier().dossier().gyro.serial : gyro;
    gyro = gyro.isEmpty() ? set->name : gyro;
    auto* dialog =
        new StoreDialog(gyros, gyro, QString::fromStdString(date_of(measured).text), window);
    connect(dialog, &StoreDialog::chosen, this,
            [this, path](const QString& named, const QString& date) { add(path, named, date); });
    dialog->open();
}

void ResultAdder::add(const QString& path, const QString& gyro, const QString& date) {
    const RecordingSet* set = document_.sets().current();
    const auto outcome = addable();
    if (!outcome) {
        return;
    }
    SetResult result = document_.sets().underPresentConditions(*set, *outcome);
    result.set.name = setName(document_, *set).toStdString();
    tellGyroAndDate(result.set, gyro.toStdString(), date.toStdString());
    storeResult(
        job_, storing_job, document_, path, std::move(result),
        [this, path, gyro](const Result<std::optional<StoredName>>& replaced) {
            if (!replaced) {
                document_.report(errorMessage(replaced.error()));
                return;
            }
            const auto text = [gyro, name = QFileInfo(path).fileName(), replaced = *replaced] {
                return replaced ? tr("The result of %1 replaces that of %3 (set %4) in %2: "
                                     "the same recordings and settings.")
                                      .arg(gyro, name, QString::fromStdString(replaced->gyro),
                                           QString::fromStdString(replaced->set))
                                : tr("The result of %1 is in %2.").arg(gyro, name);
            };
            document_.report({MessageLevel::info, text, {}, {}});
            emit added(path);
        });
}

}  // namespace vybeg::ui
