#include "ui/resonator/conditions_text.h"

#include "ui/words/unit_text.h"

#include <QLocale>

namespace vybeg::ui {

QStringList conditionsText(const RecordingRef& recording) {
    QStringList lines;
    const auto add = [&lines](const QString& name, const QString& text) {
        if (!text.isEmpty()) {
            lines << QStringLiteral("%1: %2").arg(name, text);
        }
    };
    const auto number = [](const std::optional<double>& value, const QString& with_unit) {
        return value ? with_unit.arg(QLocale().toString(*value, 'g', 6)) : QString();
    };
    const Conditions& told = recording.conditions;
    add(ResonatorWords::tr("gyro"), QString::fromStdString(told.gyro));
    add(ResonatorWords::tr("date"), QString::fromStdString(told.date));
    add(ResonatorWords::tr("bias voltage"), number(told.bias_v, ResonatorWords::tr("%1 V")));
    add(ResonatorWords::tr("temperature"), number(told.temperature_c, ResonatorWords::tr("%1 °C")));
    if (told.exchanged) {
        lines << ResonatorWords::tr("the amplifiers are exchanged");
    }
    add(ResonatorWords::tr("operator"), QString::fromStdString(told.operator_name));
    add(ResonatorWords::tr("comment"), QString::fromStdString(told.comment));
    for (const auto& [column, field] : recording.others) {
        add(QString::fromStdString(column), QString::fromStdString(field));
    }
    return lines;
}

}  // namespace vybeg::ui
