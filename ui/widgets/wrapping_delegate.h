#pragma once

#include <QStyledItemDelegate>

namespace vybeg::ui {

// Draws the texts of a table with subscripts, in as many lines as needed. The table sets the
// heights of its rows by heightFor(), because a delegate does not know the width in sizeHint().
class WrappingDelegate : public QStyledItemDelegate {
    Q_OBJECT

public:
    using QStyledItemDelegate::QStyledItemDelegate;

    void paint(QPainter* painter, const QStyleOptionViewItem& option,
               const QModelIndex& index) const override;

    // Size of a cell with a text, pixels: width on one line, height in a column of a given width.
    static int widthFor(const QString& text, const QFont& font);
    static int heightFor(const QString& text, const QFont& font, int width);
    // The text as it is drawn: no line breaks within a unit or before a deviation.
    static QString unbroken(QString text);
};

}  // namespace vybeg::ui
