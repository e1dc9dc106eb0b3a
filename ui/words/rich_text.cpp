#include "ui/words/rich_text.h"

#include <QApplication>
#include <QFontMetricsF>
#include <QPainter>
#include <QSet>
#include <QStyle>
#include <QTextDocument>

#include <cmath>

namespace vybeg::ui {

namespace {

QFont indexFont(const QFont& font) {
    QFont small(font);
    small.setPixelSize(std::max(8, qRound(0.74 * font.pixelSize())));
    return small;
}

// The symbols of the program with an index, by their last letter. A name given by a user, as "s_1"
// or "run_2", is none of them.
bool isSymbol(const QString& text, qsizetype at, qsizetype end) {
    static const QSet<QString> symbols{
        QStringLiteral("a_A"), QStringLiteral("a_B"),  QStringLiteral("a_C"),
        QStringLiteral("a_D"), QStringLiteral("θ_A"),  QStringLiteral("θ_w"),
        QStringLiteral("θ_τ"), QStringLiteral("φ_CD"), QStringLiteral("ω_cp"),
        QStringLiteral("ω_0"), QStringLiteral("f_cp"), QStringLiteral("f_q"),
        QStringLiteral("f_p"), QStringLiteral("f_0"),  QStringLiteral("f_ref"),
        QStringLiteral("S_A"), QStringLiteral("S_B"),  QStringLiteral("S_C"),
        QStringLiteral("S_D"), QStringLiteral("A_C"),  QStringLiteral("A_D")};
    while (end > at + 1 && text[end - 1] == QChar(0xb2)) {
        --end;  // a square of it
    }
    return symbols.contains(text.mid(at - 1, end - at + 1));
}

// Whether the underscore follows a symbol, one or two letters, and the text after it is not the end
// of a file's name: "a_A.wav", "a_A_c" have none.
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
    return begin < at && at - begin <= longest_symbol && isSymbol(text, at, end) && !in_name;
}

// drawIndexText() measures in pixels; the fonts of widgets are set in points.
QFont inPixels(QFont font) {
    font.setPixelSize(QFontInfo(font).pixelSize());
    return font;
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

QString richText(const QString& text) {
    QString html;
    for (const IndexTextPiece& piece : indexPieces(text)) {
        // Qt breaks lines at the narrow space between groups of digits.
        const QString escaped = piece.text.toHtmlEscaped().replace(QChar(0x202f), QChar(0x00a0));
        html += piece.index ? QStringLiteral("<sub>%1</sub>").arg(escaped) : escaped;
    }
    return html;
}

QString richTip(const QString& text) {
    return text.isEmpty() ? text : QStringLiteral("<p>%1</p>").arg(richText(text));
}

QString plainTip(const QString& text) {
    return text.isEmpty() ? text : Qt::convertFromPlainText(text, Qt::WhiteSpaceNormal);
}

void IndexDelegate::paint(QPainter* painter, const QStyleOptionViewItem& option,
                          const QModelIndex& index) const {
    QStyleOptionViewItem item = option;
    initStyleOption(&item, index);
    if (!item.text.contains(QLatin1Char('_'))) {
        QStyledItemDelegate::paint(painter, option, index);
        return;
    }
    const QString text = std::exchange(item.text, {});
    const QStyle* style = item.widget ? item.widget->style() : QApplication::style();
    style->drawControl(QStyle::CE_ItemViewItem, &item, painter, item.widget);
    const QRect area = style->subElementRect(QStyle::SE_ItemViewItemText, &item, item.widget);
    const bool selected = (item.state & QStyle::State_Selected) != 0;
    painter->save();
    painter->setClipRect(item.rect);
    painter->setPen(item.palette.color(selected ? QPalette::HighlightedText : QPalette::Text));
    const QFontMetrics metrics(item.font);
    const double base = area.center().y() + (metrics.ascent() - metrics.descent()) / 2.0;
    drawIndexText(*painter, QPointF(item.rect.left() + 4, base), text, inPixels(item.font));
    painter->restore();
}

QSize IndexDelegate::sizeHint(const QStyleOptionViewItem& option, const QModelIndex& index) const {
    QSize size = QStyledItemDelegate::sizeHint(option, index);
    const QString text = index.data(Qt::DisplayRole).toString();
    if (text.contains(QLatin1Char('_'))) {
        size.setWidth(static_cast<int>(std::ceil(indexTextWidth(text, inPixels(option.font)))) +
                      10);
        size.setHeight(option.fontMetrics.height() + 6);
    }
    return size;
}

void IndexHeader::paintSection(QPainter* painter, const QRect& rect, int section) const {
    const QString title = model()->headerData(section, orientation(), title_role).toString();
    if (title.isEmpty()) {
        QHeaderView::paintSection(painter, rect, section);
        return;
    }
    constexpr int margin = 4;
    QStyleOptionHeaderV2 item;
    initStyleOption(&item);
    initStyleOptionForIndex(&item, section);
    item.rect = rect;
    item.text.clear();
    painter->save();  // the style leaves a clip
    style()->drawControl(QStyle::CE_Header, &item, painter, this);
    painter->restore();
    const QFont pixels = inPixels(font());
    const double left = item.textAlignment.testFlag(Qt::AlignRight)
                            ? rect.right() - margin - indexTextWidth(title, pixels)
                            : rect.left() + margin;
    painter->save();
    painter->setPen(item.palette.color(QPalette::ButtonText));
    const double base =
        rect.center().y() + (fontMetrics().ascent() - fontMetrics().descent()) / 2.0;
    drawIndexText(*painter, QPointF(left, base), title, pixels);
    painter->restore();
}

}  // namespace vybeg::ui

#include "moc_rich_text.cpp"
