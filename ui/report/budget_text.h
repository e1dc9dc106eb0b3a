#pragma once

#include "core/analysis/identify.h"
#include "ui/widgets/quantity_table.h"
#include "ui/words/display_units.h"

#include <QCoreApplication>

namespace vybeg::ui {

// Texts of context "Report" in the interface's language.
struct ReportWords {
    Q_DECLARE_TR_FUNCTIONS(Report)
};

// The uncertainty budget as a table: a row for each given parameter; columns: the statistical
// part, the tolerances that have a part in any of them, u and the expanded uncertainty. Empty where
// no parameter is given.
QStringList budgetHeaders(const Identification& found);
std::vector<QuantityRow> budgetRows(const Identification& found, const DisplayUnits& units);

}  // namespace vybeg::ui
