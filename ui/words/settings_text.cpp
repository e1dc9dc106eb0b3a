#include "ui/words/settings_text.h"

#include <QCoreApplication>

#include <array>

namespace vybeg::ui {

namespace {

struct AlgorithmTexts {
    Algorithm algorithm;  // in the order of the enumeration
    const char* name;
    const char* tip;
};

constexpr std::array<AlgorithmTexts, all_algorithms.size()> algorithms{{
    {Algorithm::in_phase, QT_TRANSLATE_NOOP("Algorithm", "1 In phase"),
     QT_TRANSLATE_NOOP("Algorithm",
                       "(15)-(18): without the quadrature wave; a_B is not estimated. The starting "
                       "point for the others.")},
    {Algorithm::phase_shift, QT_TRANSLATE_NOOP("Algorithm", "2 Phase shift"),
     QT_TRANSLATE_NOOP("Algorithm",
                       "(19)-(24): phase difference of the pick-off signals, by a delay of a "
                       "quarter of a period.")},
    {Algorithm::moving_axes, QT_TRANSLATE_NOOP("Algorithm", "3 Moving axes"),
     QT_TRANSLATE_NOOP("Algorithm",
                       "(26)-(30): signals in the axes of the standing waves; gives the "
                       "orthogonality of (30).")},
    {Algorithm::demodulation, QT_TRANSLATE_NOOP("Algorithm", "4 Demodulation"),
     QT_TRANSLATE_NOOP("Algorithm", "(31)-(33): synchronous averages at the carrier.")},
    {Algorithm::conjugate_gradient, QT_TRANSLATE_NOOP("Algorithm", "5 Conjugate gradient"),
     QT_TRANSLATE_NOOP("Algorithm",
                       "Minimum of the functional F over all five parameters at once; any window "
                       "above one period.")},
    {Algorithm::maximum_likelihood, QT_TRANSLATE_NOOP("Algorithm", "6 Maximum likelihood"),
     QT_TRANSLATE_NOOP("Algorithm",
                       "The same minimum as 5 by the linear form (33), at a fraction of the cost; "
                       "any window above one period.")},
}};

const AlgorithmTexts& textsOf(Algorithm algorithm) {
    return algorithms[static_cast<std::size_t>(algorithm)];
}

}  // namespace

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

QString algorithmText(Algorithm algorithm) {
    return QCoreApplication::translate("Algorithm", textsOf(algorithm).name);
}

QString algorithmTip(Algorithm algorithm) {
    return QCoreApplication::translate("Algorithm", textsOf(algorithm).tip);
}

}  // namespace vybeg::ui
