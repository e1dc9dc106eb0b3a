#pragma once

#include <QFont>
#include <QPointF>
#include <QString>

#include <vector>

class QPainter;

namespace vybeg::ui {

struct IndexTextPiece {
    QString text;
    bool index = false;

    friend bool operator==(const IndexTextPiece&, const IndexTextPiece&) = default;
};

// "2θ_A" as {"2θ"}, {"A", index}: an underscore in a symbol of the program makes the letters and
// digits after it an index; names of files and gyros stay as they are.
std::vector<IndexTextPiece> indexPieces(const QString& text);

// "2θA", where only plain text is possible: accessible names, the rows of a choice.
QString indexPlain(const QString& text);

// Width in pixels of a text with indices.
double indexTextWidth(const QString& text, const QFont& font);

// Draws it with the painter's pen, from the left end of the base line. Returns the width.
double drawIndexText(QPainter& painter, QPointF base, const QString& text, const QFont& font);

}  // namespace vybeg::ui
