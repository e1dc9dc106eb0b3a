#include "ui/words/rich_text.h"

#include "ui/words/index_text.h"

#include <QApplication>
#include <QPainter>
#include <QStyle>
#include <QTextDocument>

#include <cmath>

namespace vybeg::ui {

namespace {

// drawIndexText() measures in pixels; the fonts of widgets are set in points.
QFont inPixels(QFont font) {
    font.setPixelSize(QFontInfo(font).pixelSize());
    return font;
}

}  // namespace

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
