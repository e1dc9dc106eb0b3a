#pragma once

#include "core/analysis/identify.h"
#include "ui/report/report_content.h"
#include "ui/widgets/quantity_table.h"

#include <QString>

namespace vybeg::ui {

// Why a content has no identification.
QString absenceText(const ReportContent& content);

// What a report tells of one set or recording, as HTML.

// `made`: when and by which program, a last row; empty: none.
QString titleBlock(const ReportTitle& title, const QString& made);

// From the recordings to the warnings; figures stand in it by their names (report_parts.h).
QString reportSections(const ReportContent& content);

// The uncertainty budget as a table: a row for each given parameter; columns: the statistical
// part, the tolerances that have a part in any of them, u and the expanded uncertainty. Empty where
// no parameter is given.
QStringList budgetHeaders(const Identification& found);
std::vector<QuantityRow> budgetRows(const Identification& found, const DisplayUnits& units);

}  // namespace vybeg::ui
