#include "ui/history/store_dialog.h"

#include "core/analysis/list_fields.h"

#include <QComboBox>
#include <QDialogButtonBox>
#include <QFormLayout>
#include <QLabel>
#include <QLineEdit>
#include <QPushButton>

namespace vybeg::ui {

StoreDialog::StoreDialog(const QStringList& gyros, const QString& gyro, const QString& date,
                         QWidget* parent)
    : QDialog(parent),
      gyro_(new QComboBox(this)),
      date_(new QLineEdit(date, this)),
      fault_(new QLabel(this)),
      buttons_(new QDialogButtonBox(QDialogButtonBox::Ok | QDialogButtonBox::Cancel, this)) {
    setAttribute(Qt::WA_DeleteOnClose);
    setWindowTitle(tr("Add this result"));
    gyro_->setObjectName(QStringLiteral("storeGyro"));
    gyro_->setEditable(true);
    gyro_->addItems(gyros);
    gyro_->setCurrentText(gyro);
    gyro_->setAccessibleName(tr("Gyro"));
    gyro_->setToolTip(tr("The name under which the history of this resonator is kept"));
    date_->setObjectName(QStringLiteral("storeDate"));
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

}  // namespace vybeg::ui
