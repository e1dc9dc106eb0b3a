#include "ui/history/result_adder.h"

#include "core/analysis/list_fields.h"
#include "core/analysis/set_conditions.h"
#include "ui/history/history_database.h"
#include "ui/resonator/set_panel.h"
#include "ui/widgets/page_parts.h"

#include <QComboBox>
#include <QDialogButtonBox>
#include <QFileInfo>
#include <QFormLayout>
#include <QLabel>
#include <QLineEdit>
#include <QPushButton>

#include <utility>

namespace vybeg::ui {

StoreDialog::StoreDialog(const QStringList& gyros, const QString& gyro, const QString& date,
                         QWidget* parent)
    : QDialog(parent),
      gyro_(withName(new QComboBox(this), "storeGyro")),
      date_(withName(new QLineEdit(date, this), "storeDate")),
      fault_(new QLabel(this)),
      buttons_(new QDialogButtonBox(QDialogButtonBox::Ok | QDialogButtonBox::Cancel, this)) {
    setAttribute(Qt::WA_DeleteOnClose);
    setWindowTitle(tr("Add this result"));
    gyro_->setEditable(true);
    gyro_->addItems(gyros);
    gyro_->setCurrentText(gyro);
    gyro_->setAccessibleName(tr("Gyro"));
    gyro_->setToolTip(tr("The name under which the history of this resonator is kept"));
    date_->setAccessibleName(tr("Date"));
    date_->setToolTip(
        tr("Of the recordings, as in 2026-03-31, with or without a time as in T14:05"));
    fault_->setWordWrap(true);
    buttons_->button(QDialogButtonBox::Ok)->setText(tr("Add"));
    buttons_->button(QDialogButtonBox::Cancel)->setText(tr("Cancel"));
    auto* form = new QFormLayout(this);
    form->addRow(tr("Gyro"), gyro_);
    form->addRow(tr("Date"), date_);
    form->addRow(fault_);
    form->addRow(buttons_);
    connect(gyro_, &QComboBox::editTextChanged, this, &StoreDialog::refresh);
    connect(date_, &QLineEdit::textChanged, this, &StoreDialog::refresh);
    connect(buttons_, &QDialogButtonBox::rejected, this, &QDialog::reject);
    connect(buttons_, &QDialogButtonBox::accepted, this, [this] {
        emit chosen(gyro_->currentText().trimmed(), date_->text().trimmed());
        accept();
    });
    setMinimumWidth(380);
    refresh();
}

void StoreDialog::refresh() {
    const QString date = date_->text().trimmed();
    const bool dated = date.isEmpty() || is_iso_date(date.toStdString());
    const bool named = !gyro_->currentText().trimmed().isEmpty();
    fault_->setText(!named ? tr("A result without a gyro has no history: name one.")
                    : !dated
                        ? tr("A date is written as in 2026-03-31, with or without a time as in "
                             "T14:05.")
                    : date.isEmpty() ? tr("Without a date the result stands behind all others.")
                                     : QString());
    buttons_->button(QDialogButtonBox::Ok)->setEnabled(named && dated);
}

namespace {

constexpr int storing_job = 1;

// The set under this gyro and date, for the whole of it.
void tellGyroAndDate(MeasurementSet& set, const std::string& gyro, const std::string& date) {
    for (RecordingRef& recording : set.recordings) {
        recording.conditions.gyro = gyro;
        if (!date.empty()) {
            recording.conditions.date = date;
        }
    }
}

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
