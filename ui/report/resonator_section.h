#pragma once

#include "ui/report/report_content.h"

#include <QString>

namespace vybeg::ui {

// The result for the page to be signed: values with their expanded uncertainties, limits and
// verdict.
QString resultSection(const ReportContent& content);

// The pages of the resonator, as HTML: parameters with their uncertainties, rim, drift, budget,
// modes, and what is known of each recording; or why there are none.
QString resonatorSection(const ReportContent& content);

// Why a content has no identification.
QString absenceText(const ReportContent& content);

}  // namespace vybeg::ui
