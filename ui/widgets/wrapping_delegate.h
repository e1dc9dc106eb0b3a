#pragma once

#include <QStyledItemDelegate>

namespace vybeg::ui {

// Draws the texts of a table with their indices set low, in as many lines as they need. The table
// sets the heights of its rows by heightFor(): a delegate does not know the width while it is
// asked.
class WrappingDelegate : public QStyledItemDelegate {
    Q_OBJECT

public:
    using QStyledItemDelegate::QStyledItemDelegate;

    void paint(QPainter* painter, const QStyleOptionViewItem& option,
               const QModelIndex& index) const override;

    // Pixels of a cell with a text: on one line, and in a column of a width.
    static int widthFor(const QString& text, const QFont& font);
    static int heightFor(const QString& text, const QFont& font, int width);
};

}  // namespace vybeg::ui
