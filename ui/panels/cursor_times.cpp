#include "ui/panels/cursor_times.h"

#include "ui/panels/measuring.h"
#include "ui/widgets/number_field.h"
#include "ui/widgets/page_parts.h"
#include "ui/words/display_units.h"

#include <QHBoxLayout>
#include <QLabel>

#include <cmath>

namespace vybeg::ui {

CursorTimes::CursorTimes(QWidget* parent)
    : QWidget(parent), difference_(withName(new QLabel(this), "cursorDifference")) {
    auto* line = new QHBoxLayout(this);
    line->setContentsMargins(4, 0, 4, 0);
    line->setSpacing(4);
    for (std::size_t which = 0; which < fields_.size(); ++which) {
        auto* field = new NumberField(this);
        field->setOptional(true);
        field->setDigits(9);
        field->setStep(0.1);
        field->setFixedWidth(112);
        names_[which] = new QLabel(this);
        names_[which]->setBuddy(field);
        fields_[which] = field;
        line->addWidget(names_[which]);
        line->addWidget(field);
        connect(field, &NumberField::valueEdited, this,
                [this] { emit edited(fields_[0]->value(), fields_[1]->value()); });
    }
    difference_->setTextInteractionFlags(Qt::TextSelectableByMouse);
    line->addWidget(difference_);
    keepTranslated(*this, [this] { retranslate(); });
}

void CursorTimes::setTimes(std::optional<double> a_s, std::optional<double> b_s,
                           const Analysis* chosen) {
    const auto outside = [chosen](const std::optional<double>& time_s) {
        return chosen && time_s && !isInside(*chosen, time_s);
    };
    outside_ = outside(a_s) || outside(b_s);
    fields_[0]->setValue(a_s);
    fields_[1]->setValue(b_s);
    showDifference();
}

void CursorTimes::showDifference() {
    const auto a_s = fields_[0]->value();
    const auto b_s = fields_[1]->value();
    const bool apart = a_s && b_s && *a_s != *b_s;
    difference_->setText(outside_ ? tr("A cursor stands where the analysis has no windows.")
                         : apart  ? tr("B − A = %1 s, 1/|B − A| = %2 Hz")
                                       .arg(shortNumberText(*b_s - *a_s, 8),
                                            shortNumberText(1 / std::abs(*b_s - *a_s), 6))
                                 : QString());
}

void CursorTimes::retranslate() {
    const std::array names{tr("A"), tr("B")};
    const std::array accessible{tr("Time of cursor A"), tr("Time of cursor B")};
    for (std::size_t which = 0; which < fields_.size(); ++which) {
        names_[which]->setText(names[which]);
        fields_[which]->setUnit(tr("s"));
        fields_[which]->setAccessibleName(accessible[which]);
        fields_[which]->setToolTip(
            tr("Seconds from the start of the recording; empty: no cursor. The keys 1 and 2 in the "
               "plots set the cursors at the mouse, Shift and an arrow key move "
               "the last one, 0 removes both."));
    }
    showDifference();
}

}  // namespace vybeg::ui

#include "moc_cursor_times.cpp"
