#include "ui/resonator/difference_text.h"

#include "ui/panels/reading.h"
#include "ui/resonator/parameter_text.h"
#include "ui/words/error_text.h"
#include "ui/words/unit_text.h"

#include <QCoreApplication>
#include <QLocale>

#include <algorithm>
#include <cmath>

namespace vybeg::ui {

namespace {

// Title of a difference such as "modes[0].f_hz".
QString titleOfMode(const std::string& name) {
    const auto digit = std::string("modes[").size();
    return modeTitle(name.at(digit) - '0', name.substr(digit + 3));
}

// Signed, with one decimal; zero has no sign.
QString deviationsText(double deviations) {
    const QString size = QLocale().toString(std::abs(deviations), 'f', 1);
    if (std::abs(deviations) < 0.05) {
        return size;
    }
    return (deviations < 0 ? QChar(0x2212) : QLatin1Char('+')) + size;
}

// Title of a difference such as "runs[10].direction.f_hz".
QString titleOfRun(const std::string& name) {
    const auto digits = std::string("runs[").size();
    return directionTitle(std::stoi(name.substr(digits)), name.substr(name.rfind('.') + 1));
}

QString titleOf(const std::string& name) {
    if (name.starts_with("modes[")) {
        return titleOfMode(name);
    }
    return name.starts_with("runs[") ? titleOfRun(name) : shownAs(name, "", {}).title;
}

// Percent, or ppm for small values.
QuantityCell relativeCell(double relative) {
    if (std::isnan(relative)) {
        return {QStringLiteral("—"), {QString()}, {}};
    }
    const bool small = std::abs(relative) < 1e-4;
    QString text = QLocale().toString(std::abs(relative) * (small ? 1e6 : 1e2), 'g', 3);
    if (relative != 0) {
        text.prepend(relative < 0 ? QChar(0x2212) : QLatin1Char('+'));
    }
    return {
        text + (small ? QStringLiteral(" ppm") : QStringLiteral(" %")), {exactText(relative)}, {}};
}

// Reasons are below the table, because its columns are too narrow.
QuantityCell sideCell(const Estimate& estimate, double factor) {
    QuantityCell cell = cellOf(estimate, factor);
    if (!estimate.given()) {
        cell.text = QStringLiteral("—");
    }
    return cell;
}

QString verdictWord(Verdict verdict) {
    switch (verdict) {
        case Verdict::unchanged: return ResonatorWords::tr("unchanged");
        case Verdict::changed: return ResonatorWords::tr("changed");
        case Verdict::not_comparable: break;
    }
    return ResonatorWords::tr("not comparable");
}

// Sign, word and an Okabe-Ito colour are redundant.
QuantityCell verdictCell(const Difference& difference, const Theme& theme) {
    const Verdict verdict = difference.verdict;
    const QColor color = verdict == Verdict::unchanged ? readable(QColor("#009e73"), theme)
                         : verdict == Verdict::changed ? readable(QColor("#d55e00"), theme)
                                                       : theme.mutedText;
    return {verdictText(verdict), {verdictWord(verdict)}, color};
}

QString whyText(const Difference& difference) {
    switch (difference.why) {
        case Incomparable::now_unknown: return reasonText(difference.now.reason);
        case Incomparable::then_unknown:
            return ResonatorWords::tr("in the passport: %1")
                .arg(reasonText(difference.then.reason));
        default:
            return QCoreApplication::translate("Reason", incomparable_sentence(difference.why));
    }
}

}  // namespace

QString verdictText(Verdict verdict) {
    const char* const sign = verdict == Verdict::unchanged ? "= "
                             : verdict == Verdict::changed ? "≠ "
                                                           : "? ";
    return QString::fromUtf8(sign) + verdictWord(verdict);
}

QString differenceSymbol(const std::string& name) {
    return name.starts_with("modes[")  ? ResonatorWords::tr("Modes")
           : name.starts_with("runs[") ? titleOf(name)
                                       : titleOf(name).section(QLatin1Char(' '), -1);
}

QStringList incomparableTexts(const std::vector<Difference>& differences) {
    std::vector<std::pair<QString, QStringList>> reasons;  // and the names of their parameters
    for (const Difference& difference : differences) {
        if (difference.verdict != Verdict::not_comparable) {
            continue;
        }
        const QString reason = whyText(difference);
        const QString symbol = differenceSymbol(difference.name);
        const auto same =
            std::ranges::find(reasons, reason, &std::pair<QString, QStringList>::first);
        if (same == reasons.end()) {
            reasons.push_back({reason, {symbol}});
        } else if (!same->second.contains(symbol)) {
            same->second << symbol;
        }
    }
    QStringList texts;
    for (const auto& [reason, symbols] : reasons) {
        texts << QStringLiteral("%1: %2").arg(symbols.join(QStringLiteral(", ")), reason);
    }
    return texts;
}

QStringList differenceHeaders() {
    return {ResonatorWords::tr("Verdict"),    ResonatorWords::tr("Difference, u"),
            ResonatorWords::tr("Difference"), ResonatorWords::tr("Relative"),
            ResonatorWords::tr("Passport"),   ResonatorWords::tr("Now")};
}

std::vector<QuantityRow> differenceRows(const std::vector<Difference>& differences,
                                        const DisplayUnits& units, const Theme& theme) {
    std::vector<QuantityRow> rows;
    for (const Difference& difference : differences) {
        const Shown shown = shownAs(difference.name, difference.unit, units);
        const double sds =
            difference.change < 0 ? -difference.deviations() : difference.deviations();
        const bool known = difference.verdict != Verdict::not_comparable;
        const QuantityCell deviations{known ? deviationsText(sds) : QStringLiteral("—"),
                                      {known ? exactText(sds) : QString()},
                                      {}};
        const double factor = shown.factor;
        const QuantityCell change = valueCell(factor * difference.change, factor * difference.u);
        rows.push_back(
            {withUnit(titleOf(difference.name), shown.unit),
             shown.tip,
             {verdictCell(difference, theme), deviations, change, relativeCell(difference.relative),
              sideCell(difference.then, factor), sideCell(difference.now, factor)}});
    }
    return rows;
}

}  // namespace vybeg::ui
