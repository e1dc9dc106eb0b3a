#pragma once

#include <QStringList>
#include <QStyledItemDelegate>

namespace vybeg::ui {

// Names by what differs between them: an ellipsis replaces the end, and where `beginning` is set
// the beginning, that all of them share, up to whole words and numbers. As they are where no
// more than a few letters are shared.
QStringList distinctNames(const QStringList& names, bool beginning = true);

// Of recordings by their files: by what differs, without the endings where nothing else differs
// with them.
QStringList recordingNames(const QStringList& files);
// What the names of files begin with, up to whole words and without a sign at its end; empty where
// that is no name.
QString commonName(const QStringList& files);

// Draws the names of a list's column; too long for it, they lose what all of them share first.
class NameDelegate : public QStyledItemDelegate {
    Q_OBJECT

public:
    using QStyledItemDelegate::QStyledItemDelegate;

    void paint(QPainter* painter, const QStyleOptionViewItem& option,
               const QModelIndex& index) const override;
};

}  // namespace vybeg::ui
