#include "ui/words/unit_text.h"

#include <QCoreApplication>

#include <array>

namespace vybeg::ui {

QString unitText(const char* unit) {
    // Those that core/ gives with its parameters and in its warnings.
    static constexpr std::array<const char*, 9> known{
        QT_TRANSLATE_NOOP("Resonator", "Hz"),
        QT_TRANSLATE_NOOP("Resonator", "s"),
        QT_TRANSLATE_NOOP("Resonator", "1/s"),
        QT_TRANSLATE_NOOP("Resonator", "Hz per squared unit"),
        QT_TRANSLATE_NOOP("Resonator", "rad"),
        QT_TRANSLATE_NOOP("Resonator", "deg"),
        QT_TRANSLATE_NOOP("Resonator", "deg/h"),
        QT_TRANSLATE_NOOP("Resonator", "ns"),
        QT_TRANSLATE_NOOP("Resonator", "ppm")};
    for (const char* each : known) {
        if (QLatin1String(each) == QLatin1String(unit)) {
            return ResonatorWords::tr(each);
        }
    }
    return QString::fromLatin1(unit);
}

QString withUnit(const QString& name, const QString& unit) {
    return unit.isEmpty() ? name : QStringLiteral("%1, %2").arg(name, unit);
}

QString channelUnit(const Recording& recording) {
    const auto unit = [&](int channel) {
        return recording.channels[static_cast<std::size_t>(channel - 1)].unit;
    };
    const std::string of_c = unit(recording.channel_c);
    return of_c == unit(recording.channel_d) ? QString::fromStdString(of_c) : QString();
}

}  // namespace vybeg::ui
