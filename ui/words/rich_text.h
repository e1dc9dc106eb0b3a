#pragma once

#include <QFont>
#include <QHeaderView>
#include <QPointF>
#include <QString>
#include <QStyledItemDelegate>

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

// The text as HTML with its indices set low ("2θ_A"), for labels.
QString richText(const QString& text);

// The same as a paragraph: tooltips of rich text break their lines, plain ones do not.
QString richTip(const QString& text);

// A tool tip of a path, a name or another foreign text, as it is: Qt takes a text with tags for
// HTML.
QString plainTip(const QString& text);

// Draws the texts of a list or table with their indices set low.
class IndexDelegate : public QStyledItemDelegate {
    Q_OBJECT

public:
    using QStyledItemDelegate::QStyledItemDelegate;

    void paint(QPainter* painter, const QStyleOptionViewItem& option,
               const QModelIndex& index) const override;
    QSize sizeHint(const QStyleOptionViewItem& option, const QModelIndex& index) const override;
};

// Draws the titles of columns with their indices set low, where a column has such a title.
class IndexHeader : public QHeaderView {
    Q_OBJECT

public:
    // Of a column's title with underscores; the title itself is plain.
    static constexpr int title_role = Qt::UserRole;

    using QHeaderView::QHeaderView;

protected:
    void paintSection(QPainter* painter, const QRect& rect, int section) const override;
};

}  // namespace vybeg::ui
