#include "ui/resonator/dossier_dialogs.h"

#include "ui/resonator/parameter_text.h"
#include "ui/widgets/number_field.h"
#include "ui/widgets/page_parts.h"
#include "ui/words/rich_text.h"

#include <QDialogButtonBox>
#include <QFormLayout>
#include <QGridLayout>
#include <QLabel>
#include <QLineEdit>
#include <QPlainTextEdit>
#include <QPushButton>
#include <QVBoxLayout>

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
        setWords(*field, name, tip);
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

namespace {

constexpr int shown_digits = 8;

// The stored value of a field. Unchanged fields keep theirs, which the display rounds.
std::optional<double> stored(const NumberField& field, std::optional<double> before,
                             double factor) {
    const std::optional<double> now = field.value();
    const bool same = now && before && *now == *before * factor;
    return same ? before : now ? std::optional(*now / factor) : std::nullopt;
}

}  // namespace

LimitsDialog::LimitsDialog(const std::vector<ParameterLimit>& limits, const DisplayUnits& units,
                           QWidget* parent)
    : QDialog(parent) {
    setWindowTitle(tr("Limits of the parameters"));
    setAttribute(Qt::WA_DeleteOnClose);
    auto* grid = new QGridLayout;
    grid->addWidget(new QLabel(tr("At least"), this), 0, 1);
    grid->addWidget(new QLabel(tr("At most"), this), 0, 2);
    int line = 0;
    for (const ResonatorParameter& parameter : limited_parameters()) {
        const Shown shown = shownAs(parameter.name, parameter.unit, units);
        const ParameterLimit* found = limit_of(limits, parameter.name);
        Row row{parameter, shown.factor, found ? *found : ParameterLimit{parameter.name, {}, {}},
                new NumberField(this), new NumberField(this)};
        auto* name = new QLabel(richText(shown.title), this);
        name->setToolTip(shown.tip);
        name->setBuddy(row.lower);
        grid->addWidget(name, ++line, 0);
        const auto field = [&](NumberField* each, int column, std::optional<double> limit,
                               const QString& what) {
            each->setObjectName(QLatin1String(parameter.name) + (column == 1
                                                                     ? QStringLiteral(".lower")
                                                                     : QStringLiteral(".upper")));
            each->setOptional(true);
            each->setUnit(shown.unit);
            each->setDigits(shown_digits);
            each->setValue(limit ? std::optional(*limit * shown.factor) : std::nullopt);
            setWords(*each, QStringLiteral("%1: %2").arg(shown.title, what), tr("Empty: no limit"));
            each->setMinimumWidth(150);
            grid->addWidget(each, line, column);
            connect(each, &NumberField::valueEdited, this, &LimitsDialog::check);
            connect(each, &NumberField::faultChanged, this, &LimitsDialog::check);
        };
        field(row.lower, 1, row.before.lower, tr("at least"));
        field(row.upper, 2, row.before.upper, tr("at most"));
        rows_.push_back(row);
    }
    auto* meaning = new QLabel(
        tr("A parameter keeps its limits where its value with twice its uncertainty lies within "
           "them (✓, green), and breaks them where all of that lies beyond (✗, red). Between, or "
           "without a value, nothing is said (?)."),
        this);
    meaning->setWordWrap(true);
    fault_ = withName(new QLabel(this), "fault");
    fault_->setWordWrap(true);
    auto* buttons = new QDialogButtonBox(QDialogButtonBox::Ok | QDialogButtonBox::Cancel, this);
    ok_ = buttons->button(QDialogButtonBox::Ok);
    connect(buttons, &QDialogButtonBox::accepted, this, &QDialog::accept);
    connect(buttons, &QDialogButtonBox::rejected, this, &QDialog::reject);
    fill(new QVBoxLayout(this), {grid, meaning, fault_, buttons});
    check();
}

std::vector<ParameterLimit> LimitsDialog::limits() const {
    std::vector<ParameterLimit> limits;
    for (const Row& row : rows_) {
        ParameterLimit limit{row.parameter.name, stored(*row.lower, row.before.lower, row.factor),
                             stored(*row.upper, row.before.upper, row.factor)};
        if (limit.lower || limit.upper) {
            limits.push_back(std::move(limit));
        }
    }
    return limits;
}

void LimitsDialog::check() {
    QString fault;
    for (const Row& row : rows_) {
        const auto lower = row.lower->value();
        const auto upper = row.upper->value();
        row.upper->setConflict(lower && upper && *lower > *upper
                                   ? tr("The greatest value lies below the least one.")
                                   : QString());
        for (const NumberField* field : {row.lower, row.upper}) {
            if (fault.isEmpty() && !field->fault().isEmpty()) {
                fault = QStringLiteral("%1. %2").arg(field->accessibleName(), field->fault());
            }
        }
    }
    fault_->setText(richText(fault));
    ok_->setEnabled(fault.isEmpty());
}

void askForLimits(DossierModel& dossier, const DisplayUnits& units, QWidget* window) {
    auto* dialog = new LimitsDialog(dossier.dossier().limits, units, window);
    QObject::connect(dialog, &LimitsDialog::accepted, &dossier,
                     [&dossier, dialog] { dossier.setLimits(dialog->limits()); });
    dialog->open();
}

}  // namespace vybeg::ui

#include "moc_dossier_dialogs.cpp"
