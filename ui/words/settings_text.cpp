#include "ui/words/settings_text.h"

#include <QCoreApplication>

namespace vybeg::ui {

QStringList changedGroups(const Settings& a, const Settings& b) {
    QStringList names;
    const auto name = [&names](bool differ, const char* group) {
        if (differ) {
            names << QCoreApplication::translate("Settings", group);
        }
    };
    name(a.algorithm != b.algorithm, QT_TRANSLATE_NOOP("Settings", "algorithm"));
    name(a.window != b.window || a.periods != b.periods || a.snap != b.snap || a.hop != b.hop,
         QT_TRANSLATE_NOOP("Settings", "window"));
    name(a.from_s != b.from_s || a.to_s != b.to_s, QT_TRANSLATE_NOOP("Settings", "range"));
    name(a.f0_hz != b.f0_hz || a.band != b.band, QT_TRANSLATE_NOOP("Settings", "carrier"));
    name(a.filter != b.filter, QT_TRANSLATE_NOOP("Settings", "filter"));
    name(a.initial != b.initial || a.start != b.start,
         QT_TRANSLATE_NOOP("Settings", "start values"));
    name(!(a.calibration == b.calibration) || a.repair_lost != b.repair_lost,
         QT_TRANSLATE_NOOP("Settings", "calibration"));
    return names;
}

}  // namespace vybeg::ui
