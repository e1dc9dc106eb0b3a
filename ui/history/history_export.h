#pragma once

#include "ui/history/history_view.h"
#include "ui/report/report_document.h"
#include "ui/report/report_parts.h"

#include <string>
#include <vector>

namespace vybeg::ui {

// What the page shows, on its way into a file.
struct HistoryExport {
    std::string table;  // CSV: a row a result, in the units of the database
    ReportText report;
    std::vector<ReportFigure> figures;  // of the report
};

// `database`: its name; `gyro`: nothing for all.
HistoryExport historyExport(const HistoryView& view, const QString& database,
                            const std::optional<std::string>& gyro);

}  // namespace vybeg::ui
