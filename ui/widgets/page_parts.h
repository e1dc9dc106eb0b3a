#pragma once

#include <QMargins>
#include <QString>
#include <QStringList>

#include <initializer_list>

class QBoxLayout;
class QComboBox;
class QLabel;
class QLayout;
class QScrollArea;
class QVBoxLayout;
class QWidget;

namespace vybeg::ui {

class Section;

// Parts of pages.

// A widget under the name by which others find it.
template <class Widget>
Widget* withName(Widget* widget, const char* name) {
    widget->setObjectName(QLatin1String(name));
    return widget;
}

// A part of a row or column of a layout: a widget, another layout, or room that grows.
struct LayoutPart {
    LayoutPart(QWidget* of, int stretch_of = 0, Qt::Alignment aligned = {})
        : widget(of), stretch(stretch_of), alignment(aligned) {}
    LayoutPart(QLayout* of, int stretch_of = 0) : layout(of), stretch(stretch_of) {}
    explicit LayoutPart(int stretch_of) : stretch(stretch_of) {}

    QWidget* widget = nullptr;
    QLayout* layout = nullptr;
    int stretch = 0;
    Qt::Alignment alignment;
};
using LayoutParts = std::initializer_list<LayoutPart>;

// Puts parts into a row or column, with so much room around and between them.
void addParts(QBoxLayout& layout, LayoutParts parts);
template <class Layout>
Layout* fill(Layout* layout, LayoutParts parts) {
    addParts(*layout, parts);
    return layout;
}
template <class Layout>
Layout* fill(Layout* layout, const QMargins& around, LayoutParts parts) {
    layout->setContentsMargins(around);
    return fill(layout, parts);
}
template <class Layout>
Layout* fill(Layout* layout, const QMargins& around, int between, LayoutParts parts) {
    layout->setSpacing(between);
    return fill(layout, around, parts);
}

// A label of whole sentences, rich text.
constexpr QMargins around_sentence{6, 2, 6, 2};
QLabel* sentence(QWidget* parent, const char* name, const QMargins& around = around_sentence);
void makeSentence(QLabel& label);
// The texts of a box's entries, from the `first` on.
void setTexts(QComboBox& box, const QStringList& texts, int first = 0);

// Each text a paragraph, in the form of `form`, whose %1 it takes.
QString paragraphs(const QStringList& texts, const QString& form);
// A part that can be folded away, at the end of a layout.
Section* addSection(QVBoxLayout& layout, std::initializer_list<QWidget*> parts);
// A column that scrolls up and down.
QScrollArea* scrolled(QVBoxLayout* column);
QScrollArea* scrolled(QWidget* content, QWidget* parent = nullptr);

}  // namespace vybeg::ui
