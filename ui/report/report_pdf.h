#pragma once

#include "ui/report/report_figures.h"
#include "ui/report/report_text.h"

#include <QByteArray>

#include <vector>

namespace vybeg::ui {

// A report as a PDF of A4 pages with head and page numbers: figures as vectors, text as text, fonts
// embedded, title and author in its metadata. Any thread may call it.
QByteArray reportPdf(const ReportText& text, const std::vector<ReportPicture>& pictures);

}  // namespace vybeg::ui
