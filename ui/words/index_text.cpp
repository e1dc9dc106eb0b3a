#include "ui/words/index_text.h"

#include <QFontMetricsF>
#include <QPainter>

namespace vybeg::ui {
namespace {

QFont indexFont(const QFont& font) {
    QFont small(font);
    small.setPixelSize(std::max(8, qRound(0.74 * font.pixelSize())));
    return small;
}

}  // namespace

std::vector<IndexTextPiece> indexPieces(const QString& text) {
    std::vector<IndexTextPiece> pieces;
    bool index = false;
    QString piece;
    const auto close = [&] {
        if (!piece.isEmpty()) {
            pieces.push_back({piece, index});
        }
        piece.clear();
    };
    for (const QChar c : text) {
        if (c == '_') {
            close();
            index = true;
        } else if (index && !c.isLetterOrNumber()) {
            close();
            index = false;
            piece += c;
        } else {
            piece += c;
        }
    }
    close();
    return pieces;
}

QString indexPlain(const QString& text) {
    QString plain;
    for (const IndexTextPiece& piece : indexPieces(text)) {
        plain += piece.text;
    }
    return plain;
}

double indexTextWidth(const QString& text, const QFont& font) {
    double width = 0;
    for (const IndexTextPiece& piece : indexPieces(text)) {
        width += QFontMetricsF(piece.index ? indexFont(font) : font).horizontalAdvance(piece.text);
    }
    return width;
}

double drawIndexText(QPainter& painter, QPointF base, const QString& text, const QFont& font) {
    const double begin = base.x();
    const double drop = 0.22 * font.pixelSize();
    for (const IndexTextPiece& piece : indexPieces(text)) {
        const QFont used = piece.index ? indexFont(font) : font;
        painter.setFont(used);
        painter.drawText(base + QPointF(0, piece.index ? drop : 0), piece.text);
        base.rx() += QFontMetricsF(used).horizontalAdvance(piece.text);
    }
    return base.x() - begin;
}

}  // namespace vybeg::ui
