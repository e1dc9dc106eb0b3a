#include "ui/window/report_dialog.h"

#include <QCheckBox>
#include <QComboBox>
#include <QDialogButtonBox>
#include <QFormLayout>
#include <QLineEdit>
#include <QPushButton>
#include <QSettings>

namespace vybeg::ui {

namespace {

const QString all_plots_key = QStringLiteral("report/all_plots");

}  // namespace

ReportDialog::ReportDialog(Document& document, QWidget* parent)
    : QDialog(parent),
      document_(document),
      subjects_(reportSubjects(document)),
      subject_(new QComboBox(this)),
      gyro_(new QLineEdit(this)),
      engineer_(new QLineEdit(this)),
      date_(new QLineEdit(this)),
      comment_(new QLineEdit(this)),
      all_plots_(new QCheckBox(tr("All plots, also phase, noise and orthogonality"), this)) {
    setWindowTitle(tr("Report"));
    setAttribute(Qt::WA_DeleteOnClose);
    setMinimumWidth(460);
    auto* form = new QFormLayout(this);
    const auto add = [form](const QString& name, QWidget* field, const QString& tip) {
        form->addRow(name, field);
        field->setAccessibleName(name);
        field->setToolTip(tip);
    };
    for (const ReportSubject& each : subjects_) {
        subject_->addItem(each.name);
    }
    add(tr("Report of"), subject_,
        tr("A recording, a set of them with its resonator, or all sets"));
    const QString by_hand = tr("Empty: a line to fill in by hand");
    add(tr("Gyro"), gyro_, tr("Serial number. %1").arg(by_hand));
    add(tr("Operator"), engineer_, by_hand);
    add(tr("Date"), date_, tr("Of the measurement. %1").arg(by_hand));
    add(tr("Comment"), comment_, by_hand);
    gyro_->setObjectName(QStringLiteral("gyro"));
    engineer_->setObjectName(QStringLiteral("operator"));
    date_->setObjectName(QStringLiteral("date"));
    comment_->setObjectName(QStringLiteral("comment"));
    all_plots_->setToolTip(tr("Off: the five slow variables"));
    form->addRow(all_plots_);
    const GyroData& known = document.dossier().dossier().gyro;
    gyro_->setText(known.serial);
    engineer_->setText(known.operator_name);
    comment_->setText(known.comment.simplified());
    all_plots_->setChecked(QSettings().value(all_plots_key, false).toBool());
    const auto propose_date = [this] {
        // Each of several sets has its own.
        date_->setEnabled(!subject().all_sets);
        date_->setText(subject().all_sets ? QString()
                                          : reportContentOf(document_, subject()).title.date);
    };
    connect(subject_, &QComboBox::currentIndexChanged, this, propose_date);
    propose_date();
    auto* buttons = new QDialogButtonBox(this);
    auto* save = new QPushButton(tr("&Save…"), this);
    save->setObjectName(QStringLiteral("save"));
    save->setToolTip(tr("As a PDF document"));
    save->setDefault(true);
    buttons->addButton(save, QDialogButtonBox::AcceptRole);
    buttons->addButton(QDialogButtonBox::Cancel);
    connect(buttons, &QDialogButtonBox::rejected, this, &QDialog::reject);
    connect(buttons, &QDialogButtonBox::accepted, this, [this] {
        keep();
        emit saveWanted();
    });
    form->addRow(buttons);
}

const ReportSubject& ReportDialog::subject() const {
    return subjects_[static_cast<std::size_t>(subject_->currentIndex())];
}

std::vector<ReportContent> ReportDialog::contents() const {
    std::vector<ReportContent> contents = reportContentsOf(document_, subject());
    for (ReportContent& content : contents) {
        const QString date = subject().all_sets ? content.title.date : date_->text().trimmed();
        content.title = {gyro_->text().trimmed(), engineer_->text().trimmed(), date,
                         comment_->text().trimmed()};
        if (all_plots_->isChecked()) {
            content.variables.assign(shown_slow_variables.begin(), shown_slow_variables.end());
        }
    }
    return contents;
}

void ReportDialog::keep() {
    GyroData gyro = document_.dossier().dossier().gyro;
    gyro.serial = gyro_->text().trimmed();
    gyro.operator_name = engineer_->text().trimmed();
    // The dossier's comment may have several lines.
    if (const QString comment = comment_->text().trimmed(); comment != gyro.comment.simplified()) {
        gyro.comment = comment;
    }
    document_.dossier().setGyro(gyro);
    QSettings().setValue(all_plots_key, all_plots_->isChecked());
}

}  // namespace vybeg::ui
