#include "ui/settings/settings_fields.h"

#include "ui/words/display_units.h"
#include "ui/words/rich_text.h"

#include <QFormLayout>
#include <QHBoxLayout>
#include <QLabel>

#include <algorithm>

namespace vybeg::ui {

namespace {

constexpr int least_field = 58;  // seven digits

}  // namespace

SettingsFields::SettingsFields(QWidget* parent) : QWidget(parent), form_(new QFormLayout(this)) {
    form_->setContentsMargins(6, 0, 4, 4);
    form_->setHorizontalSpacing(6);
    form_->setVerticalSpacing(3);
    form_->setFieldGrowthPolicy(QFormLayout::AllNonFixedFieldsGrow);
    form_->setRowWrapPolicy(QFormLayout::DontWrapRows);
}

void SettingsFields::setState(const SettingsState& state) {
    state_ = state;
    refresh();
}

void SettingsFields::refresh() {
    for (const auto& show : shown_) {
        show();
    }
}

NumberField* SettingsFields::makeField(const Texts& texts) {
    auto* field = withTexts(new NumberField(this), texts);
    field->setMinimumWidth(least_field);
    return field;
}

NumberField* SettingsFields::addField(const Texts& texts, const Bounds& limits, double unit) {
    NumberField* field = makeField(texts);
    field->setLimits(limits, unit);
    auto* label = new QLabel(this);
    label->setBuddy(field);
    // One width of labels for all groups, so that their fields are aligned.
    label->setMinimumWidth(fontMetrics().horizontalAdvance(QStringLiteral("Перекрытие")));
    entries_.back().label = label;
    form_->addRow(label, field);
    addFaults({field});
    return field;
}

std::array<NumberField*, 2> SettingsFields::addPair(const Texts& first, const char* second_name,
                                                    const std::array<Bounds, 2>& limits) {
    const std::array pair{makeField(first), makeField({"", first.unit, first.tip, second_name})};
    auto* label = new QLabel(this);
    label->setBuddy(pair[0]);
    entries_[entries_.size() - 2].label = label;
    for (std::size_t k = 0; k < pair.size(); ++k) {
        entries_[entries_.size() - 1 - k].unit_in_label = true;
        pair[k]->setFixedWidth(least_field);
        pair[k]->setLimits(limits[k]);
    }
    addRow({label, LayoutPart(1), pair[0], pair[1]}, 4);
    addFaults({pair[0], pair[1]});
    return pair;
}

// A line below the fields with their fault.
void SettingsFields::addFaults(const std::vector<NumberField*>& fields) {
    auto* line = withName(new QLabel(this), "fault");
    line->setWordWrap(true);
    line->hide();
    form_->addRow(line);
    const auto show = [line, fields] {
        const auto wrong = std::ranges::find_if(
            fields, [](const NumberField* field) { return !field->fault().isEmpty(); });
        line->setVisible(wrong != fields.end());
        line->setText(wrong == fields.end() ? QString()
                                            : tr("Not in effect: %1").arg((*wrong)->fault()));
    };
    for (NumberField* field : fields) {
        connect(field, &NumberField::faultChanged, line, [field, show] {
            field->setAccessibleDescription(field->fault());
            show();
        });
    }
}

NumberField* SettingsFields::faulty() const {
    for (const Entry& entry : entries_) {
        auto* field = qobject_cast<NumberField*>(entry.widget);
        if (field && field->isEnabled() && !field->fault().isEmpty()) {
            return field;
        }
    }
    return nullptr;
}

void SettingsFields::addWide(QWidget* widget) {
    form_->addRow(widget);
}

QWidget* SettingsFields::addRow(LayoutParts parts, int between) {
    auto* row = new QWidget(this);
    fill(new QHBoxLayout(row), {}, between, parts);
    addWide(row);
    return row;
}

void SettingsFields::translate() {
    const auto translated = [this](const char* text) {
        return text && *text ? metaObject()->tr(text, nullptr) : QString();
    };
    for (const Entry& entry : entries_) {
        const QString tip = richTip(translated(entry.texts.tip));
        const QString label = translated(entry.texts.label);
        if (entry.label) {
            const QString unit = entry.unit_in_label ? translated(entry.texts.unit) : QString();
            entry.label->setText(richText(withUnit(label, unit)));
            entry.label->setToolTip(tip);
        }
        entry.widget->setToolTip(tip);
        entry.widget->setAccessibleName(entry.texts.name ? translated(entry.texts.name) : label);
        if (auto* field = qobject_cast<NumberField*>(entry.widget)) {
            field->setUnit(entry.unit_in_label ? QString() : translated(entry.texts.unit));
        } else if (auto* button = qobject_cast<QAbstractButton*>(entry.widget)) {
            button->setText(label);
        } else if (auto* sentence = qobject_cast<QLabel*>(entry.widget)) {
            sentence->setText(label);
        }
    }
    refresh();
}

}  // namespace vybeg::ui

#include "moc_settings_fields.cpp"
