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

// Whether the underscore follows a symbol, one or two letters, and what is behind it is not the end
// of a file's name: "run_2", "s_1.wav", "a_b_c" have none.
bool beginsIndex(const QString& text, qsizetype at) {
    const auto is_word = [&text](qsizetype place) {
        return place >= 0 && place < text.size() &&
               (text[place].isLetterOrNumber() || text[place] == '_');
    };
    constexpr qsizetype longest_symbol = 2;
    qsizetype begin = at;
    while (begin > 0 && text[begin - 1].isLetter()) {
        --begin;
    }
    qsizetype end = at + 1;
    while (is_word(end) && text[end] != '_') {
        ++end;
    }
    const bool in_name = (end < text.size() && text[end] == '_') ||
                         (end + 1 < text.size() && text[end] == '.' && is_word(end + 1)) ||
                         (begin > 0 && text[begin - 1] == '_');
    return begin < at && at - begin <= longest_symbol && end > at + 1 && !in_name;
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
    for (qsizetype at = 0; at < text.size(); ++at) {
        const QChar c = text[at];
        if (c == '_' && beginsIndex(text, at)) {
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
