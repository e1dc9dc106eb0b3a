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
    const auto number = [](const std::optional<double>& value, const char* with_unit) {
        return value ? resonatorText(with_unit).arg(QLocale().toString(*value, 'g', 6)) : QString();
    };
    const Conditions& told = recording.conditions;
    add(resonatorText(QT_TRANSLATE_NOOP("Resonator", "gyro")), QString::fromStdString(told.gyro));
    add(resonatorText(QT_TRANSLATE_NOOP("Resonator", "date")), QString::fromStdString(told.date));
    add(resonatorText(QT_TRANSLATE_NOOP("Resonator", "bias voltage")),
        number(told.bias_v, QT_TRANSLATE_NOOP("Resonator", "%1 V")));
    add(resonatorText(QT_TRANSLATE_NOOP("Resonator", "temperature")),
        number(told.temperature_c, QT_TRANSLATE_NOOP("Resonator", "%1 °C")));
    if (told.exchanged) {
        lines << resonatorText(QT_TRANSLATE_NOOP("Resonator", "the amplifiers are exchanged"));
    }
    add(resonatorText(QT_TRANSLATE_NOOP("Resonator", "operator")),
        QString::fromStdString(told.operator_name));
    add(resonatorText(QT_TRANSLATE_NOOP("Resonator", "comment")),
        QString::fromStdString(told.comment));
    for (const auto& [column, field] : recording.others) {
        add(QString::fromStdString(column), QString::fromStdString(field));
    }
    return lines;
}

}  // namespace vybeg::ui
