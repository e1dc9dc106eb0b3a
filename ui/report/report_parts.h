#pragma once

#include "core/analysis/identify.h"
#include "ui/plots/plot_file.h"
#include "ui/report/report_content.h"
#include "ui/widgets/quantity_table.h"

#include <QPicture>
#include <QString>
#include <QStringList>

#include <cstddef>
#include <vector>

namespace vybeg::ui {

// Pieces of the report in the HTML that QTextDocument knows. Texts are plain and become escaped.

QString heading(const QString& text, bool new_page = false);
QString smallHeading(const QString& text);
QString paragraph(const QString& text);
QString monospaced(const QString& text);
// A list of sentences.
QString items(const QStringList& sentences);

// Rows of cells, each an HTML text; `columns`: the width of each in percent.
struct HtmlTable {
    QStringList head;  // repeated on each page; empty: none
    std::vector<QStringList> rows;
    std::vector<int> columns;
    bool small = false;
};
QString html(const HtmlTable& table);

// Quantities in tables of at most `most` columns of values.
QString quantityTables(const QStringList& headers, const std::vector<QuantityRow>& rows,
                       qsizetype most, bool small = false);

// The figure of that name.
QString figureHtml(const QString& name);
QString sideBySide(const QString& left, const QString& right);

// A figure of the report. `paper`: its size in the report, in pixels of pixels_per_inch; drawn
// larger and reduced, for the sake of smaller texts than on screen.
struct ReportFigure {
    QString name;  // in the text of the report
    Drawing draw;  // until it is drawn
    QSize drawn;
    QSizeF paper;
    QPicture picture{};  // vectors, which any thread can play
};

// Content of a page between its margins, pixels of pixels_per_inch.
inline constexpr QSizeF report_page{657, 950};

// Of a size in the report; texts of its drawing become smaller than on screen.
ReportFigure reportFigure(const QString& name, Drawing draw, QSizeF paper);

inline constexpr const char* rim_figure = "rim";
inline constexpr const char* drift_figure = "drift";
inline constexpr const char* balance_figure = "balance";
inline constexpr const char* whole_angle_figure = "whole-angle";

// The name of one of these in the text, and of the plots of a recording: different in each chapter.
QString figureName(const ReportContent& content, const char* figure);
QString plotsName(const ReportContent& content, std::size_t recording);

// All figures of a report: for each recording with an analysis the slow variables, then those of
// the resonator and of the whole-angle logs. Drawing one needs the thread of the window
// (QCustomPlot is a widget).
std::vector<ReportFigure> reportFigures(const ReportContent& content);

ReportFigure drawn(ReportFigure figure);
// All figures of a report in one go.
std::vector<ReportFigure> drawnFigures(const ReportContent& content);

// Why a content has no identification.
QString absenceText(const ReportContent& content);

// Parts of the chapter of one set or recording.

// `made`: when and by which program, a last row; empty: none.
QString titleBlock(const ReportTitle& title, const QString& made);

// From the recordings to the warnings; figures are in it by their names.
QString reportSections(const ReportContent& content);

// The uncertainty budget as a table: a row for each given parameter; columns: the statistical
// part, the tolerances that have a part in any of them, u and the expanded uncertainty. Empty where
// no parameter is given.
QStringList budgetHeaders(const Identification& found);
std::vector<QuantityRow> budgetRows(const Identification& found, const DisplayUnits& units);

}  // namespace vybeg::ui
