#include "ui/report/budget_text.h"

#include "core/resonator/results/uncertainty_budget.h"
#include "ui/resonator/parameter_text.h"
#include "ui/words/error_text.h"
#include "ui/words/unit_text.h"

#include <QCoreApplication>

#include <algorithm>
#include <array>
#include <cmath>

namespace vybeg::ui {

namespace {

// As budget_sources.
constexpr std::array<const char*, 7> source_texts{
    QT_TRANSLATE_NOOP("Report", "Gain ratio"),  QT_TRANSLATE_NOOP("Report", "Skew"),
    QT_TRANSLATE_NOOP("Report", "Delay"),       QT_TRANSLATE_NOOP("Report", "Crosstalk"),
    QT_TRANSLATE_NOOP("Report", "Phase drift"), QT_TRANSLATE_NOOP("Report", "Gain drift"),
    QT_TRANSLATE_NOOP("Report", "Sample rate")};
static_assert(source_texts.size() == budget_sources.size());

QString sourceText(double ToleranceShares::*member) {
    const auto source = std::ranges::find(budget_sources, member, &BudgetSource::member);
    return reportText(source_texts[static_cast<std::size_t>(source - budget_sources.begin())]);
}

}  // namespace

QString reportText(const char* text) {
    return QCoreApplication::translate("Report", text);
}

QStringList budgetHeaders(const Identification& found) {
    QStringList headers{reportText(QT_TRANSLATE_NOOP("Report", "Statistical"))};
    for (const BudgetSource& source : sources_of(uncertainty_budget(found.fit))) {
        headers << sourceText(source.member);
    }
    headers << reportText(QT_TRANSLATE_NOOP("Report", "Combined u"))
            << reportText(QT_TRANSLATE_NOOP("Report", "Expanded U = 2u"));
    return headers;
}

std::vector<QuantityRow> budgetRows(const Identification& found, const DisplayUnits& units) {
    constexpr int digits = 2;
    const std::vector<ParameterBudget> budget = uncertainty_budget(found.fit);
    const std::vector<BudgetSource> sources = sources_of(budget);
    std::vector<QuantityRow> rows;
    for (const ParameterBudget& each : budget) {
        const Shown shown = shownAs(each.parameter.name, each.parameter.unit, units);
        QuantityRow row{withUnit(shown.title, shown.unit), shown.tip, {}};
        const auto add = [&](double part) {
            const double value = std::abs(shown.factor) * part;
            row.cells.push_back({shortNumberText(value, digits), {exactText(value)}, {}});
        };
        add(each.statistical);
        for (const BudgetSource& source : sources) {
            add(each.shares.*source.member);
        }
        add(each.combined);
        add(each.expanded);
        rows.push_back(std::move(row));
    }
    return rows;
}

QStringList toleranceTexts(const Identification& found) {
    constexpr int digits = 3;
    constexpr double ns = 1e-9;
    const Tolerance& tolerance = found.settings.tolerance;
    const bool gain_is_told = found.settings.signal.calibration.kappa != 1;
    QStringList texts;
    const auto add = [&texts](double ToleranceShares::*source, double value, const QString& unit) {
        if (value > 0) {
            texts << QStringLiteral("%1: %2%3")
                         .arg(sourceText(source), shortNumberText(value, digits),
                              unit.isEmpty() || unit == QStringLiteral("°")
                                  ? unit
                                  : QStringLiteral(" ") + unit);
        }
    };
    add(&ToleranceShares::kappa,
        tolerance.kappa.value_or(gain_is_told ? 0 : ChannelTolerance{}.kappa), {});
    add(&ToleranceShares::skew, tolerance.skew_deg, QStringLiteral("°"));
    add(&ToleranceShares::delay, tolerance.delay_s / ns, unitText("ns"));
    add(&ToleranceShares::crosstalk, tolerance.crosstalk, {});
    add(&ToleranceShares::phase_drift, tolerance.phase_drift_rad, unitText("rad"));
    add(&ToleranceShares::gain_drift, tolerance.gain_drift, {});
    return texts;
}

}  // namespace vybeg::ui
