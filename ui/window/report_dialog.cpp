#include "ui/window/report_dialog.h"

#include "ui/widgets/page_parts.h"

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
const QString summary_key = QStringLiteral("report/summary");
const QString instrument_key = QStringLiteral("report/instrument");

}  // namespace

ReportDialog::ReportDialog(Document& document, bool of_set, QWidget* parent)
    : QDialog(parent),
      document_(document),
      subjects_(reportSubjects(document)),
      subject_(new QComboBox(this)),
      summary_(new QCheckBox(tr("One page to be signed: result, limits, warnings"), this)),
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
        if (of_set && document.sets().current() && each.set == document.sets().current()->id) {
            subject_->setCurrentIndex(subject_->count() - 1);
        }
    }
    add(tr("Report of"), subject_,
        tr("A recording, a set of them with its resonator, or all sets"));
    const QString by_hand = tr("Empty: a line to fill in by hand");
    for (std::size_t k = 0; k < title_fields.size(); ++k) {
        fields_[k] = new QLineEdit(this);
        fields_[k]->setObjectName(QLatin1String(title_fields[k].option));
        add(ReportWords::tr(title_fields[k].name), fields_[k], by_hand);
    }
    all_plots_->setToolTip(tr("Off: the five slow variables"));
    form->addRow(summary_);
    form->addRow(all_plots_);
    connect(summary_, &QCheckBox::toggled, all_plots_, &QWidget::setDisabled);
    summary_->setChecked(QSettings().value(summary_key, false).toBool());
    all_plots_->setChecked(QSettings().value(all_plots_key, false).toBool());
    connect(subject_, &QComboBox::currentIndexChanged, this, &ReportDialog::propose);
    propose();
    auto* buttons = new QDialogButtonBox(this);
    auto* save = withName(new QPushButton(tr("&Save…"), this), "save");
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

// What a measurement list tells of the subject, otherwise what the dossier tells.
void ReportDialog::propose() {
    proposed_ = titleOf(document_.dossier().dossier().gyro);
    // Each of several sets has its own date, and what its list tells.
    if (!subject().all_sets) {
        proposed_ = completed(reportContentOf(document_, subject()).title, proposed_);
    }
    proposed_.instrument = QSettings().value(instrument_key).toString();
    for (std::size_t k = 0; k < title_fields.size(); ++k) {
        const TitleField& field = title_fields[k];
        fields_[k]->setText(proposed_.*field.text);
        fields_[k]->setEnabled(field.text != &ReportTitle::date || !subject().all_sets);
    }
}

ReportTitle ReportDialog::typed() const {
    ReportTitle title;
    for (std::size_t k = 0; k < title_fields.size(); ++k) {
        title.*title_fields[k].text = fields_[k]->text().trimmed();
    }
    return title;
}

std::vector<ReportContent> ReportDialog::contents() const {
    std::vector<ReportContent> contents = reportContentsOf(document_, subject());
    const ReportTitle title = typed();
    for (ReportContent& content : contents) {
        content.title = subject().all_sets ? completed(content.title, title) : title;
        content.summary = summary_->isChecked();
        if (all_plots_->isChecked()) {
            content.variables.assign(shown_slow_variables.begin(), shown_slow_variables.end());
        }
    }
    return contents;
}

// The dossier takes what was typed over the proposal.
void ReportDialog::keep() {
    GyroData gyro = document_.dossier().dossier().gyro;
    const ReportTitle title = typed();
    const auto take = [](QString& kept, const QString& now, const QString& proposed) {
        kept = now == proposed ? kept : now;
    };
    take(gyro.serial, title.gyro, proposed_.gyro);
    take(gyro.operator_name, title.engineer, proposed_.engineer);
    take(gyro.comment, title.comment, proposed_.comment);
    document_.dossier().setGyro(gyro);
    QSettings().setValue(all_plots_key, all_plots_->isChecked());
    QSettings().setValue(summary_key, summary_->isChecked());
    QSettings().setValue(instrument_key, title.instrument);
}

}  // namespace vybeg::ui
