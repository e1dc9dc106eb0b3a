#include "ui/window/gyro_dialog.h"

#include <QDialogButtonBox>
#include <QFormLayout>
#include <QLineEdit>
#include <QPlainTextEdit>

namespace vybeg::ui {

GyroDialog::GyroDialog(const GyroData& gyro, QWidget* parent)
    : QDialog(parent),
      serial_(new QLineEdit(gyro.serial, this)),
      type_(new QLineEdit(gyro.type, this)),
      operator_(new QLineEdit(gyro.operator_name, this)),
      comment_(new QPlainTextEdit(gyro.comment, this)) {
    setWindowTitle(tr("The gyro's data"));
    setAttribute(Qt::WA_DeleteOnClose);
    setMinimumWidth(420);
    auto* form = new QFormLayout(this);
    const auto add = [form](const char* object, const QString& name, QWidget* field,
                            const QString& tip) {
        field->setObjectName(QLatin1String(object));
        field->setAccessibleName(name);
        field->setToolTip(tip);
        form->addRow(name, field);
    };
    const QString kept = tr("Kept in the session, and proposed for its report");
    add("serial", tr("Serial number"), serial_, kept);
    add("type", tr("Type"), type_, kept);
    add("operator", tr("Operator"), operator_, kept);
    add("comment", tr("Comment"), comment_, kept);
    comment_->setTabChangesFocus(true);
    comment_->setMaximumHeight(120);
    auto* buttons = new QDialogButtonBox(QDialogButtonBox::Ok | QDialogButtonBox::Cancel, this);
    connect(buttons, &QDialogButtonBox::accepted, this, &QDialog::accept);
    connect(buttons, &QDialogButtonBox::rejected, this, &QDialog::reject);
    form->addRow(buttons);
}

GyroData GyroDialog::gyro() const {
    return {serial_->text().trimmed(), type_->text().trimmed(), operator_->text().trimmed(),
            comment_->toPlainText().trimmed()};
}

void askForGyro(DossierModel& dossier, QWidget* window) {
    auto* dialog = new GyroDialog(dossier.dossier().gyro, window);
    QObject::connect(dialog, &GyroDialog::accepted, &dossier,
                     [&dossier, dialog] { dossier.setGyro(dialog->gyro()); });
    dialog->open();
}

}  // namespace vybeg::ui
