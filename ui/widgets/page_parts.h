#pragma once

#include <QMargins>
#include <QString>
#include <QStringList>

#include <initializer_list>

class QLabel;
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

// A label of whole sentences, rich text.
constexpr QMargins around_sentence{6, 2, 6, 2};
QLabel* sentence(QWidget* parent, const char* name, const QMargins& around = around_sentence);
void makeSentence(QLabel& label);
// Each text a paragraph, in the form of `form`, whose %1 it takes.
QString paragraphs(const QStringList& texts, const QString& form);
// A part that can be folded away, at the end of a layout.
Section* addSection(QVBoxLayout& layout, std::initializer_list<QWidget*> parts);
// A column that scrolls up and down.
QScrollArea* scrolled(QVBoxLayout* column);
QScrollArea* scrolled(QWidget* content);

}  // namespace vybeg::ui
