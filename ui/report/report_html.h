#pragma once

#include "ui/widgets/quantity_table.h"

#include <QString>
#include <QStringList>

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

}  // namespace vybeg::ui
