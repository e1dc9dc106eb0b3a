#include "ui/report/budget_text.h"

#include "core/resonator/results/resonator_parameters.h"
#include "ui/panels/reading.h"
#include "ui/resonator/parameter_text.h"
#include "ui/resonator/resonator_text.h"
#include "ui/words/error_text.h"
#include "ui/words/unit_text.h"

#include <QCoreApplication>

#include <cmath>

namespace vybeg::ui {

QStringList budgetHeaders(const Identification& found) {
    QStringList headers{ReportWords::tr("Statistical")};
    for (const ErrorSource source : sources_of(uncertainty_budget(found.fit))) {
        headers << toleranceName(source, found.settings);
    }
    headers << ReportWords::tr("Combined u") << ReportWords::tr("Expanded U = 2u");
    return headers;
}

std::vector<QuantityRow> budgetRows(const Identification& found, const DisplayUnits& units) {
    constexpr int digits = 2;
    const std::vector<ParameterBudget> budget = uncertainty_budget(found.fit);
    const std::vector<ErrorSource> sources = sources_of(budget);
    std::vector<QuantityRow> rows;
    for (const ParameterBudget& each : budget) {
        const Shown shown = shownAs(each.parameter.name, each.parameter.unit, units);
        QuantityRow row{withUnit(shown.title, shown.unit), shown.tip, {}};
        const auto add = [&](double part) {
            const double value = std::abs(shown.factor) * part;
            row.cells.push_back({shortNumberText(value, digits), {exactText(value)}, {}});
        };
        add(each.statistical);
        for (const ErrorSource source : sources) {
            add(each.shares[source]);
        }
        add(each.combined);
        add(each.expanded);
        rows.push_back(std::move(row));
    }
    return rows;
}

}  // namespace vybeg::ui
