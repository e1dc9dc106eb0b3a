#include "ui/widgets/wrapping_delegate.h"

#include "ui/words/rich_text.h"

#include <QAbstractTextDocumentLayout>
#include <QApplication>
#include <QPainter>
#include <QStyle>
#include <QTextDocument>

#include <cmath>

namespace vybeg::ui {

namespace {

constexpr int padding = 4;

void prepare(QTextDocument& document, const QString& text, const QFont& font) {
    document.setDocumentMargin(0);
    document.setDefaultFont(font);
    document.setHtml(richText(WrappingDelegate::unbroken(text)));
}

}  // namespace

QString WrappingDelegate::unbroken(QString text) {
    return text.replace(QLatin1Char('/'), QStringLiteral("/\u2060"))
        .replace(QStringLiteral("± "), QStringLiteral("±\u00a0"))
        .replace(QStringLiteral("(u "), QStringLiteral("(u\u00a0"));
}

void WrappingDelegate::paint(QPainter* painter, const QStyleOptionViewItem& option,
                             const QModelIndex& index) const {
    QStyleOptionViewItem item = option;
    initStyleOption(&item, index);
    const QString text = std::exchange(item.text, {});
    const QStyle* style = item.widget ? item.widget->style() : QApplication::style();
    style->drawControl(QStyle::CE_ItemViewItem, &item, painter, item.widget);
    QTextDocument document;
    prepare(document, text, item.font);
    const QRect area = item.rect.adjusted(padding, 2, -padding, -2);
    document.setTextWidth(area.width());
    QAbstractTextDocumentLayout::PaintContext context;
    const bool selected = (item.state & QStyle::State_Selected) != 0;
    context.palette.setColor(
        QPalette::Text, item.palette.color(selected ? QPalette::HighlightedText : QPalette::Text));
    painter->save();
    painter->setClipRect(item.rect);
    painter->translate(area.topLeft());
    document.documentLayout()->draw(painter, context);
    painter->restore();
}

int WrappingDelegate::widthFor(const QString& text, const QFont& font) {
    QTextDocument document;
    prepare(document, text, font);
    return static_cast<int>(std::ceil(document.idealWidth())) + 2 * padding + 2;
}

int WrappingDelegate::heightFor(const QString& text, const QFont& font, int width) {
    QTextDocument document;
    prepare(document, text, font);
    document.setTextWidth(std::max(20, width - 2 * padding - 1));
    return static_cast<int>(std::ceil(document.size().height())) + 5;
}

}  // namespace vybeg::ui
