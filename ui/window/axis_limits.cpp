#include "ui/window/axis_limits.h"

#include "ui/plots/track_view.h"
#include "ui/widgets/number_field.h"
#include "ui/widgets/page_parts.h"
#include "ui/words/display_units.h"
#include "ui/words/error_text.h"
#include "ui/words/rich_text.h"

#include <QDialogButtonBox>
#include <QFormLayout>
#include <QLabel>
#include <QPushButton>
#include <QVBoxLayout>

namespace vybeg::ui {

AxisLimitsDialog::AxisLimitsDialog(TrackView& tracks, SlowVariable variable, QWidget* parent)
    : QDialog(parent),
      tracks_(tracks),
      variable_(variable),
      lower_(withName(new NumberField(this), "axisLower")),
      upper_(withName(new NumberField(this), "axisUpper")),
      fault_(withName(new QLabel(this), "axisFault")) {
    setAttribute(Qt::WA_DeleteOnClose);
    const QString symbol = displaySymbol(variable, tracks.units());
    setWindowTitle(tr("Limits of the axis of %1").arg(indexPlain(symbol)));
    const auto& fixed = tracks.zoom().current().fixed;
    const auto typed = fixed.find(variable);
    const AxisRange shown = tracks.valueRange(variable);
    auto* form = new QFormLayout;
    const auto add = [&](NumberField* field, const QString& label, double end) {
        constexpr int digits = 8;
        constexpr int shown_digits = 6;
        field->setOptional(true);
        field->setDigits(digits);
        field->setUnit(displayUnit(variable, tracks.units()));
        field->setMinimumWidth(200);
        field->setPlaceholderText(shortNumberText(end, shown_digits));
        setWords(*field, label, tr("Empty: as the data are"));
        if (typed != fixed.end()) {
            field->setValue(end);
        }
        form->addRow(label, field);
        connect(field, &NumberField::valueEdited, this, &AxisLimitsDialog::check);
        connect(field, &NumberField::faultChanged, this, &AxisLimitsDialog::check);
    };
    add(lower_, tr("From"), shown.lower);
    add(upper_, tr("To"), shown.upper);
    auto* meaning = sentence(this, "axisMeaning", QMargins());
    meaning->setText(tr("Empty: as the data are. Fit and Zoom back take the limits away."));
    fault_->setWordWrap(true);
    auto* buttons = new QDialogButtonBox(QDialogButtonBox::Ok | QDialogButtonBox::Cancel, this);
    ok_ = buttons->button(QDialogButtonBox::Ok);
    connect(buttons, &QDialogButtonBox::accepted, this, [this] {
        apply();
        accept();
    });
    connect(buttons, &QDialogButtonBox::rejected, this, &QDialog::reject);
    fill(new QVBoxLayout(this), {form, meaning, fault_, buttons});
    check();
}

void AxisLimitsDialog::check() {
    const bool logarithmic = variable_ == SlowVariable::a_A && tracks_.units().log_a_A &&
                             tracks_.units().amplitude != AmplitudeUnit::decibels;
    const AxisRange shown = tracks_.valueRange(variable_);
    const double lower = lower_->value().value_or(shown.lower);
    const double upper = upper_->value().value_or(shown.upper);
    QString fault;
    if (!lower_->isValid() || !upper_->isValid()) {
        fault = lower_->isValid() ? upper_->fault() : lower_->fault();
    } else if (lower >= upper) {
        fault = tr("The upper end lies at or below the lower one.");
    } else if (logarithmic && lower <= 0) {
        fault = tr("A logarithmic axis begins above zero.");
    }
    fault_->setText(fault);
    ok_->setEnabled(fault.isEmpty() && lower_->isValid() && upper_->isValid());
}

void AxisLimitsDialog::apply() {
    const AxisRange shown = tracks_.valueRange(variable_);
    if (!lower_->value() && !upper_->value()) {
        tracks_.setValueRange(variable_, std::nullopt);
    } else {
        tracks_.setValueRange(variable_, AxisRange{lower_->value().value_or(shown.lower),
                                                   upper_->value().value_or(shown.upper)});
    }
}

void askForAxisLimits(TrackView& tracks, QWidget* window) {
    if (const auto variable = tracks.chosenVariable()) {
        (new AxisLimitsDialog(tracks, *variable, window))->open();
    }
}

}  // namespace vybeg::ui

#include "moc_axis_limits.cpp"
